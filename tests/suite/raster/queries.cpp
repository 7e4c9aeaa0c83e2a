// Occlusion queries (4.1.7, 6.1.12).
#include "pixels/scenes.h"
#include "raster/chapter.h"
#include "raster/scenes.h"
#include "script/fed_values.h"

namespace softgl::suite {
namespace {

constexpr Need kQueries{15};

Test counted(const char* name, const char* sentence, std::function<void(Script&)> body,
             const char* section = "4.1.7") {
  return raster_test(std::string("query.") + name, section, sentence, std::move(body), kQueries);
}
// The count of what is drawn is seen at the lower border.
void query(Script& s, int number, const std::function<void()>& draw) {
  s.BeginQuery(GL_SAMPLES_PASSED, 40 + number), draw(), s.EndQuery(GL_SAMPLES_PASSED);
}
void show(Script& s, int number) { s.PaintQuery(40 + number, 20 * (number % 4), 8 * (number / 4)); }
// The name of the query that counts is this one.
void current(Script& s, int name) { s.GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, V{double(name)}); }
void result(Script& s, int number, double count) {
  s.GetQueryObjectuiv(40 + number, GL_QUERY_RESULT, V{count});
}

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
      counted("comparisons", "Fragments count that pass the depth test, whatever it compares.",
              [](Script& s) {
                const auto boxes = [&](double nearer) {
                  box(s, 10, 20, 43, 40), box(s, 10, 42, 27, 60, nearer), box(s, 50, 20, 59, 70, -nearer);
                };
                s.Enable(GL_DEPTH_TEST), tint(s, 2), boxes(0), s.DepthMask(0), tint(s, 3);
                for (int i = 0; i < 8; i++)
                  s.DepthFunc(kComparisons[i].second), query(s, i, [&] { boxes(2); });
                s.Disable(GL_DEPTH_TEST);
                for (int i = 0; i < 8; i++) show(s, i);
              }),
      counted("stencil_and_depth",
              "What the stencil test lets through and the depth test does not, does not count.",
              [](Script& s) {
                s.Enable(GL_STENCIL_TEST), s.Enable(GL_DEPTH_TEST), s.StencilFunc(GL_ALWAYS, 1, 255),
                    s.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE), tint(s, 2), box(s, 10, 20, 51, 60);
                s.Disable(GL_STENCIL_TEST), tint(s, 4), box(s, 30, 40, 80, 90, 3), s.Enable(GL_STENCIL_TEST);
                s.StencilFunc(GL_EQUAL, 1, 255), query(s, 0, [&] { tint(s, 1), box(s, 20, 30, 80, 80, 1); });
                show(s, 0);
              }),
      counted("cut", "What is cut away does not count.",
              [](Script& s) {
                s.ClipPlane(GL_CLIP_PLANE1, V{-1, 0, 0, 0}), s.Enable(GL_CLIP_PLANE1), tint(s, 1);
                query(s, 0, [&] { box(s, 21, 20, 70, 61), box(s, -40, 70, 200, 83); }), show(s, 0);
              }),
      counted("culled", "A polygon that is culled counts nothing.",
              [](Script& s) {
                s.Enable(GL_CULL_FACE), tint(s, 1);
                query(s, 0, [&] { box(s, 61, 20, 30, 50), box(s, 20, 55, 71, 80); }), show(s, 0);
              }),
      counted("stipple", "The pixels that a stipple leaves out do not count.",
              [](Script& s) {
                s.PolygonStipple(Memory{GL_UNSIGNED_BYTE, std::vector<double>(128, 0x33)}),
                    s.Enable(GL_POLYGON_STIPPLE), tint(s, 3);
                query(s, 0, [&] { box(s, 20, 20, 61, 60); }), show(s, 0);
              }),
      counted("line", "Fragments of lines count.",
              [](Script& s) {
                s.LineWidth(3), tint(s, 1);
                query(s, 0, [&] {
                  s.Begin(GL_LINES), pixel_vertex(s, 10.2, 30.5), pixel_vertex(s, 81.3, 30.5), s.End();
                });
                show(s, 0);
              }),
      counted("copied", "Fragments of pixels that are copied count.",
              [](Script& s) {
                tint(s, 0), box(s, 10, 20, 30, 40), tint(s, 3), box(s, 20, 25, 35, 50), place(s, 45.3, 30.2);
                query(s, 0, [&] { s.CopyPixels(12, 22, 21, 17, GL_COLOR); });
                query(s, 1, [&] {
                  s.PixelZoom(2, 3), place(s, 50.3, 54.2), s.CopyPixels(15, 24, 13, 9, GL_COLOR);
                });
                show(s, 0), show(s, 1);
              }),
      counted("cleared", "A clear has no fragments.",
              [](Script& s) {
                tint(s, 2), box(s, 10, 20, 80, 80), s.Scissor(20, 30, 40, 30), s.Enable(GL_SCISSOR_TEST);
                query(s, 0, [&] {
                  s.ClearColor(1, 0.5, 0, 1), s.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                });
                s.Disable(GL_SCISSOR_TEST), show(s, 0);
              }),
      counted("no_buffer", "Fragments count if no buffer is drawn to, too.",
              [](Script& s) {
                tint(s, 2), box(s, 10, 20, 60, 60), s.DrawBuffer(GL_NONE);
                query(s, 0, [&] { tint(s, 1), box(s, 20, 30, 81, 80); }), s.DrawBuffer(GL_FRONT_AND_BACK),
                    show(s, 0);
              }),
      counted(
          "other_modes", "What is selected or fed back has no fragments.",
          [](Script& s) {
            s.SelectBuffer(40, V(40, kUntouchedName)), s.FeedbackBuffer(60, GL_2D, V(60, kUntouchedFeedback)),
                tint(s, 4);
            query(s, 0, [&] {
              s.RenderMode(GL_SELECT), box(s, 10, 20, 80, 50), s.RenderMode(GL_FEEDBACK),
                  box(s, 10, 20, 80, 80), s.RenderMode(GL_RENDER), box(s, 30, 25, 73, 60);
            });
            show(s, 0);
          },
          "4.1.7, 5.2, 5.3"),
      counted(
          "lists", "A list begins or ends a query when it is executed.",
          [](Script& s) {
            s.NewList(5, GL_COMPILE), s.BeginQuery(GL_SAMPLES_PASSED, 40), tint(s, 0), box(s, 10, 20, 33, 50),
                s.EndList();
            s.NewList(6, GL_COMPILE), tint(s, 1), box(s, 60, 40, 81, 80), s.EndQuery(GL_SAMPLES_PASSED),
                s.EndList();
            current(s, 0), tint(s, 2), box(s, 5, 80, 45, 90), s.CallList(5), current(s, 40),
                box(s, 20, 52, 58, 71), s.CallList(6), current(s, 0), show(s, 0);
          },
          "4.1.7, 5.4"),
      counted("attributes", "glPushAttrib and glPopAttrib do not matter to a query.",
              [](Script& s) {
                s.PushAttrib(GL_ALL_ATTRIB_BITS), s.BeginQuery(GL_SAMPLES_PASSED, 40), tint(s, 1),
                    box(s, 10, 20, 43, 60), s.PopAttrib(), tint(s, 2), box(s, 50, 30, 83, 70),
                    s.EndQuery(GL_SAMPLES_PASSED), show(s, 0);
              }),
      counted("flushed", "glFlush and glFinish do not matter to a query.",
              [](Script& s) {
                query(s, 0, [&] {
                  tint(s, 0), box(s, 10, 20, 33, 60), s.Flush(), tint(s, 1), box(s, 40, 20, 61, 80);
                  s.Finish(), tint(s, 2), box(s, 65, 20, 88, 70);
                });
                show(s, 0);
              }),
      counted(
          "results", "The count of a query can be asked for again and again, and is there then.",
          [](Script& s) {
            query(s, 0, [&] { tint(s, 0), box(s, 10, 20, 53, 61); });
            query(s, 1, [&] { tint(s, 1), box(s, 30, 30, 41, 80); }), query(s, 2, [] {});
            for (int i = 0; i < 2; i++) {
              result(s, 0, 43 * 41), result(s, 1, 11 * 50), result(s, 2, 0);
              for (int k = 0; k < 3; k++) s.GetQueryObjectuiv(40 + k, GL_QUERY_RESULT_AVAILABLE, V{1});
            }
            result(s, 0, 43 * 41);
          },
          "4.1.7, 6.1.12"),
      counted(
          "current", "The query that counts can be asked for; its name is 0 if there is none.",
          [](Script& s) {
            current(s, 0), query(s, 0, [&] { current(s, 40), tint(s, 1), box(s, 20, 20, 60, 60); });
            current(s, 0), query(s, 7, [&] { current(s, 47), tint(s, 2), box(s, 40, 40, 80, 80); });
            current(s, 0), query(s, 0, [&] { current(s, 40); }), current(s, 0);
          },
          "6.1.12"),
      counted(
          "is_query", "A name is that of a query from its first glBeginQuery to glDeleteQueries.",
          [](Script& s) {
            s.IsQuery(0, 0), s.IsQuery(40, 0), query(s, 0, [&] { s.IsQuery(40, 1), s.IsQuery(41, 0); });
            s.IsQuery(40, 1), query(s, 1, [&] { tint(s, 1), box(s, 20, 20, 60, 60); }), s.IsQuery(41, 1);
            s.DeleteQueries(1, V{40}), s.IsQuery(40, 0), s.IsQuery(41, 1), s.DeleteQueries(2, V{41, 0}),
                s.IsQuery(41, 0), s.IsQuery(0, 0);
          },
          "6.1.12"),
      counted("made_again", "A name that was deleted is free for a query, which counts from 0.",
              [](Script& s) {
                query(s, 0, [&] { tint(s, 0), box(s, 10, 20, 80, 80); }), s.DeleteQueries(1, V{40}),
                    s.IsQuery(40, 0);
                query(s, 0, [&] { tint(s, 1), box(s, 20, 30, 43, 47); }), s.IsQuery(40, 1), show(s, 0);
              }),
  };
}

} // namespace softgl::suite
