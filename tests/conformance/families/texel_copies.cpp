// Textures copied from the framebuffer: all targets and formats, parts of images, rectangles partly outside
// the window.
#include <algorithm>

#include "conformance/families/common.h"

namespace softgl::test {

namespace {

struct Copy {
  GLenum target = GL_TEXTURE_2D; // as it is bound
  GLint format = GL_RGBA;
  int width = 1, height = 1, depth = 1;
};

/// One copy into a face of the bound texture: a whole image, or a part of one that has texels already.
void copy_face(Stage& s, const Copy& c, GLenum face) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  const bool depth = c.format == GL_DEPTH_COMPONENT || c.format == GL_DEPTH_COMPONENT16 ||
                     c.format == GL_DEPTH_COMPONENT24 || c.format == GL_DEPTH_COMPONENT32;
  const bool part = c.target == GL_TEXTURE_3D || r.chance(50);
  // What lies outside the window is not defined for a new image; in a part, the texels there stay.
  const int outside = part && r.chance(40) ? 20 : 0;
  auto place = [&](int size, int window) {
    return r.integer(-outside, std::max(-outside, window - size + outside));
  };
  if (!part) {
    const int x = place(c.width, s.width), y = place(c.height, s.height);
    if (c.target == GL_TEXTURE_1D)
      gl.CopyTexImage1D(face, 0, GLenum(c.format), x, y, c.width, 0);
    else
      gl.CopyTexImage2D(face, 0, GLenum(c.format), x, y, c.width, c.height, 0);
    return;
  }
  std::vector<uint8_t> texels(size_t(c.width) * size_t(c.height) * size_t(c.depth) * 4 + 16);
  for (uint8_t& t : texels) t = uint8_t(r.bits() >> 24);
  const GLenum format = depth ? GL_DEPTH_COMPONENT : GL_RGBA,
               type = depth ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE;
  if (c.target == GL_TEXTURE_1D)
    gl.TexImage1D(face, 0, c.format, c.width, 0, format, type, texels.data());
  else if (c.target == GL_TEXTURE_3D)
    gl.TexImage3D(face, 0, c.format, c.width, c.height, c.depth, 0, format, type, texels.data());
  else
    gl.TexImage2D(face, 0, c.format, c.width, c.height, 0, format, type, texels.data());
  for (int copies = c.target == GL_TEXTURE_3D ? c.depth : 1; copies > 0; --copies) {
    const int to_x = r.integer(0, c.width - 1), to_y = r.integer(0, c.height - 1),
              to_z = r.integer(0, c.depth - 1);
    const int w = r.integer(1, c.width - to_x), h = r.integer(1, c.height - to_y), x = place(w, s.width),
              y = place(h, s.height);
    if (c.target == GL_TEXTURE_1D)
      gl.CopyTexSubImage1D(face, 0, to_x, x, y, w);
    else if (c.target == GL_TEXTURE_3D)
      gl.CopyTexSubImage3D(face, 0, to_x, to_y, to_z, x, y, w, h);
    else
      gl.CopyTexSubImage2D(face, 0, to_x, to_y, x, y, w, h);
  }
}

void copied_texture(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  Copy c;
  c.target = r.pick(
      {GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP});
  const bool depth = r.chance(15) && (c.target == GL_TEXTURE_1D || c.target == GL_TEXTURE_2D);
  c.format =
      depth ? r.pick({GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32})
            : r.pick({GL_RGBA,
                      GL_RGBA,
                      GL_RGB,
                      GL_RGB,
                      GL_RGBA8,
                      GL_RGB8,
                      GL_LUMINANCE,
                      GL_LUMINANCE8,
                      GL_LUMINANCE_ALPHA,
                      GL_LUMINANCE8_ALPHA8,
                      GL_ALPHA,
                      GL_ALPHA8,
                      GL_INTENSITY,
                      GL_INTENSITY8,
                      GL_RGB5,
                      GL_RGB4,
                      GL_R3_G3_B2,
                      GL_RGBA4,
                      GL_RGB5_A1,
                      GL_RGBA2,
                      GL_LUMINANCE4,
                      GL_ALPHA4,
                      GL_INTENSITY4,
                      GL_LUMINANCE4_ALPHA4,
                      GL_RGB10,
                      GL_RGB10_A2,
                      GL_RGB12,
                      GL_RGB16,
                      GL_RGBA12,
                      GL_RGBA16,
                      GL_LUMINANCE16,
                      GL_ALPHA16,
                      GL_INTENSITY16,
                      GL_LUMINANCE16_ALPHA16});
  const bool odd = r.chance(40);
  const int largest = c.target == GL_TEXTURE_3D ? 3 : 5;
  auto size = [&] { return odd ? r.integer(1, (1 << largest) + 7) : 1 << r.integer(0, largest); };
  c.width = size(), c.height = size();
  if (c.target == GL_TEXTURE_1D) c.height = 1;
  if (c.target == GL_TEXTURE_3D) c.depth = size();
  if (c.target == GL_TEXTURE_CUBE_MAP) c.height = c.width;
  c.width = std::min(c.width, s.width), c.height = std::min(c.height, s.height);
  if (c.target == GL_TEXTURE_CUBE_MAP) c.width = c.height = std::min(c.width, c.height);
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(c.target, name);
  const bool mipmaps = r.chance(30);
  gl.TexParameteri(c.target, GL_GENERATE_MIPMAP, mipmaps);
  gl.TexParameteri(c.target, GL_TEXTURE_MIN_FILTER,
                   mipmaps ? r.pick({GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR})
                           : r.pick({GL_NEAREST, GL_LINEAR}));
  gl.TexParameteri(c.target, GL_TEXTURE_MAG_FILTER, r.pick({GL_NEAREST, GL_LINEAR}));
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(c.target, axis, r.pick({GL_REPEAT, GL_CLAMP_TO_EDGE}));
  // Colors are not scaled on the way: reference/DEVIATIONS.md.
  const bool transfers = r.chance(20);
  gl.PixelTransferf(GL_DEPTH_SCALE, transfers ? r.real(0.3f, 1.5f) : 1.0f);
  gl.PixelTransferf(GL_DEPTH_BIAS, transfers ? r.real(-0.3f, 0.3f) : 0.0f);
  if (c.target == GL_TEXTURE_CUBE_MAP)
    for (GLenum face = 0; face < 6; ++face) copy_face(s, c, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face);
  else
    copy_face(s, c, c.target);
  gl.PixelTransferf(GL_DEPTH_SCALE, 1);
  gl.PixelTransferf(GL_DEPTH_BIAS, 0);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, r.pick({GL_MODULATE, GL_REPLACE, GL_DECAL}));
  gl.Enable(c.target);
}

void draw_copies(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_canvas(s);
  gl.Viewport(0, 0, s.width, s.height);
  backdrop(s);
  for (int round = r.integer(1, 2); round > 0; --round) {
    gl.Enable(GL_DEPTH_TEST);
    PrimitiveOptions options;
    options.spread = Spread::Any;
    options.primitives = 6;
    random_primitive(s, options);
    gl.Disable(GL_DEPTH_TEST);
    gl.PushAttrib(GL_TEXTURE_BIT | GL_ENABLE_BIT);
    copied_texture(s);
    // A texel covers a few pixels, so that each is seen.
    const float x = r.real(-1, 0), y = r.real(-1, 0), w = r.real(0.4f, 1.2f), h = r.real(0.4f, 1.2f);
    gl.Begin(GL_TRIANGLE_FAN);
    for (int i = 0; i < 4; ++i) {
      const float right = i == 1 || i == 2 ? 1.0f : 0.0f, top = i >= 2 ? 1.0f : 0.0f;
      const Float4 color = r.color();
      gl.Color4fv(color.data());
      gl.TexCoord3f(right * 1.5f - 0.25f, top * 1.5f - 0.25f, r.real(-1, 1));
      gl.Vertex2f(x + right * w, y + top * h);
    }
    gl.End();
    gl.PopAttrib();
  }
}

SceneRegistration copies{{"texel_copies", draw_copies, true}};

} // namespace

} // namespace softgl::test
