#include <cstdio>
#include <vector>

#include "fuzz/choices.h"
#include "fuzz/targets.h"

namespace softgl::test {
namespace {

constexpr int kMostSteps = 80, kNames = 4;

class Machine {
public:
  Machine(const Gl& gl, Choices& choices) : gl_(gl), choices_(choices), memory_(1 << 20) {
    gl.GenFramebuffers(kNames, framebuffers_);
    gl.GenRenderbuffers(kNames, renderbuffers_);
    gl.GenTextures(kNames, textures_);
  }

  void step() {
    switch (choices_.integer(0, 13)) {
    case 0: gl_.BindFramebuffer(target(), name(framebuffers_)); break;
    case 1: gl_.BindRenderbuffer(GL_RENDERBUFFER, name(renderbuffers_)); break;
    case 2: delete_name(); break;
    case 3: store_renderbuffer(); break;
    case 4: specify_texture(); break;
    case 5: attach_renderbuffer(); break;
    case 6:
    case 7: attach_texture(); break;
    case 8: blit(); break;
    case 9: draw(); break;
    case 10: read(); break;
    case 11: generate_mipmaps(); break;
    case 12: choose_buffers(); break;
    case 13: copy_to_texture(); break;
    }
    check();
  }

private:
  GLuint name(const GLuint* names) {
    return choices_.chance(15) ? 0 : names[choices_.integer(0, kNames - 1)];
  }
  GLenum target() {
    return choices_.pick<GLenum>({GL_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER});
  }
  GLenum attachment() {
    return choices_.pick<GLenum>({GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT,
                                  GL_DEPTH_STENCIL_ATTACHMENT, GL_COLOR_ATTACHMENT1});
  }
  GLenum texture_target() {
    return choices_.pick<GLenum>(
        {GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D, GL_TEXTURE_1D, GL_TEXTURE_RECTANGLE});
  }
  GLsizei size() { return choices_.pick({16, 8, 32, 1, 0, 17}); }
  GLenum format() {
    return choices_.pick<GLenum>({GL_RGBA8, GL_DEPTH24_STENCIL8, GL_RGBA, GL_RGB5, GL_RGBA16,
                                  GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_STENCIL_INDEX8,
                                  GL_DEPTH_STENCIL, GL_LUMINANCE8, GL_RGBA16F,
                                  GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, GL_DEPTH32F_STENCIL8, GL_R8});
  }

  void delete_name() {
    const int kind = choices_.integer(0, 2);
    const GLuint one = name(kind == 0 ? framebuffers_ : kind == 1 ? renderbuffers_ : textures_);
    if (kind == 0) gl_.DeleteFramebuffers(1, &one);
    if (kind == 1) gl_.DeleteRenderbuffers(1, &one);
    if (kind == 2) gl_.DeleteTextures(1, &one);
  }
  void store_renderbuffer() {
    const GLenum kind = format();
    const GLsizei samples = choices_.pick({0, 0, 4, 2, 1}), width = size(), height = size();
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, kind, width, height);
  }
  GLenum bind_some_texture() {
    const GLenum where = texture_target();
    gl_.BindTexture(where, name(textures_));
    return where;
  }
  void specify_texture() {
    const GLenum where = bind_some_texture(), kind = format();
    const GLint level = choices_.pick({0, 0, 1, 2});
    const GLsizei width = size(), height = size();
    const bool depth_stencil =
        kind == GL_DEPTH24_STENCIL8 || kind == GL_DEPTH_STENCIL || kind == GL_DEPTH32F_STENCIL8;
    const bool depth = kind == GL_DEPTH_COMPONENT16 || kind == GL_DEPTH_COMPONENT24;
    const GLenum given = depth_stencil ? GL_DEPTH_STENCIL : depth ? GL_DEPTH_COMPONENT : GL_RGBA;
    const GLenum type = depth_stencil ? GL_UNSIGNED_INT_24_8 : GL_UNSIGNED_BYTE;
    const void* pixels = choices_.chance(50) ? memory_.data() : nullptr;
    if (where == GL_TEXTURE_1D)
      gl_.TexImage1D(where, level, GLint(kind), width, 0, given, type, pixels);
    else if (where == GL_TEXTURE_3D)
      gl_.TexImage3D(where, level, GLint(kind), width, height, choices_.pick({4, 1, 0}), 0, given, type,
                     pixels);
    else if (where == GL_TEXTURE_CUBE_MAP)
      for (GLenum face = 0; face < 6; ++face)
        gl_.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, GLint(kind), width, width, 0, given,
                       type, pixels);
    else
      gl_.TexImage2D(where, level, GLint(kind), width, height, 0, given, type, pixels);
  }
  void attach_renderbuffer() {
    const GLenum where = target(), point = attachment();
    gl_.FramebufferRenderbuffer(where, point, GL_RENDERBUFFER, name(renderbuffers_));
  }
  void attach_texture() {
    const GLenum where = target(), point = attachment();
    const GLuint texture = name(textures_);
    const GLint level = choices_.pick({0, 0, 1, 3}), layer = choices_.pick({0, 1, 3});
    switch (choices_.integer(0, 4)) {
    case 0: gl_.FramebufferTexture1D(where, point, GL_TEXTURE_1D, texture, level); break;
    case 1: gl_.FramebufferTexture2D(where, point, GL_TEXTURE_2D, texture, level); break;
    case 2:
      gl_.FramebufferTexture2D(where, point, GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(choices_.integer(0, 5)),
                               texture, level);
      break;
    case 3: gl_.FramebufferTexture3D(where, point, GL_TEXTURE_3D, texture, level, layer); break;
    case 4: gl_.FramebufferTextureLayer(where, point, texture, level, layer); break;
    }
  }
  GLint corner() { return choices_.pick({0, 8, 16, -3, 40, 1}); }
  void blit() {
    GLint c[8];
    for (GLint& value : c) value = corner();
    const GLbitfield mask =
        choices_.pick<GLbitfield>({GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT,
                                   GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT});
    gl_.BlitFramebuffer(c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], mask,
                        choices_.pick<GLenum>({GL_NEAREST, GL_LINEAR}));
  }
  void draw() {
    const bool textured = choices_.chance(50);
    const GLenum where = textured ? bind_some_texture() : GLenum(GL_TEXTURE_2D);
    if (textured) gl_.Enable(where);
    for (GLenum test : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_BLEND, GL_MULTISAMPLE})
      choices_.chance(50) ? gl_.Enable(test) : gl_.Disable(test);
    if (choices_.chance(50)) gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (choices_.chance(20))
      gl_.RasterPos2f(0, 0), gl_.DrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, memory_.data());
    if (choices_.chance(20))
      gl_.CopyPixels(corner(), 0, 8, 8, choices_.pick<GLenum>({GL_COLOR, GL_DEPTH, GL_STENCIL}));
    gl_.Begin(choices_.pick<GLenum>({GL_TRIANGLES, GL_LINES, GL_POINTS}));
    for (const float x : {-0.9f, 0.8f, 0.1f}) {
      gl_.TexCoord3f(x, x * 2, 0.5f);
      gl_.Vertex3f(x, x * x, 0.5f - x);
    }
    gl_.End();
    if (textured) gl_.Disable(where);
  }
  void read() {
    const GLenum kind =
        choices_.pick<GLenum>({GL_RGBA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_DEPTH_STENCIL});
    gl_.ReadPixels(corner(), 0, 16, 16, kind, kind == GL_DEPTH_STENCIL ? GL_UNSIGNED_INT_24_8 : GL_FLOAT,
                   memory_.data());
  }
  void generate_mipmaps() { gl_.GenerateMipmap(bind_some_texture()); }
  void choose_buffers() {
    gl_.DrawBuffer(choices_.pick<GLenum>({GL_COLOR_ATTACHMENT0, GL_NONE, GL_FRONT, GL_COLOR_ATTACHMENT1}));
    gl_.ReadBuffer(choices_.pick<GLenum>({GL_COLOR_ATTACHMENT0, GL_NONE, GL_FRONT, GL_COLOR_ATTACHMENT1}));
  }
  void copy_to_texture() {
    bind_some_texture();
    if (choices_.chance(50))
      gl_.CopyTexImage2D(GL_TEXTURE_2D, choices_.pick({0, 1}),
                         choices_.pick<GLenum>({GL_RGBA, GL_DEPTH_COMPONENT, GL_DEPTH_STENCIL}), corner(), 0,
                         16, 16, 0);
    else
      gl_.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, corner(), 0, 8, 8);
  }

  bool fails_to(void (*use)(const Gl& gl)) {
    while (gl_.GetError() != GL_NO_ERROR) {}
    use(gl_);
    return gl_.GetError() == GL_INVALID_FRAMEBUFFER_OPERATION;
  }
  // GL_ARB_framebuffer_object, 4.4.4.3
  void check() {
    const bool drawn = gl_.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    const bool read = gl_.CheckFramebufferStatus(GL_READ_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (fails_to([](const Gl& gl) { gl.Clear(GL_STENCIL_BUFFER_BIT); }) == drawn)
      fault("glClear and completeness");
    if (fails_to([](const Gl& gl) { gl.Begin(GL_POINTS), gl.End(); }) == drawn)
      fault("glBegin and completeness");
    if (fails_to([](const Gl& gl) { gl.DrawArrays(GL_POINTS, 0, 1); }) == drawn)
      fault("glDrawArrays and completeness");
    if (fails_to([](const Gl& gl) {
          GLubyte pixel[16];
          gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        }) == read)
      fault("glReadPixels and completeness");
  }

  const Gl& gl_;
  Choices& choices_;
  std::vector<unsigned char> memory_;
  GLuint framebuffers_[kNames], renderbuffers_[kNames], textures_[kNames];
};

} // namespace

void fuzz_framebuffers(const Gl& gl, std::span<const uint8_t> bytes) {
  Choices choices(bytes);
  void* context = gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, nullptr);
  std::vector<unsigned char> window(64 * 48 * 4);
  if (!context || !gl.OSMesaMakeCurrent(context, window.data(), GL_UNSIGNED_BYTE, 64, 48))
    fault("no context");
  {
    Machine machine(gl, choices);
    for (int i = 0; i < kMostSteps && !choices.ended(); ++i) machine.step();
  }
  gl.Finish();
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(context);
}

} // namespace softgl::test
