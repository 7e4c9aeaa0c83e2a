// Selection and feedback (5.2, 5.3).
#include "expect/calls.h"

namespace softgl::suite {

// A primitive that is clipped, in window coordinates.
void Machine::receive(GLenum token, const std::vector<LitVertex>& vertices) {
  if (render_mode_.mode == GL_SELECT)
    note_hit(render_mode_, vertices);
  else
    feed_back(render_mode_, token, vertices);
}

// A bitmap or an image; it is no hit (corollary 6).
bool Machine::receives_pixels(GLenum token) {
  if (render_mode_.mode == GL_FEEDBACK) feed_back(render_mode_, token, {raster_position_});
  return render_mode_.mode != GL_RENDER;
}

void Machine::paint_numbers(const std::vector<Interval>& numbers, int size,
                            void (*paint)(Interval, Interval*)) {
  const int columns = raster_.width() / size;
  if (int(numbers.size()) > painted_squares(size)) throw std::logic_error("more numbers than squares");
  for (int i = 0; i < painted_squares(size); i++) {
    Interval color[4] = {0, 0, 0, 1};
    if (size_t(i) < numbers.size()) paint(numbers[size_t(i)], color);
    raster_.paint(i % columns * size, i / columns * size, size, color);
  }
}

bool Machine::play_special(const Call& call) {
  RenderModeState& s = render_mode_;
  const bool selects = s.mode == GL_SELECT;
  switch (call.command) {
  case Command::RenderMode: change_mode(s, call.e(0)); return true;
  case Command::SelectBuffer:
    s.selection_size = int(call.n(0)), s.selection_memory.assign(call.v(1).begin(), call.v(1).end());
    return true;
  case Command::FeedbackBuffer:
    s.feedback_size = int(call.n(0)), s.feedback_type = call.e(1);
    s.feedback_memory.assign(call.v(2).begin(), call.v(2).end());
    return true;
  case Command::PassThrough:
    if (s.mode == GL_FEEDBACK) s.items.push_back({GL_PASS_THROUGH_TOKEN, {{call.n(0)}}});
    return true;
  case Command::InitNames:
    if (selects) write_record(s), s.names.clear();
    return true;
  case Command::PushName:
    if (selects) write_record(s), s.names.push_back(GLuint(call.n(0)));
    return true;
  case Command::PopName:
    if (selects && s.names.empty()) throw std::logic_error("glPopName of an empty stack");
    if (selects) write_record(s), s.names.pop_back();
    return true;
  case Command::LoadName:
    if (selects && s.names.empty()) throw std::logic_error("glLoadName of an empty stack");
    if (selects) write_record(s), s.names.back() = GLuint(call.n(0));
    return true;
  case Command::PaintFeedback:
    if (s.mode != GL_RENDER) throw std::logic_error("a mode in which nothing is painted");
    paint_numbers(fed_numbers(s, FedOrder(int(call.n(0)))), int(call.n(1)), paint_number);
    return true;
  case Command::PaintSelection: {
    if (s.mode != GL_RENDER) throw std::logic_error("a mode in which nothing is painted");
    std::vector<Interval> numbers = s.selection_memory;
    numbers.insert(numbers.begin(), s.result.low < 0 ? Interval(4294967295.0) : s.result);
    paint_numbers(numbers, int(call.n(0)), paint_record_number);
    return true;
  }
  default: return false;
  }
}

} // namespace softgl::suite
