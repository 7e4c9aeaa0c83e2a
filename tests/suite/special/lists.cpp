// Special functions in display lists (5.4), and the indices of lists.
#include "special/chapter.h"
#include "special/evaluated.h"

namespace softgl::suite {
namespace {

Test list_row(const std::string& name, const char* sentence, std::function<void(Script&)> body,
              const char* section = "5.4") {
  return special_test("list." + name, section, sentence, std::move(body));
}

void list(Script& s, int name, const std::function<void()>& commands, GLenum mode = GL_COMPILE) {
  s.NewList(name, mode), commands(), s.EndList();
}

} // namespace

std::vector<Test> special_list_tests() {
  return {
      list_row(
          "marks", "A list holds glPassThrough, in its order among the primitives.",
          [](Script& s) {
            list(s, 1, [&] {
              s.PassThrough(4), dot(s, 20, 30), s.PassThrough(5), shape(s, 60, 40), s.PassThrough(6);
            });
            fed_back(s, GL_2D, [&] { s.PassThrough(1), s.CallList(1), s.PassThrough(2), s.CallList(1); });
          },
          "5.4, 5.3"),
      list_row(
          "names", "A list holds the commands of names.",
          [](Script& s) {
            list(s, 1,
                 [&] { s.PushName(4), dot(s, 20, 30, 1), s.LoadName(5), dot(s, 20, 30, -3), s.PopName(); });
            list(s, 2, [&] { s.InitNames(); });
            selected(s,
                     [&] { s.PushName(9), s.CallList(1), s.CallList(2), dot(s, 40, 50, 2), s.CallList(1); });
          },
          "5.4, 5.2"),
      list_row(
          "names_not_at_compile",
          "While a list is compiled its names are not pushed, and its points are no hits.",
          [](Script& s) {
            selected(s, [&] {
              s.PushName(3), list(s, 1, [&] { s.PushName(4), dot(s, 20, 30, 1); }), dot(s, 30, 40, -2),
                  s.CallList(1), s.PushName(5);
            });
          },
          "5.4, 5.2"),
      list_row(
          "feedback_executed",
          "A list that is executed while it is compiled is fed back then, and when it is called.",
          [](Script& s) {
            fed_back(s, GL_2D, [&] {
              list(
                  s, 1, [&] { s.PassThrough(4), dot(s, 20, 30), shape(s, 60, 40); }, GL_COMPILE_AND_EXECUTE),
                  s.PassThrough(7), s.CallList(1);
            });
          },
          "5.4, 5.3"),
      list_row(
          "render_mode",
          "glRenderMode, glFeedbackBuffer and glSelectBuffer are executed at once, and are not in the list.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), s.FeedbackBuffer(40, GL_2D, V(40, kUntouchedFeedback)),
                s.SelectBuffer(40, V(40, kUntouchedName));
            s.RenderMode(GL_FEEDBACK), dot(s, 20, 30), s.EndList(), dot(s, 30, 40), s.CallList(1),
                s.RenderMode(GL_RENDER);
            s.PaintFeedback(2, 8), tint(s, 3), s.PointSize(9), s.CallList(1);
          }),
      list_row(
          "evaluation", "A list holds evaluations, which take the maps of when it is called.",
          [](Script& s) {
            arch(s), list(s, 1, [&] { s.Begin(GL_POINTS), s.EvalCoord1f(0.2), s.EvalCoord1f(0.7), s.End(); });
            fed_back(s, GL_3D, [&] {
              s.CallList(1), s.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, V{-0.6, 0.2, 0.3, 0.9, -0.8, 0.1}),
                  s.CallList(1);
            });
          },
          "5.4, 5.1"),
      list_row(
          "evaluation_executed",
          "Evaluations of a list that is executed while it is compiled are evaluated again when it is "
          "called.",
          [](Script& s) {
            arch(s);
            fed_back(s, GL_3D, [&] {
              list(
                  s, 1, [&] { s.Begin(GL_POINTS), s.EvalCoord1f(0.2), s.EvalCoord1f(0.7), s.End(); },
                  GL_COMPILE_AND_EXECUTE);
              s.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, V{-0.6, 0.2, 0.3, 0.9, -0.8, 0.1}), s.CallList(1);
            });
          },
          "5.4, 5.1"),
      list_row(
          "map", "A list holds maps and grids, and takes control points when it is compiled.",
          [](Script& s) {
            list(s, 1, [&] {
              hill(s), hill_colors(s), s.MapGrid2f(2, 0, 1, 2, 0.2, 0.8), s.EvalMesh2(GL_POINT, 0, 2, 0, 2);
            });
            fed_back(s, GL_3D_COLOR, [&] { s.CallList(1); });
          },
          "5.4, 5.1"),
      list_row(
          "evaluation_in_begin", "A list of evaluations may be called between glBegin and glEnd.",
          [](Script& s) {
            arch(s), arch_colors(s), list(s, 1, [&] { s.EvalCoord1f(0.1), s.EvalCoord1f(0.5); });
            fed_back(s, GL_3D_COLOR, [&] {
              s.Begin(GL_LINE_STRIP), s.CallList(1), tint(s, 3), pixel_vertex(s, 80, 20), s.CallList(1),
                  s.End();
            });
          },
          "5.4, 5.1"),
      list_row(
          "error_of_map", "A wrong glMap in a list raises its error when the list is called.",
          [](Script& s) {
            arch(s), s.MapGrid1f(1, 0, 1), list(s, 1, [&] { s.MapGrid1f(0, 0, 1); }), s.CallList(1),
                s.raises(GL_INVALID_VALUE);
            list(s, 2, [&] { s.EvalMesh1(GL_FILL, 0, 1); }), s.CallList(2), s.raises(GL_INVALID_ENUM);
            tint(s, 2), s.PointSize(7), s.EvalMesh1(GL_POINT, 0, 1), box(s, 30, 10, 60, 30);
          },
          "5.4, corollary 9"),
      list_row("nesting", "Lists may call lists at least 64 deep.",
               [](Script& s) {
                 s.PaintInteger(GL_MAX_LIST_NESTING, 64, 1e9, 0, 0),
                     list(s, 1, [&] { tint(s, 4), box(s, 30, 40, 70, 80); });
                 for (int i = 2; i <= 64; i++) list(s, i, [&] { s.CallList(i - 1); });
                 s.CallList(64);
               }),
      list_row("is_list", "glIsList says whether there is a list.",
               [](Script& s) {
                 s.IsList(3, 0), s.IsList(0, 0), list(s, 3, [&] { arrow(s); }), list(s, 5, [] {}),
                     s.IsList(3, 1), s.IsList(5, 1), s.IsList(4, 0);
                 s.DeleteLists(3, 1), s.IsList(3, 0), s.IsList(5, 1), s.DeleteLists(1, 9), s.IsList(5, 0),
                     s.DeleteLists(7, 0), arrow(s);
               }),
      list_row("deleted_does_nothing", "A list that is not there does nothing when it is called.",
               [](Script& s) {
                 list(s, 3, [&] { s.Translatef(9, 9, 9); }), s.DeleteLists(3, 1), s.CallList(3),
                     s.CallList(77), arrow(s);
               }),
  };
}

} // namespace softgl::suite
