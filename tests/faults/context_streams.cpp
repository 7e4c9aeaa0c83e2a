// Contexts: created, made current, resized, destroyed, none current; objects that several of them share.
#include "faults/streams.h"

namespace softgl::test {
namespace {

void triangle(const Gl& gl, float x) {
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(1, x, 0);
  gl.Vertex2f(x, 0);
  gl.Vertex2f(x + 0.5f, 0);
  gl.Vertex2f(x, 0.5f);
  gl.End();
}

void contexts(Player& p) {
  const Gl& gl = p.gl;
  for (GLenum format : {kOSMesaRgba, kOSMesaBgra, kOSMesaRgb}) {
    void* context = p.create(nullptr, format, format == kOSMesaBgra ? 16 : 24, 0);
    if (!context) continue;
    for (int size : {40, 100, 600, 64}) { // the first frame of a large one is prepared
      if (!p.make_current(context, size, size)) continue;
      triangle(gl, -0.5f);
      if (size == 100) p.make_none_current(); // with a frame that waits
      if (size == 600) {
        gl.Finish();
        triangle(gl, 0.5f);
        p.make_current(p.own_context());
        triangle(gl, 0.1f);
        continue;
      }
      GLint width = 0, height = 0, bytes = 0;
      void* depth = nullptr;
      if (!gl.OSMesaGetDepthBuffer(context, &width, &height, &bytes, &depth)) p.refuse();
      p.picture();
    }
    p.make_current(context, 64, 64, GL_FLOAT);
    p.picture();
    p.destroy(context);
  }
  p.make_current(p.own_context());
  p.picture();
}

void sharing(Player& p) {
  const Gl& gl = p.gl;
  void* second = p.create(p.own_context());
  GLuint texture = 0, buffer = 0;
  unsigned char texels[16][16][4];
  for (auto& row : texels)
    for (auto& texel : row)
      for (auto& x : texel) x = static_cast<unsigned char>(p.random.integer(0, 255));
  gl.GenTextures(1, &texture);
  gl.GenBuffers(1, &buffer);
  const GLuint list = gl.GenLists(1);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  gl.NewList(list, GL_COMPILE);
  for (int i = 0; i < 30; ++i) triangle(gl, 0.05f * float(i) - 0.7f);
  gl.EndList();
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof texels, texels, GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.Enable(GL_TEXTURE_2D);
  gl.CallList(list);
  p.check();
  for (int i = 0; second && i < 3; ++i) {
    if (!p.make_current(second, 70, 50)) break;
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.Enable(GL_TEXTURE_2D);
    gl.CallList(list);
    gl.CallList(list);
    if (i == 1) gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    if (i == 2) {
      gl.DeleteTextures(1, &texture);
      gl.DeleteLists(list, 1);
    }
    p.picture();
    if (!p.make_current(p.own_context())) break;
    gl.CallList(list);
    p.picture();
  }
  if (second) p.destroy(second);
  p.make_current(p.own_context());
  p.picture();
  gl.DeleteBuffers(1, &buffer);
  gl.DeleteTextures(1, &texture);
  gl.DeleteLists(list, 1);
}

} // namespace

const std::vector<Stream>& context_streams() {
  static const std::vector<Stream> streams = {{"contexts", contexts}, {"contexts.sharing", sharing}};
  return streams;
}

} // namespace softgl::test
