// Planes that are drawn to apart from the window: of a renderbuffer, or of a slice of a texture's image
// (GL_ARB_framebuffer_object, 4.4.2).
#pragma once

#include <memory>
#include <vector>

#include "base/gl_types.h"
#include "shaders/common/surface.h"

namespace softgl {

struct RenderTarget; // framebuffer.h
struct TexelFormat;

/// How an image is stored while it is drawn to, and which of it counts.
struct RenderFormat {
  enum class Kind : uint8_t { None, Color, DepthStencil } kind = Kind::None; // None: it cannot be drawn to
  ColorFormat color = ColorFormat::Rgba8;
  ColorEncoding encoding;              // of colors
  const TexelFormat* texels = nullptr; // of colors: how an image of texels stores them
  DepthFormat depth = DepthFormat::None;
  uint8_t bits[4] = {}; // red, green, blue, alpha; not those of luminance and intensity
  uint8_t depth_bits = 0, stencil_bits = 0;

  bool is_color() const { return kind == Kind::Color; }
  bool has_alpha() const { return encoding.bits[3] != 0; }
  /// Depths are floats.
  bool has_floats() const { return depth == DepthFormat::Z32F; }
  /// Stencil values have words of their own, behind those of the depths (DepthFormat).
  bool has_stencil_words() const { return has_floats() && stencil_bits > 0; }
  /// Blits of depths and stencil values ask for equal formats.
  bool operator==(const RenderFormat&) const = default;
};

/// The format of a renderbuffer, that of a texture of the same internal format; Kind::None where
/// `internal_format` is not color-, depth- or stencil-renderable, or has no size and is of sRGB.
RenderFormat renderbuffer_format(GLenum internal_format);
/// The format in which images of texels are drawn to; Kind::None where they cannot be, whose bits are known,
/// too.
RenderFormat render_format(const TexelFormat& texels);

/// Memory of one plane, with one or kSamples samples a pixel. Its tiles have fixed places.
struct RenderPlane {
  RenderFormat format;
  int width = 0, height = 0, samples = 1, tiles_x = 0, tiles_y = 0;
  void* memory = nullptr;
  size_t bytes = 0;
  std::vector<TileWords> tile;
  /// Of an image's tile, whose texels are all the same: the word they were made of. A shadow map that is
  /// cleared and drawn anew for every frame is stored where it is drawn on.
  struct StoredWord {
    bool known = false;
    uint32_t word = 0;
  };
  std::vector<StoredWord> stored;

  /// Zeros; alpha 1 where there is none. Throws std::bad_alloc.
  RenderPlane(const RenderFormat& format, int width, int height, int samples = 1);
  ~RenderPlane();
  RenderPlane(const RenderPlane&) = delete;
  RenderPlane& operator=(const RenderPlane&) = delete;

  uint32_t tiles() const { return uint32_t(tiles_x) * uint32_t(tiles_y); }
  /// The plane's pixels from those of tile `i` on; stencil words are behind those of the tile.
  unsigned char* pixels(uint32_t i) const;
  /// Where a sample of the tile's pixel `at` is, counted from pixels().
  size_t place(size_t at, int sample) const { return at * size_t(samples) + size_t(sample); }
  int pixel_bytes() const { return format.is_color() ? bytes_per_pixel(format.color) : 4; }
};

/// A surface of width x height pixels, which lie in both planes; each may be null, but they have equally many
/// samples. Its rows go up. `depth` and `stencil`: those values of the plane count.
void assemble(GLuint name, int width, int height, RenderPlane* color, RenderPlane* depth_stencil, bool depth,
              bool stencil, RenderTarget& target);

} // namespace softgl
