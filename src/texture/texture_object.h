// Texture objects and images (GL 1.5, 3.8.1, 3.8.11, 3.8.12).
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "base/assert.h"
#include "base/gl_types.h"
#include "base/vectors.h"
#include "shaders/common/limits.h"
#include "texture/texel_format.h"
#include "texture/texel_memory.h"
#include "texture/texture_target.h"

namespace softgl {

struct RenderPlane; // surface/render_plane.h

/// A slice of an image that has been attached to a framebuffer object: what is drawn to.
struct DrawnSlice {
  std::shared_ptr<RenderPlane> plane; // null: was never attached
  bool texels_newer = true;           // the plane has to be loaded from the texels
};

/// A part of an image.
struct TexelBox {
  int x, y, z, width, height, depth;
};

/// Texels around an image, on each side of an axis: 0 or 1. An axis that the target does not have has none.
struct ImageBorder {
  int x = 0, y = 0, z = 0;
  bool operator==(const ImageBorder&) const = default;
};
/// The border of an image of so many dimensions (GL 1.5, 3.8.1).
constexpr ImageBorder image_border(int border, int dimensions) {
  return {border, dimensions > 1 ? border : 0, dimensions > 2 ? border : 0};
}

/// One image of a level (and face). Rows are padded: texel (width, y) repeats (0, y), row `height` repeats
/// row 0, and 8 spare bytes follow, so that a 2x2 footprint is two 8-byte loads whatever the wrap mode. With
/// a border texels (-1, y) and (width, y) are its own, and nothing is repeated. Immutable while anybody but
/// its texture object holds it.
struct TextureImage {
  const TexelFormat* format = nullptr;
  GLint internal_format = 1;            // as the client named it
  int width = 0, height = 0, depth = 0; // without the border
  ImageBorder border;
  size_t row_bytes = 0, slice_bytes = 0;
  size_t origin = 0;              // of texel (0, 0, 0)
  TexelMemory texels;             // zeros where nothing was stored
  std::vector<uint8_t> stencils;  // of GL_DEPTH_STENCIL, row by row without padding; else empty
  std::vector<uint8_t> blocks;    // of a compressed format, row by row, slice by slice; else empty
  bool blank = true;              // nothing was
  std::vector<DrawnSlice> slices; // empty: none was ever attached

  bool empty() const { return width == 0 || height == 0 || depth == 0; }
  unsigned char* at(int x, int y, int z) {
    SOFTGL_ASSERT(x >= -border.x && x <= width + border.x && y >= -border.y && y <= height + border.y &&
                  z >= -border.z && z < depth + border.z);
    return texels.data() +
           (origin + size_t(z) * slice_bytes + size_t(y) * row_bytes + size_t(x) * size_t(format->bytes()));
  }
  const unsigned char* at(int x, int y, int z) const { return const_cast<TextureImage*>(this)->at(x, y, z); }
  uint8_t* stencil_at(int x, int y, int z) {
    const size_t row = size_t(z + border.z) * size_t(height + 2 * border.y) + size_t(y + border.y);
    return stencils.data() + row * size_t(width + 2 * border.x) + size_t(x + border.x);
  }
  const uint8_t* stencil_at(int x, int y, int z) const {
    return const_cast<TextureImage*>(this)->stencil_at(x, y, z);
  }
  TexelBox whole() const { return {0, 0, 0, width, height, depth}; }
  TexelBox with_border() const {
    return {-border.x,           -border.y, -border.z, width + 2 * border.x, height + 2 * border.y,
            depth + 2 * border.z};
  }
  /// Alpha 1 where the format has none, in an image that is not given any texels.
  void fill_absent_alpha();
  /// After every change of texels, and of those in the box alone. The blocks that the box touches are made
  /// anew.
  void texels_changed(const TexelBox& box);
  void texels_changed() { texels_changed(whole()); }

  // Compressed formats:
  size_t block_row_bytes() const {
    return size_t(blocks_in_row(format->block, width)) * size_t(block_bytes(format->block));
  }
  uint8_t* block_at(int x, int y, int z) { // of the block that has the texel
    return blocks.data() +
           (size_t(z) * size_t(blocks_in_column(height)) + size_t(y / kBlockHeight)) * block_row_bytes() +
           size_t(x / block_width(format->block)) * size_t(block_bytes(format->block));
  }
  /// After a change of blocks: makes the texels of those that the box touches.
  void blocks_changed(const TexelBox& box);
  /// Makes column `width` and row `height` repeat the first ones.
  void repeat_edges();

private:
  void encode_blocks(const TexelBox& box);
  void decode_blocks(const TexelBox& box);
  void finish_change();
};

/// A zeroed image. Throws std::bad_alloc.
std::shared_ptr<TextureImage> make_image(const TexelFormat& format, GLint internal_format, int width,
                                         int height, int depth, ImageBorder border = {});
/// The size that an image takes; the limit of OSMesa is 1 GiB.
uint64_t image_bytes(const TexelFormat& format, int width, int height, int depth);
constexpr uint64_t kMaxImageBytes = uint64_t(1) << 30;

/// What of a texture's parameters a sampler object may take the place of (GL_ARB_sampler_objects,
/// table 6.23).
struct SamplingParameters {
  GLenum wrap[3] = {GL_REPEAT, GL_REPEAT, GL_REPEAT}; // s, t, r
  GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR, mag_filter = GL_LINEAR;
  Vec4 border_color{0, 0, 0, 0};
  float min_lod = -1000, max_lod = 1000, lod_bias = 0;
  GLenum compare_mode = GL_NONE, compare_function = GL_LEQUAL;
  GLenum srgb_decode = GL_DECODE_EXT; // GL_EXT_texture_sRGB_decode
  float max_anisotropy = 1;           // GL_EXT_texture_filter_anisotropic
};
/// Table 3.19 and the level of detail bias; what GL_TEXTURE_BIT saves of an object.
struct TextureParameters : SamplingParameters {
  float priority = 1;
  GLint base_level = 0, max_level = 1000;
  GLenum depth_mode = GL_LUMINANCE;
  bool generate_mipmap = false;
};

struct TextureObject {
  TextureObject(GLuint name, TextureTarget target) : name(name), target(target) {
    if (target == kTextureRectangle) { // GL_ARB_texture_rectangle
      parameters.wrap[0] = parameters.wrap[1] = parameters.wrap[2] = GL_CLAMP_TO_EDGE;
      parameters.min_filter = GL_LINEAR;
    }
  }
  GLuint name;
  std::string label; // GL_KHR_debug
  TextureTarget target;
  TextureParameters parameters;
  int immutable_levels = 0; // GL_ARB_texture_storage; 0: images may get other sizes and formats
  std::shared_ptr<TextureImage> image[6][kMaxTextureLevels]; // [face][level]; null = never specified
  std::atomic<bool> drawn_to = false; // some planes of its images may be newer than the texels

  /// GL_TEXTURE_BASE_LEVEL and GL_TEXTURE_MAX_LEVEL, kept within the levels of an immutable texture.
  int base_level() const { return level_within(parameters.base_level, 0); }
  int max_level() const { return level_within(parameters.max_level, base_level()); }
  /// `level`, of an immutable texture clamped to [least, its last level].
  int level_within(int level, int least) const {
    return immutable_levels ? std::clamp(level, std::min(least, immutable_levels - 1), immutable_levels - 1)
                            : level;
  }
  /// The image for a change: a copy of its own if somebody else holds it.
  TextureImage& writable(int face, int level);
};

/// The storage for a new image: that of the level before it if both have one internal format, so that the
/// levels of a texture fit together whatever form each one's pixels have; else `chosen`, which suits the
/// pixels best.
const TexelFormat& level_format(const TextureObject& object, int face, int level, GLint internal_format,
                                const TexelFormat& chosen);
/// Stores all other images of the same internal format as this one is stored: 3.8.10 asks for nothing more of
/// a complete texture, and the sampling kernels read one format. Throws std::bad_alloc.
void match_formats(TextureObject& object, const TextureImage& image);

/// Sets all levels behind the base level from it (3.8.8, automatic mipmap generation).
void generate_mipmaps(TextureObject& object, int face);

/// What can be sampled with a filter: the levels of a complete texture (3.8.10). No levels: it is incomplete.
struct CompleteLevels {
  int first = 0, count = 0;
};
CompleteLevels complete_levels(const TextureObject& object, GLenum min_filter);
bool uses_mipmaps(GLenum min_filter);
/// Wrap modes that rectangles do not have (GL_ARB_texture_rectangle).
inline bool repeats(GLenum wrap) { return wrap == GL_REPEAT || wrap == GL_MIRRORED_REPEAT; }

} // namespace softgl
