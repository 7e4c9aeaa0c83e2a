#include "surface/render_plane.h"

#include <algorithm>
#include <new>

#include "base/pages.h"
#include "surface/framebuffer.h"
#include "texture/texel_format.h"

namespace softgl {
namespace {

RenderFormat color_format(ColorFormat format, int red, int green, int blue, int alpha) {
  RenderFormat f;
  f.kind = RenderFormat::Kind::Color;
  f.color = format;
  const int bits[4] = {red, green, blue, alpha};
  for (int i = 0; i < 4; ++i) f.bits[i] = uint8_t(bits[i]);
  return f;
}

/// Of 32 bits are floats only.
RenderFormat depth_format(int depth, int stencil) {
  RenderFormat f;
  f.kind = RenderFormat::Kind::DepthStencil;
  f.depth = depth == 32                   ? DepthFormat::Z32F
            : depth == 16 && stencil == 0 ? DepthFormat::Z16
                                          : DepthFormat::Z24S8;
  f.depth_bits = uint8_t(depth);
  f.stencil_bits = uint8_t(stencil);
  return f;
}

} // namespace

RenderFormat renderbuffer_format(GLenum internal_format) {
  switch (internal_format) {
  case GL_RGBA:
  case GL_RGBA2:
  case GL_RGBA4:
  case GL_RGB5_A1:
  case GL_RGBA8: return color_format(ColorFormat::Rgba8, 8, 8, 8, 8);
  case GL_R3_G3_B2:
  case GL_RGB:
  case GL_RGB4:
  case GL_RGB5:
  case GL_RGB8: return color_format(ColorFormat::Rgba8, 8, 8, 8, 0);
  case GL_RGB565: return color_format(ColorFormat::Rgb565, 5, 6, 5, 0);
  case GL_RGB10:
  case GL_RGB12:
  case GL_RGB16: return color_format(ColorFormat::Rgba16, 16, 16, 16, 0);
  case GL_RGB10_A2:
  case GL_RGBA12:
  case GL_RGBA16: return color_format(ColorFormat::Rgba16, 16, 16, 16, 16);
  case GL_DEPTH_COMPONENT16: return depth_format(16, 0);
  case GL_DEPTH_COMPONENT:
  case GL_DEPTH_COMPONENT24:
  case GL_DEPTH_COMPONENT32: return depth_format(24, 0);
  case GL_DEPTH_STENCIL:
  case GL_DEPTH24_STENCIL8: return depth_format(24, 8);
  case GL_DEPTH_COMPONENT32F: return depth_format(32, 0);
  case GL_DEPTH32F_STENCIL8: return depth_format(32, 8);
  case GL_STENCIL_INDEX:
  case GL_STENCIL_INDEX1:
  case GL_STENCIL_INDEX4:
  case GL_STENCIL_INDEX8:
  case GL_STENCIL_INDEX16: return depth_format(0, 8);
  default: return {};
  }
}

RenderFormat render_format(const TexelFormat& t) {
  const auto has = [&](int red, int green, int blue, int alpha) {
    return t.bits[0] == red && t.bits[1] == green && t.bits[2] == blue && t.bits[3] == alpha;
  };
  if (t.layout == TexelLayout::Float || t.layout == TexelLayout::Signed16) return {};
  switch (t.base) {
  case GL_RGBA:
    if (has(8, 8, 8, 8)) return color_format(ColorFormat::Rgba8, 8, 8, 8, 8);
    if (has(16, 16, 16, 16)) return color_format(ColorFormat::Rgba16, 16, 16, 16, 16);
    return {};
  case GL_RGB:
    if (has(8, 8, 8, 0)) return color_format(ColorFormat::Rgba8, 8, 8, 8, 0);
    if (has(5, 6, 5, 0)) return color_format(ColorFormat::Rgb565, 5, 6, 5, 0);
    if (has(16, 16, 16, 0)) return color_format(ColorFormat::Rgba16, 16, 16, 16, 0);
    return {};
  case GL_DEPTH_COMPONENT: return depth_format(t.floats ? 32 : t.bits[0] == 16 ? 16 : 24, 0);
  case GL_DEPTH_STENCIL: return depth_format(t.floats ? 32 : 24, 8);
  default: return {};
  }
}

RenderPlane::RenderPlane(const RenderFormat& f, int w, int h, int n)
    : format(f), width(w), height(h), samples(n), tiles_x((w + kTileSize - 1) / kTileSize),
      tiles_y((h + kTileSize - 1) / kTileSize) {
  const bool words = !f.is_color() || f.color == ColorFormat::Rgba8; // the others' tiles do not wait
  const uint32_t first = f.is_color() && !f.has_alpha() ? 0xff000000u : 0;
  tile.assign(tiles(), TileWords{first, words ? ~0u : 0u, words});
  stored.resize(tiles());
  const uint32_t step = f.has_stencil_words() || (n > 1 && f.has_floats()) ? 2 : 1;
  for (uint32_t i = 0; i < tiles(); ++i) tile[i].place = i * step * uint32_t(n);
  bytes = size_t(tiles()) * step * size_t(n) * kTilePixels * size_t(pixel_bytes());
  memory = map_pages(bytes);
  if (!memory) throw std::bad_alloc();
  if (f.is_color() && !f.has_alpha() && f.color == ColorFormat::Rgba16)
    for (size_t i = 0; i < bytes / 8; ++i) static_cast<uint16_t*>(memory)[4 * i + 3] = 0xffff;
}

RenderPlane::~RenderPlane() { unmap_pages(memory, bytes); }

unsigned char* RenderPlane::pixels(uint32_t i) const {
  return static_cast<unsigned char*>(memory) + size_t(tile[i].place) * kTilePixels * size_t(pixel_bytes());
}

void assemble(GLuint name, int width, int height, RenderPlane* color, RenderPlane* depth_stencil, bool depth,
              bool stencil, RenderTarget& target) {
  target = RenderTarget{};
  Surface& s = target.surface;
  s.width = s.plane_width = width;
  s.height = s.plane_height = height;
  s.samples = 1;
  for (const RenderPlane* plane : {color, depth_stencil}) {
    if (!plane) continue;
    s.samples = plane->samples;
    s.plane_width = std::max(s.plane_width, plane->width);
    s.plane_height = std::max(s.plane_height, plane->height);
  }
  s.tiles_x = (s.width + kTileSize - 1) / kTileSize;
  s.tiles_y = (s.height + kTileSize - 1) / kTileSize;
  s.name = name;
  s.y_up = true;
  s.place_step = uint32_t(s.samples);
  s.color_columns = s.depth_columns = s.tiles_x;
  if (color) {
    s.color_format = color->format.color;
    s.color = color->memory;
    s.color_tile = color->tile.data();
    s.color_columns = color->tiles_x;
    target.has_alpha = color->format.has_alpha();
  }
  if (depth_stencil) {
    s.depth_format = depth_stencil->format.depth;
    s.depth_stencil = static_cast<uint32_t*>(depth_stencil->memory);
    s.depth_tile = depth_stencil->tile.data();
    s.depth_columns = depth_stencil->tiles_x;
    target.depth_bits = depth ? depth_stencil->format.depth_bits : 0;
    target.stencil_bits = stencil ? depth_stencil->format.stencil_bits : 0;
  }
  target.unwritten = true;
}

} // namespace softgl
