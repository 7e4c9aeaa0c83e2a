// glCopyImageSubData: bits from image to image (GL_ARB_copy_image, GL_NV_copy_image, 4.3.3).
#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "commands/textures/texture_images.h"
#include "context/context.h"
#include "frame/surface_work.h"
#include "snapshot/render_targets.h"
#include "texture/pixel_formats.h"
#include "texture/pixel_transfer.h"
#include "texture/view_class.h"

namespace softgl {
namespace {

/// The texels that a renderbuffer would have, were it a texture. Stencil values alone lie beside depths.
const TexelFormat& texel_format(const Renderbuffer& r) {
  const bool stencils = !r.format.is_color() && r.format.depth_bits == 0;
  return *choose_texel_format(GLint(stencils ? GL_DEPTH24_STENCIL8 : r.internal_format), 0, 0, false);
}

/// One end of a copy: a level of a texture, or a renderbuffer.
struct CopyEnd {
  // Of the command, for messages of errors.
  const char *name_argument = nullptr, *target_argument = nullptr, *level_argument = nullptr;
  std::shared_ptr<TextureObject> texture;
  std::shared_ptr<Renderbuffer> renderbuffer;
  int level = 0, samples = 1;
  GLint internal_format = 0;
  const TexelFormat* format = nullptr;
  int width = 0, height = 0, layers = 0; // layers: slices, or faces
  int x = 0, y = 0, z = 0;
  std::vector<std::shared_ptr<TextureImage>> sample_image; // of a renderbuffer, by sample

  bool compressed() const { return format->block != BlockFormat::None; }
  int columns() const { return compressed() ? block_width(format->block) : 1; } // texels of an element
  int rows() const { return compressed() ? kBlockHeight : 1; }
  bool faces() const { return texture && texture->target == kTextureCube; }
  int slice(int layer) const { return faces() ? 0 : z + layer; }
  int face(int layer) const { return faces() ? z + layer : 0; }
  TextureImage& image(int sample, int layer) {
    return texture ? *texture->image[face(layer)][level] : *sample_image[size_t(sample)];
  }
  /// Makes images of the renderbuffer's samples. Throws std::bad_alloc.
  void open() {
    if (texture) return store_drawn_texels(*texture);
    RenderPlane& plane = *renderbuffer->plane;
    for (int s = 0; s < samples; ++s) {
      auto& made = sample_image.emplace_back(make_image(*format, internal_format, width, height, 1));
      for (uint32_t i = 0; i < plane.tiles(); ++i)
        plane.tile[i].changed = true, plane.stored[i].known = false;
      store_plane(plane, *made, 0, s);
    }
  }
  /// Of what is changed: nobody else holds the images. Throws std::bad_alloc.
  void make_writable(int layer_count) {
    for (int layer = 0; texture && layer < (faces() ? layer_count : 1); ++layer)
      texture->writable(face(layer), level);
  }
  /// Stores what was changed.
  void close(Context& c) {
    if (texture) return mark_images(c, *texture);
    RenderPlane& plane = *renderbuffer->plane;
    for (int s = 0; s < samples; ++s) load_plane(plane, *sample_image[size_t(s)], 0, s);
    c.dirty |= kDirtyFramebuffer;
  }
};

bool find_renderbuffer(Context& c, GLuint name, CopyEnd& end) {
  end.renderbuffer = c.shared->renderbuffers.find(name);
  if (!end.renderbuffer) return set_error(c, GL_INVALID_VALUE, end.name_argument), false;
  const Renderbuffer& r = *end.renderbuffer;
  if (!r.plane) return set_error(c, GL_INVALID_OPERATION), false; // without storage
  if (end.level != 0) return set_error(c, GL_INVALID_VALUE, end.level_argument), false;
  end.internal_format = GLint(r.internal_format);
  end.format = &texel_format(r);
  end.width = r.width, end.height = r.height, end.layers = 1, end.samples = r.samples;
  return true;
}

bool find_texture(Context& c, GLuint name, TextureTarget target, CopyEnd& end) {
  end.texture = c.shared->textures.find(name);
  if (!end.texture) return set_error(c, GL_INVALID_VALUE, end.name_argument), false;
  TextureObject& object = *end.texture;
  if (complete_levels(object, object.parameters.min_filter).count == 0)
    return set_error(c, GL_INVALID_OPERATION), false;
  if (object.target != target) return set_error(c, GL_INVALID_ENUM, end.target_argument), false;
  if (end.level < 0 || end.level >= kMaxTextureLevels)
    return set_error(c, GL_INVALID_VALUE, end.level_argument), false;
  const TextureImage* image = object.image[0][end.level].get();
  if (!image) return set_error(c, GL_INVALID_VALUE, end.level_argument), false;
  for (int face = 0; face < (target == kTextureCube ? 6 : 1); ++face) {
    const auto& one =
        object.image[face][end.level]; // those of other levels than the complete ones may differ
    if (!one || one->format != image->format || one->width != image->width || one->height != image->height)
      return set_error(c, GL_INVALID_VALUE, end.level_argument), false;
  }
  end.internal_format = image->internal_format;
  end.format = image->format;
  end.width = image->width, end.height = image->height;
  end.layers = target == kTextureCube ? 6 : image->depth;
  return true;
}

/// False, and the error, for a name, target or level that is none.
bool find_end(Context& c, GLuint name, GLenum target, CopyEnd& end) {
  if (name == 0) return set_error(c, GL_INVALID_VALUE, end.name_argument), false;
  if (target == GL_RENDERBUFFER) return find_renderbuffer(c, name, end);
  const TextureTarget t = binding_target(target);
  if (t == kTextureTargets) return set_error(c, GL_INVALID_ENUM, end.target_argument), false;
  return find_texture(c, name, t, end);
}

/// A size in texels of one end, in those of the other one: as many elements.
int64_t scaled(int size, int from, int to) { return (int64_t(size) + from - 1) / from * to; }

/// How texels become others.
enum class CopyWay { Refused, Same, Pixels, Bits };

CopyWay way_of(const CopyEnd& from, const CopyEnd& to, bool any_class) {
  if (from.internal_format == to.internal_format)
    return from.format == to.format ? CopyWay::Same : CopyWay::Pixels;
  const ViewFormat *a = view_format(GLenum(from.internal_format)),
                   *b = view_format(GLenum(to.internal_format));
  if (!any_class || !a || !b) return CopyWay::Refused;
  if (a->view_class == b->view_class) return CopyWay::Bits;
  const bool one_is_compressed = from.compressed() != to.compressed();
  const int bytes = block_copy_bytes(a->view_class);
  return one_is_compressed && bytes && bytes == block_copy_bytes(b->view_class) ? CopyWay::Bits
                                                                                : CopyWay::Refused;
}

/// The client pixels that rows go through.
PixelFormat pixels_of_bits(const CopyEnd& end) {
  const ViewFormat& view = *view_format(GLenum(end.internal_format));
  return describe_pixel_format(view.format, view.type);
}
PixelFormat pixels_of_format(const TexelFormat& format) {
  const bool depth = format.layout == TexelLayout::Depth;
  return describe_pixel_format(depth ? GL_DEPTH_COMPONENT : GL_RGBA, depth ? GL_UNSIGNED_INT : GL_FLOAT);
}

/// Copies rows of elements, each a texel or a block.
class RowCopier {
public:
  RowCopier(const CopyEnd& from, const CopyEnd& to, CopyWay way, int elements)
      : from_blocks_(from.compressed()), to_blocks_(to.compressed()), way_(way), elements_(elements) {
    if (way == CopyWay::Pixels) from_pixels_ = to_pixels_ = pixels_of_format(*from.format);
    if (way == CopyWay::Bits && !from_blocks_) from_pixels_ = pixels_of_bits(from);
    if (way == CopyWay::Bits && !to_blocks_) to_pixels_ = pixels_of_bits(to);
    row_.resize(size_t(elements) * 16);
  }
  void copy(const TextureImage& from, int x, int y, int z, TextureImage& to, int to_x, int to_y, int to_z) {
    load(from, x, y, z);
    store(to, to_x, to_y, to_z);
    if (from.stencils.empty() || to.stencils.empty()) return;
    std::memmove(to.stencil_at(to_x, to_y, to_z), from.stencil_at(x, y, z), size_t(elements_));
  }

private:
  void load(const TextureImage& image, int x, int y, int z) {
    if (from_blocks_)
      std::memcpy(row_.data(), const_cast<TextureImage&>(image).block_at(x, y, z), block_row_bytes(image));
    else if (way_ == CopyWay::Same)
      std::memcpy(row_.data(), image.at(x, y, z), texel_row_bytes(image));
    else
      load_texels(*image.format, image.at(x, y, z), from_pixels_, row_.data(), elements_, false);
  }
  void store(TextureImage& image, int x, int y, int z) {
    if (to_blocks_)
      std::memcpy(image.block_at(x, y, z), row_.data(), block_row_bytes(image));
    else if (way_ == CopyWay::Same)
      std::memcpy(image.at(x, y, z), row_.data(), texel_row_bytes(image));
    else
      store_texels(*image.format, image.at(x, y, z), to_pixels_, row_.data(), elements_, false,
                   PixelTransfer::none());
  }
  size_t block_row_bytes(const TextureImage& image) const {
    return size_t(elements_) * size_t(block_bytes(image.format->block));
  }
  size_t texel_row_bytes(const TextureImage& image) const {
    return size_t(elements_) * size_t(image.format->bytes());
  }

  bool from_blocks_, to_blocks_;
  CopyWay way_;
  int elements_;
  PixelFormat from_pixels_{}, to_pixels_{};
  std::vector<unsigned char> row_;
};

void copy_box(CopyEnd& from, CopyEnd& to, CopyWay way, int columns, int rows, int layers) {
  RowCopier copier(from, to, way, columns);
  for (int sample = 0; sample < from.samples; ++sample)
    for (int layer = 0; layer < layers; ++layer) {
      const TextureImage& source = from.image(sample, layer);
      TextureImage& target = to.image(sample, layer);
      for (int row = 0; row < rows; ++row)
        copier.copy(source, from.x, from.y + row * from.rows(), from.slice(layer), target, to.x,
                    to.y + row * to.rows(), to.slice(layer));
      const TexelBox box{to.x,
                         to.y,
                         to.slice(layer),
                         std::min(columns * to.columns(), target.width - to.x),
                         std::min(rows * to.rows(), target.height - to.y),
                         1};
      if (to.compressed())
        target.blocks_changed(box);
      else
        target.texels_changed(box);
    }
}

/// `any_class`: formats of one class will do; else they must be the same.
void copy_image(Context& c, GLuint from_name, GLenum from_target, CopyEnd from, GLuint to_name,
                GLenum to_target, CopyEnd to, GLsizei width, GLsizei height, GLsizei depth, bool any_class) {
  // The two commands' names of one argument.
  const char *const width_argument = any_class ? "srcWidth" : "width",
                    *const height_argument = any_class ? "srcHeight" : "height",
                    *const depth_argument = any_class ? "srcDepth" : "depth";
  if (const char* wrong = first_wrong(
          {{width_argument, width < 0}, {height_argument, height < 0}, {depth_argument, depth < 0}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  draw_what_waits(c);
  if (!find_end(c, from_name, from_target, from) || !find_end(c, to_name, to_target, to)) return;
  const int columns = from.columns(), rows = from.rows();
  const auto in_blocks = [](int size, int block, int first, int whole) {
    return size % block == 0 || int64_t(first) + size == whole;
  };
  if (const char* wrong = first_wrong({{"srcX", from.x < 0 || from.x % columns != 0},
                                       {"srcY", from.y < 0 || from.y % rows != 0},
                                       {"srcZ", from.z < 0},
                                       {"dstX", to.x < 0 || to.x % to.columns() != 0},
                                       {"dstY", to.y < 0 || to.y % to.rows() != 0},
                                       {"dstZ", to.z < 0},
                                       {width_argument, !in_blocks(width, columns, from.x, from.width)},
                                       {height_argument, !in_blocks(height, rows, from.y, from.height)}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  // Where blocks are copied to blocks, the last ones may reach beyond the image.
  const bool same_blocks = columns == to.columns() && rows == to.rows();
  const int64_t to_width = same_blocks ? width : scaled(width, columns, to.columns()),
                to_height = same_blocks ? height : scaled(height, rows, to.rows());
  const auto beyond = [](int first, int64_t size, int limit) { return first + size > limit; };
  if (const char* wrong = first_wrong(
          {{width_argument, beyond(from.x, width, from.width) || beyond(to.x, to_width, to.width)},
           {height_argument, beyond(from.y, height, from.height) || beyond(to.y, to_height, to.height)},
           {depth_argument, beyond(from.z, depth, from.layers) || beyond(to.z, depth, to.layers)}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  const CopyWay way = way_of(from, to, any_class);
  if (way == CopyWay::Refused || from.samples != to.samples) return set_error(c, GL_INVALID_OPERATION);
  if (width == 0 || height == 0 || depth == 0) return;
  from.open();
  to.open();
  to.make_writable(depth);
  if (from.renderbuffer && from.renderbuffer == to.renderbuffer) from.sample_image = to.sample_image;
  copy_box(from, to, way, int(scaled(width, columns, 1)), int(scaled(height, rows, 1)), depth);
  to.close(c);
}

CopyEnd end_at(GLint level, GLint x, GLint y, GLint z) {
  CopyEnd end;
  end.level = level;
  end.x = x, end.y = y, end.z = z;
  return end;
}
CopyEnd source_at(GLint level, GLint x, GLint y, GLint z) {
  CopyEnd end = end_at(level, x, y, z);
  end.name_argument = "srcName", end.target_argument = "srcTarget", end.level_argument = "srcLevel";
  return end;
}
CopyEnd destination_at(GLint level, GLint x, GLint y, GLint z) {
  CopyEnd end = end_at(level, x, y, z);
  end.name_argument = "dstName", end.target_argument = "dstTarget", end.level_argument = "dstLevel";
  return end;
}

} // namespace

namespace gl {

void CopyImageSubData(Context& c, GLuint srcName, GLenum srcTarget, GLint srcLevel, GLint srcX, GLint srcY,
                      GLint srcZ, GLuint dstName, GLenum dstTarget, GLint dstLevel, GLint dstX, GLint dstY,
                      GLint dstZ, GLsizei srcWidth, GLsizei srcHeight, GLsizei srcDepth) {
  copy_image(c, srcName, srcTarget, source_at(srcLevel, srcX, srcY, srcZ), dstName, dstTarget,
             destination_at(dstLevel, dstX, dstY, dstZ), srcWidth, srcHeight, srcDepth, true);
}
void CopyImageSubDataNV(Context& c, GLuint srcName, GLenum srcTarget, GLint srcLevel, GLint srcX, GLint srcY,
                        GLint srcZ, GLuint dstName, GLenum dstTarget, GLint dstLevel, GLint dstX, GLint dstY,
                        GLint dstZ, GLsizei width, GLsizei height, GLsizei depth) {
  copy_image(c, srcName, srcTarget, source_at(srcLevel, srcX, srcY, srcZ), dstName, dstTarget,
             destination_at(dstLevel, dstX, dstY, dstZ), width, height, depth, false);
}

} // namespace gl
} // namespace softgl
