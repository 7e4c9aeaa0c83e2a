// Texture coordinates: matrices, generation, perspective (2.7, 2.11.2, 2.11.4, 3.5.1, 3.8.7).
#include <cmath>

#include "texture/chapter.h"
#include "texture/scenes.h"

namespace softgl::suite {
namespace {

// The texture matrix while `set` runs.
void texture_matrix(Script& s, const std::function<void(Script&)>& set) {
  s.MatrixMode(GL_TEXTURE), set(s), s.MatrixMode(GL_MODELVIEW);
}

// A dome of triangles with normals that turn.
void dome(Script& s) {
  constexpr int kCells = 8;
  s.Begin(GL_TRIANGLES);
  for (int j = 0; j < kCells; j++)
    for (int i = 0; i < kCells; i++)
      for (int corner : {0, 1, 3, 0, 3, 2}) {
        const double x = 2.0 * (i + (corner & 1)) / kCells - 1, y = 2.0 * (j + (corner >> 1)) / kCells - 1;
        const double length = std::sqrt(1 + 0.49 * (x * x + y * y));
        s.Normal3f(float(0.7 * x / length), float(0.7 * y / length), float(1 / length));
        s.Vertex3f(float(x), float(y), 0);
      }
  s.End();
}

void generate(Script& s, GLenum coordinate, GLenum mode) {
  s.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode);
  s.Enable(GLenum(GL_TEXTURE_GEN_S + (coordinate - GL_S)));
}

void cube(Script& s) {
  replace_scene(s, GL_TEXTURE_CUBE_MAP), wrap(s, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
  for (int face = 0; face < 6; face++)
    s.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA, 4, 4, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texel_bytes(16, 4, face));
}

void perspective(Script& s) {
  s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Frustum(-0.24, 0.24, -0.247, 0.239, 1.0, 20.0),
      s.MatrixMode(GL_MODELVIEW);
}

// A sheet that leans back: its right side is farther away.
void leaning_sheet(Script& s) {
  s.Begin(GL_TRIANGLES);
  for (int corner : {0, 1, 3, 0, 3, 2}) {
    const float x = corner & 1 ? 1 : 0, y = corner & 2 ? 1 : 0;
    s.TexCoord2f(x, y), s.Vertex3f(2.2f * x - 1, 2 * y - 1, -4 * x);
  }
  s.End();
}

} // namespace

std::vector<Test> texture_coordinate_tests() {
  return {
      texture_test("matrix.scaled", "2.11.2", "The texture matrix multiplies the coordinates.",
                   [](Script& s) {
                     replace_scene(s), texture_matrix(s, [](Script& m) { m.Scalef(2.0, 0.5, 1.0); }),
                         textured_sheet(s);
                   }),
      texture_test("matrix.translated", "2.11.2", "The texture matrix moves the coordinates.",
                   [](Script& s) {
                     replace_scene(s), texture_matrix(s, [](Script& m) { m.Translatef(0.3, -0.2, 0.0); }),
                         textured_sheet(s);
                   }),
      texture_test("matrix.rotated", "2.11.2", "The texture matrix turns the coordinates.",
                   [](Script& s) {
                     replace_scene(s), texture_matrix(s, [](Script& m) { m.Rotatef(30.0, 0.0, 0.0, 1.0); }),
                         textured_sheet(s);
                   }),
      texture_test("matrix.order", "2.11.2", "Later matrices come first to the coordinates.",
                   [](Script& s) {
                     replace_scene(s);
                     texture_matrix(s,
                                    [](Script& m) { m.Scalef(2.0, 1.5, 1.0), m.Translatef(0.3, 0.1, 0.0); }),
                         textured_sheet(s);
                   }),
      texture_test("matrix.projective", "2.11.2, 3.8.7",
                   "A texture matrix may change q, by which the coordinates are divided.",
                   [](Script& s) {
                     replace_scene(s);
                     texture_matrix(s, [](Script& m) {
                       m.LoadMatrixf(V{1, 0, 0, 0.6, 0, 1, 0, 0.2, 0, 0, 1, 0, 0, 0, 0, 1});
                     });
                     textured_sheet(s);
                   }),
      texture_test("matrix.stack", "2.11.2", "glPopMatrix brings the texture matrix back.",
                   [](Script& s) {
                     replace_scene(s);
                     texture_matrix(s, [](Script& m) {
                       m.Scalef(2.0, 1.0, 1.0), m.PushMatrix(), m.Translatef(0.4, 0.4, 0.0), m.PopMatrix();
                     });
                     textured_sheet(s);
                   }),
      texture_test("matrix.not_the_modelview", "2.11.2", "The modelview does not move texture coordinates.",
                   [](Script& s) {
                     replace_scene(s), s.Translatef(0.2, 0.1, 0.0), s.Scalef(0.7, 0.7, 1.0),
                         textured_sheet(s);
                   }),
      texture_test("coordinate.one", "2.7", "glTexCoord1 sets t to 0 and q to 1.",
                   [](Script& s) {
                     replace_scene(s), texture_matrix(s, [](Script& m) { m.Translatef(0.0, 0.1, 0.0); });
                     s.Begin(GL_TRIANGLES);
                     for (int corner : {0, 1, 3, 0, 3, 2}) {
                       s.TexCoord4f(0.5, 0.9, 0.5, 3), s.TexCoord1f(corner & 1 ? 1.0f : 0.0f);
                       s.Vertex2f(corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f);
                     }
                     s.End();
                   }),
      texture_test("coordinate.four", "2.7, 3.8.7", "s and t are divided by q.",
                   [](Script& s) {
                     replace_scene(s), s.Begin(GL_TRIANGLES);
                     for (int corner : {0, 1, 3, 0, 3, 2}) {
                       const float x = corner & 1 ? 1 : 0, y = corner & 2 ? 1 : 0;
                       s.TexCoord4f(2.5f * x, 2.5f * y, 0, 2.5), s.Vertex2f(2 * x - 1, 2 * y - 1);
                     }
                     s.End();
                   }),
      texture_test("coordinate.q_varies", "3.8.7", "Coordinates are divided by q at each fragment.",
                   [](Script& s) {
                     replace_scene(s), s.Begin(GL_TRIANGLES);
                     for (int corner : {0, 1, 3, 0, 3, 2}) {
                       const float x = corner & 1 ? 1 : 0, y = corner & 2 ? 1 : 0, q = corner & 1 ? 3 : 1;
                       s.TexCoord4f(q * x, q * y, 0, q), s.Vertex2f(2 * x - 1, 2 * y - 1);
                     }
                     s.End();
                   }),
      texture_test("coordinate.initial", "2.7, table 6.5",
                   "The current coordinates are (0, 0, 0, 1) at first.",
                   [](Script& s) {
                     replace_scene(s), texture_matrix(s, [](Script& m) { m.Translatef(0.6, 0.4, 0.0); });
                     s.Begin(GL_TRIANGLES), s.Vertex2f(-1, -1), s.Vertex2f(1, -1), s.Vertex2f(0, 1), s.End();
                   }),
      texture_test("coordinate.current", "2.7",
                   "A vertex has the coordinates that are current when it comes.",
                   [](Script& s) {
                     replace_scene(s), s.Begin(GL_TRIANGLES);
                     s.TexCoord2f(0.3f, 0.6f), s.Vertex2f(-1, -1), s.Vertex2f(1, -1),
                         s.TexCoord2f(0.9f, 0.1f), s.Vertex2f(0, 1);
                     s.End();
                   }),
      texture_test("coordinate.flat", "2.14.7", "Flat shading does not make texture coordinates flat.",
                   [](Script& s) { replace_scene(s), s.ShadeModel(GL_FLAT), textured_sheet(s); }),
      texture_test("coordinate.perspective", "3.5.1, equation 3.6",
                   "Coordinates are interpolated with perspective.",
                   [](Script& s) { replace_scene(s), perspective(s), leaning_sheet(s); }),
      texture_test("coordinate.perspective_linear", "3.5.1, equation 3.6",
                   "Coordinates are interpolated with perspective, filtered, too.",
                   [](Script& s) {
                     replace_scene(s), filters(s, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR), perspective(s),
                         leaning_sheet(s);
                   }),
      texture_test("coordinate.points", "3.3", "A point has the coordinates of its vertex.",
                   [](Script& s) {
                     replace_scene(s), s.PointSize(6), s.Begin(GL_POINTS);
                     for (int i = 0; i < 16; i++)
                       s.TexCoord2f(0.125f + 0.25f * float(i % 4), 0.125f + 0.25f * float(i / 4)),
                           s.Vertex2f(-0.8f + 0.5f * float(i % 4), -0.8f + 0.5f * float(i / 4));
                     s.End();
                   }),
      texture_test(
          "coordinate.many_texels", "3.8.8", "An image of 64x64 texels is sampled at each pixel.",
          [](Script& s) {
            replace_scene(s), image_2d(s, GL_RGBA, GL_RGBA, 64, 64), textured_sheet(s, {0.1, 0.2, 0.2, 0.3});
          }),

      texture_test("generation.object_linear", "2.11.4",
                   "GL_OBJECT_LINEAR is the product of plane and object coordinates.",
                   [](Script& s) {
                     replace_scene(s), generate(s, GL_S, GL_OBJECT_LINEAR),
                         generate(s, GL_T, GL_OBJECT_LINEAR);
                     s.TexGenfv(GL_S, GL_OBJECT_PLANE, V{0.5, 0.2, 0, 0.4}),
                         s.TexGenfv(GL_T, GL_OBJECT_PLANE, V{-0.1, 0.7, 0, 0.6});
                     s.Translatef(0.1, 0.1, 0.0), textured_sheet(s);
                   }),
      texture_test("generation.eye_linear", "2.11.4",
                   "GL_EYE_LINEAR is the product of plane and eye coordinates.",
                   [](Script& s) {
                     replace_scene(s), generate(s, GL_S, GL_EYE_LINEAR), generate(s, GL_T, GL_EYE_LINEAR);
                     s.PushMatrix(), s.LoadIdentity();
                     s.TexGenfv(GL_S, GL_EYE_PLANE, V{0.5, 0.2, 0, 0.4}),
                         s.TexGenfv(GL_T, GL_EYE_PLANE, V{-0.1, 0.7, 0, 0.6});
                     s.PopMatrix(), s.Scalef(0.8, 0.9, 1.0), textured_sheet(s);
                   }),
      texture_test("generation.eye_plane_transformed", "2.11.4",
                   "An eye plane is transformed by the inverse of the modelview when it is set.",
                   [](Script& s) {
                     replace_scene(s), generate(s, GL_S, GL_EYE_LINEAR), generate(s, GL_T, GL_EYE_LINEAR);
                     s.PushMatrix(), s.Rotatef(40.0, 0.0, 0.0, 1.0), s.Scalef(2.0, 0.5, 1.0),
                         s.Translatef(0.2, 0.3, 0.0);
                     s.TexGenfv(GL_S, GL_EYE_PLANE, V{0.5, 0.2, 0, 0.4}),
                         s.TexGenfv(GL_T, GL_EYE_PLANE, V{-0.1, 0.7, 0, 0.6});
                     s.PopMatrix(), textured_sheet(s);
                   }),
      texture_test("generation.eye_plane_stays", "2.11.4",
                   "A modelview that is set later does not change an eye plane.",
                   [](Script& s) {
                     replace_scene(s), generate(s, GL_S, GL_EYE_LINEAR), generate(s, GL_T, GL_EYE_LINEAR);
                     s.TexGenfv(GL_S, GL_EYE_PLANE, V{0.5, 0.2, 0, 0.4}),
                         s.TexGenfv(GL_T, GL_EYE_PLANE, V{-0.1, 0.7, 0, 0.6});
                     s.Rotatef(20.0, 0.0, 0.0, 1.0), s.Scalef(0.8, 0.8, 1.0), textured_sheet(s);
                   }),
      texture_test("generation.default_planes", "2.11.4, table 6.14",
                   "At first the planes are x for s and y for t, in eye coordinates.",
                   [](Script& s) {
                     replace_scene(s), s.Enable(GL_TEXTURE_GEN_S), s.Enable(GL_TEXTURE_GEN_T),
                         textured_sheet(s, {0.4, 0.4, 0.4, 0.4});
                   }),
      texture_test("generation.sphere_map", "2.11.4", "GL_SPHERE_MAP makes s and t of the reflection.",
                   [](Script& s) {
                     replace_scene(s), generate(s, GL_S, GL_SPHERE_MAP), generate(s, GL_T, GL_SPHERE_MAP),
                         dome(s);
                   }),
      texture_test("generation.sphere_map_near", "2.11.4",
                   "The reflection is of the direction from the eye to the vertex.",
                   [](Script& s) {
                     replace_scene(s), perspective(s), s.Translatef(0.0, 0.0, 2.0), s.Scalef(0.6, 0.6, 1.0),
                         s.Enable(GL_NORMALIZE);
                     generate(s, GL_S, GL_SPHERE_MAP), generate(s, GL_T, GL_SPHERE_MAP), dome(s);
                   }),
      texture_test(
          "generation.normal_map", "2.11.4",
          "GL_NORMAL_MAP makes s, t and r of the normal in eye coordinates.",
          [](Script& s) {
            cube(s), s.Rotatef(30.0, 0.0, 1.0, 0.0), s.Scalef(0.8, 0.8, 0.8), s.Enable(GL_NORMALIZE);
            for (GLenum c : {GL_S, GL_T, GL_R}) generate(s, c, GL_NORMAL_MAP);
            dome(s);
          },
          kVersion13),
      texture_test(
          "generation.reflection_map", "2.11.4", "GL_REFLECTION_MAP makes s, t and r of the reflection.",
          [](Script& s) {
            cube(s), s.Rotatef(20.0, 1.0, 0.0, 0.0), s.Enable(GL_NORMALIZE);
            for (GLenum c : {GL_S, GL_T, GL_R}) generate(s, c, GL_REFLECTION_MAP);
            dome(s);
          },
          kVersion13),
      texture_test("generation.one_coordinate", "2.11.4",
                   "A coordinate that is not generated is the current one.",
                   [](Script& s) {
                     replace_scene(s), generate(s, GL_T, GL_OBJECT_LINEAR),
                         s.TexGenfv(GL_T, GL_OBJECT_PLANE, V{0.8, 0.3, 0, 0.5});
                     textured_sheet(s);
                   }),
      texture_test("generation.q", "2.11.4", "q may be generated.",
                   [](Script& s) {
                     replace_scene(s), generate(s, GL_Q, GL_OBJECT_LINEAR),
                         s.TexGenfv(GL_Q, GL_OBJECT_PLANE, V{0.4, 0, 0, 1});
                     textured_sheet(s);
                   }),
      texture_test("generation.then_matrix", "2.11.4", "The texture matrix transforms what is generated.",
                   [](Script& s) {
                     replace_scene(s), generate(s, GL_S, GL_OBJECT_LINEAR),
                         s.TexGenfv(GL_S, GL_OBJECT_PLANE, V{0.5, 0.2, 0, 0.4});
                     texture_matrix(s,
                                    [](Script& m) { m.Scalef(2.0, 1.0, 1.0), m.Translatef(0.2, 0.0, 0.0); }),
                         textured_sheet(s);
                   }),
      texture_test("generation.off", "2.11.4",
                   "A plane of a coordinate that is not generated changes nothing.",
                   [](Script& s) {
                     replace_scene(s), generate(s, GL_S, GL_OBJECT_LINEAR),
                         s.TexGenfv(GL_S, GL_OBJECT_PLANE, V{0.5, 0.2, 0, 0.4});
                     s.Disable(GL_TEXTURE_GEN_S), textured_sheet(s);
                   }),
      texture_test("generation.keeps_both_planes", "2.11.4", "Object plane and eye plane are kept apart.",
                   [](Script& s) {
                     replace_scene(s), generate(s, GL_S, GL_EYE_LINEAR),
                         s.TexGenfv(GL_S, GL_EYE_PLANE, V{0, 1, 0, 0.4});
                     s.TexGenfv(GL_S, GL_OBJECT_PLANE, V{0.6, 0.1, 0, 0.5}), textured_sheet(s, {}, -1, -1, 0);
                     s.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR),
                         textured_sheet(s, {}, 0.02, -1, 1);
                   }),
  };
}

} // namespace softgl::suite
