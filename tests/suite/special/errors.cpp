// Errors of special functions (2.5, 5.1 to 5.3): the wrong command does nothing.
#include "special/chapter.h"
#include "special/evaluated.h"

namespace softgl::suite {
namespace {

Test wrong(const std::string& name, const char* section, const char* sentence,
           std::function<void(Script&)> body, Need need = {}) {
  return special_test("error." + name, section, sentence, std::move(body), need);
}

using Calls = std::vector<std::function<void(Script&)>>;

// Wrong maps leave the arch and the hill as they are.
Test wrong_maps(const char* name, const char* section, const char* sentence, GLenum error, Calls calls) {
  return wrong(name, section, sentence, [=](Script& s) {
    arch(s), hill(s);
    s.MapGrid1f(3, 0, 1), s.MapGrid2f(1, 0, 1, 2, 0, 1);
    for (const auto& call : calls) call(s), s.raises(error);
    fed_back(s, GL_3D, [&] { s.EvalMesh1(GL_POINT, 0, 3), s.EvalMesh2(GL_POINT, 0, 1, 0, 2); });
  });
}

const V kPoints(1000, 0.5);

// Nothing is fed back or selected: the picture is drawn.
void drawn(Script& s) { tint(s, 2), box(s, 20, 30, 60, 70), arrow(s); }

} // namespace

std::vector<Test> special_error_tests() {
  return {
      wrong("feedback_without_buffer", "5.3",
            "Feedback without a buffer is GL_INVALID_OPERATION, and does not begin.",
            [](Script& s) {
              s.RenderMode(GL_FEEDBACK), s.raises(GL_INVALID_OPERATION),
                  s.GetFloatv(GL_RENDER_MODE, V{double(GL_RENDER)}), drawn(s);
            }),
      wrong("selection_without_buffer", "5.2",
            "Selection without a buffer is GL_INVALID_OPERATION, and does not begin.",
            [](Script& s) {
              s.RenderMode(GL_SELECT), s.raises(GL_INVALID_OPERATION),
                  s.GetFloatv(GL_RENDER_MODE, V{double(GL_RENDER)}), drawn(s);
            }),
      wrong("render_mode", "2.5, 5.2", "glRenderMode of no mode is GL_INVALID_ENUM.",
            [](Script& s) {
              s.RenderMode(GL_FLAT), s.raises(GL_INVALID_ENUM),
                  s.GetFloatv(GL_RENDER_MODE, V{double(GL_RENDER)}), drawn(s);
            }),
      wrong("feedback_buffer_inside", "5.3",
            "glFeedbackBuffer while there is feedback is GL_INVALID_OPERATION.",
            [](Script& s) {
              fed_back(s, GL_2D, [&] {
                dot(s, 20, 30), s.FeedbackBuffer(10, GL_3D, V(10, 0.0)), s.raises(GL_INVALID_OPERATION),
                    dot(s, 40, 50);
              });
              s.GetFloatv(GL_FEEDBACK_BUFFER_TYPE, V{double(GL_2D)});
            }),
      wrong("select_buffer_inside", "5.2",
            "glSelectBuffer while something is selected is GL_INVALID_OPERATION.",
            [](Script& s) {
              selected(s, [&] {
                s.PushName(3), dot(s, 20, 30, 1), s.SelectBuffer(10, V(10, 0.0)),
                    s.raises(GL_INVALID_OPERATION), s.PushName(4), dot(s, 40, 50, 2);
              });
            }),
      wrong("other_buffer", "5.2, 5.3",
            "glSelectBuffer is right while there is feedback, glFeedbackBuffer while something is selected.",
            [](Script& s) {
              s.FeedbackBuffer(30, GL_2D, V(30, kUntouchedFeedback)), s.RenderMode(GL_FEEDBACK),
                  s.SelectBuffer(30, V(30, kUntouchedName)), dot(s, 20, 30), s.RenderMode(GL_SELECT);
              s.FeedbackBuffer(30, GL_3D, V(30, kUntouchedFeedback)), s.PushName(4), dot(s, 40, 50, 2),
                  s.RenderMode(GL_FEEDBACK), dot(s, 50, 60, 1), s.RenderMode(GL_RENDER),
                  s.PaintFeedback(2, 8);
            }),
      wrong("feedback_buffer", "2.5, 5.3",
            "glFeedbackBuffer of a negative size is GL_INVALID_VALUE, of no type GL_INVALID_ENUM.",
            [](Script& s) {
              s.FeedbackBuffer(30, GL_2D, V(30, kUntouchedFeedback)), s.FeedbackBuffer(-1, GL_3D, V(30, 0.0)),
                  s.raises(GL_INVALID_VALUE);
              s.FeedbackBuffer(30, GL_FLAT, V(30, 0.0)), s.raises(GL_INVALID_ENUM), s.RenderMode(GL_FEEDBACK),
                  dot(s, 20, 30), dot(s, 40, 50), s.RenderMode(GL_RENDER), s.PaintFeedback(2, 8);
            }),
      wrong("select_buffer", "2.5, 5.2", "glSelectBuffer of a negative size is GL_INVALID_VALUE.",
            [](Script& s) {
              s.SelectBuffer(30, V(30, kUntouchedName)), s.SelectBuffer(-1, V(30, 0.0)),
                  s.raises(GL_INVALID_VALUE), s.RenderMode(GL_SELECT), s.PushName(3), dot(s, 20, 30, 1),
                  s.RenderMode(GL_RENDER), s.PaintSelection(8);
            }),
      wrong("load_name", "5.2", "glLoadName of an empty stack is GL_INVALID_OPERATION.",
            [](Script& s) {
              selected(s, [&] {
                s.LoadName(3), s.raises(GL_INVALID_OPERATION), s.PushName(4), s.LoadName(5),
                    dot(s, 20, 30, 1), s.InitNames(), s.LoadName(6), s.raises(GL_INVALID_OPERATION),
                    dot(s, 40, 50, -2);
              });
            }),
      wrong("pop_name", "5.2", "glPopName of an empty stack is GL_STACK_UNDERFLOW.",
            [](Script& s) {
              selected(s, [&] {
                s.PopName(), s.raises(GL_STACK_UNDERFLOW), s.PushName(4), s.PopName(), s.PopName(),
                    s.raises(GL_STACK_UNDERFLOW), s.PushName(5), dot(s, 20, 30, 1);
              });
            }),
      wrong("names_in_begin", "2.6.3, 5.2",
            "Commands of names between glBegin and glEnd are GL_INVALID_OPERATION.",
            [](Script& s) {
              selected(s, [&] {
                s.PushName(4), s.Begin(GL_POINTS), s.PushName(5), s.raises(GL_INVALID_OPERATION),
                    s.LoadName(6), s.raises(GL_INVALID_OPERATION), s.PopName(),
                    s.raises(GL_INVALID_OPERATION), s.InitNames(), s.raises(GL_INVALID_OPERATION),
                    pixel_vertex(s, 20, 30, 1), s.End(), s.PushName(7), dot(s, 30, 40, 2);
              });
            }),
      wrong("mark_in_begin", "2.6.3, 5.3", "glPassThrough between glBegin and glEnd is GL_INVALID_OPERATION.",
            [](Script& s) {
              fed_back(s, GL_2D, [&] {
                s.Begin(GL_POINTS), pixel_vertex(s, 20, 30), s.PassThrough(5), s.raises(GL_INVALID_OPERATION),
                    pixel_vertex(s, 40, 50), s.End();
              });
            }),
      wrong("mode_in_begin", "2.6.3, 5.2", "glRenderMode between glBegin and glEnd is GL_INVALID_OPERATION.",
            [](Script& s) {
              fed_back(s, GL_2D, [&] {
                s.Begin(GL_POINTS), pixel_vertex(s, 20, 30), s.RenderMode(GL_RENDER),
                    s.raises(GL_INVALID_OPERATION), pixel_vertex(s, 40, 50), s.End();
              });
            }),
      wrong_maps("map_target", "2.5, 5.1", "glMap of no target is GL_INVALID_ENUM.", GL_INVALID_ENUM,
                 {[](Script& s) { s.Map1f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, kPoints); },
                  [](Script& s) { s.Map1d(GL_FLAT, 0, 1, 3, 2, kPoints); },
                  [](Script& s) { s.Map2f(GL_MAP1_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, kPoints); },
                  [](Script& s) { s.Map2d(GL_FLAT, 0, 1, 6, 2, 0, 1, 3, 2, kPoints); }}),
      wrong_maps("map_domain", "5.1", "u1 = u2 or v1 = v2 is GL_INVALID_VALUE.", GL_INVALID_VALUE,
                 {[](Script& s) { s.Map1f(GL_MAP1_VERTEX_3, 2, 2, 3, 2, kPoints); },
                  [](Script& s) { s.Map2f(GL_MAP2_VERTEX_3, 2, 2, 6, 2, 0, 1, 3, 2, kPoints); },
                  [](Script& s) { s.Map2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, -1, -1, 3, 2, kPoints); }}),
      wrong_maps("map_stride", "5.1", "A stride below the number of values is GL_INVALID_VALUE.",
                 GL_INVALID_VALUE,
                 {[](Script& s) { s.Map1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, kPoints); },
                  [](Script& s) { s.Map1d(GL_MAP1_VERTEX_3, 0, 1, 0, 2, kPoints); },
                  [](Script& s) { s.Map2f(GL_MAP2_VERTEX_3, 0, 1, 2, 2, 0, 1, 6, 2, kPoints); },
                  [](Script& s) { s.Map2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 2, 2, kPoints); }}),
      wrong_maps("map_order", "5.1", "An order below 1 or above the greatest is GL_INVALID_VALUE.",
                 GL_INVALID_VALUE,
                 {[](Script& s) { s.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, kPoints); },
                  [](Script& s) { s.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, -2, kPoints); },
                  [](Script& s) { s.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 100000, kPoints); },
                  [](Script& s) { s.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 0, 0, 1, 3, 2, kPoints); },
                  [](Script& s) { s.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 3, 100000, kPoints); }}),
      wrong_maps("grid", "5.1", "A grid without partitions is GL_INVALID_VALUE.", GL_INVALID_VALUE,
                 {[](Script& s) { s.MapGrid1f(0, 0, 1); }, [](Script& s) { s.MapGrid1d(-3, 0, 1); },
                  [](Script& s) { s.MapGrid2f(0, 0, 1, 2, 0, 1); },
                  [](Script& s) { s.MapGrid2d(2, 0, 1, -1, 0, 1); }}),
      wrong_maps("mesh_mode", "2.5, 5.1", "A mesh of no mode is GL_INVALID_ENUM, as is GL_FILL of a curve.",
                 GL_INVALID_ENUM,
                 {[](Script& s) { s.EvalMesh1(GL_FILL, 0, 1); },
                  [](Script& s) { s.EvalMesh1(GL_LINES, 0, 1); },
                  [](Script& s) { s.EvalMesh2(GL_FLAT, 0, 1, 0, 1); }}),
      wrong(
          "map_unit", "5.1", "glMap while another texture unit is active is GL_INVALID_OPERATION.",
          [](Script& s) {
            arch(s), s.ActiveTexture(GL_TEXTURE1), s.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, kPoints),
                s.raises(GL_INVALID_OPERATION);
            s.Map2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, kPoints), s.raises(GL_INVALID_OPERATION),
                s.ActiveTexture(GL_TEXTURE0);
            s.MapGrid1f(4, 0, 1), fed_back(s, GL_3D, [&] { s.EvalMesh1(GL_POINT, 0, 4); });
          },
          kVersion13),
      wrong("map_in_begin", "2.6.3, 5.1",
            "glMap, glMapGrid and glEvalMesh between glBegin and glEnd are GL_INVALID_OPERATION.",
            [](Script& s) {
              arch(s), s.MapGrid1f(4, 0, 1);
              fed_back(s, GL_3D, [&] {
                const Calls calls = {[](Script& t) { t.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, kPoints); },
                                     [](Script& t) { t.MapGrid1f(2, 0, 1); },
                                     [](Script& t) { t.EvalMesh1(GL_POINT, 0, 3); }};
                for (const auto& call : calls)
                  s.Begin(GL_POINTS), s.EvalPoint1(1), call(s), s.raises(GL_INVALID_OPERATION),
                      s.EvalPoint1(3), s.End();
              });
            }),
      wrong("get_map", "2.5, 6.1.3", "glGetMap of no map or no query is GL_INVALID_ENUM.",
            [](Script& s) {
              s.GetMapfv(GL_FLAT, GL_ORDER, V{0}), s.raises(GL_INVALID_ENUM),
                  s.GetMapfv(GL_MAP1_VERTEX_3, GL_FLAT, V{0}), s.raises(GL_INVALID_ENUM), drawn(s);
            }),
  };
}

} // namespace softgl::suite
