// Display lists: compiled, executed at the same time, nested, with errors inside, replaced while they are
// drawn.
#include "faults/streams.h"

namespace softgl::test {
namespace {

void shape(Player& p, int triangles, bool attributes) {
  const Gl& gl = p.gl;
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3 * triangles; ++i) {
    if (attributes && i > 5) {
      const Float4 c = p.random.color();
      gl.Color4fv(c.data());
    }
    if (attributes && i == 30) gl.Normal3f(0, 1, 0);
    const float x = p.random.real(-1, 1), y = p.random.real(-1, 1);
    gl.Vertex2f(x, y);
  }
  gl.End();
}

void play(Player& p, GLuint list) {
  for (int i = 0; i < 3; ++i) {
    p.gl.CallList(list);
    p.check();
    p.gl.Translatef(0.1f, 0.05f, 0);
  }
  p.gl.LoadIdentity();
  p.picture();
}

void compile(Player& p, GLenum mode) {
  const Gl& gl = p.gl;
  const GLuint list = gl.GenLists(2);
  gl.Color3f(0.5f, 1, 0.25f);
  gl.NewList(list, mode);
  gl.Color3f(1, 0, 0.5f);
  shape(p, 40, false);
  gl.Enable(GL_BLEND);
  shape(p, 3000, true); // larger than a piece of memory
  gl.Disable(GL_BLEND);
  gl.Normal3f(1, 0, 0);
  gl.Rotatef(30, 0, 0, 1);
  shape(p, 1, true);
  gl.EndList();
  p.check();
  play(p, list);
  gl.DeleteLists(list, 2);
  p.check();
}
void compiled(Player& p) { compile(p, GL_COMPILE); }
void compiled_and_executed(Player& p) { compile(p, GL_COMPILE_AND_EXECUTE); }

void nested(Player& p) {
  const Gl& gl = p.gl;
  const GLuint first = gl.GenLists(8);
  for (GLuint i = 0; i < 8; ++i) {
    gl.NewList(first + i, i == 3 ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
    shape(p, 5, i % 2);
    if (i) gl.CallList(first + i - 1);
    const GLubyte names[3] = {0, 1, 0};
    gl.ListBase(first);
    if (i > 2) gl.CallLists(3, GL_UNSIGNED_BYTE, names);
    gl.EndList();
  }
  p.check();
  play(p, first + 7);
  // A primitive that begins in one list and ends in another.
  gl.NewList(first, GL_COMPILE);
  gl.Begin(GL_TRIANGLE_STRIP);
  gl.Color3f(0, 1, 1);
  gl.Vertex2f(-1, 0);
  gl.EndList();
  gl.NewList(first + 1, GL_COMPILE);
  gl.Vertex2f(0, 1);
  gl.Color3f(1, 1, 0);
  gl.Vertex2f(0, -1);
  gl.Vertex2f(1, 0);
  gl.EndList();
  gl.NewList(first + 2, GL_COMPILE);
  gl.CallList(first);
  gl.CallList(first + 1);
  gl.End();
  gl.EndList();
  p.check();
  play(p, first + 2);
  gl.Begin(GL_TRIANGLES);
  gl.CallList(first + 1);
  gl.End();
  p.check();
  p.picture();
  gl.DeleteLists(first, 8);
}

/// What a list keeps besides vertices: payloads, images, matrices; and commands that are errors.
void commands_and_errors(Player& p) {
  const Gl& gl = p.gl;
  const GLuint list = gl.GenLists(1);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  unsigned char texels[32][32][4];
  for (auto& row : texels)
    for (auto& texel : row)
      for (auto& x : texel) x = static_cast<unsigned char>(p.random.integer(0, 255));
  for (GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    gl.NewList(list, mode);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 8, 8, GL_RGB, GL_UNSIGNED_BYTE, texels);
    gl.Enable(GL_TEXTURE_2D);
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      const float x = float(i == 1 || i == 2), y = float(i > 1);
      gl.TexCoord2f(x, y);
      gl.Vertex2f(x, y - 0.5f);
    }
    gl.End();
    gl.Disable(GL_TEXTURE_2D);
    gl.Bitmap(20, 20, 0, 0, 5, 5, &texels[0][0][0]);
    gl.DrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    gl.MultMatrixf(std::array<float, 16>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1f, 0, 0, 1}.data());
    gl.PolygonStipple(&texels[0][0][0]);
    gl.PushMatrix();
    gl.PopMatrix();
    gl.EndList();
    p.check();
    play(p, list);
    // The first error hides all others: a list that has one says nothing about memory.
    gl.NewList(list, mode);
    gl.Enable(GL_FOG + 1);
    p.check();
    gl.Begin(77);
    p.check();
    gl.LineWidth(-1);
    gl.EndList();
    p.check();
    gl.CallList(list);
    p.check();
  }
  gl.DeleteLists(list, 1);
  gl.DeleteTextures(1, &texture);
}

/// Lists that are redefined and deleted while a frame waits that draws them; arrays in lists; many names.
void replaced(Player& p) {
  const Gl& gl = p.gl;
  const GLuint first = gl.GenLists(40);
  for (int round = 0; round < 3; ++round)
    for (GLuint i = 0; i < 10; ++i) {
      gl.NewList(first + i, GL_COMPILE);
      shape(p, 30, round == 1);
      gl.EndList();
      gl.CallList(first + i);
      if (round && i % 3 == 0) gl.CallList(first + i);
      p.check();
    }
  float vertices[60][2];
  for (auto& v : vertices)
    for (float& x : v) x = p.random.real(-1, 1);
  gl.VertexPointer(2, GL_FLOAT, 0, vertices);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.NewList(first + 11, GL_COMPILE);
  gl.DrawArrays(GL_TRIANGLES, 0, 60);
  gl.EndList();
  gl.DisableClientState(GL_VERTEX_ARRAY);
  gl.DeleteLists(first, 5);
  p.check();
  play(p, first + 11);
  gl.DeleteLists(first, 40);
  p.picture();
}

} // namespace

const std::vector<Stream>& list_streams() {
  static const std::vector<Stream> streams = {{"lists.compiled", compiled},
                                              {"lists.executed", compiled_and_executed},
                                              {"lists.nested", nested},
                                              {"lists.commands", commands_and_errors},
                                              {"lists.replaced", replaced}};
  return streams;
}

} // namespace softgl::test
