// From a fragment to the answers of a pixel: the operations of 4.1.
#include <stdexcept>

#include "expect/primitive.h"

namespace softgl::suite {
namespace {

enum class Passes { No, Perhaps, Yes };

Passes compare(GLenum function, Interval a, Interval b) {
  const auto decide = [](bool always, bool never) {
    return always ? Passes::Yes : never ? Passes::No : Passes::Perhaps;
  };
  switch (function) {
  case GL_NEVER: return Passes::No;
  case GL_LESS: return decide(a.high < b.low, a.low >= b.high);
  case GL_LEQUAL: return decide(a.high <= b.low, a.low > b.high);
  case GL_GREATER: return decide(a.low > b.high, a.high <= b.low);
  case GL_GEQUAL: return decide(a.low >= b.high, a.high < b.low);
  case GL_EQUAL:
    return decide(a.low == a.high && b.low == b.high && a.low == b.low, a.high < b.low || a.low > b.high);
  case GL_NOTEQUAL: return decide(a.high < b.low || a.low > b.high, false);
  default: return Passes::Yes;
  }
}

Interval factor(GLenum f, Interval source, Interval destination, Interval source_alpha) {
  switch (f) {
  case GL_ZERO: return 0;
  case GL_ONE: return 1;
  case GL_SRC_COLOR: return source;
  case GL_DST_COLOR: return destination;
  case GL_SRC_ALPHA: return source_alpha;
  case GL_ONE_MINUS_SRC_ALPHA: return {1 - source_alpha.high, 1 - source_alpha.low};
  }
  throw std::logic_error("a blend factor that the machine does not know");
}

bool same(const Answer& a, const Answer& b) {
  for (int c = 0; c < 4; c++)
    if (a.color[c].low != b.color[c].low || a.color[c].high != b.color[c].high) return false;
  return a.depth.low == b.depth.low && a.depth.high == b.depth.high;
}

} // namespace

void Rasterizer::fragment(const State& state, int x, int y, const Fragment& f) {
  auto& answers = picture_.pixels[size_t(y * picture_.width + x)];
  Answer drawn;
  process_color(state, f, drawn.color);
  const Passes alpha =
      !state.color_buffer.alpha_test
          ? Passes::Yes
          : compare(state.color_buffer.alpha_function, drawn.color[3], state.color_buffer.alpha_reference);
  if (alpha == Passes::No) return;
  if (f.certain && alpha == Passes::Yes) picture_.covered++;

  std::vector<Answer> result;
  const auto add = [&](const Answer& answer) {
    for (const Answer& other : result)
      if (same(other, answer)) return;
    if (result.size() < 24)
      result.push_back(answer);
    else
      throw std::logic_error("a pixel with too many answers");
  };
  const Interval depth = spec::clamped(spec::widened(f.depth, 3e-5), 0, 1);
  for (const Answer& before : answers) {
    Answer after = drawn;
    after.depth = before.depth;
    Passes passes = alpha;
    if (state.depth.test) {
      const Passes depth_passes = compare(state.depth.function, depth, before.depth);
      passes = std::min(passes, depth_passes);
      if (state.depth.mask) after.depth = depth;
    }
    if (passes == Passes::No) {
      add(before);
      continue;
    }
    if (state.color_buffer.blend)
      for (int c = 0; c < 4; c++) {
        const double step = precision_.half_step(c == 3 && precision_.bits[3] < 2 ? 0 : c);
        const Interval destination = spec::clamped(spec::widened(before.color[c], step), 0, 1);
        const Interval s = factor(state.color_buffer.source, drawn.color[c], destination, drawn.color[3]);
        const Interval d =
            factor(state.color_buffer.destination, drawn.color[c], destination, drawn.color[3]);
        after.color[c] = spec::clamped(spec::widened(drawn.color[c] * s + destination * d, step), 0, 1);
      }
    const bool keeps = !f.certain || passes == Passes::Perhaps;
    if (f.nominal) add(after);
    if (keeps) add(before);
    if (!f.nominal) add(after);
  }
  answers = std::move(result);
}

} // namespace softgl::suite
