// Occlusion queries (4.1.7).
#include "pixels/scenes.h"
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

constexpr Need kQueries{15};

Test counted(const char* name, const char* sentence, std::function<void(Script&)> body) {
  return raster_test(std::string("query.") + name, "4.1.7", sentence, std::move(body), kQueries);
}
// The count of what is drawn is seen at the lower border.
void query(Script& s, int number, const std::function<void()>& draw) {
  s.BeginQuery(GL_SAMPLES_PASSED, 40 + number), draw(), s.EndQuery(GL_SAMPLES_PASSED);
}
void show(Script& s, int number) { s.PaintQuery(40 + number, 20 * number, 0); }

} // namespace

std::vector<Test> raster_query_tests() {
  return {
      counted("fragments", "Each fragment counts.",
              [](Script& s) { query(s, 0, [&] { tint(s, 0), box(s, 10, 20, 53, 61); }), show(s, 0); }),
      counted("overdraw", "A pixel that is drawn twice counts twice.",
              [](Script& s) {
                query(s, 0, [&] { tint(s, 0), box(s, 10, 20, 50, 60), tint(s, 1), box(s, 30, 30, 80, 80); }),
                    show(s, 0);
              }),
      counted("depth", "Fragments that fail the depth test do not count.",
              [](Script& s) {
                s.Enable(GL_DEPTH_TEST), tint(s, 0), box(s, 10, 20, 50, 60, 1);
                query(s, 0, [&] { tint(s, 1), box(s, 31, 30, 80, 80, -1); }), show(s, 0);
              }),
      counted("other_tests", "Fragments that fail the scissor, alpha or stencil test do not count.",
              [](Script& s) {
                s.ClearStencil(0), s.Clear(GL_STENCIL_BUFFER_BIT), s.Scissor(20, 30, 41, 37),
                    s.Enable(GL_SCISSOR_TEST);
                query(s, 0, [&] { tint(s, 1), box(s, 10, 20, 80, 80); }), s.Disable(GL_SCISSOR_TEST);
                s.AlphaFunc(GL_GREATER, 0.5), s.Enable(GL_ALPHA_TEST);
                query(s, 1, [&] {
                  s.Color4f(1, 1, 0, 0.2), box(s, 10, 70, 50, 90), s.Color4f(0, 1, 1, 0.9),
                      box(s, 50, 70, 83, 90);
                });
                s.Disable(GL_ALPHA_TEST), s.StencilFunc(GL_EQUAL, 1, 255), s.Enable(GL_STENCIL_TEST);
                query(s, 2, [&] { tint(s, 0), box(s, 10, 20, 80, 80); }), s.Disable(GL_STENCIL_TEST);
                for (int i = 0; i < 3; i++) show(s, i);
              }),
      counted("masks", "Masks and blending do not matter.",
              [](Script& s) {
                s.Enable(GL_DEPTH_TEST), s.ColorMask(0, 0, 0, 0), s.DepthMask(0);
                query(s, 0, [&] { tint(s, 0), box(s, 10, 20, 53, 61); }), s.ColorMask(1, 1, 1, 1), show(s, 0),
                    tint(s, 1), box(s, 30, 30, 70, 70);
              }),
      counted("lines_and_points", "Fragments of points count, too.",
              [](Script& s) {
                s.PointSize(7), tint(s, 3);
                query(s, 0, [&] {
                  s.Begin(GL_POINTS);
                  for (int i = 0; i < 11; i++) pixel_vertex(s, 12.3 + 7 * i, 20.2 + 6 * i);
                  s.End();
                });
                show(s, 0);
              }),
      counted("bitmap", "Fragments of bitmaps and images count.",
              [](Script& s) {
                s.Color3f(0.9, 0.8, 0.2), s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), place(s, 28.3, 33.2);
                query(s, 0, [&] {
                  s.Bitmap(8, 8, 0, 0, 0, 0, Memory{GL_UNSIGNED_BYTE, {1, 2, 4, 255, 15, 60, 129, 80}});
                });
                query(s, 1, [&] {
                  s.PixelZoom(5, 6), place(s, 45.3, 48.2),
                      s.DrawPixels(6, 5, GL_RED, GL_UNSIGNED_BYTE,
                                   Memory{GL_UNSIGNED_BYTE, std::vector<double>(30, 200)});
                });
                show(s, 0), show(s, 1);
              }),
      counted("begins_with_0", "A query that is begun again counts from 0.",
              [](Script& s) {
                query(s, 0, [&] { tint(s, 0), box(s, 10, 20, 80, 80); });
                query(s, 0, [&] { tint(s, 1), box(s, 20, 30, 43, 47); }), show(s, 0);
              }),
      counted("nothing", "Without a fragment the count is 0.",
              [](Script& s) { tint(s, 2), box(s, 10, 20, 80, 80), query(s, 0, [] {}), show(s, 0); }),
      counted("outside", "What is drawn behind the end of a query does not count.",
              [](Script& s) {
                tint(s, 1), box(s, 10, 20, 40, 80), query(s, 0, [&] { box(s, 50, 20, 60, 33); }),
                    box(s, 70, 20, 90, 80), show(s, 0);
              }),
      counted("several", "Each query keeps its count.",
              [](Script& s) {
                for (int i = 0; i < 4; i++)
                  query(s, i, [&] { tint(s, i), box(s, 8 + 20 * i, 20, 20 + 21 * i, 40 + 11 * i); });
                for (int i = 0; i < 4; i++) show(s, i);
              }),
      counted("deleted", "Names that are no query's are ignored when they are deleted.",
              [](Script& s) {
                query(s, 0, [&] { tint(s, 0), box(s, 10, 20, 53, 61); }), s.DeleteQueries(3, V{0, 977, 978}),
                    show(s, 0);
              }),
  };
}

} // namespace softgl::suite
