// The stack of names and the buffer of selection (5.2).
#include "special/chapter.h"
#include "special/scenes.h"

namespace softgl::suite {
namespace {

Test name_row(const char* name, const char* sentence, std::function<void(Script&)> body,
              const char* section = "5.2") {
  return special_test(std::string("names.") + name, section, sentence, std::move(body));
}

void hit(Script& s, double z = 0) { dot(s, 30, 40, z); }

} // namespace

std::vector<Test> special_name_tests() {
  return {
      name_row("order", "A record has the number of names, the depths, and the names, bottommost first.",
               [](Script& s) {
                 selected(s, [&] {
                   s.InitNames(), s.PushName(11), s.PushName(12), s.PushName(13), s.PushName(14), hit(s, 1);
                 });
               }),
      name_row("push", "glPushName writes the record of the names before it.",
               [](Script& s) {
                 selected(s, [&] {
                   s.PushName(21), hit(s, 1), s.PushName(22), hit(s, 2), s.PushName(23), s.PushName(24),
                       hit(s, -4);
                 });
               }),
      name_row("pop", "glPopName writes the record, and takes the topmost name away.",
               [](Script& s) {
                 selected(s, [&] {
                   s.PushName(31), s.PushName(32), s.PushName(33), hit(s, 1), s.PopName(), hit(s, -2),
                       s.PopName(), s.PopName(), hit(s, 2);
                 });
               }),
      name_row("load", "glLoadName writes the record, and replaces the topmost name.",
               [](Script& s) {
                 selected(s, [&] {
                   s.PushName(41), s.PushName(42), hit(s, 1), s.LoadName(43), hit(s, -2), s.LoadName(44),
                       s.LoadName(45), hit(s, 2);
                 });
               }),
      name_row("init", "glInitNames writes the record, and empties the stack.",
               [](Script& s) {
                 selected(s, [&] {
                   s.PushName(51), s.PushName(52), hit(s, 1), s.InitNames(), hit(s, -2), s.InitNames(),
                       s.PushName(53), hit(s, 2);
                 });
               }),
      name_row("same_name", "The record is written although the name stays the same.",
               [](Script& s) {
                 selected(s, [&] {
                   s.PushName(7), hit(s, 1), s.LoadName(7), hit(s, -2), s.LoadName(7), hit(s, 2);
                 });
               }),
      name_row("hit_is_over", "A hit belongs to one record: the next begins without hit and depths.",
               [](Script& s) {
                 selected(s, [&] {
                   s.PushName(1), hit(s, 3), hit(s, -12), s.PushName(2), s.PopName(), s.LoadName(3),
                       hit(s, -3), s.LoadName(4);
                 });
               }),
      name_row("large", "Names are unsigned integers of 32 bits.",
               [](Script& s) {
                 selected(s, [&] {
                   s.PushName(4294967295.0), s.PushName(2147483648.0), s.PushName(0),
                       s.PushName(3000000000.0), hit(s, 1);
                 });
               }),
      name_row("depth", "The stack takes as many names as its limit says, and no more.",
               [](Script& s) {
                 s.PaintStack(GL_NAME_STACK_DEPTH, GL_MAX_NAME_STACK_DEPTH, 0, 0),
                     s.PaintInteger(GL_MAX_NAME_STACK_DEPTH, 64, 1e9, 16, 0), tint(s, 2),
                     box(s, 20, 30, 60, 70);
               }),
      name_row("sixty_four", "A record has 64 names.",
               [](Script& s) {
                 selected(
                     s,
                     [&] {
                       for (int i = 0; i < 64; i++) s.PushName(63 - i);
                       hit(s, 1);
                     },
                     80, 80);
               }),
      name_row(
          "depth_counted", "GL_NAME_STACK_DEPTH is the number of names.",
          [](Script& s) {
            selected(s, [&] {
              s.GetFloatv(GL_NAME_STACK_DEPTH, V{0}), s.PushName(5), s.PushName(6), s.PushName(5),
                  s.GetFloatv(GL_NAME_STACK_DEPTH, V{3});
              s.PopName(), s.GetFloatv(GL_NAME_STACK_DEPTH, V{2}), s.LoadName(3),
                  s.GetFloatv(GL_NAME_STACK_DEPTH, V{2});
              s.InitNames(), s.GetFloatv(GL_NAME_STACK_DEPTH, V{0});
            });
          },
          "5.2, table 6.31"),
      name_row("ignored", "Outside of selection the commands of names have no effect.",
               [](Script& s) {
                 s.PushName(1), s.LoadName(2), s.PopName(), s.PopName(), s.InitNames(), s.PushName(3),
                     tint(s, 3), box(s, 70, 70, 90, 90);
                 s.FeedbackBuffer(20, GL_2D, V(20, kUntouchedFeedback)), s.RenderMode(GL_FEEDBACK),
                     s.PushName(5), s.LoadName(6), s.RenderMode(GL_RENDER);
                 selected(s, [&] { hit(s, 1), s.PushName(9), hit(s, -3); });
               }),
      name_row("cleared", "glRenderMode empties the stack.",
               [](Script& s) {
                 s.SelectBuffer(40, V(40, kUntouchedName)), s.RenderMode(GL_SELECT), s.PushName(1),
                     s.PushName(2), hit(s), s.RenderMode(GL_SELECT), hit(s, 1), s.PushName(3), hit(s, -3),
                     s.RenderMode(GL_RENDER), s.PaintSelection(8);
               }),
      name_row("result", "glRenderMode returns the number of records.",
               [](Script& s) {
                 selected(s, [&] {
                   s.PushName(1);
                   for (int i = 0; i < 7; i++) s.LoadName(i), hit(s, i * 0.3);
                 });
               }),
      name_row("again", "glRenderMode begins the buffer anew.",
               [](Script& s) {
                 s.SelectBuffer(40, V(40, kUntouchedName)), s.RenderMode(GL_SELECT), s.PushName(8), hit(s),
                     s.PushName(9), hit(s), s.RenderMode(GL_RENDER), s.RenderMode(GL_SELECT), s.PushName(3),
                     hit(s, 2), s.RenderMode(GL_RENDER), s.PaintSelection(8);
               }),
      name_row("to_feedback", "Selection ends with glRenderMode(GL_FEEDBACK), too.",
               [](Script& s) {
                 s.SelectBuffer(40, V(40, kUntouchedName)),
                     s.FeedbackBuffer(40, GL_2D, V(40, kUntouchedFeedback));
                 s.RenderMode(GL_SELECT), s.PushName(8), hit(s, 1), s.RenderMode(GL_FEEDBACK), hit(s),
                     s.RenderMode(GL_RENDER), s.PaintFeedback(2, 8);
               }),
      name_row("result_of_feedback", "The records count where selection ends with glRenderMode(GL_FEEDBACK).",
               [](Script& s) {
                 s.SelectBuffer(40, V(40, kUntouchedName)),
                     s.FeedbackBuffer(40, GL_2D, V(40, kUntouchedFeedback));
                 s.RenderMode(GL_FEEDBACK), s.PushName(5), hit(s), s.RenderMode(GL_SELECT), s.PushName(8),
                     hit(s, 1), s.PushName(9), hit(s, 2), s.RenderMode(GL_RENDER), s.PaintSelection(8);
               }),
      name_row(
          "overflow",
          "If the buffer is too small, as much of the record as fits is written, and glRenderMode returns "
          "-1.",
          [](Script& s) {
            selected(
                s, [&] { s.PushName(1), hit(s, 1), s.PushName(2), hit(s, -3), s.PushName(3), hit(s); }, 20,
                6);
          }),
      name_row("no_overflow", "A buffer that is full to its last number is no overflow.",
               [](Script& s) {
                 selected(
                     s, [&] { s.PushName(1), hit(s, 1), s.PushName(2), hit(s, -3); }, 20, 9);
               }),
      name_row("overflow_is_over", "The overflow is forgotten when glRenderMode has returned -1.",
               [](Script& s) {
                 selected(
                     s, [&] { s.PushName(1), hit(s, 1), s.PushName(2), hit(s, -3), s.PushName(3), hit(s); },
                     20, 6);
                 s.RenderMode(GL_SELECT), s.PushName(6), hit(s, 1), s.RenderMode(GL_RENDER),
                     s.PaintSelection(8);
               }),
      name_row(
          "state", "The mode and the sizes of the buffers can be asked for.",
          [](Script& s) {
            s.GetFloatv(GL_RENDER_MODE, V{double(GL_RENDER)}), s.GetFloatv(GL_SELECTION_BUFFER_SIZE, V{0}),
                s.GetFloatv(GL_FEEDBACK_BUFFER_SIZE, V{0}),
                s.GetFloatv(GL_FEEDBACK_BUFFER_TYPE, V{double(GL_2D)});
            s.FeedbackBuffer(33, GL_3D_COLOR, V(33, kUntouchedFeedback));
            selected(s, [&] { s.GetFloatv(GL_RENDER_MODE, V{double(GL_SELECT)}), s.PushName(1), hit(s, 1); });
            s.GetFloatv(GL_RENDER_MODE, V{double(GL_RENDER)}), s.GetFloatv(GL_SELECTION_BUFFER_SIZE, V{40}),
                s.GetFloatv(GL_FEEDBACK_BUFFER_SIZE, V{33}),
                s.GetFloatv(GL_FEEDBACK_BUFFER_TYPE, V{double(GL_3D_COLOR)});
          },
          "5.2, 5.3, table 6.33"),
  };
}

} // namespace softgl::suite
