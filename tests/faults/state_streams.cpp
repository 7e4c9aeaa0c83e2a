// Stacks of attributes and matrices, selection and feedback, queries.
#include "faults/streams.h"

namespace softgl::test {
namespace {

void triangle(const Gl& gl, float x) {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex2f(x, 0);
  gl.Vertex2f(x + 0.5f, 0);
  gl.Vertex2f(x, 0.5f);
  gl.End();
}

void stacks(Player& p) {
  const Gl& gl = p.gl;
  for (int i = 0; i < 10; ++i) {
    gl.PushAttrib(i % 2 ? GLbitfield(GL_ALL_ATTRIB_BITS) : GLbitfield(GL_LIGHTING_BIT | GL_ENABLE_BIT));
    gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT | GL_CLIENT_PIXEL_STORE_BIT);
    gl.Enable(i % 2 ? GL_LIGHTING : GL_BLEND);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
      gl.MatrixMode(mode);
      if (mode == GL_MODELVIEW || i == 0) gl.PushMatrix();
      gl.Scalef(1, 0.9f, 1);
    }
    gl.MatrixMode(GL_MODELVIEW);
    triangle(gl, -1 + 0.1f * float(i));
    p.check();
  }
  for (int i = 0; i < 10; ++i) {
    gl.PopAttrib();
    gl.PopClientAttrib();
    gl.PopMatrix();
    triangle(gl, 0.1f * float(i));
  }
  p.check();
  p.picture();
}

void selection_and_feedback(Player& p) {
  const Gl& gl = p.gl;
  GLuint names[256] = {};
  gl.SelectBuffer(256, names);
  gl.RenderMode(GL_SELECT);
  gl.InitNames();
  for (GLuint i = 0; i < 10; ++i) {
    gl.PushName(i);
    triangle(gl, -1 + 0.2f * float(i));
    if (i % 2) gl.LoadName(i + 100);
    gl.RasterPos2f(0, 0);
  }
  p.add(uint64_t(gl.RenderMode(GL_RENDER)));
  p.check();
  p.add(names, sizeof names);
  GLfloat values[2048] = {};
  for (GLenum type : {GL_2D, GL_3D_COLOR, GL_4D_COLOR_TEXTURE}) {
    gl.FeedbackBuffer(2048, type, values);
    gl.RenderMode(GL_FEEDBACK);
    for (int i = 0; i < 12; ++i) triangle(gl, -1 + 0.2f * float(i));
    gl.PassThrough(5);
    const unsigned char pixels[64] = {};
    gl.DrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    p.add(uint64_t(gl.RenderMode(GL_RENDER)));
    p.check();
    p.add(values, sizeof values);
  }
  p.picture();
}

void occlusion_queries(Player& p) {
  const Gl& gl = p.gl;
  GLuint names[12];
  gl.GenQueries(12, names);
  p.check();
  // Names that failed to come are names nevertheless.
  for (GLuint i = 0; i < 12; ++i) names[i] = 100 + i;
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int i = 0; i < 12; ++i) {
    gl.BeginQuery(GL_SAMPLES_PASSED, names[i]);
    for (int k = 0; k <= i; ++k) triangle(gl, -1 + 0.1f * float(k));
    gl.EndQuery(GL_SAMPLES_PASSED);
    p.check();
    if (i % 4 == 3) gl.Flush();
  }
  for (GLuint name : names) {
    GLuint count = 0, available = 0;
    gl.GetQueryObjectuiv(name, GL_QUERY_RESULT_AVAILABLE, &available);
    gl.GetQueryObjectuiv(name, GL_QUERY_RESULT, &count);
    p.check();
    p.add(uint64_t(count) << 1 | available);
  }
  gl.DeleteQueries(12, names);
  p.check();
  p.picture();
}

} // namespace

const std::vector<Stream>& state_streams() {
  static const std::vector<Stream> streams = {{"state.stacks", stacks},
                                              {"state.feedback", selection_and_feedback},
                                              {"state.queries", occlusion_queries}};
  return streams;
}

} // namespace softgl::test
