// glDrawPixels, glCopyPixels and glBitmap (GL 1.5, 3.6.4, 4.3.3 and 3.7): images on their way into the
// window.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include "base/unit_range.h"
#include "commands/buffers/pixel_buffers.h"
#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "context/context.h"
#include "context/pixel_transfer.h"
#include "shaders/common/seeded_faults.h"
#include "shaders/fragment/pixel_image.h"
#include "snapshot/feedback.h"
#include "snapshot/render_targets.h"
#include "snapshot/submit.h"
#include "surface/read_surface.h"
#include "texture/pixel_formats.h"

namespace softgl {
namespace {

/// Elements [first, end) of an image that are in view along one axis, and for each pixel of the window from
/// `pixel` on which of them it shows.
struct Axis {
  int32_t pixel = 0, pixels = 0;
  int32_t first = 0, end = 0;
  std::vector<int32_t> element;
};

/// Pixels whose centres lie between the ends of `count` elements of size `zoom` from `start` on, of the
/// window's `size` pixels, which are numbered `down` or up. The ends are in 1/256 of a pixel, as those of
/// polygons are.
Axis place(double start, int count, double zoom, int size, bool down) {
  Axis axis;
  const double stop = start + count * zoom;
  if (!(std::fabs(start) < 65536 && std::fabs(stop) < 65536) || start == stop) return axis;
  auto in_window = [&](double v) { return down ? size - v : v; };
  const double from = in_window(start), to = in_window(stop);
  auto snap = [](double v) { return int32_t(std::lround((v - 0.5) * 256)); };
  auto pixel_at = [&](double v) {
    return down ? (snap(v) >> 8) + 1 : (snap(v) + 255) >> 8;
  }; // left and lower ends are inside
  const int32_t begin = std::max(pixel_at(std::min(from, to)), 0),
                end = std::min(pixel_at(std::max(from, to)), size);
  if (begin >= end) return axis;
  axis.pixel = begin;
  axis.pixels = end - begin;
  auto element_at = [&](int32_t i) {
    // A centre on the border of two elements belongs to the one on its right or above it.
    const double at = (in_window(i + 0.5) - start) / zoom;
    return int32_t(zoom > 0 ? std::floor(at) : std::ceil(at) - 1);
  };
  axis.element.resize(size_t(axis.pixels));
  int32_t* const element = axis.element.data();
  // As large as pixels, elements follow one another: all numbers here are exact.
  const int32_t first = element_at(begin), step = down ? -1 : 1;
  for (int32_t i = 0; i < axis.pixels; ++i)
    element[i] = std::clamp(zoom == 1 ? first + i * step : element_at(begin + i), 0, count - 1);
  const auto [least, most] = std::minmax_element(axis.element.begin(), axis.element.end());
  axis.first = *least, axis.end = *most + 1;
  for (int32_t& e : axis.element) e -= axis.first;
  return axis;
}

/// An image of width x height elements whose lower left corner (or, with a negative zoom, another one) is at
/// x, y of the window.
struct Placement {
  Axis columns, rows;

  Placement(const Surface& surface, float x, float y, int width, int height, float zoom_x, float zoom_y)
      : columns(place(x, width, zoom_x, surface.width, false)),
        rows(place(y, height, zoom_y, surface.height, !surface.y_up)) {
    for (int32_t& e : rows.element) e *= width_in_view();
  }
  bool visible() const { return columns.pixels > 0 && rows.pixels > 0; }
  int width_in_view() const { return columns.end - columns.first; }
  int height_in_view() const { return rows.end - rows.first; }
  size_t elements() const { return size_t(width_in_view()) * size_t(height_in_view()); }

  WindowBox box() const {
    return {columns.pixel, rows.pixel, columns.pixel + columns.pixels, rows.pixel + rows.pixels};
  }
  const PixelImage& image(PixelElement kind, const void* element, Arena& arena) const {
    auto copy = [&](const std::vector<int32_t>& v) {
      return std::copy(v.begin(), v.end(), arena.allocate_array<int32_t>(v.size())) - v.size();
    };
    return *arena.make<PixelImage>(kind, element, columns.pixel, rows.pixel, columns.pixels, rows.pixels,
                                   copy(columns.element), copy(rows.element));
  }
};

/// Placed at the raster position, enlarged as glPixelZoom says.
Placement place_at_raster_position(Context& c, int width, int height) {
  const RasterPosition& p = c.state.raster_position;
  auto pixel = [](float v) { return std::round(v); };
  return Placement(
      c.draw->surface, pixel(p.window.x), pixel(p.window.y), width, height,
      SOFTGL_FAULT(zoom_always_positive) ? std::fabs(c.state.pixel_mode.zoom_x) : c.state.pixel_mode.zoom_x,
      SOFTGL_FAULT(zoom_always_positive) ? std::fabs(c.state.pixel_mode.zoom_y) : c.state.pixel_mode.zoom_y);
}

/// The client's image, in its memory or in the unpack buffer.
struct ClientImage {
  const unsigned char* memory;
  PixelFormat format;
  ImageLayout layout;
  bool swap, lsb_first;

  ClientImage(const Context& c, const void* pixels, int width, int height, GLenum f, GLenum type)
      : memory(static_cast<const unsigned char*>(pixels)), format(describe_pixel_format(f, type)),
        layout(layout_image(c.client.pixel_store.unpack, 2, width, height, format)),
        swap(c.client.pixel_store.unpack.swap_bytes && !SOFTGL_FAULT(swap_ignored)),
        lsb_first(c.client.pixel_store.unpack.lsb_first && !SOFTGL_FAULT(lsb_first_ignored)) {}

  PixelSpan span(const Context& c, int height) const {
    return image_span(c.client.pixel_store.unpack, layout, height, 1, format);
  }
  const unsigned char* at(int column, int row) const {
    return memory + layout.offset + size_t(row) * layout.row_stride + size_t(column) * format.bytes;
  }
  void indexes(int column, int row, int count, uint32_t* index) const {
    const bool bits = format.channel == PixelChannel::Bitmap;
    unpack_indexes(format, at(column, row), bits ? layout.bit_offset + column : 0, count, swap, lsb_first,
                   index);
  }
};

/// None, and the error, where the unpack buffer does not hold the image. Without pixels its memory is null.
std::optional<ClientImage> client_image(Context& c, const void* pixels, int width, int height, GLenum format,
                                        GLenum type) {
  ClientImage image(c, nullptr, width, height, format, type);
  if (!find_unpack_memory(c, pixels, image.span(c, height))) return std::nullopt;
  image.memory = static_cast<const unsigned char*>(pixels);
  return image;
}

/// Depths, which become those after the pixel transfer, as the surface stores them.
void store_depths(const Surface& surface, const PixelTransfer& transfer, float* depth, size_t count,
                  uint32_t* stored) {
  transfer.depths(depth, count);
  floats_to_depths(surface.depth_format, depth, count, stored);
}

/// Calls fill(row, elements of the row) for the rows in view of an image of T and returns the image.
template <class T, class Fill> T* fill_rows(Context& c, const Placement& p, Fill fill) {
  T* element = c.frame.arena().allocate_array<T>(p.elements());
  for (int r = 0; r < p.height_in_view(); ++r)
    fill(p.rows.first + r, element + size_t(r) * size_t(p.width_in_view()));
  return element;
}

using FloatRow = float (*)[4];
using ByteRow = uint8_t (*)[4];

/// `element` lies in the frame's arena.
void submit_image(Context& c, const Placement& p, PixelElement kind, const void* element) {
  submit_pixels(c, p.image(kind, element, c.frame.arena()), p.box());
}

/// Stencil values after the pixel transfer; `value` lies in the frame's arena.
void submit_stencils(Context& c, const Placement& p, const uint8_t* value) {
  if (const uint32_t mask = c.state.stencil.front.write_mask & 0xff)
    softgl::submit_stencils(c, p.image(PixelElement::Stencil, value, c.frame.arena()), p.box(), mask);
}

void draw_colors(Context& c, const Placement& p, const ClientImage& image) {
  const PixelTransfer transfer = pixel_transfer(c);
  const int count = p.width_in_view();
  if (image.format.channel == PixelChannel::UnsignedByte && !transfer.changes_color()) {
    return submit_image(c, p, PixelElement::Bytes, fill_rows<uint32_t>(c, p, [&](int row, uint32_t* element) {
                          unpack_pixels(image.format, image.at(p.columns.first, row), count, image.swap,
                                        reinterpret_cast<ByteRow>(element));
                        }));
  }
  submit_image(c, p, PixelElement::Floats, fill_rows<PixelFloats>(c, p, [&](int row, PixelFloats* element) {
                 auto* rgba = reinterpret_cast<FloatRow>(element);
                 unpack_pixels(image.format, image.at(p.columns.first, row), count, image.swap, rgba);
                 if (transfer.changes_color()) transfer.color(rgba, count);
               }));
}

void draw_color_indexes(Context& c, const Placement& p, const ClientImage& image) {
  const PixelTransfer transfer = pixel_transfer(c);
  std::vector<uint32_t> index(size_t(p.width_in_view()));
  submit_image(c, p, PixelElement::Floats, fill_rows<PixelFloats>(c, p, [&](int row, PixelFloats* element) {
                 image.indexes(p.columns.first, row, p.width_in_view(), index.data());
                 for (size_t i = 0; i < index.size(); ++i) transfer.index_to_color(index[i], element[i].rgba);
               }));
}

void draw_depths(Context& c, const Placement& p, const ClientImage& image) {
  const PixelTransfer transfer = pixel_transfer(c);
  std::vector<float> depth(size_t(p.width_in_view()));
  submit_image(c, p, PixelElement::Depth, fill_rows<uint32_t>(c, p, [&](int row, uint32_t* element) {
                 unpack_depth(image.format, image.at(p.columns.first, row), p.width_in_view(), image.swap,
                              depth.data());
                 store_depths(c.draw->surface, transfer, depth.data(), depth.size(), element);
               }));
}

void draw_stencils(Context& c, const Placement& p, const ClientImage& image) {
  const PixelTransfer transfer = pixel_transfer(c);
  const StencilTransfer stencil(transfer);
  std::vector<uint32_t> index(size_t(p.width_in_view()));
  submit_stencils(c, p, fill_rows<uint8_t>(c, p, [&](int row, uint8_t* element) {
                    image.indexes(p.columns.first, row, p.width_in_view(), index.data());
                    std::transform(index.begin(), index.end(), element, stencil);
                  }));
}

/// GL_DEPTH_STENCIL: both go to their buffers whatever the tests are, under the masks (4.3.1).
void submit_depths_and_stencils(Context& c, const Placement& p, std::vector<float> depth,
                                const std::vector<uint8_t>& stencil) {
  const PixelTransfer transfer = pixel_transfer(c);
  if (c.state.depth.mask) {
    auto* element = c.frame.arena().allocate_array<uint32_t>(depth.size());
    store_depths(c.draw->surface, transfer, depth.data(), depth.size(), element);
    submit_copy(c, p.image(PixelElement::Depth, element, c.frame.arena()), p.box());
  }
  auto* value = c.frame.arena().allocate_array<uint8_t>(stencil.size());
  std::transform(stencil.begin(), stencil.end(), value, StencilTransfer(transfer));
  submit_stencils(c, p, value);
}

void draw_depths_and_stencils(Context& c, const Placement& p, const ClientImage& image) {
  std::vector<float> depth(p.elements());
  std::vector<uint8_t> stencil(p.elements());
  const size_t count = size_t(p.width_in_view());
  for (int r = 0; r < p.height_in_view(); ++r)
    unpack_depths_and_stencils(image.format, image.at(p.columns.first, p.rows.first + r), p.width_in_view(),
                               image.swap, depth.data() + size_t(r) * count,
                               stencil.data() + size_t(r) * count);
  submit_depths_and_stencils(c, p, std::move(depth), stencil);
}

bool becomes_color(GLenum type) {
  return type == GL_DEPTH_STENCIL_TO_RGBA_NV || type == GL_DEPTH_STENCIL_TO_BGRA_NV;
}

/// GL_NV_copy_depth_to_color: the words of 24 bits of depth and 8 of stencil are taken for four bytes of
/// color.
void submit_depths_as_colors(Context& c, const Placement& p, const std::vector<float>& depth,
                             const std::vector<uint8_t>& stencil, bool bgra) {
  const PixelTransfer transfer = pixel_transfer(c);
  auto* element = c.frame.arena().allocate_array<uint32_t>(depth.size());
  for (size_t i = 0; i < depth.size(); ++i) {
    const auto z = uint32_t(double(unit_range(transfer.depth(depth[i]))) * 16777215.0 + 0.5);
    const uint32_t first = z >> 16, second = z >> 8 & 255, third = z & 255;
    element[i] = (bgra ? third | first << 16 : first | third << 16) | second << 8 |
                 (transfer.stencil(stencil[i]) & 255) << 24;
  }
  submit_image(c, p, PixelElement::Bytes, element);
}

/// Copies what is in view of an image whose lower left pixel is x, y of the surface. The frame is empty.
void copy_pixels(Context& c, const Placement& p, GLint x, GLint y, GLenum type) {
  if (SOFTGL_FAULT(copied_row_too_high)) y += 1;
  const PixelTransfer transfer = pixel_transfer(c);
  const auto bounded = [](int64_t v) { return int(std::clamp<int64_t>(v, -(1 << 30), 1 << 30)); };
  const int count = p.width_in_view(), left = bounded(int64_t(x) + p.columns.first),
            bottom = bounded(int64_t(y) + p.rows.first);
  if (type == GL_DEPTH_STENCIL || becomes_color(type)) {
    std::vector<float> depth(p.elements());
    std::vector<uint8_t> stencil(p.elements());
    read_depth_float(c.read->surface, left, bottom, count, p.height_in_view(), depth.data());
    read_stencil(c.read->surface, left, bottom, count, p.height_in_view(), stencil.data());
    if (becomes_color(type))
      return submit_depths_as_colors(c, p, depth, stencil, type == GL_DEPTH_STENCIL_TO_BGRA_NV);
    return submit_depths_and_stencils(c, p, std::move(depth), stencil);
  }
  if (type == GL_STENCIL) {
    auto* value = c.frame.arena().allocate_array<uint8_t>(p.elements());
    read_stencil(c.read->surface, left, bottom, count, p.height_in_view(), value);
    std::transform(value, value + p.elements(), value, StencilTransfer(transfer));
    return submit_stencils(c, p, value);
  }
  if (type == GL_DEPTH) {
    std::vector<float> depth(p.elements());
    read_depth_float(c.read->surface, left, bottom, count, p.height_in_view(), depth.data());
    auto* element = c.frame.arena().allocate_array<uint32_t>(depth.size());
    store_depths(c.draw->surface, transfer, depth.data(), depth.size(), element);
    return submit_image(c, p, PixelElement::Depth, element);
  }
  if (c.read->surface.color_format == ColorFormat::Rgba8 && !transfer.changes_color()) {
    auto* element = c.frame.arena().allocate_array<uint32_t>(p.elements());
    read_rgba8(c.read->surface, left, bottom, count, p.height_in_view(), reinterpret_cast<ByteRow>(element));
    spread_colors(c.read->texels, reinterpret_cast<ByteRow>(element), p.elements());
    return submit_image(c, p, PixelElement::Bytes, element);
  }
  auto* element = c.frame.arena().allocate_array<PixelFloats>(p.elements());
  read_rgba_float(c.read->surface, left, bottom, count, p.height_in_view(),
                  reinterpret_cast<FloatRow>(element));
  spread_colors(c.read->texels, reinterpret_cast<FloatRow>(element), p.elements());
  if (transfer.changes_color()) transfer.color(reinterpret_cast<FloatRow>(element), int(p.elements()));
  submit_image(c, p, PixelElement::Floats, element);
}

bool has_buffer(const RenderTarget& target, GLenum format) {
  if (format == GL_DEPTH_COMPONENT || format == GL_DEPTH) return target.depth_bits > 0;
  if (format == GL_STENCIL_INDEX || format == GL_STENCIL) return target.stencil_bits > 0;
  if (format == GL_DEPTH_STENCIL || becomes_color(format))
    return target.depth_bits > 0 && target.stencil_bits > 0;
  return true;
}

} // namespace

namespace gl {

void DrawPixels(Context& c, GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels) {
  if (const char* wrong = first_wrong({{"width", width < 0}, {"height", height < 0}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  if (const Refusal refusal = check_pixel_format(format, type)) return set_error(c, refusal);
  if (!ready_to_draw(c)) return;
  if (!has_buffer(*c.draw, format)) return set_error(c, GL_INVALID_OPERATION);
  if (!c.state.raster_position.valid && !SOFTGL_FAULT(invalid_position_draws)) return;
  if (c.state.render_mode.mode != GL_RENDER) return feed_back_pixels(c, GL_DRAW_PIXEL_TOKEN);
  if (width == 0 || height == 0) return;
  const std::optional<ClientImage> found = client_image(c, pixels, width, height, format, type);
  if (!found || !found->memory) return;
  const ClientImage& image = *found;
  const Placement p = place_at_raster_position(c, width, height);
  if (!p.visible()) return;
  switch (format) {
  case GL_COLOR_INDEX: return draw_color_indexes(c, p, image);
  case GL_DEPTH_COMPONENT: return draw_depths(c, p, image);
  case GL_DEPTH_STENCIL: return draw_depths_and_stencils(c, p, image);
  case GL_STENCIL_INDEX: return draw_stencils(c, p, image);
  default: return draw_colors(c, p, image);
  }
}

void CopyPixels(Context& c, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type) {
  if (const char* wrong = first_wrong({{"width", width < 0}, {"height", height < 0}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  if (type != GL_COLOR && type != GL_DEPTH && type != GL_STENCIL && type != GL_DEPTH_STENCIL &&
      !becomes_color(type))
    return set_error(c, GL_INVALID_ENUM, "type");
  if (c.bindings.draw || c.bindings.read) {
    if (!ready_to_draw(c)) return;
    if (!flush_for_reading(c)) return set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
  }
  if (c.read->surface.samples > 1 || !has_buffer(*c.draw, type) || !has_buffer(*c.read, type) ||
      (type == GL_COLOR && !reads_color(c)))
    return set_error(c, GL_INVALID_OPERATION);
  if (!c.state.raster_position.valid) return;
  if (c.state.render_mode.mode != GL_RENDER) return feed_back_pixels(c, GL_COPY_PIXEL_TOKEN);
  if (width == 0 || height == 0) return;
  flush_for_reading(c); // before anything lies in the frame's arena
  if (const Placement p = place_at_raster_position(c, width, height); p.visible())
    copy_pixels(c, p, x, y, type);
}

void Bitmap(Context& c, GLsizei width, GLsizei height, GLfloat xorig, GLfloat yorig, GLfloat xmove,
            GLfloat ymove, const GLubyte* bitmap) {
  if (const char* wrong = first_wrong({{"width", width < 0}, {"height", height < 0}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  if (!ready_to_draw(c)) return;
  RasterPosition& position = c.state.raster_position;
  if (!position.valid) return;
  if (c.state.render_mode.mode != GL_RENDER)
    feed_back_pixels(c, GL_BITMAP_TOKEN);
  else if (width > 0 && height > 0) {
    const std::optional<ClientImage> found =
        client_image(c, bitmap, width, height, GL_COLOR_INDEX, GL_BITMAP);
    if (!found) return;
    const ClientImage& image = *found;
    // Positions that are whole numbers but for a rounding error stay what they are, as in OSMesa.
    auto pixel = [](float v) {
      return SOFTGL_FAULT(bitmap_rounds) ? std::round(v) : std::floor(v + 0.0001f);
    };
    const Placement p(c.draw->surface, pixel(position.window.x - xorig), pixel(position.window.y - yorig),
                      width, height, 1, 1);
    if (image.memory && p.visible()) {
      std::vector<uint32_t> index(size_t(p.width_in_view()));
      const auto* bit = fill_rows<uint8_t>(c, p, [&](int row, uint8_t* element) {
        image.indexes(p.columns.first, row, p.width_in_view(), index.data());
        for (size_t i = 0; i < index.size(); ++i) element[i] = uint8_t(index[i]);
      });
      submit_image(c, p, PixelElement::Bit, bit);
    }
  }
  if (SOFTGL_FAULT(bitmap_does_not_move)) return;
  position.window.x += xmove;
  position.window.y += ymove;
}

} // namespace gl
} // namespace softgl
