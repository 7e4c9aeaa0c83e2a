// Workloads that draw by other means than lit meshes: what viewers of point clouds, games, plots and user
// interfaces ask for.
#include <algorithm>
#include <cmath>

#include "frames/workloads.h"

namespace softgl::bench {
namespace {

/// A workload of two functions. Both see the same random numbers in every run.
class Program : public Workload {
public:
  using Step = void (*)(Program& p);
  Program(const Gl& gl, int size, double scale, Step begin, Step draw)
      : Workload(gl, size), scale(scale), draw_(draw) {
    gl.ClearColor(0.2f, 0.25f, 0.3f, 1);
    gl.MatrixMode(GL_PROJECTION);
    gl.Frustum(-0.5, 0.5, -0.5, 0.5, 1, 10);
    gl.MatrixMode(GL_MODELVIEW);
    begin(*this);
  }
  void frame(int turn) override {
    random_ = 12345;
    gl.DepthMask(GL_TRUE);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    gl.LoadIdentity();
    gl.Translatef(0, 0, -3);
    gl.Rotatef(float(turn % 90), 0.2f, 1, 0);
    draw_(*this);
  }

  /// In [-1, 1).
  float random() {
    random_ = random_ * 1664525u + 1013904223u;
    return float(random_ >> 8) / 8388608.0f - 1;
  }
  int many(int count) const { return std::max(1, int(count * scale)); }
  /// In pixels of the picture, y upwards; without depth test.
  void use_window_coordinates() {
    gl.Disable(GL_DEPTH_TEST);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Ortho(0, size, 0, size, -1, 1);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
  }
  void use_image(GLint filter) {
    GLuint name;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 128, 128, 0, GL_RGBA, GL_UNSIGNED_BYTE, make_image(128).data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl.Enable(GL_TEXTURE_2D);
  }
  void use_arrays() {
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_NORMAL_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, sizeof(MeshVertex), mesh.vertices[0].position);
    gl.NormalPointer(GL_FLOAT, sizeof(MeshVertex), mesh.vertices[0].normal);
  }

  const double scale;
  Mesh mesh;
  std::vector<uint8_t> bytes;

private:
  Step draw_;
  uint32_t random_ = 0;
};

void blend(const Gl& gl, GLenum to) {
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, to);
}

void begin_points(Program& p) {
  p.gl.Enable(GL_DEPTH_TEST);
  const int count = p.many(500000);
  for (int i = 0; i < count; i++) {
    MeshVertex v{};
    for (float& x : v.position) x = p.random();
    for (float& n : v.normal) n = std::fabs(p.random());
    p.mesh.vertices.push_back(v);
  }
  p.gl.EnableClientState(GL_VERTEX_ARRAY);
  p.gl.EnableClientState(GL_COLOR_ARRAY);
  p.gl.VertexPointer(3, GL_FLOAT, sizeof(MeshVertex), p.mesh.vertices[0].position);
  p.gl.ColorPointer(3, GL_FLOAT, sizeof(MeshVertex), p.mesh.vertices[0].normal);
  p.units = count / 1e6, p.unit = "Mpoint/s";
}
void draw_points(Program& p) { p.gl.DrawArrays(GL_POINTS, 0, GLsizei(p.mesh.vertices.size())); }

void begin_sprites(Program& p) {
  p.gl.Enable(GL_DEPTH_TEST);
  p.use_image(GL_LINEAR);
  p.gl.Enable(GL_POINT_SPRITE);
  p.gl.TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
  p.gl.PointSize(16);
  blend(p.gl, GL_ONE);
  p.units = p.many(8000) / 1e6, p.unit = "Mpoint/s";
}
void draw_sprites(Program& p) {
  p.gl.DepthMask(GL_FALSE);
  p.gl.Begin(GL_POINTS);
  for (int i = p.many(8000); i > 0; i--) {
    const float red = std::fabs(p.random()), x = p.random(), y = p.random();
    p.gl.Color4f(red, 0.5f, 0.2f, 0.5f);
    p.gl.Vertex3f(x, y, p.random());
  }
  p.gl.End();
}

void draw_volume(Program& p) {
  p.gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 40; i++) {
    const float a = float(i) * 0.37f;
    p.gl.Vertex3f(std::cos(a), std::sin(a * 1.3f), 0.9f);
    p.gl.Vertex3f(std::sin(a * 2.1f), std::cos(a * 0.7f), -0.9f);
    p.gl.Vertex3f(std::sin(a * 3.1f), std::cos(a * 1.7f), 0.2f);
  }
  p.gl.End();
}
void begin_shadow_volumes(Program& p) {
  p.gl.Enable(GL_DEPTH_TEST);
  p.gl.StencilFunc(GL_ALWAYS, 0, 255);
  p.units = 10, p.unit = "pass/s";
}
void draw_shadow_volumes(Program& p) {
  const Gl& gl = p.gl;
  gl.Disable(GL_STENCIL_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.Begin(GL_QUADS);
  gl.Vertex3f(-1, -1, -0.3f), gl.Vertex3f(1, -1, 0.3f), gl.Vertex3f(1, 1, 0.2f), gl.Vertex3f(-1, 1, -0.2f);
  gl.End();
  gl.ColorMask(0, 0, 0, 0);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_STENCIL_TEST);
  gl.Enable(GL_CULL_FACE);
  for (int light = 0; light < 5; light++)
    for (GLenum face : {GL_BACK, GL_FRONT}) {
      gl.CullFace(face);
      gl.StencilOp(GL_KEEP, GL_KEEP, face == GL_BACK ? GL_INCR : GL_DECR);
      draw_volume(p);
    }
  gl.ColorMask(1, 1, 1, 1);
}

void begin_wireframe(Program& p) {
  const int cells = std::max(4, int(120 * std::sqrt(p.scale)));
  p.mesh = make_shell(cells, cells);
  p.gl.Enable(GL_DEPTH_TEST);
  p.gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  p.use_arrays();
  p.units = double(p.mesh.indices.size()) / 3e6;
}
void draw_wireframe(Program& p) {
  p.gl.DrawElements(GL_TRIANGLES, GLsizei(p.mesh.indices.size()), GL_UNSIGNED_INT, p.mesh.indices.data());
}

void begin_plot(Program& p) { p.units = p.many(60) * 400 / 1e6, p.unit = "Mline/s"; }
void draw_plot(Program& p) {
  p.use_window_coordinates();
  const float width = float(p.size) / 400;
  for (int k = p.many(60); k > 0; k--) {
    p.gl.Begin(GL_LINE_STRIP);
    for (int i = 0; i <= 400; i++) {
      const float angle = float(i) * 0.05f + float(k) * 0.3f;
      p.gl.Vertex2f(float(i) * width,
                    float(p.size) * (0.5f + 0.4f * std::sin(angle) * std::cos(float(i * k) * 0.011f)));
    }
    p.gl.End();
  }
}

void begin_text(Program& p) {
  p.bytes = make_image(64);
  p.units = p.many(5000) / 1e6, p.unit = "Mglyph/s";
}
void draw_text(Program& p) {
  p.use_window_coordinates();
  for (int i = p.many(5000); i > 0; i--) {
    p.gl.RasterPos2i(i * 9 % (p.size - 8), i * 9 / (p.size - 8) * 14 % p.size);
    p.gl.Bitmap(8, 13, 0, 0, 9, 0, p.bytes.data() + i % 1000 * 16);
  }
}

void begin_slices(Program& p) {
  p.bytes.resize(64 * 64 * 64 * 4);
  for (uint8_t& b : p.bytes) b = uint8_t(int(p.random() * 32) + 40);
  GLuint name;
  p.gl.GenTextures(1, &name);
  p.gl.BindTexture(GL_TEXTURE_3D, name);
  p.gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 64, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, p.bytes.data());
  p.gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  p.gl.Enable(GL_TEXTURE_3D);
  blend(p.gl, GL_ONE_MINUS_SRC_ALPHA);
  p.units = p.many(64), p.unit = "slice/s";
}
void draw_slices(Program& p) {
  const int count = p.many(64);
  p.gl.Begin(GL_QUADS);
  for (int i = 0; i < count; i++) {
    const float r = float(i) / float(count), z = r * 1.6f - 0.8f;
    p.gl.TexCoord3f(0, 0, r), p.gl.Vertex3f(-0.8f, -0.8f, z);
    p.gl.TexCoord3f(1, 0, r), p.gl.Vertex3f(0.8f, -0.8f, z);
    p.gl.TexCoord3f(1, 1, r), p.gl.Vertex3f(0.8f, 0.8f, z);
    p.gl.TexCoord3f(0, 1, r), p.gl.Vertex3f(-0.8f, 0.8f, z);
  }
  p.gl.End();
}

void begin_reading(Program& p) {
  p.bytes.resize(size_t(p.size) * size_t(p.size) * 3);
  p.gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  p.units = double(p.size) * p.size / 1e6, p.unit = "Mpixel/s";
}
void draw_reading(Program& p) {
  p.gl.ReadPixels(0, 0, p.size, p.size, GL_RGB, GL_UNSIGNED_BYTE, p.bytes.data());
}

template <Program::Step Begin, Program::Step Draw>
std::unique_ptr<Workload> make(const Gl& gl, int size, double scale) {
  return std::make_unique<Program>(gl, size, scale, Begin, Draw);
}

} // namespace

std::vector<WorkloadKind> program_workloads() {
  return {
      {"points", "half a million points of one pixel, depth test", make<begin_points, draw_points>, false},
      {"sprites", "eight thousand textured, blended point sprites of 16x16 pixels",
       make<begin_sprites, draw_sprites>, false},
      {"shadow_volumes", "ten passes of 40 large triangles that change the stencil buffer alone",
       make<begin_shadow_volumes, draw_shadow_volumes>, false},
      {"wireframe", "29 thousand triangles by their edges", make<begin_wireframe, draw_wireframe>, false},
      {"plot", "sixty curves of 400 lines", make<begin_plot, draw_plot>, false},
      {"text", "five thousand letters by glBitmap", make<begin_text, draw_text>, false},
      {"slices", "a volume of 64 blended slices of a 3-D texture", make<begin_slices, draw_slices>, false},
      {"reading", "glReadPixels of the whole picture as GL_RGB", make<begin_reading, draw_reading>, false},
  };
}

} // namespace softgl::bench
