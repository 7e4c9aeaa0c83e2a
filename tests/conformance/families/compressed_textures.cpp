// Textures of compressed blocks: random blocks, parts that are replaced, what is read back.
#include <algorithm>

#include "conformance/families/common.h"
#include "conformance/families/environments.h"

namespace softgl::test {

namespace {

const GLenum kFormats[] = {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
                           GL_COMPRESSED_RED_RGTC1, GL_COMPRESSED_SIGNED_RED_RGTC1,
                           GL_COMPRESSED_LUMINANCE_LATC1_EXT, GL_COMPRESSED_SIGNED_LUMINANCE_LATC1_EXT,
                           GL_COMPRESSED_SRGB_S3TC_DXT1_EXT, GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT,
                           // those of 16 bytes a block
                           GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
                           GL_COMPRESSED_RG_RGTC2, GL_COMPRESSED_SIGNED_RG_RGTC2,
                           GL_COMPRESSED_LUMINANCE_ALPHA_LATC2_EXT,
                           GL_COMPRESSED_SIGNED_LUMINANCE_ALPHA_LATC2_EXT,
                           GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT, GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT};

int bytes_of_block(GLenum format) {
  return std::find(kFormats, kFormats + 8, format) != kFormats + 8 ? 8 : 16;
}

/// Random blocks. Some repeat a byte, so that the two ends of a palette are often equal.
std::vector<GLubyte> random_blocks(Stage& s, GLenum format, int width, int height) {
  Random& r = s.random;
  std::vector<GLubyte> blocks(size_t((width + 3) / 4) * size_t((height + 3) / 4) *
                              size_t(bytes_of_block(format)));
  const bool repeats = r.chance(20);
  for (GLubyte& byte : blocks) byte = repeats && r.chance(50) ? 0x5a : GLubyte(r.bits() >> 24);
  return blocks;
}

void replace_part(Stage& s, GLenum target, GLenum format, int level, int width, int height) {
  Random& r = s.random;
  const int x = 4 * r.integer(0, (width - 1) / 4), y = 4 * r.integer(0, (height - 1) / 4);
  const int part_width = std::min(4 * r.integer(1, 4), width - x),
            part_height = std::min(4 * r.integer(1, 4), height - y);
  const std::vector<GLubyte> blocks = random_blocks(s, format, part_width, part_height);
  s.gl.CompressedTexSubImage2D(target, level, x, y, part_width, part_height, format, GLsizei(blocks.size()),
                               blocks.data());
}

/// What can be read of level 0, the blocks and the texels, becomes a texture that is not compressed.
void show_what_is_read(Stage& s, GLenum format, int width, int height) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  std::vector<GLubyte> blocks(random_blocks(s, format, width, height).size());
  gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, blocks.data());
  const GLenum client =
                   r.pick({GL_RGBA, GL_BGRA, GL_RGB, GL_RED, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA}),
               type = r.pick({GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT, GL_SHORT});
  std::vector<GLubyte> pixels(size_t(width) * size_t(height) * 16 + 64);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.GetTexImage(GL_TEXTURE_2D, 0, client, type, pixels.data());
  GLint size = 0;
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &size);
  for (size_t i = 0; i < blocks.size() && i < pixels.size(); ++i) pixels[i] ^= blocks[i];
  pixels[0] ^= GLubyte(size), pixels[1] ^= GLubyte(size >> 8);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, client,
                type == GL_FLOAT ? GLenum(GL_UNSIGNED_BYTE) : type, pixels.data());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void compressed_texture(Stage& s, GLenum target) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(target, name);
  const GLenum format = kFormats[r.integer(0, int(std::size(kFormats)) - 1)];
  const bool odd = r.chance(40), cube = target == GL_TEXTURE_CUBE_MAP;
  const int width = odd ? r.integer(1, 37) : 1 << r.integer(0, 6);
  const int height = cube ? width : odd ? r.integer(1, 37) : 1 << r.integer(0, 6);
  const bool mipmaps = r.chance(50);
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER,
                   mipmaps ? r.pick({GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
                                     GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR})
                           : r.pick({GL_NEAREST, GL_LINEAR}));
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, r.pick({GL_NEAREST, GL_LINEAR}));
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(
        target, axis,
        r.pick({GL_REPEAT, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT}));
  const Float4 border = r.color();
  gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, border.data());
  for (int face = 0; face < (cube ? 6 : 1); ++face) {
    const GLenum image = cube ? GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face) : target;
    int w = width, h = height;
    for (int level = 0;; ++level) {
      const std::vector<GLubyte> blocks = random_blocks(s, format, w, h);
      gl.CompressedTexImage2D(image, level, format, w, h, 0, GLsizei(blocks.size()), blocks.data());
      if (r.chance(20)) replace_part(s, image, format, level, w, h);
      if (!mipmaps || (w == 1 && h == 1)) break;
      w = std::max(1, w / 2), h = std::max(1, h / 2);
    }
  }
  const auto* f = std::find(kFormats, std::end(kFormats), format);
  const bool latc = f == kFormats + 4 || f == kFormats + 5 || f == kFormats + 12 || f == kFormats + 13;
  // What is read of LATC: reference/DEVIATIONS.md.
  if (!cube && !mipmaps && !latc && r.chance(25)) show_what_is_read(s, format, width, height);
  gl.Enable(target);
}

void draw_compressed(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  compressed_texture(s, r.chance(20) ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D);
  random_environment(s, 1, true);
  const float scale = r.pick({0.6f, 1.0f, 2.0f, 8.0f});
  gl.Begin(GL_TRIANGLES);
  for (int triangle = 0; triangle < 2; ++triangle)
    for (int i = 0; i < 3; ++i) {
      const float x = (i + triangle) % 3 == 1 ? 0.9f : -0.9f, y = (i + triangle) % 3 == 2 ? 0.9f : -0.9f;
      const float flip = triangle ? -1.0f : 1.0f;
      const Float4 color = r.color();
      gl.Color4fv(color.data());
      const float a = r.real(-scale, scale), b = r.real(-scale, scale), c = r.real(-scale, scale);
      gl.TexCoord3f(a, b, c);
      gl.Vertex2f(x * flip, y * flip);
    }
  gl.End();
}

SceneRegistration compressed{{"compressed_textures", draw_compressed, true}};

} // namespace

} // namespace softgl::test
