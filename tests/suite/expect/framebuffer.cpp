// The whole framebuffer: clears, the accumulation buffer, what is read (4.2, 4.3.2), and what is painted.
#include <stdexcept>

#include "expect/fragment_operations.h"
#include "expect/interpolation.h"

namespace softgl::suite {

void Rasterizer::clear(const State& state, GLbitfield mask) { // 4.2.3
  const ColorBufferState& buffer = state.color_buffer;
  const Vec4 &color = buffer.clear_color, &sums = state.accumulation_clear;
  const double colors[4] = {color.x, color.y, color.z, color.w},
               cleared[4] = {sums.x, sums.y, sums.z, sums.w};
  for (int y = 0; y < picture_.height; y++)
    for (int x = 0; x < picture_.width; x++) {
      if (!in_scissor(state.scissor, x, y)) continue;
      const size_t pixel = size_t(y * picture_.width + x);
      picture_.touched[pixel]++, picture_.hidden[pixel]++;
      answers_.clear();
      for (Answer answer : picture_.pixels[pixel]) {
        for (int c = 0; c < 4; c++) {
          if (mask & GL_COLOR_BUFFER_BIT && buffer.mask[c] && buffer.drawn)
            answer.color[c] = dithered(buffer, std::clamp(colors[c], 0.0, 1.0), step_of(c));
          if (mask & GL_ACCUM_BUFFER_BIT) answer.accumulated[c] = std::clamp(cleared[c], -1.0, 1.0);
        }
        if (mask & GL_DEPTH_BUFFER_BIT && state.depth.mask)
          answer.depth = std::clamp(state.depth.clear, 0.0, 1.0), answer.depth_source = 0;
        if (mask & GL_STENCIL_BUFFER_BIT) {
          const int all = (1 << precision_.stencil_bits) - 1, bits = int(state.stencil.write_mask) & all;
          answer.stencil = (state.stencil.clear & bits) | (answer.stencil & ~bits);
        }
        add_answer(answers_, answer);
      }
      picture_.pixels[pixel].swap(answers_);
    }
}

void Rasterizer::accumulate(const State& state, GLenum operation, double value) {
  const double step = std::ldexp(1, 1 - std::max(precision_.accumulation_bits, 8));
  const ColorBufferState& buffer = state.color_buffer;
  for (int y = 0; y < picture_.height; y++)
    for (int x = 0; x < picture_.width; x++) {
      if (!in_scissor(state.scissor, x, y)) continue;
      const size_t pixel = size_t(y * picture_.width + x);
      if (operation == GL_RETURN) picture_.touched[pixel]++, picture_.hidden[pixel]++, picture_.covered++;
      answers_.clear();
      for (Answer answer : picture_.pixels[pixel]) {
        for (int c = 0; c < 4; c++) {
          Interval& sum = answer.accumulated[c];
          const bool stored = c < 3 || precision_.bits[3] > 0;
          const Interval color =
              stored ? spec::clamped(spec::widened(answer.color[c], precision_.half_step(c)), 0, 1)
                     : Interval(1);
          switch (operation) {
          case GL_ACCUM: sum = sum + color * Interval(value); break;
          case GL_LOAD: sum = color * Interval(value); break;
          case GL_ADD: sum = sum + Interval(value); break;
          case GL_MULT: sum = sum * Interval(std::clamp(value, -1.0, 1.0)); break;
          case GL_RETURN:
            if (buffer.mask[c] && buffer.drawn)
              answer.color[c] = dithered(buffer, spec::clamped(sum * Interval(value), 0, 1), step_of(c));
            continue;
          default: throw std::logic_error("glAccum of what the machine does not know");
          }
          sum = spec::widened(sum, step);
          if (sum.low < -1.01 || sum.high > 1.01) throw std::logic_error("a sum that is not defined (4.2.4)");
        }
        add_answer(answers_, answer);
      }
      picture_.pixels[pixel].swap(answers_);
    }
}

void Rasterizer::pixel(const State& state, int x, int y, const LitVertex& at, Interval depth) {
  if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) return;
  Fragment f;
  f.color = at.front, f.depth = depth, f.fog = fog_factor(state.fog, at.fog_distance);
  f.texture = constant_texture(state, at.texture);
  fragment(state, x, y, f);
}

void Rasterizer::stencil(const State& state, int x, int y, int value) {
  if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) return;
  if (!in_scissor(state.scissor, x, y)) return;
  const int bits = int(state.stencil.write_mask) & ((1 << precision_.stencil_bits) - 1);
  answers_.clear();
  for (Answer answer : picture_.pixels[size_t(y * picture_.width + x)]) {
    answer.stencil = (value & bits) | (answer.stencil & ~bits);
    add_answer(answers_, answer);
  }
  picture_.pixels[size_t(y * picture_.width + x)].swap(answers_);
}

PixelImage Rasterizer::read(int left, int bottom, int width, int height, PixelKind kind) const {
  PixelImage image{kind, width, height, 1, {}};
  for (int y = bottom; y < bottom + height; y++)
    for (int x = left; x < left + width; x++) {
      if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height)
        throw std::logic_error("pixels outside of the window are read");
      const std::vector<Answer>& answers = picture_.pixels[size_t(y * picture_.width + x)];
      Pixel pixel;
      for (size_t i = 0; i < answers.size(); i++) {
        const Answer& a = answers[i];
        const auto add = [&](int c, Interval value) {
          pixel.c[c] = i == 0 ? value : spec::hull(pixel.c[c], value);
        };
        switch (kind) {
        case PixelKind::Color:
          for (int c = 0; c < 4; c++) {
            const bool stored = c < 3 || precision_.bits[3] > 0;
            add(c, stored ? spec::clamped(spec::widened(a.color[c], precision_.half_step(c)), 0, 1)
                          : Interval(1));
          }
          break;
        case PixelKind::Depth: add(0, spec::clamped(spec::widened(a.depth, 1.0 / 65535), 0, 1)); break;
        case PixelKind::Stencil: add(0, a.stencil); break;
        default: throw std::logic_error("a buffer that the machine does not have");
        }
      }
      image.pixels.push_back(pixel);
    }
  return image;
}

void Rasterizer::paint(int left, int bottom, int size, const Interval color[4]) {
  for (int y = std::max(bottom, 0); y < std::min(bottom + size, picture_.height); y++)
    for (int x = std::max(left, 0); x < std::min(left + size, picture_.width); x++) {
      auto& answers = picture_.pixels[size_t(y * picture_.width + x)];
      answers.resize(1);
      std::copy(color, color + 4, answers[0].color);
      picture_.covered++, picture_.touched[size_t(y * picture_.width + x)]++;
      picture_.hidden[size_t(y * picture_.width + x)]++;
    }
}

} // namespace softgl::suite
