// Feedback (5.3): what stands in the buffer, and what the buffer takes.
#include "special/chapter.h"
#include "special/scenes.h"

namespace softgl::suite {
namespace {

Test feedback_row(const char* name, const char* sentence, std::function<void(Script&)> body,
                  const char* section = "5.3", Need need = {}) {
  return special_test(std::string("feedback.") + name, section, sentence, std::move(body), need);
}

// A point, a line and a triangle.
void one_of_each(Script& s) {
  shape(s, 25, 24, 0.4, GL_POINTS), s.Begin(GL_LINES), corner(s, 3, 12.4, 55.3, -2),
      corner(s, 5, 40.2, 71.6, 1), s.End(), shape(s, 66, 58, -1.1);
}

Test type_row(const char* name, GLenum type, const char* sentence, int size = 8) {
  return feedback_row(
      name, sentence,
      [=](Script& s) {
        fed_back(
            s, type, [&] { one_of_each(s); }, FedOrder::InOrder, size);
      },
      "5.3, table 5.2");
}

void points(Script& s, int count) {
  s.Begin(GL_POINTS);
  for (int i = 0; i < count; i++) pixel_vertex(s, 10.3 + 9 * i, 80.1 - 11 * i);
  s.End();
}

void strip(Script& s, GLenum mode, int count = 5) {
  s.Begin(mode);
  for (int i = 0; i < count; i++) corner(s, i, 12.3 + 17 * i, i % 2 ? 70.2 + 3 * i : 20.4 + 5 * i);
  s.End();
}

// Whether the mode draws nothing: what is seen was drawn before and behind it.
Test no_feedback_row(const char* name, const char* sentence, std::function<void(Script&)> inside) {
  return feedback_row(
      name, sentence,
      [=](Script& s) {
        tint(s, 1), box(s, 20, 22, 52, 61), s.FeedbackBuffer(300, GL_2D, V(300, kUntouchedFeedback)),
            s.RenderMode(GL_FEEDBACK), inside(s), s.RenderMode(GL_RENDER), tint(s, 4), box(s, 61, 40, 88, 80);
      },
      "5.3, corollary 18");
}

} // namespace

std::vector<Test> special_feedback_tests() {
  return {
      type_row("2d", GL_2D, "GL_2D gives x and y of each vertex."),
      type_row("3d", GL_3D, "GL_3D gives x, y and z of each vertex."),
      type_row("3d_color", GL_3D_COLOR, "GL_3D_COLOR gives x, y, z and the color."),
      type_row("3d_color_texture", GL_3D_COLOR_TEXTURE,
               "GL_3D_COLOR_TEXTURE gives x, y, z, the color and the texture coordinates.", 6),
      type_row("4d_color_texture", GL_4D_COLOR_TEXTURE,
               "GL_4D_COLOR_TEXTURE gives x, y, z, w, the color and the texture coordinates.", 6),
      feedback_row("points", "A point is GL_POINT_TOKEN and a vertex.",
                   [](Script& s) { fed_back(s, GL_3D, [&] { points(s, 6); }); }),
      feedback_row("lines", "A line is a token and two vertices, from its beginning to its end.",
                   [](Script& s) {
                     fed_back(
                         s, GL_3D_COLOR, [&] { star(s, 12); }, FedOrder::InOrder, 6);
                   }),
      feedback_row("line_strip", "Each line of a strip has its own token and vertices.",
                   [](Script& s) { fed_back(s, GL_3D_COLOR, [&] { strip(s, GL_LINE_STRIP); }); }),
      feedback_row("line_loop", "The line that closes a loop is one, too.",
                   [](Script& s) { fed_back(s, GL_3D_COLOR, [&] { strip(s, GL_LINE_LOOP); }); }),
      feedback_row(
          "reset_lines", "Before each line of GL_LINES the stipple is reset: GL_LINE_RESET_TOKEN.",
          [](Script& s) {
            fed_back(
                s, GL_2D, [&] { star(s); }, FedOrder::Resets);
          },
          "5.3, 3.4.2"),
      feedback_row(
          "reset_strip", "In a strip the stipple is reset before the first line only.",
          [](Script& s) {
            fed_back(
                s, GL_2D, [&] { strip(s, GL_LINE_STRIP), strip(s, GL_LINE_STRIP, 3); }, FedOrder::Resets);
          },
          "5.3, 3.4.2"),
      feedback_row(
          "reset_loop", "In a loop the stipple is reset before the first line only.",
          [](Script& s) {
            fed_back(
                s, GL_2D, [&] { strip(s, GL_LINE_LOOP); }, FedOrder::Resets);
          },
          "5.3, 3.4.2"),
      feedback_row("triangles", "A triangle is GL_POLYGON_TOKEN, 3 and three vertices.",
                   [](Script& s) {
                     fed_back(s, GL_3D_COLOR,
                              [&] { shape(s, 24, 30), shape(s, 70, 25, 1), shape(s, 50, 70, -2); });
                   }),
      feedback_row("triangle_strip", "Each triangle of a strip is a polygon.",
                   [](Script& s) { fed_back(s, GL_2D, [&] { strip(s, GL_TRIANGLE_STRIP); }); }),
      feedback_row("triangle_fan", "Each triangle of a fan is a polygon.",
                   [](Script& s) {
                     fed_back(s, GL_2D, [&] {
                       s.Begin(GL_TRIANGLE_FAN), pixel_vertex(s, 40.2, 44.3);
                       for (int i = 0; i < 5; i++)
                         pixel_vertex(s, 40.2 + 30 * std::cos(1.2 * i + 0.3),
                                      44.3 + 31 * std::sin(1.2 * i + 0.3));
                       s.End();
                     });
                   }),
      feedback_row("quads", "A quadrilateral is a polygon, or the triangles that it is cut into.",
                   [](Script& s) {
                     fed_back(
                         s, GL_3D, [&] { box(s, 11, 12, 33, 40.6, 1), box(s, 44, 51, 78, 84.2, -3); },
                         FedOrder::AnyOrder);
                   }),
      feedback_row("quad_strip", "The quadrilaterals of a strip are polygons, or triangles.",
                   [](Script& s) {
                     fed_back(
                         s, GL_3D_COLOR,
                         [&] {
                           s.Begin(GL_QUAD_STRIP);
                           for (int i = 0; i < 6; i++)
                             corner(s, i, 12.1 + 30 * (i / 2), i % 2 ? 71.3 + i : 21.7 - i, 0.5 * i);
                           s.End();
                         },
                         FedOrder::AnyOrder);
                   }),
      feedback_row("polygon", "A polygon of many corners is one, or the triangles that it is cut into.",
                   [](Script& s) {
                     fed_back(
                         s, GL_3D_COLOR,
                         [&] {
                           s.Begin(GL_POLYGON);
                           for (int i = 0; i < 7; i++)
                             corner(s, i, 47.2 + 33 * std::cos(0.9 * i + 0.23),
                                    46.1 + 37 * std::sin(0.9 * i + 0.23), 1);
                           s.End();
                         },
                         FedOrder::AnyOrder);
                   }),
      feedback_row(
          "rectangle", "A rectangle is a polygon.",
          [](Script& s) {
            fed_back(
                s, GL_2D, [&] { s.Rectf(-0.9, -0.61, 0.43, 0.87); }, FedOrder::AnyOrder);
          },
          "5.3, 2.10"),
      feedback_row(
          "marks",
          "glPassThrough writes GL_PASS_THROUGH_TOKEN and its number, between the primitives in their order.",
          [](Script& s) {
            fed_back(s, GL_2D, [&] {
              s.PassThrough(7), points(s, 1), s.PassThrough(-3.25), shape(s, 40, 40), s.PassThrough(1201.5),
                  s.PassThrough(0), strip(s, GL_LINE_STRIP, 2), s.PassThrough(41);
            });
          }),
      feedback_row("marks_outside", "glPassThrough does nothing outside of feedback.",
                   [](Script& s) {
                     s.PassThrough(9), tint(s, 2), box(s, 30, 20, 50, 40);
                     fed_back(s, GL_2D, [&] { s.PassThrough(11); }), s.PassThrough(12);
                     fed_back(s, GL_2D, [&] { points(s, 2); });
                   }),
      feedback_row("result",
                   "glRenderMode returns how many numbers were written, and the buffer begins anew.",
                   [](Script& s) {
                     s.FeedbackBuffer(90, GL_3D, V(90, kUntouchedFeedback)), s.RenderMode(GL_FEEDBACK),
                         points(s, 7), s.RenderMode(GL_FEEDBACK), points(s, 2), s.RenderMode(GL_RENDER),
                         s.PaintFeedback(2, 8);
                   }),
      feedback_row("result_of_render", "In the mode that renders glRenderMode returns 0.",
                   [](Script& s) {
                     s.FeedbackBuffer(40, GL_3D, V(40, kUntouchedFeedback)), s.RenderMode(GL_FEEDBACK),
                         points(s, 3), s.RenderMode(GL_RENDER), s.RenderMode(GL_RENDER),
                         s.PaintFeedback(2, 8);
                   }),
      feedback_row("nothing", "Without a primitive nothing is written.",
                   [](Script& s) {
                     fed_back(
                         s, GL_3D, [&] { tint(s, 3); }, FedOrder::Raw, 8, 20);
                   }),
      feedback_row("overflow", "If the buffer is too small, it is filled and glRenderMode returns -1.",
                   [](Script& s) {
                     fed_back(
                         s, GL_3D, [&] { points(s, 6); }, FedOrder::Raw, 8, 14);
                   }),
      feedback_row("overflow_in_mark", "A block that does not fit is written in part.",
                   [](Script& s) {
                     fed_back(
                         s, GL_2D, [&] { points(s, 2), s.PassThrough(33), points(s, 1); }, FedOrder::Raw, 8,
                         7);
                   }),
      feedback_row("no_overflow", "A buffer that is full to its last number is no overflow.",
                   [](Script& s) {
                     fed_back(
                         s, GL_3D, [&] { points(s, 5); }, FedOrder::Raw, 8, 20);
                   }),
      feedback_row("overflow_is_over", "The overflow is forgotten when glRenderMode has returned -1.",
                   [](Script& s) {
                     fed_back(
                         s, GL_3D, [&] { points(s, 6); }, FedOrder::Raw, 8, 14),
                         s.RenderMode(GL_FEEDBACK), points(s, 2), s.RenderMode(GL_RENDER),
                         s.PaintFeedback(2, 8);
                   }),
      feedback_row("no_room", "A buffer of no numbers is filled by the first.",
                   [](Script& s) {
                     fed_back(
                         s, GL_3D, [&] { points(s, 1); }, FedOrder::Raw, 8, 0);
                   }),
      no_feedback_row("draws_nothing", "Feedback writes no fragments.",
                      [](Script& s) { tint(s, 0), box(s, 10, 10, 90, 90), star(s), points(s, 7); }),
      no_feedback_row(
          "clears_nothing", "glClear changes nothing while there is feedback.",
          [](Script& s) { s.ClearColor(1, 1, 1, 1), s.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }),
      no_feedback_row("images_draw_nothing",
                      "Bitmaps and pixel rectangles are not drawn while there is feedback.",
                      [](Script& s) {
                        raster_at(s, 30.3, 30.2), s.PixelZoom(4, 4), s.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
                        s.DrawPixels(3, 2, GL_RED, GL_UNSIGNED_BYTE,
                                     Memory{GL_UNSIGNED_BYTE, {200, 100, 90, 80, 70, 10}});
                        s.CopyPixels(0, 0, 5, 5, GL_COLOR);
                        s.Bitmap(8, 3, 0, 0, 0, 0, Memory{GL_UNSIGNED_BYTE, {255, 255, 255}});
                      }),
      feedback_row(
          "depths_stay", "Feedback leaves the depths.",
          [](Script& s) {
            s.Enable(GL_DEPTH_TEST), s.FeedbackBuffer(300, GL_2D, V(300, kUntouchedFeedback)),
                s.RenderMode(GL_FEEDBACK), box(s, 10, 10, 90, 90, 3), s.RenderMode(GL_RENDER), tint(s, 3),
                slope(s);
          },
          "5.3, corollary 18"),
      feedback_row(
          "state_changes", "State goes on changing while there is feedback.",
          [](Script& s) {
            fed_back(s, GL_2D, [&] {
              s.Translatef(0.3, 0.2, 0), tint(s, 5), s.Viewport(20, 10, 50, 60), s.PointSize(11);
            });
            dot(s, 40, 50), arrow(s);
          },
          "5.3, corollary 18"),
      feedback_row(
          "arrays", "Arrays are fed back as other primitives.",
          [](Script& s) {
            s.EnableClientState(GL_VERTEX_ARRAY);
            s.VertexPointer(2, GL_FLOAT, 0, Memory{GL_FLOAT, {-0.8, -0.7, 0.8, -0.6, 0.1, 0.9, -0.7, 0.6}});
            fed_back(s, GL_2D, [&] {
              s.DrawArrays(GL_TRIANGLES, 0, 3),
                  s.DrawElements(GL_LINES, 4, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {3, 1, 2, 0}});
            });
          },
          "5.3, 2.8"),
  };
}

} // namespace softgl::suite
