// From a fragment to the answers of a pixel: the operations of 4.1.
#include "expect/fragment_operations.h"

#include <stdexcept>

#include "expect/primitive.h"

namespace softgl::suite {
namespace {

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

Interval less(Interval a) { return {1 - a.high, 1 - a.low}; }

// Table 4.1; c is the component.
Interval factor(GLenum f, const Interval* source, const Interval* destination, const Vec4& constant, int c) {
  switch (f) {
  case GL_ZERO: return 0;
  case GL_ONE: return 1;
  case GL_SRC_COLOR: return source[c];
  case GL_ONE_MINUS_SRC_COLOR: return less(source[c]);
  case GL_DST_COLOR: return destination[c];
  case GL_ONE_MINUS_DST_COLOR: return less(destination[c]);
  case GL_SRC_ALPHA: return source[3];
  case GL_ONE_MINUS_SRC_ALPHA: return less(source[3]);
  case GL_DST_ALPHA: return destination[3];
  case GL_ONE_MINUS_DST_ALPHA: return less(destination[3]);
  case GL_CONSTANT_COLOR: return component(constant, c);
  case GL_ONE_MINUS_CONSTANT_COLOR: return 1 - component(constant, c);
  case GL_CONSTANT_ALPHA: return constant.w;
  case GL_ONE_MINUS_CONSTANT_ALPHA: return 1 - constant.w;
  case GL_SRC_ALPHA_SATURATE: {
    if (c == 3) return 1;
    const Interval rest = less(destination[3]);
    return {std::min(source[3].low, rest.low), std::min(source[3].high, rest.high)};
  }
  }
  throw std::logic_error("a blend factor that the machine does not know");
}

Interval blended(const ColorBufferState& b, const Interval* source, const Interval* destination, int c) {
  const auto [s, d] = std::pair{source[c], destination[c]};
  if (b.equation == GL_MIN) return {std::min(s.low, d.low), std::min(s.high, d.high)};
  if (b.equation == GL_MAX) return {std::max(s.low, d.low), std::max(s.high, d.high)};
  const Interval weighted_source = s * factor(b.source[c == 3], source, destination, b.constant, c);
  const Interval weighted_destination = d * factor(b.destination[c == 3], source, destination, b.constant, c);
  switch (b.equation) {
  case GL_FUNC_SUBTRACT: return weighted_source - weighted_destination;
  case GL_FUNC_REVERSE_SUBTRACT: return weighted_destination - weighted_source;
  case GL_FUNC_ADD: return weighted_source + weighted_destination;
  }
  throw std::logic_error("a blend equation that the machine does not know");
}

// Table 4.2, of whole numbers.
unsigned logic(GLenum operation, unsigned s, unsigned d) {
  switch (operation) {
  case GL_CLEAR: return 0;
  case GL_AND: return s & d;
  case GL_AND_REVERSE: return s & ~d;
  case GL_COPY: return s;
  case GL_AND_INVERTED: return ~s & d;
  case GL_NOOP: return d;
  case GL_XOR: return s ^ d;
  case GL_OR: return s | d;
  case GL_NOR: return ~(s | d);
  case GL_EQUIV: return ~(s ^ d);
  case GL_INVERT: return ~d;
  case GL_OR_REVERSE: return s | ~d;
  case GL_COPY_INVERTED: return ~s;
  case GL_OR_INVERTED: return ~s | d;
  case GL_NAND: return ~(s & d);
  default: return ~0u;
  }
}

// The whole numbers that a color may be as fixed point. A color that is one of them is that one.
std::vector<unsigned> steps_of(Interval color, double greatest) {
  std::vector<unsigned> steps;
  // Half a step at each end is that of the rounding.
  const double middle = color.middle() * greatest, half = (color.high - color.low) * greatest / 2 - 0.5;
  const double low = middle - std::max(half, 0.0), high = middle + std::max(half, 0.0);
  for (double i = std::floor(low + 0.05); i <= std::ceil(high - 0.05); i++)
    if (i >= 0 && i <= greatest) steps.push_back(unsigned(i));
  return steps;
}
Interval logic(GLenum operation, Interval source, Interval destination, int bits) {
  const double greatest = std::ldexp(1, bits) - 1;
  Interval result;
  bool first = true;
  for (unsigned s : steps_of(source, greatest))
    for (unsigned d : steps_of(destination, greatest)) {
      const double value = (logic(operation, s, d) & unsigned(greatest)) / greatest;
      result = first ? Interval(value) : spec::hull(result, value);
      first = false;
    }
  return result;
}

bool stencil_passes(const StencilState& s, int value, int greatest) {
  const int mask = int(s.mask) & greatest;
  const int a = std::clamp(s.reference, 0, greatest) & mask, b = value & mask;
  return compare(s.function, double(a), double(b)) == Passes::Yes;
}

int stencil_value(const StencilState& s, GLenum operation, int value, int greatest) {
  int result = value;
  switch (operation) {
  case GL_KEEP: return value;
  case GL_ZERO: result = 0; break;
  case GL_REPLACE: result = std::clamp(s.reference, 0, greatest); break;
  case GL_INCR: result = std::min(value + 1, greatest); break;
  case GL_DECR: result = std::max(value - 1, 0); break;
  case GL_INVERT: result = ~value & greatest; break;
  case GL_INCR_WRAP: result = (value + 1) & greatest; break;
  case GL_DECR_WRAP: result = (value - 1) & greatest; break;
  default: throw std::logic_error("a stencil operation that the machine does not know");
  }
  const int mask = int(s.write_mask) & greatest;
  return (result & mask) | (value & ~mask);
}

bool same(Interval a, Interval b) { return a.low == b.low && a.high == b.high; }
bool same(const Answer& a, const Answer& b) {
  for (int c = 0; c < 4; c++)
    if (!same(a.color[c], b.color[c]) || !same(a.accumulated[c], b.accumulated[c])) return false;
  return a.stencil == b.stencil && same(a.depth, b.depth) && a.depth_source == b.depth_source &&
         same(a.depth_offset, b.depth_offset);
}

// The same depths, of which each is moved by its offset.
Passes compare_offsets(GLenum function, Interval a, Interval b) {
  return same(a, b) ? compare(function, 0, 0) : compare(function, a, b);
}

// An alpha of 0 or 1 is exact as fixed point (2.14.9).
Interval exact_ends(Interval alpha, Interval rounded) {
  const double a = alpha.middle();
  const bool exact = alpha.high - alpha.low < 1e-9 && (a < 1e-9 || a > 1 - 1e-9);
  return exact ? Interval(a > 0.5 ? 1 : 0) : rounded;
}

} // namespace

Passes Rasterizer::fragment(const State& state, int x, int y, const Fragment& f) {
  if (!in_scissor(state.scissor, x, y)) return Passes::No;
  const size_t pixel = size_t(y * picture_.width + x);
  const ColorBufferState& buffer = state.color_buffer;
  Interval drawn[4];
  process_color(state, f, drawn);
  bool textured = false;
  for (int u = 0; u < kTextureUnits; u++) textured |= state.texture.texture_of(u) != nullptr;
  const Interval alpha_value =
      textured || f.coverage.low != 1 ? drawn[3] : exact_ends(f.color.primary[3], drawn[3]);
  const double reference = std::clamp(buffer.alpha_reference, 0.0, 1.0);
  const Passes alpha =
      buffer.alpha_test ? compare(buffer.alpha_function, alpha_value, reference) : Passes::Yes;
  if (alpha == Passes::No) return Passes::No;
  if (f.certain && alpha == Passes::Yes) picture_.covered++;
  picture_.touched[pixel]++;

  const int greatest = (1 << precision_.stencil_bits) - 1;
  const Interval depth = spec::clamped(spec::widened(f.depth, 3e-5), 0, 1);
  answers_.clear();
  bool all = true, any = false; // of the answers
  for (const Answer& before : picture_.pixels[pixel]) {
    const bool stencil = !state.stencil.test || stencil_passes(state.stencil, before.stencil, greatest);
    const bool same_depth = f.depth_source != 0 && f.depth_source == before.depth_source;
    const Passes passes = !stencil            ? Passes::No
                          : !state.depth.test ? Passes::Yes
                          : same_depth
                              ? compare_offsets(state.depth.function, f.depth_offset, before.depth_offset)
                              : compare(state.depth.function, depth, before.depth);
    all &= passes == Passes::Yes, any |= passes != Passes::No;
    Answer failed = before, after = before;
    if (state.stencil.test) {
      failed.stencil = stencil_value(state.stencil, stencil ? state.stencil.depth_fail : state.stencil.fail,
                                     before.stencil, greatest);
      after.stencil = stencil_value(state.stencil, state.stencil.depth_pass, before.stencil, greatest);
    }
    if (state.depth.test && state.depth.mask)
      after.depth = depth, after.depth_source = f.depth_source, after.depth_offset = f.depth_offset;
    write_color(buffer, drawn, before, after);
    if (f.nominal && passes != Passes::No) add_answer(answers_, after);
    if (f.nominal && passes != Passes::Yes) add_answer(answers_, failed);
    if (!f.certain || alpha != Passes::Yes) add_answer(answers_, before);
    if (!f.nominal && passes != Passes::No) add_answer(answers_, after);
    if (!f.nominal && passes != Passes::Yes) add_answer(answers_, failed);
  }
  picture_.pixels[pixel].swap(answers_);
  const bool passes_all = all && alpha == Passes::Yes;
  passed.low += passes_all && f.certain, passed.high += any;
  picture_.hidden[pixel] += passes_all && f.certain;
  return passes_all ? Passes::Yes : any ? Passes::Perhaps : Passes::No;
}

void Rasterizer::add_answer(std::vector<Answer>& answers, const Answer& answer) {
  for (const Answer& other : answers)
    if (same(other, answer)) return;
  if (answers.size() == 24) throw std::logic_error("a pixel with too many answers");
  answers.push_back(answer);
}

void Rasterizer::write_color(const ColorBufferState& buffer, const Interval drawn[4], const Answer& before,
                             Answer& after) const {
  Interval destination[4];
  for (int c = 0; c < 4; c++)
    destination[c] = spec::clamped(spec::widened(before.color[c], step_of(c)), 0, 1);
  if (precision_.bits[3] == 0) destination[3] = 1; // 4.1.8
  for (int c = 0; c < 4; c++) {
    if (!buffer.mask[c] || !buffer.drawn) continue;
    if (buffer.logic) // 4.1.10: in place of blending
      after.color[c] = logic(buffer.operation, drawn[c], before.color[c], std::max(precision_.bits[c], 1));
    else if (buffer.blend)
      after.color[c] = spec::clamped(spec::widened(blended(buffer, drawn, destination, c), step_of(c)), 0, 1);
    else
      after.color[c] = drawn[c];
    if (!buffer.logic) after.color[c] = dithered(buffer, after.color[c], step_of(c));
  }
}

} // namespace softgl::suite
