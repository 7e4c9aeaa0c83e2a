#include "surface/render_plane.h"

#include <algorithm>
#include <new>

#include "base/pages.h"
#include "surface/framebuffer.h"
#include "surface/stored_color.h"
#include "texture/texel_format.h"

namespace softgl {
namespace {

/// `layout`: the texels'.
ColorFormat storage(const TexelFormat& t) {
  switch (t.layout) {
  case TexelLayout::Float: return ColorFormat::RgbaFloat;
  case TexelLayout::Rgba16:
  case TexelLayout::Signed16: return ColorFormat::Rgba16;
  default: return t.bits[0] == 5 && t.bits[1] == 6 ? ColorFormat::Rgb565 : ColorFormat::Rgba8;
  }
}

RenderFormat color_format(const TexelFormat& t) {
  const bool luminance = t.base == GL_LUMINANCE || t.base == GL_LUMINANCE_ALPHA;
  // Three numbers with one exponent have no masks; OSMesa 22.3.6 does not draw to luminance of sRGB.
  const bool drawn = t.block == BlockFormat::None && t.bits[0] != 9 && !(t.srgb && luminance);
  RenderFormat f;
  f.kind = drawn ? RenderFormat::Kind::Color : RenderFormat::Kind::None;
  f.color = storage(t);
  f.texels = &t;
  f.encoding.numbers = t.layout == TexelLayout::Float      ? ColorNumbers::Float
                       : t.layout == TexelLayout::Signed16 ? ColorNumbers::Signed
                                                           : ColorNumbers::Unsigned;
  f.encoding.srgb = t.srgb;
  const bool one = luminance || t.base == GL_INTENSITY; // for red, green and blue
  for (int i = 0; i < 4; ++i) {
    const bool absent = (i > 0 && i < 3 && one) || (i == 3 && t.base == GL_INTENSITY);
    f.encoding.bits[i] = absent ? 0 : t.bits[i];
    f.bits[i] = one && i < 3 ? 0 : f.encoding.bits[i];
  }
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
  case GL_STENCIL_INDEX:
  case GL_STENCIL_INDEX1:
  case GL_STENCIL_INDEX4:
  case GL_STENCIL_INDEX8:
  case GL_STENCIL_INDEX16: return depth_format(0, 8);
  case 1: // numbers of components and generic compressed formats are for texture images
  case 2:
  case 3:
  case 4:
  case GL_SRGB:
  case GL_SRGB_ALPHA:
  case GL_COMPRESSED_ALPHA:
  case GL_COMPRESSED_LUMINANCE:
  case GL_COMPRESSED_LUMINANCE_ALPHA:
  case GL_COMPRESSED_INTENSITY:
  case GL_COMPRESSED_RGB:
  case GL_COMPRESSED_RGBA:
  case GL_COMPRESSED_RED:
  case GL_COMPRESSED_RG:
  case GL_COMPRESSED_SRGB:
  case GL_COMPRESSED_SRGB_ALPHA: return {};
  default: break;
  }
  const TexelFormat* texels = choose_texel_format(GLint(internal_format), 0, 0, false);
  return texels ? render_format(*texels) : RenderFormat{};
}

RenderFormat render_format(const TexelFormat& t) {
  switch (t.base) {
  case GL_DEPTH_COMPONENT: return depth_format(t.floats ? 32 : t.bits[0] == 16 ? 16 : 24, 0);
  case GL_DEPTH_STENCIL: return depth_format(t.floats ? 32 : 24, 8);
  default: return color_format(t);
  }
}

RenderPlane::RenderPlane(const RenderFormat& f, int w, int h, int n)
    : format(f), width(w), height(h), samples(n), tiles_x((w + kTileSize - 1) / kTileSize),
      tiles_y((h + kTileSize - 1) / kTileSize) {
  const bool words = !f.is_color() || f.color == ColorFormat::Rgba8; // the others' tiles do not wait
  const uint32_t first = f.is_color() && !f.has_alpha() ? 0xff000000u : 0;
  tile.assign(tiles(), TileWords{first, words ? ~0u : 0u, words});
  stored.resize(tiles());
  const uint32_t step = f.has_stencil_words() ? 2 : 1;
  for (uint32_t i = 0; i < tiles(); ++i) tile[i].place = i * step * uint32_t(n);
  bytes = size_t(tiles()) * step * size_t(n) * kTilePixels * size_t(pixel_bytes());
  memory = map_pages(bytes);
  if (!memory) throw std::bad_alloc();
  if (f.is_color() && !f.has_alpha()) fill_alpha(f.color, f.encoding, memory, bytes);
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
  s.pixel_step = s.samples;
  s.place_step = uint32_t(s.samples);
  s.color_columns = s.depth_columns = s.tiles_x;
  if (color) {
    s.color_format = color->format.color;
    s.encoding = color->format.encoding;
    s.color = color->memory;
    s.color_tile = color->tile.data();
    s.color_columns = color->tiles_x;
    target.has_alpha = color->format.has_alpha();
    target.texels = color->format.texels;
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
