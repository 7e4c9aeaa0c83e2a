// BlitFramebuffer (GL_ARB_framebuffer_object, 4.3.3).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "context/context.h"
#include "shaders/fragment/pixel_image.h"
#include "snapshot/render_targets.h"
#include "snapshot/submit.h"
#include "surface/read_surface.h"
#include "surface/sample_resolve.h"

namespace softgl {
namespace {

/// One axis of a blit: for each pixel from `first` on, in the rows or columns of the drawn surface, which
/// pixel of the read one it shows, or which two and how much of the second (1/256).
struct BlitAxis {
  int32_t first = 0;
  std::vector<int32_t> low, high;
  std::vector<int32_t> weight;
  int32_t source_first = 0, source_end = 0; // of the pixels that are read
  int32_t count() const { return int32_t(low.size()); }
};

/// Where an end of a rectangle lies on a surface whose pixels are numbered up or down.
double on_surface(double v, int size, bool down) { return down ? size - v : v; }

/// Rectangle ends from0, from1 of the read surface to to0, to1 of the drawn one. Pixels from outside the read
/// surface are not drawn; where two are mixed they are those at its edge.
BlitAxis make_axis(int from0, int from1, int from_size, bool from_down, int to0, int to1, int to_size,
                   bool to_down, bool linear) {
  BlitAxis axis;
  const double a = on_surface(to0, to_size, to_down), b = on_surface(to1, to_size, to_down);
  const double s = on_surface(from0, from_size, from_down), t = on_surface(from1, from_size, from_down);
  if (a == b || s == t) return axis;
  const int begin = std::max(int(std::min(a, b)), 0), end = int(std::min(std::max(a, b), double(to_size)));
  const double step = (t - s) / (b - a);
  axis.source_first = from_size;
  for (int i = begin; i < end; ++i) {
    const double at = s + (i + 0.5 - a) * step;
    if (at < 0 || at >= from_size) {
      if (axis.low.empty()) continue;
      break;
    }
    if (axis.low.empty()) axis.first = i;
    int low = int(at), high = low, weight = 0;
    if (linear) {
      const int fixed = int(std::lrint(at * 256)) - 128;
      low = std::clamp(fixed >> 8, 0, from_size - 1);
      high = fixed < 0 ? low : std::min(low + 1, from_size - 1);
      weight = fixed & 255;
    }
    axis.low.push_back(low);
    axis.high.push_back(high);
    axis.weight.push_back(weight);
    axis.source_first = std::min(axis.source_first, low);
    axis.source_end = std::max(axis.source_end, high + 1);
  }
  return axis;
}

struct Blit {
  BlitAxis columns, rows;
  bool linear;
  bool moved; // the rectangles are equally large
  bool visible() const { return columns.count() > 0 && rows.count() > 0; }
  int source_width() const { return columns.source_end - columns.source_first; }
  int source_height() const { return rows.source_end - rows.source_first; }
  size_t pixels() const { return size_t(columns.count()) * size_t(rows.count()); }
  size_t source_pixels() const { return size_t(source_width()) * size_t(source_height()); }
  WindowBox box() const {
    return {columns.first, rows.first, columns.first + columns.count(), rows.first + rows.count()};
  }
  /// Elements are the read pixels, row by row, or, where they are mixed, the drawn ones.
  const PixelImage& image(PixelElement kind, const void* element, Arena& arena) const {
    auto* column = arena.allocate_array<int32_t>(size_t(columns.count()));
    auto* row = arena.allocate_array<int32_t>(size_t(rows.count()));
    for (int i = 0; i < columns.count(); ++i)
      column[i] = linear ? i : columns.low[size_t(i)] - columns.source_first;
    for (int i = 0; i < rows.count(); ++i)
      row[i] = linear ? i * columns.count() : (rows.low[size_t(i)] - rows.source_first) * source_width();
    return *arena.make<PixelImage>(kind, element, columns.first, rows.first, columns.count(), rows.count(),
                                   column, row);
  }
};

int mix(int weight, int a, int b) { return a + ((weight * (b - a) + 128) >> 8); }
float mix(int weight, float a, float b) { return float(weight) * (1.0f / 256.0f) * (b - a) + a; }

/// Bilinear mixtures of groups of four components: across first, then along (as OSMesa 22.3.6 filters
/// textures).
template <class T, class Number> void mix_pixels(const Blit& blit, const T (*from)[4], T (*to)[4]) {
  const auto width = size_t(blit.source_width()), numbers = 4 * size_t(blit.columns.count());
  // Rows that are mixed across, which neighboring rows share.
  std::vector<T> mixed[2] = {std::vector<T>(numbers), std::vector<T>(numbers)};
  int32_t which[2] = {-1, -1};
  const int32_t *lefts = blit.columns.low.data(), *rights = blit.columns.high.data(),
                *weights = blit.columns.weight.data(), first = blit.columns.source_first;
  const auto across = [&](int32_t row) {
    const auto place = size_t(row & 1);
    T* out = mixed[place].data();
    if (which[place] == row) return out;
    which[place] = row;
    const T(*source)[4] = from + size_t(row - blit.rows.source_first) * width;
    for (size_t i = 0; i < numbers / 4; ++i) {
      const T *left = source[lefts[i] - first], *right = source[rights[i] - first];
      const int w = weights[i];
      for (size_t k = 0; k < 4; ++k) out[4 * i + k] = T(mix(w, Number(left[k]), Number(right[k])));
    }
    return out;
  };
  for (int y = 0; y < blit.rows.count(); ++y, to += blit.columns.count()) {
    const auto j = size_t(y);
    const T *low = across(blit.rows.low[j]), *high = across(blit.rows.high[j]);
    const int w = blit.rows.weight[j];
    T* out = *to;
    for (size_t i = 0; i < numbers; ++i) out[i] = T(mix(w, Number(low[i]), Number(high[i])));
  }
}

/// What is read, and the samples that are drawn (bit s: sample s).
struct BlitSamples {
  Surface from;
  unsigned to;
};

/// Colors are mixed and stored as linear ones (GL_EXT_framebuffer_sRGB, issue 17).
bool converts_srgb(const Context& c, const Surface& from) {
  return from.encoding.srgb && c.state.color_buffer.framebuffer_srgb;
}

bool keeps_bytes(const ColorEncoding& e) {
  return std::all_of(e.bits, e.bits + 4, [](uint8_t bits) { return bits == 0 || bits == 8; });
}

void blit_resolved_colors(Context& c, const Blit& blit, const BlitSamples& samples) {
  Arena& arena = c.frame.arena();
  const Surface& s = samples.from;
  const int x = blit.columns.source_first, y = blit.rows.source_first, width = blit.source_width();
  const auto columns = size_t(width), rows = size_t(blit.source_height());
  if (s.color_format == ColorFormat::Rgba8 && keeps_bytes(s.encoding) && !s.encoding.srgb) {
    // The surface that is drawn to has bytes, too: then it is the same to round now.
    auto* bytes = reinterpret_cast<uint8_t(*)[4]>(arena.allocate_array<uint32_t>(blit.source_pixels()));
    average_bytes(s, x, y, width, int(rows), bytes, columns);
    spread_colors(c.read->texels, bytes, blit.source_pixels());
    return submit_copy(c, blit.image(PixelElement::Bytes, bytes, arena), blit.box(), samples.to);
  }
  std::vector<unsigned char> row(columns * 16);
  std::vector<PixelFloats> sample(columns);
  auto* pixels = arena.allocate_array<PixelFloats>(blit.source_pixels());
  for (size_t j = 0; j < rows; ++j)
    average_samples(s, x, y + int(j), width, converts_srgb(c, s), row.data(), &sample[0].rgba,
                    &pixels[j * columns].rgba);
  spread_colors(c.read->texels, &pixels[0].rgba, blit.source_pixels());
  submit_copy(c, blit.image(PixelElement::Floats, pixels, arena), blit.box(), samples.to);
}

void blit_colors(Context& c, const Blit& blit, const BlitSamples& samples) {
  const Surface& s = samples.from;
  if (s.samples > 1) return blit_resolved_colors(c, blit, samples);
  Arena& arena = c.frame.arena();
  std::vector<unsigned char> row(size_t(blit.source_width()) * 16);
  const auto read = [&](auto* pixels, auto convert) {
    for (int y = 0; y < blit.source_height(); ++y) {
      copy_color_row(s, blit.columns.source_first, blit.rows.source_first + y, blit.source_width(),
                     row.data());
      auto* to = pixels + size_t(y) * size_t(blit.source_width());
      convert(s, row.data(), blit.source_width(), to);
      spread_colors(c.read->texels, to, size_t(blit.source_width()));
    }
  };
  const bool srgb = converts_srgb(c, s);
  // OSMesa 22.3.6: pixels that are but moved go through floats, others through bytes.
  if (s.color_format == ColorFormat::Rgba8 && !srgb && (keeps_bytes(s.encoding) || !blit.moved)) {
    auto* pixels = reinterpret_cast<uint8_t(*)[4]>(arena.allocate_array<uint32_t>(blit.source_pixels()));
    read(pixels, color_row_to_bytes);
    if (blit.linear) {
      auto* mixed = reinterpret_cast<uint8_t(*)[4]>(arena.allocate_array<uint32_t>(blit.pixels()));
      mix_pixels<uint8_t, int>(blit, pixels, mixed);
      pixels = mixed;
    }
    return submit_copy(c, blit.image(PixelElement::Bytes, pixels, arena), blit.box(), samples.to);
  }
  auto* pixels = reinterpret_cast<float(*)[4]>(arena.allocate_array<PixelFloats>(blit.source_pixels()));
  read(pixels, srgb ? color_row_to_linear_floats : color_row_to_floats);
  if (blit.linear) {
    auto* mixed = reinterpret_cast<float(*)[4]>(arena.allocate_array<PixelFloats>(blit.pixels()));
    mix_pixels<float, float>(blit, pixels, mixed);
    pixels = mixed;
  }
  submit_copy(c, blit.image(PixelElement::Floats, pixels, arena), blit.box(), samples.to);
}

/// The words that copy_row reads: where pixels have samples, of the first one.
template <class CopyRow>
uint32_t* read_words(Context& c, const Blit& blit, const Surface& from, CopyRow copy_row) {
  auto* words = c.frame.arena().allocate_array<uint32_t>(blit.source_pixels());
  for (int y = 0; y < blit.source_height(); ++y)
    copy_row(from, blit.columns.source_first, blit.rows.source_first + y, blit.source_width(),
             words + size_t(y) * size_t(blit.source_width()));
  return words;
}

void blit_depths(Context& c, const Blit& blit, const BlitSamples& samples) {
  uint32_t* words = read_words(c, blit, samples.from, copy_depth_stencil_row);
  const uint32_t mask = largest_depth(samples.from.depth_format);
  for (size_t i = 0; i < blit.source_pixels(); ++i) words[i] &= mask;
  submit_copy(c, blit.image(PixelElement::Depth, words, c.frame.arena()), blit.box(), samples.to);
}

void blit_stencils(Context& c, const Blit& blit, const BlitSamples& samples) {
  const uint32_t* words = read_words(c, blit, samples.from, copy_stencil_row);
  auto* stencil = c.frame.arena().allocate_array<uint8_t>(blit.source_pixels());
  std::transform(words, words + blit.source_pixels(), stencil, [](uint32_t v) { return uint8_t(v); });
  submit_stencils(c, blit.image(PixelElement::Stencil, stencil, c.frame.arena()), blit.box(), 0xff,
                  samples.to);
}

} // namespace

void gl::BlitFramebuffer(Context& c, GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1, GLint dstX0,
                         GLint dstY0, GLint dstX1, GLint dstY1, GLbitfield mask, GLenum filter) {
  if (mask & ~GLbitfield(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT))
    return set_error(c, GL_INVALID_VALUE, "mask");
  if (filter != GL_NEAREST && filter != GL_LINEAR) return set_error(c, GL_INVALID_ENUM, "filter");
  if ((mask & (GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)) && filter != GL_NEAREST)
    return set_error(c, GL_INVALID_OPERATION);
  if (!flush_for_reading(c) || !prepare_draw_target(c)) return set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
  const RenderTarget &from = *c.read, &to = *c.draw;
  // What is not in both is not copied.
  const bool color = (mask & GL_COLOR_BUFFER_BIT) && from.surface.color && to.surface.color &&
                     reads_color(c) && draws_color(c);
  const bool depth = (mask & GL_DEPTH_BUFFER_BIT) && from.depth_bits && to.depth_bits;
  const bool stencil = (mask & GL_STENCIL_BUFFER_BIT) && from.stencil_bits && to.stencil_bits;
  // Depths and stencil values of other formats: floats have 32 bits, and nothing else has.
  const bool mixes_floats =
      (from.surface.depth_format == DepthFormat::Z32F) != (to.surface.depth_format == DepthFormat::Z32F);
  if ((depth && from.depth_bits != to.depth_bits) || (stencil && mixes_floats))
    return set_error(c, GL_INVALID_OPERATION);
  const Surface &s = from.surface, &t = to.surface;
  const bool multisampled = s.samples > 1 || t.samples > 1;
  if (multisampled && color && (s.color_format != t.color_format || s.encoding != t.encoding))
    return set_error(c, GL_INVALID_OPERATION);
  // Ends so far away are not met by any surface, and their differences fit an integer.
  constexpr GLint kFar = 1 << 28;
  for (GLint* v : {&srcX0, &srcY0, &srcX1, &srcY1, &dstX0, &dstY0, &dstX1, &dstY1})
    *v = std::clamp(*v, -kFar, kFar);
  const bool same_size = std::abs(srcX1 - srcX0) == std::abs(dstX1 - dstX0) &&
                         std::abs(srcY1 - srcY0) == std::abs(dstY1 - dstY0);
  if (multisampled && !same_size) return set_error(c, GL_INVALID_OPERATION);
  if (!color && !depth && !stencil) return;
  Blit blit;
  blit.linear = filter == GL_LINEAR && !same_size;
  blit.moved = same_size;
  blit.columns = make_axis(srcX0, srcX1, s.width, false, dstX0, dstX1, t.width, false, blit.linear);
  blit.rows = make_axis(srcY0, srcY1, s.height, !s.y_up, dstY0, dstY1, t.height, !t.y_up, blit.linear);
  if (!blit.visible()) return;
  if (!c.bindings.draw) c.framebuffer.unresolved = true;
  const auto copy = [&](const BlitSamples& samples) {
    if (color) blit_colors(c, blit, samples);
    if (depth) blit_depths(c, blit, samples);
    if (stencil) blit_stencils(c, blit, samples);
  };
  if (s.samples > 1 && t.samples > 1)
    for (int i = 0; i < kSamples; ++i) copy({sample_surface(s, i), 1u << i});
  else
    copy({s, kAllSamples});
}

} // namespace softgl
