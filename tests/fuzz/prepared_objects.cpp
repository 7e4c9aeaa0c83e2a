#include "fuzz/arguments.h"
#include "fuzz/input_memory.h"

namespace softgl::test {

void prepare_objects(const Gl& gl, Choices& choices) {
  const unsigned char* const pixels = input().images;
  const auto on = [&] { return choices.chance(50); };
  if (on()) {
    gl.BindTexture(GL_TEXTURE_1D, 1);
    gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  }
  if (on()) {
    gl.BindTexture(GL_TEXTURE_2D, 2);
    for (int level = 0; level < 4; ++level)
      gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, 8 >> level, 8 >> level, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    pixels);
  }
  if (on()) {
    gl.BindTexture(GL_TEXTURE_3D, 3);
    gl.TexImage3D(GL_TEXTURE_3D, 0, GL_LUMINANCE8, 8, 8, 8, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, pixels);
  }
  if (on()) {
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, 4);
    for (GLenum face = 0; face < 6; ++face)
      gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB8, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE,
                    pixels);
  }
  if (on()) {
    gl.BindTexture(GL_TEXTURE_RECTANGLE, 5);
    gl.TexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA8, 8, 5, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  }
  if (on())
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  pixels);
  if (on()) {
    gl.BindBuffer(GL_ARRAY_BUFFER, 1);
    gl.BufferData(GL_ARRAY_BUFFER, 4096, pixels, GL_STATIC_DRAW);
    if (on()) gl.BindBuffer(GL_COPY_READ_BUFFER, 2);
    if (on()) gl.BufferData(GL_COPY_READ_BUFFER, 64, pixels, GL_DYNAMIC_COPY);
    if (choices.chance(30)) gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
    if (on()) gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  }
  if (on()) {
    gl.NewList(1, GL_COMPILE);
    gl.Translatef(1, 0, 0);
    gl.EndList();
  }
  if (choices.chance(30)) {
    GLuint names[2];
    gl.GenRenderbuffers(2, names);
    gl.GenFramebuffers(2, names);
    gl.BindRenderbuffer(GL_RENDERBUFFER, 1);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 16, 16);
    gl.BindRenderbuffer(GL_RENDERBUFFER, 2);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 16, 16);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 1);
    if (on()) gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 1);
    if (on()) gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 2);
    if (choices.chance(30)) gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    if (choices.chance(30)) gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  }
  if (choices.chance(60)) {
    GLuint samplers[3];
    gl.GenSamplers(3, samplers);
    if (on()) gl.BindSampler(0, 1);
    if (on()) gl.SamplerParameteri(2, GL_TEXTURE_WRAP_S, GL_CLAMP);
  }
  if (choices.chance(25)) {
    GLuint query = 0;
    gl.GenQueries(1, &query);
    gl.BeginQuery(GL_SAMPLES_PASSED, query);
  }
  if (choices.chance(25)) {
    GLuint array = 0;
    gl.GenVertexArrays(1, &array);
    gl.BindVertexArray(array);
  }
  if (choices.chance(25)) gl.Enable(GL_PRIMITIVE_RESTART_NV);
  if (choices.chance(30)) gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  if (choices.chance(30)) gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  if (choices.chance(30)) gl.MatrixMode(choices.pick<GLenum>({GL_PROJECTION, GL_TEXTURE}));
  if (choices.chance(30)) gl.ActiveTexture(GL_TEXTURE2);
}

} // namespace softgl::test
