// Every form of the commands that specify vertices and what is current (2.7), and rectangles (2.10).
#include <cmath>

#include "lighting/scenes.h"
#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {
namespace {

// Where the k-th of 12 patches stands.
double column(int k) { return -0.85 + 0.57 * (k % 4); }
double line_of(int k) { return 0.7 - 0.7 * (k / 4); }

// The color command of the type: four values each, as scalars and behind a pointer.
template <class Scalar3, class Vector3, class Scalar4, class Vector4>
Test color_row(const char* name, const char* sentence, std::vector<V> values, Scalar3 scalar3,
               Vector3 vector3, Scalar4 scalar4, Vector4 vector4) {
  return row(name, "2.7, table 2.9", sentence, [=](Script& s) {
    s.Enable(GL_BLEND), s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int k = 0; k < 12; k++) {
      const V& v = values[size_t(k) % values.size()];
      const V three{v[0], v[1], v[2]};
      switch (k / 3) {
      case 0: (s.*scalar3)(v[0], v[1], v[2]); break;
      case 1: (s.*vector3)(three); break;
      case 2: (s.*scalar4)(v[0], v[1], v[2], v[3]); break;
      default: (s.*vector4)(v);
      }
      patch(s, column(k), line_of(k), 0.22);
    }
  });
}
#define COLOR_ROW(type, sentence, ...) \
  color_row("commands.color_" #type, sentence, {__VA_ARGS__}, &Script::Color3##type<double, double, double>, \
            &Script::Color3##type##v<V>, &Script::Color4##type<double, double, double, double>, \
            &Script::Color4##type##v<V>)

// The normal command of the type, lit by light 0 from the front.
template <class Scalar, class Vector>
Test normal_row(const char* name, const char* sentence, double scale, Scalar scalar, Vector vector) {
  return row(name, "2.7, table 2.9", sentence, [=](Script& s) {
    diffuse_scene(s, {1, 2, 3, 0});
    for (int k = 0; k < 12; k++) {
      const double turn = 0.7 * k;
      const V n{std::trunc(0.7 * scale * std::cos(turn)), std::trunc(0.7 * scale * std::sin(turn)),
                std::trunc(0.7 * scale)};
      if (k % 2)
        (s.*vector)(n);
      else
        (s.*scalar)(n[0], n[1], n[2]);
      patch(s, column(k), line_of(k), 0.22);
    }
  });
}

} // namespace

std::vector<Test> vertices_command_tests() {
  return {
      row("commands.vertex2", "2.7", "glVertex2 of each type has z = 0 and w = 1.",
          [](Script& s) {
            s.Scalef(0.1, 0.1, 1);
            s.Begin(GL_TRIANGLES);
            tint(s, 0), s.Vertex2s(-9, -8), s.Vertex2sv(V{-2, -7}), s.Vertex2i(-6, 9);
            tint(s, 1), s.Vertex2iv(V{0, -9}), s.Vertex2f(8.5, -6.5), s.Vertex2fv(V{1.5, 0.25});
            tint(s, 2), s.Vertex2d(-1.5, 1.25), s.Vertex2dv(V{9.25, 2.5}), s.Vertex2d(2.5, 9.5);
            s.End();
          }),
      row("commands.vertex3", "2.7", "glVertex3 of each type has w = 1.",
          [](Script& s) {
            perspective(s), s.Scalef(0.1, 0.1, 0.1);
            s.Begin(GL_TRIANGLES);
            tint(s, 0), s.Vertex3s(-9, -8, 0), s.Vertex3sv(V{-2, -7, -9}), s.Vertex3i(-6, 9, 4);
            tint(s, 1), s.Vertex3iv(V{0, -9, 5}), s.Vertex3f(8.5, -6.5, -5.5), s.Vertex3fv(V{1.5, 0.25, 1.5});
            tint(s, 2), s.Vertex3d(-1.5, 1.25, 0.5), s.Vertex3dv(V{9.25, 2.5, -9.5}), s.Vertex3d(2.5, 9.5, 2);
            s.End();
          }),
      row("commands.vertex4", "2.7", "glVertex4 of each type gives w itself.",
          [](Script& s) {
            s.Begin(GL_TRIANGLES);
            tint(s, 0), s.Vertex4s(-9, -8, 0, 10), s.Vertex4sv(V{-1, -3, 0, 5}), s.Vertex4i(-6, 9, 1, 10);
            tint(s, 1), s.Vertex4iv(V{0, -9, 1, 10}), s.Vertex4f(1.7, -1.3, 0.5, 2),
                s.Vertex4fv(V{0.1, 0.01, 0.1, 0.5});
            tint(s, 2), s.Vertex4d(-0.15, 0.125, 0, 1), s.Vertex4dv(V{9.25, 2.5, 0, 10}),
                s.Vertex4d(0.25, 0.95, 0, 1);
            s.End();
          }),
      row("commands.vertex_w", "2.11", "A vertex stands where its coordinates divided by w are.",
          [](Script& s) {
            s.Begin(GL_TRIANGLES);
            for (double w : {0.25, 4.0}) {
              const double y = w < 1 ? -0.45 : 0.45;
              tint(s, w < 1), s.Vertex4f(-0.9 * w, (y - 0.4) * w, 0, w),
                  s.Vertex4f(0.85 * w, (y - 0.3) * w, 0, w);
              s.Vertex4f(0.1 * w, (y + 0.4) * w, 0, w);
            }
            s.End();
          }),
      COLOR_ROW(b, "Signed bytes b of colors are (2b + 1) / 255.", {127, 0, 63, 127}, {20, 120, -1, 60},
                {-128, 90, 127, 90}),
      COLOR_ROW(s, "Signed shorts c of colors are (2c + 1) / 65535.", {32767, 0, 16000, 32767},
                {5000, 30000, -1, 16000}, {-32768, 25000, 32767, 24000}),
      COLOR_ROW(i, "Signed integers c of colors are (2c + 1) / (2^32 - 1).", {2147483647, 0, 1e9, 2147483647},
                {3e8, 2e9, -1, 1e9}, {-2147483648.0, 16e8, 2147483647, 15e8}),
      COLOR_ROW(ub, "Unsigned bytes c of colors are c / 255.", {255, 0, 128, 255}, {40, 240, 3, 128},
                {200, 180, 255, 190}),
      COLOR_ROW(us, "Unsigned shorts c of colors are c / 65535.", {65535, 0, 32768, 65535},
                {9000, 60000, 700, 32768}, {51000, 46000, 65535, 49000}),
      COLOR_ROW(ui, "Unsigned integers c of colors are c / (2^32 - 1).",
                {4294967295.0, 0, 2147483648.0, 4294967295.0}, {6e8, 4e9, 4e7, 2147483648.0},
                {3.4e9, 3e9, 4294967295.0, 3.2e9}),
      COLOR_ROW(f, "Colors of floats are taken as they are, and clamped at the end.", {1, 0, 0.5, 1},
                {0.2, 0.95, 0.01, 0.5}, {0.8, 7, -3, 0.75}),
      COLOR_ROW(d, "Colors of doubles are taken as they are, and clamped at the end.", {1, 0, 0.5, 1},
                {0.2, 0.95, 0.01, 0.5}, {0.8, 7, -3, 0.75}),
      normal_row("commands.normal_b", "Signed bytes b of normals are (2b + 1) / 255.", 127,
                 &Script::Normal3b<double, double, double>, &Script::Normal3bv<V>),
      normal_row("commands.normal_s", "Signed shorts c of normals are (2c + 1) / 65535.", 32767,
                 &Script::Normal3s<double, double, double>, &Script::Normal3sv<V>),
      normal_row("commands.normal_i", "Signed integers c of normals are (2c + 1) / (2^32 - 1).", 2147483647,
                 &Script::Normal3i<double, double, double>, &Script::Normal3iv<V>),
      row("commands.color_queried", "2.7, table 6.5",
          "The current color is what the last color command set; alpha is 1 if it is not given.",
          [](Script& s) {
            s.GetFloatv(GL_CURRENT_COLOR, V{1, 1, 1, 1});
            s.Color4ub(255, 51, 0, 102), s.GetFloatv(GL_CURRENT_COLOR, V{1, 0.2, 0, 0.4});
            s.Color3s(32767, -32768, 0), s.GetFloatv(GL_CURRENT_COLOR, V{1, -1, 1 / 65535.0, 1});
            s.Color3f(4, -2, 0.5), s.GetFloatv(GL_CURRENT_COLOR, V{4, -2, 0.5, 1});
            s.Begin(GL_POINTS), s.Color4d(0.25, 0.5, 0.75, 0.125), s.End();
            s.GetFloatv(GL_CURRENT_COLOR, V{0.25, 0.5, 0.75, 0.125});
          }),
      row("commands.normal_queried", "2.7, table 6.5",
          "The current normal is what the last normal command set.",
          [](Script& s) {
            s.GetFloatv(GL_CURRENT_NORMAL, V{0, 0, 1});
            s.Normal3b(127, -128, 0), s.GetFloatv(GL_CURRENT_NORMAL, V{1, -1, 1 / 255.0});
            s.Normal3f(3, 0.5, -7), s.GetFloatv(GL_CURRENT_NORMAL, V{3, 0.5, -7});
            s.Normal3dv(V{0.25, -0.5, 9}), s.GetFloatv(GL_CURRENT_NORMAL, V{0.25, -0.5, 9});
          }),
      row("commands.texcoord", "2.7",
          "glTexCoord of each size and type sets what it gives; t and r are 0 and q is 1 if not given.",
          [](Script& s) {
            const auto is = [&](double x, double y, double z, double w) {
              s.GetFloatv(GL_CURRENT_TEXTURE_COORDS, V{x, y, z, w});
            };
            is(0, 0, 0, 1);
            s.TexCoord1s(3), is(3, 0, 0, 1), s.TexCoord1iv(V{-4}), is(-4, 0, 0, 1), s.TexCoord1f(0.5),
                is(0.5, 0, 0, 1);
            s.TexCoord1dv(V{2.5}), is(2.5, 0, 0, 1), s.TexCoord2sv(V{7, 8}), is(7, 8, 0, 1);
            s.TexCoord2i(-1, 9), is(-1, 9, 0, 1), s.TexCoord2fv(V{0.5, 0.25}), is(0.5, 0.25, 0, 1);
            s.TexCoord2d(3.5, 4.5), is(3.5, 4.5, 0, 1), s.TexCoord3s(1, 2, 3), is(1, 2, 3, 1);
            s.TexCoord3iv(V{4, 5, 6}), is(4, 5, 6, 1), s.TexCoord3f(0.1, 0.2, 0.3), is(0.1, 0.2, 0.3, 1);
            s.TexCoord3dv(V{7.5, 8.5, 9.5}), is(7.5, 8.5, 9.5, 1), s.TexCoord4sv(V{1, 2, 3, 4}),
                is(1, 2, 3, 4);
            s.TexCoord4i(5, 6, 7, 8), is(5, 6, 7, 8), s.TexCoord4fv(V{0.5, 0.6, 0.7, 0.8}),
                is(0.5, 0.6, 0.7, 0.8);
            s.TexCoord4d(1.5, 2.5, 3.5, 4.5), is(1.5, 2.5, 3.5, 4.5);
          }),
      row("commands.rect", "2.10", "glRect of each type draws the rectangle between two corners at z = 0.",
          [](Script& s) {
            s.Scalef(0.1, 0.1, 1);
            tint(s, 0), s.Rects(-9, -9, -5, -6), tint(s, 1), s.Recti(-4, -9, 1, -5), tint(s, 2),
                s.Rectf(2.5, -9.25, 8.5, -4.5);
            tint(s, 3), s.Rectd(-9.25, -3.5, -4.5, 1.25), tint(s, 4), s.Rectsv(V{-3, -3}, V{2, 2});
            tint(s, 5), s.Rectiv(V{4, -3}, V{9, 1}), tint(s, 6), s.Rectfv(V{-8.5, 3.5}, V{-1.5, 9.25});
            tint(s, 0), s.Rectdv(V{1.5, 3.25}, V{9.25, 8.5});
          }),
      row("commands.rect_faces", "2.10", "A rectangle is clockwise if one of its sides runs backwards.",
          [](Script& s) {
            s.Enable(GL_CULL_FACE);
            tint(s, 0), s.Rectf(-0.9, -0.9, -0.1, -0.1), tint(s, 1), s.Rectf(0.9, -0.9, 0.1, -0.1);
            tint(s, 2), s.Rectf(0.9, 0.9, 0.1, 0.1), tint(s, 3), s.Rectf(-0.9, 0.9, -0.1, 0.1);
          }),
      row("commands.current_stays", "2.7",
          "A color that is set inside or outside of glBegin and glEnd stays current.",
          [](Script& s) {
            tint(s, 3), patch(s, -0.6, -0.6, 0.3);
            s.Begin(GL_TRIANGLES), s.Vertex3f(0.1, -0.9, 0), s.Vertex3f(0.9, -0.9, 0), tint(s, 1),
                s.Vertex3f(0.5, -0.1, 0), tint(s, 4), s.End();
            patch(s, -0.6, 0.6, 0.3);
            s.Begin(GL_TRIANGLES), s.Vertex3f(0.1, 0.1, 0), s.Vertex3f(0.9, 0.1, 0), s.Vertex3f(0.5, 0.9, 0),
                s.End();
          }),
      row("commands.saved", "6.1.14, table 6.5", "GL_CURRENT_BIT saves the current color.",
          [](Script& s) {
            tint(s, 1), s.PushAttrib(GL_CURRENT_BIT), tint(s, 0), patch(s, -0.5, 0, 0.3), s.PopAttrib();
            patch(s, 0.5, 0, 0.3);
          }),
  };
}

} // namespace softgl::suite
