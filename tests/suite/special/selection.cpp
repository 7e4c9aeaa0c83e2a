// Selection (5.2): what is a hit, and its depths.
#include "special/chapter.h"
#include "special/scenes.h"

namespace softgl::suite {
namespace {

Test hit_row(const char* name, const char* sentence, std::function<void(Script&)> body,
             const char* section = "5.2", Need need = {}) {
  return special_test(std::string("selection.") + name, section, sentence, std::move(body), need);
}

// Draws each of the scenes under a name of its own: 1, 2 and so on.
void named(Script& s, const std::vector<std::function<void()>>& scenes, int room = 40) {
  selected(
      s,
      [&] {
        s.InitNames(), s.PushName(0);
        for (size_t i = 0; i < scenes.size(); i++) s.LoadName(int(i) + 1), scenes[i]();
      },
      room);
}

void line(Script& s, double x1, double y1, double z1, double x2, double y2, double z2) {
  s.Begin(GL_LINES), pixel_vertex(s, x1, y1, z1), pixel_vertex(s, x2, y2, z2), s.End();
}
void reversed_shape(Script& s, double x, double y) {
  s.Begin(GL_TRIANGLES), pixel_vertex(s, x - 14, y - 11), pixel_vertex(s, x + 3, y + 12),
      pixel_vertex(s, x + 13, y - 7), s.End();
}

Test no_hit_row(const char* name, const char* sentence, std::function<void(Script&)> inside) {
  return hit_row(
      name, sentence,
      [=](Script& s) {
        tint(s, 1), box(s, 20, 22, 52, 61), s.SelectBuffer(40, V(40, kUntouchedName)),
            s.RenderMode(GL_SELECT), inside(s), s.RenderMode(GL_RENDER), tint(s, 4), box(s, 61, 40, 88, 80);
      },
      "5.2, corollary 18");
}

} // namespace

std::vector<Test> special_selection_tests() {
  return {
      hit_row("points", "A point in the clip volume is a hit, with its depth.",
              [](Script& s) {
                named(s, {[&] { dot(s, 20, 30, 1); }, [&] { dot(s, 70, 40, -7); }, [&] { dot(s, 130, 40); }});
              }),
      hit_row("lines", "A line is a hit, with the least and the greatest depth of its ends.",
              [](Script& s) {
                named(s, {[&] { line(s, 20, 30, 1, 50, 60, -3); }, [&] { line(s, 20, 30, -8, 50, 60, 2.5); },
                          [&] { line(s, 20, 130, 1, 50, 160, -3); }});
              }),
      hit_row("polygons", "A polygon is a hit, with the least and the greatest depth of its corners.",
              [](Script& s) {
                named(s, {[&] { shape(s, 30, 40, 1); }, [&] { box(s, 50, 50, 70, 60, -4); },
                          [&] { shape(s, 30, 140); }, [&] { slope(s); }});
              }),
      hit_row("one_record", "What is hit under the same names is one record, with the depths of all.",
              [](Script& s) {
                named(s, {[&] {
                        dot(s, 20, 30, -2);
                        dot(s, 20, 30, 2), shape(s, 40, 40, -9), dot(s, 50, 30, 300);
                      }});
              }),
      hit_row("nothing", "Without a hit there is no record.",
              [](Script& s) {
                selected(
                    s,
                    [&] {
                      s.InitNames(), s.PushName(3), dot(s, 140, 30), s.PushName(4), s.PopName(),
                          s.LoadName(8);
                    },
                    20);
              }),
      hit_row("without_names", "A hit without names is a record of no names.",
              [](Script& s) {
                selected(
                    s, [&] { dot(s, 40, 30, 1); }, 20);
              }),
      hit_row("depth_cut", "Depths are those of the vertices behind clipping.",
              [](Script& s) {
                named(s, {[&] { line(s, 20, 30, 1, 150, 60, -13); }, [&] { line(s, 20, 30, 9, 60, 60, -5); },
                          [&] { slope(s, 6); }});
              }),
      hit_row(
          "depth_cut_by_plane", "Clip planes cut what is selected, and its depths.",
          [](Script& s) {
            s.ClipPlane(GL_CLIP_PLANE1, V{-1, 0, 0, 0.1}), s.Enable(GL_CLIP_PLANE1);
            named(s, {[&] { line(s, 20, 30, 1, 90, 60, -13); }, [&] { dot(s, 80, 30); }, [&] { slope(s); },
                      [&] { shape(s, 75, 40); }});
          },
          "5.2, 2.12"),
      hit_row("around", "A polygon without a corner in the clip volume is a hit if it goes through it.",
              [](Script& s) {
                named(s, {[&] { box(s, -50, -60, 170, 150, -3); },
                          [&] {
                            s.Begin(GL_TRIANGLES), pixel_vertex(s, 90, 300, 1), pixel_vertex(s, 300, 90, 1),
                                pixel_vertex(s, 300, 300, 1), s.End();
                          },
                          [&] {
                            s.Begin(GL_TRIANGLES), pixel_vertex(s, -300, -200, 1),
                                pixel_vertex(s, 400, -150, -4), pixel_vertex(s, 30, 500, 2), s.End();
                          }});
              }),
      hit_row("region", "The matrices define the region in which something is selected.",
              [](Script& s) {
                s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Scalef(96 / 10.0, 96 / 10.0, 1),
                    s.Translatef(0.3, -0.2, 0), s.Ortho(-1.2, 1.2, -1.235, 1.195, 1, 20),
                    s.MatrixMode(GL_MODELVIEW);
                named(s, {[&] { shape(s, 33.6, 57.6, 1); }, [&] { shape(s, 70, 57); },
                          [&] { dot(s, 33.6, 57.6); }, [&] { dot(s, 48, 48); }});
              }),
      hit_row(
          "culled", "A polygon that is culled is no hit.",
          [](Script& s) {
            s.Enable(GL_CULL_FACE);
            named(s, {[&] { shape(s, 30, 40, 1); }, [&] { reversed_shape(s, 60, 40); },
                      [&] { dot(s, 20, 20); }});
          },
          "5.2, 3.5.1"),
      hit_row(
          "culled_front", "Which face is culled and which is the front matters as it does to pictures.",
          [](Script& s) {
            s.CullFace(GL_FRONT), s.Enable(GL_CULL_FACE);
            named(s, {[&] { shape(s, 30, 40, 1); }, [&] { reversed_shape(s, 60, 40); },
                      [&] { s.FrontFace(GL_CW), shape(s, 30, 40, 1); }});
          },
          "5.2, 3.5.1"),
      hit_row("polygon_mode", "The mode of polygons does not matter: the polygon itself is a hit.",
              [](Script& s) {
                s.PolygonMode(GL_FRONT_AND_BACK, GL_POINT), s.EdgeFlag(0);
                named(s, {[&] { box(s, -50, -60, 170, 150, -3); }, [&] { shape(s, 30, 40, 1); },
                          [&] { s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), box(s, -50, -60, 170, 150, 2); }});
              }),
      hit_row("offset", "The offset of polygons is not added to the depths.",
              [](Script& s) {
                s.PolygonOffset(4, 1000000), s.Enable(GL_POLYGON_OFFSET_FILL);
                named(s, {[&] { shape(s, 30, 40, 1); }, [&] { slope(s); }});
              }),
      hit_row(
          "depth_range", "Depths are those of the window.",
          [](Script& s) {
            s.DepthRange(0.75, 0.125),
                named(s, {[&] { shape(s, 30, 40, 1); }, [&] { line(s, 20, 30, 2, 50, 60, -11); }});
          },
          "5.2, 2.11.1"),
      hit_row("depth_ends", "The depths 0 and 1 are 0 and 2^32 - 1.",
              [](Script& s) {
                s.LoadIdentity(), s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.DepthRange(0, 0);
                named(s,
                      {[&] { s.Begin(GL_POINTS), s.Vertex2f(0.2, 0.1), s.End(); },
                       [&] { s.DepthRange(1, 1), s.Begin(GL_POINTS), s.Vertex2f(0.2, 0.1), s.End(); },
                       [&] { s.DepthRange(0.5, 0.5), s.Begin(GL_POINTS), s.Vertex2f(0.2, 0.1), s.End(); }});
              }),
      hit_row("raster_position", "A valid raster position is a hit, with its depth.",
              [](Script& s) {
                named(s, {[&] { raster_at(s, 30, 40, 1); }, [&] { raster_at(s, 130, 40, 1); },
                          [&] { raster_at(s, 50, 60, -9); }});
              }),
      hit_row(
          "window_position", "glWindowPos is always a hit.",
          [](Script& s) {
            named(s, {[&] { s.WindowPos3f(20, 30, 0.25); }, [&] { s.WindowPos3f(-500, 900, 0.7); }});
          },
          "5.2", kVersion14),
      hit_row(
          "images", "Bitmaps and pixel rectangles are no hits.",
          [](Script& s) {
            raster_at(s, 40.3, 40.4), s.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
            named(s, {[&] {
                        s.Bitmap(8, 1, 0, 0, 0, 0, Memory{GL_UNSIGNED_BYTE, {255}});
                      },
                      [&] {
                        s.DrawPixels(1, 1, GL_RED, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {255}});
                      },
                      [&] { s.CopyPixels(0, 0, 3, 3, GL_COLOR); }, [&] { dot(s, 30, 30); }});
          },
          "5.2, corollary 6"),
      hit_row("fragment_tests", "Tests of fragments and masks do not matter.",
              [](Script& s) {
                s.Scissor(0, 0, 0, 0), s.Enable(GL_SCISSOR_TEST), s.AlphaFunc(GL_NEVER, 0),
                    s.Enable(GL_ALPHA_TEST);
                s.DepthFunc(GL_NEVER), s.Enable(GL_DEPTH_TEST), s.ColorMask(0, 0, 0, 0);
                named(s, {[&] { shape(s, 30, 40, 1); }, [&] { dot(s, 20, 60, -3); }});
              }),
      hit_row("every_primitive", "Primitives of every kind are hits.",
              [](Script& s) {
                std::vector<std::function<void()>> scenes;
                for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; mode++)
                  scenes.push_back([&s, mode] {
                    s.Begin(mode);
                    for (int i = 0; i < 4; i++) {
                      const int place = mode == GL_TRIANGLE_STRIP || mode == GL_QUAD_STRIP ? i : i ^ (i >> 1);
                      pixel_vertex(s, place % 2 ? 61.3 : 20.2, place / 2 ? 70.1 : 33.4,
                                   1.5 - mode - i * 0.25);
                    }
                    s.End();
                  });
                named(s, scenes);
              }),
      hit_row(
          "arrays", "Primitives of arrays and rectangles are hits.",
          [](Script& s) {
            s.EnableClientState(GL_VERTEX_ARRAY);
            s.VertexPointer(3, GL_FLOAT, 0, Memory{GL_FLOAT, {-0.8, -0.7, 1, 0.8, -0.6, -2, 0.1, 0.9, -3}});
            named(s, {[&] { s.DrawArrays(GL_TRIANGLES, 0, 3); },
                      [&] {
                        s.DrawElements(GL_LINES, 2, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {1, 2}});
                      },
                      [&] { s.Rectf(-0.4, -0.3, 0.5, 0.6); }, [&] { s.Rectf(2, 2, 3, 3); }});
          },
          "5.2, 2.8, 2.10"),
      no_hit_row("draws_nothing", "Selection writes no fragments.",
                 [](Script& s) { tint(s, 0), box(s, 10, 10, 90, 90), star(s); }),
      no_hit_row("clears_nothing", "glClear changes nothing while something is selected.",
                 [](Script& s) { s.ClearColor(1, 1, 1, 1), s.Clear(GL_COLOR_BUFFER_BIT); }),
      no_hit_row(
          "images_draw_nothing", "Bitmaps and pixel rectangles are not drawn while something is selected.",
          [](Script& s) {
            raster_at(s, 30.3, 30.2), s.PixelZoom(9, 9), s.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
            s.DrawPixels(3, 1, GL_RED, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {200, 100, 90}});
            s.CopyPixels(0, 0, 5, 5, GL_COLOR), s.Bitmap(8, 1, 0, 0, 0, 0, Memory{GL_UNSIGNED_BYTE, {255}});
          }),
      hit_row(
          "state_changes", "State goes on changing while something is selected.",
          [](Script& s) {
            selected(s, [&] {
              s.Translatef(0.3, 0.2, 0), tint(s, 5), s.Viewport(20, 10, 50, 60), s.PointSize(11);
            });
            dot(s, 40, 50), arrow(s);
          },
          "5.2, corollary 18"),
  };
}

} // namespace softgl::suite
