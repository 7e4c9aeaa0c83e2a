// glReadPixels (GL 1.5, 4.3.2).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "base/fast_paths.h"
#include "base/unit_range.h"
#include "commands/buffers/pixel_buffers.h"
#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "context/color_clamping.h"
#include "context/context.h"
#include "context/pixel_transfer.h"
#include "frame/parallel.h"
#include "shaders/common/seeded_faults.h"
#include "surface/plane_texels.h"
#include "surface/read_surface.h"
#include "texture/pixel_formats.h"
#include "texture/small_floats.h"
#include "texture/texel_format.h"

namespace softgl {
namespace {

/// Colors of attached images are converted as their texels are, where they are not those of windows, too.
bool reads_texels(const Context& c) {
  if (!c.read->texels) return false;
  const TexelFormat& f = *c.read->texels;
  const bool window = (f.base == GL_RGB || f.base == GL_RGBA) && f.array && !f.srgb &&
                      (f.layout == TexelLayout::Rgba8 || f.layout == TexelLayout::Rgba16);
  return !window && c.read->surface.color_format != ColorFormat::Rgb565;
}

/// The part of the rectangle that lies on the surface, and where it goes.
struct Target {
  int x, count;          // columns of the surface
  int first_row, rows;   // rows of the rectangle, bottom first
  int bottom;            // y (up) of row 0 of the rectangle
  unsigned char* memory; // the client's image
  PixelFormat format;
  ImageLayout layout;
  int skipped; // columns of the rectangle left of the surface
  bool swap;
  unsigned char* row(int r) const { return memory + layout.row(r); }
  unsigned char* pixels(int r) const { return row(r) + size_t(skipped) * format.bytes; }
};

bool has_float_type(const PixelFormat& f) {
  return f.channel == PixelChannel::Float || f.channel == PixelChannel::Half ||
         f.type == GL_UNSIGNED_INT_10F_11F_11F_REV;
}

/// Red, green and blue are summed for luminance, where there is more than one of them (4.3.2).
bool sums_luminance(const Context& c, const PixelFormat& f) {
  const TexelFormat* texels = c.read->texels;
  return f.luminance && !SOFTGL_FAULT(luminance_is_red) &&
         (!texels || texels->base == GL_RG || texels->base == GL_RGB || texels->base == GL_RGBA);
}

/// Whether colors are clamped to [0, 1] after the pixel transfer (GL_ARB_color_buffer_float, 4.3.2). What
/// cannot lie elsewhere is not.
bool clamps_read_colors(const Context& c, const PixelFormat& f) {
  const RenderTarget& target = *c.read;
  const ColorNumbers numbers = target.surface.encoding.numbers;
  if (numbers == ColorNumbers::Unsigned && !sums_luminance(c, f)) return false;
  const GLenum mode = c.state.color_buffer.clamp_read_color;
  // OSMesa 22.3.6 takes a window of floats for one of fixed point.
  if (mode == GL_FIXED_ONLY && !target.texels && !c.specification_answers) return true;
  if (clamps(target, mode)) return true;
  const bool has_sign =
      f.channel == PixelChannel::Byte || f.channel == PixelChannel::Short || f.channel == PixelChannel::Int;
  return !has_float_type(f) && !(numbers == ColorNumbers::Signed && has_sign);
}

/// Whether colors go through floats: pixel transfer, clamping, sums of luminance, and what OSMesa converts
/// that way.
bool needs_floats(const Context& c, const PixelFormat& f) {
  if (pixel_transfer(c).changes_color() || sums_luminance(c, f)) return true;
  if (reads_texels(c)) return clamps_read_colors(c, f);
  if (f.channel == PixelChannel::Packed && f.bits[0] > 8) return true;
  switch (c.read->surface.color_format) {
  case ColorFormat::Rgba8:
  case ColorFormat::Rgba16: return false;
  case ColorFormat::Rgb565:
    return f.channel != PixelChannel::UnsignedByte && f.channel != PixelChannel::Packed;
  default: return true;
  }
}

void transfer(const Context& c, float (*rgba)[4], int count, bool clamp, bool luminance) {
  const PixelTransfer operations = pixel_transfer(c);
  if (operations.changes_color()) operations.color(rgba, count);
  for (int i = 0; i < count; ++i) {
    float* p = rgba[i];
    if (clamp)
      for (int k = 0; k < 4; ++k) p[k] = unit_range(p[k]);
    if (luminance) {
      p[0] = p[0] + p[1] + p[2];
      if (clamp) p[0] = unit_range(p[0]);
    }
  }
}

/// The rows first .. end - 1 of the target. Scratch memory is the caller's: 16 bytes per pixel each.
void read_color_rows(const Context& c, const Target& t, int first, int end, unsigned char* row,
                     unsigned char* converted) {
  const Surface& s = c.read->surface;
  const auto copy_row = [&](int r, void* to) {
    copy_color_row(s, t.x, surface_row(s, t.bottom + r), t.count, to);
  };
  if (needs_floats(c, t.format)) {
    auto* rgba = reinterpret_cast<float(*)[4]>(converted);
    // OSMesa 22.3.6: floating-point surfaces are clamped when read; of others a transfer may leave [0,1] when
    // the result is signed or float, except where luminance is summed.
    const bool sums = sums_luminance(c, t.format);
    const bool clamp = clamps_read_colors(c, t.format);
    for (int r = first; r < end; ++r) {
      copy_row(r, row);
      color_row_to_floats(s, row, t.count, rgba);
      transfer(c, rgba, t.count, clamp, sums);
      pack_pixels(t.format, rgba, t.count, t.swap, t.pixels(r));
    }
  } else if (reads_texels(c)) {
    for (int r = first; r < end; ++r) {
      copy_row(r, row);
      pixels_to_texels(*c.read->texels, s.color_format, row, t.count, converted);
      load_texels(*c.read->texels, converted, t.format, t.pixels(r), t.count, t.swap);
    }
  } else if (s.color_format == ColorFormat::Rgba16) {
    for (int r = first; r < end; ++r) {
      copy_row(r, row);
      pack_pixels(t.format, reinterpret_cast<const uint16_t(*)[4]>(row), t.count, t.swap, t.pixels(r));
    }
  } else if (s.color_format == ColorFormat::Rgba8 && t.format.format == GL_RGBA &&
             t.format.channel == PixelChannel::UnsignedByte && takes(FastPath::CopiedRows)) {
    for (int r = first; r < end; ++r) copy_row(r, t.pixels(r));
  } else {
    auto* rgba = reinterpret_cast<uint8_t(*)[4]>(converted);
    for (int r = first; r < end; ++r) {
      copy_row(r, row);
      color_row_to_bytes(s, row, t.count, rgba);
      pack_pixels(t.format, rgba, t.count, t.swap, t.pixels(r));
    }
  }
}

void read_colors(const Context& c, const Target& t) {
  const size_t scratch_bytes = size_t(t.count) * 16;
  constexpr int kRowsPerTask = 32;
  // Rows that overlap (a row length below the width) have an order; a small rectangle is read before a thread
  // wakes.
  const bool overlapping = t.layout.row_stride < t.layout.row_bytes;
  const auto read = [&](int first, int end) {
    const std::unique_ptr<unsigned char[]> scratch(new unsigned char[2 * scratch_bytes]);
    read_color_rows(c, t, first, end, scratch.get(), scratch.get() + scratch_bytes);
  };
  const int end = t.first_row + t.rows;
  if (overlapping || int64_t(t.count) * t.rows < 128 * 1024) return read(t.first_row, end);
  in_parallel(size_t((t.rows + kRowsPerTask - 1) / kRowsPerTask), [&](size_t task) {
    const int first = t.first_row + int(task) * kRowsPerTask;
    read(first, std::min(first + kRowsPerTask, end));
  });
}

void read_depths(const Context& c, const Target& t) {
  const Surface& s = c.read->surface;
  const PixelTransfer operations = pixel_transfer(c);
  const bool scale = operations.changes_depth();
  std::vector<uint32_t> row(static_cast<size_t>(t.count));
  std::vector<float> depth(static_cast<size_t>(t.count));
  for (int r = t.first_row; r < t.first_row + t.rows; ++r) {
    copy_depth_stencil_row(s, t.x, surface_row(s, t.bottom + r), t.count, row.data());
    if (t.format.channel == PixelChannel::UnsignedInt && s.depth_format != DepthFormat::Z32F && !scale &&
        !t.swap) {
      // OSMesa: the bits are repeated, which a float could not hold.
      unsigned char* out = t.pixels(r);
      for (int i = 0; i < t.count; ++i) {
        const uint32_t z = row[size_t(i)] & 0xffffff;
        const uint32_t v =
            s.depth_format == DepthFormat::Z16 ? (z & 0xffff) << 16 | (z & 0xffff) : z << 8 | z >> 16;
        std::memcpy(out + 4 * i, &v, 4);
      }
      continue;
    }
    depths_to_floats(s.depth_format, row.data(), t.count, depth.data());
    if (scale) operations.depths(depth.data(), t.count);
    pack_depth(t.format, depth.data(), t.count, t.swap, t.pixels(r));
  }
}

/// GL_DEPTH_STENCIL: words of both.
void read_depths_and_stencils(const Context& c, const Target& t) {
  const Surface& s = c.read->surface;
  const PixelTransfer operations = pixel_transfer(c);
  const StencilTransfer stencil_transfer(operations);
  const bool scale = operations.changes_depth();
  std::vector<uint32_t> depth(static_cast<size_t>(t.count)), stencil(depth.size());
  for (int r = t.first_row; r < t.first_row + t.rows; ++r) {
    copy_depth_stencil_row(s, t.x, surface_row(s, t.bottom + r), t.count, depth.data());
    copy_stencil_row(s, t.x, surface_row(s, t.bottom + r), t.count, stencil.data());
    for (uint32_t& v : stencil) v = stencil_transfer(v);
    unsigned char* out = t.pixels(r);
    if (s.depth_format == DepthFormat::Z24S8 && !scale && t.format.type == GL_UNSIGNED_INT_24_8) {
      // Words on both sides.
      for (size_t i = 0; i < depth.size(); ++i) {
        uint32_t word = depth[i] << 8 | stencil[i];
        if (t.swap) word = __builtin_bswap32(word);
        std::memcpy(out + 4 * i, &word, 4);
      }
      continue;
    }
    for (size_t i = 0; i < depth.size(); ++i, out += t.format.bytes) {
      DepthStencilPixel v;
      v.integer = s.depth_format != DepthFormat::Z32F;
      v.bits = depth[i] & 0xffffff;
      v.depth = depth_to_float(s.depth_format, depth[i]);
      v.stencil = stencil[i];
      if (scale) {
        v.depth = operations.depth(v.depth);
        v.integer = false;
      }
      pack_depth_stencil(t.format, v, t.swap, out);
    }
  }
}

template <class T> void store(unsigned char* to, T v, bool swap) {
  std::memcpy(to, &v, sizeof v);
  if (swap && sizeof v > 1) std::reverse(to, to + sizeof v);
}

void read_stencils(const Context& c, const Target& t) {
  const Surface& s = c.read->surface;
  const PixelTransfer operations = pixel_transfer(c);
  const StencilTransfer stencil(operations);
  std::vector<uint32_t> row(static_cast<size_t>(t.count));
  for (int r = t.first_row; r < t.first_row + t.rows; ++r) {
    copy_stencil_row(s, t.x, surface_row(s, t.bottom + r), t.count, row.data());
    for (uint32_t& v : row) v = stencil(v);
    unsigned char* out = t.pixels(r);
    const auto each = [&](auto value) {
      for (size_t i = 0; i < row.size(); ++i) store(out + i * sizeof(value(0u)), value(row[i]), t.swap);
    };
    switch (t.format.channel) {
    case PixelChannel::UnsignedByte: each([](uint32_t v) { return uint8_t(v); }); break;
    case PixelChannel::Byte: each([](uint32_t v) { return uint8_t(v & 0x7f); }); break;
    case PixelChannel::UnsignedShort:
    case PixelChannel::Short: each([](uint32_t v) { return uint16_t(v); }); break;
    case PixelChannel::UnsignedInt:
    case PixelChannel::Int: each([](uint32_t v) { return v; }); break;
    case PixelChannel::Float: each([](uint32_t v) { return float(v); }); break;
    case PixelChannel::Half: each([](uint32_t v) { return float_to_half(float(v)); }); break;
    case PixelChannel::Bitmap:
      for (size_t i = 0; i < row.size(); ++i) {
        const size_t bit = size_t(t.layout.bit_offset) + size_t(t.skipped) + i;
        const uint8_t mask =
            c.client.pixel_store.pack.lsb_first ? uint8_t(1u << (bit & 7)) : uint8_t(0x80u >> (bit & 7));
        unsigned char& byte = t.row(r)[bit >> 3];
        byte = row[i] ? byte | mask : byte & uint8_t(~mask);
      }
      break;
    default: break;
    }
  }
}

Refusal check_size(GLsizei width, GLsizei height) {
  const char* wrong = first_wrong({{"width", width < 0}, {"height", height < 0}});
  return wrong ? Refusal{GL_INVALID_VALUE, wrong} : Refusal{};
}

/// Whether what is read lacks the buffer of a format, which is wrong also with a type that does not fit, as
/// in OSMesa.
bool lacks_buffer(const RenderTarget& read, GLenum format) {
  return format == GL_COLOR_INDEX || // there are no color index buffers
         (format == GL_DEPTH_COMPONENT && read.depth_bits == 0) ||
         (format == GL_STENCIL_INDEX && read.stencil_bits == 0);
}

/// The error that the arguments call for (4.3.2).
Refusal check(const Context& c, GLsizei width, GLsizei height, GLenum format, GLenum type) {
  if (const Refusal refusal = check_size(width, height)) return refusal;
  if (c.read->surface.samples > 1 || lacks_buffer(*c.read, format)) return {GL_INVALID_OPERATION};
  if (const Refusal refusal = check_pixel_format(format, type)) return refusal;
  if (format == GL_DEPTH_STENCIL && (c.read->depth_bits == 0 || c.read->stencil_bits == 0))
    return {GL_INVALID_OPERATION};
  const bool color = format != GL_DEPTH_COMPONENT && format != GL_STENCIL_INDEX && format != GL_DEPTH_STENCIL;
  return color && !reads_color(c) ? Refusal{GL_INVALID_OPERATION} : Refusal{};
}

} // namespace

void gl::ReadPixels(Context& c, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                    void* pixels) {
  if (c.bindings.read && !flush_for_reading(c)) {
    Refusal refusal = check_size(width, height);
    if (!refusal) refusal = check_pixel_format(format, type);
    return set_error(c, refusal ? refusal : Refusal{GL_INVALID_FRAMEBUFFER_OPERATION});
  }
  if (const Refusal refusal = check(c, width, height, format, type)) return set_error(c, refusal);
  if (width == 0 || height == 0) return;
  const PixelFormat pixel = describe_pixel_format(format, type);
  const ImageLayout layout = layout_image(c.client.pixel_store.pack, 2, width, height, pixel);
  if (!find_pack_memory(c, pixels, image_span(c.client.pixel_store.pack, layout, height, 1, pixel)) ||
      !pixels)
    return;
  flush_for_reading(c);
  if (!c.bindings.read)
    c.framebuffer.unresolved = true; // OSMesa: a read, too, makes the next glFlush write the caller's buffer
  ++c.framebuffer.counts.reads;

  const Surface& s = c.read->surface;
  const int64_t left = std::max<int64_t>(x, 0), right = std::min<int64_t>(int64_t(x) + width, s.width);
  const int64_t bottom = std::max<int64_t>(y, 0), top = std::min<int64_t>(int64_t(y) + height, s.height);
  if (left >= right || bottom >= top) return;
  Target t{};
  t.x = int(left);
  t.count = int(right - left);
  t.first_row = int(bottom - y);
  t.rows = int(top - bottom);
  t.bottom = y;
  t.memory = static_cast<unsigned char*>(pixels);
  t.format = pixel;
  t.layout = layout;
  t.skipped = int(left - x);
  t.swap = c.client.pixel_store.pack.swap_bytes;
  if (format == GL_DEPTH_COMPONENT) return read_depths(c, t);
  if (format == GL_DEPTH_STENCIL) return read_depths_and_stencils(c, t);
  if (format == GL_STENCIL_INDEX) return read_stencils(c, t);
  read_colors(c, t);
}

} // namespace softgl
