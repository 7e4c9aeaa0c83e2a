#include "frames/workloads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace softgl::bench {
namespace {

int scaled(int cells, double scale) { return std::max(2, int(cells * std::sqrt(scale))); }

// A mesh under lights, in one of the ways in which programs hand over vertices.
enum class Source { Buffers, ClientArrays, List, Immediate };
struct MeshPlan {
  int around, along;
  int lights = 1;
  Source source = Source::Buffers;
  bool textured = false;
  GLenum mode = GL_TRIANGLES;
  GLenum shade_model = GL_SMOOTH;
};

void use_texture(const Gl& gl, bool trilinear) {
  GLuint name;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  int level = 0;
  for (int size = 512; size >= 1; size /= 2)
    gl.TexImage2D(GL_TEXTURE_2D, level++, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  make_image(size).data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, trilinear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, trilinear ? GL_LINEAR : GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
}

// One light is a lamp infinitely far away; of several, all have a place and distance, and every other one is
// a spot.
void use_lights(const Gl& gl, int count) {
  gl.Enable(GL_LIGHTING);
  for (int i = 0; i < count; i++) {
    const GLenum light = GLenum(GL_LIGHT0 + i);
    const float angle = 0.8f * float(i), share = 1.2f / float(count);
    const float position[4] = {2.5f * std::cos(angle), 2.5f * std::sin(angle), 3, count > 1 ? 1.0f : 0.0f};
    const float color[4] = {share, share * 0.9f, share * 0.8f, 1};
    gl.Enable(light);
    gl.Lightfv(light, GL_POSITION, position);
    gl.Lightfv(light, GL_DIFFUSE, color);
    gl.Lightfv(light, GL_SPECULAR, color);
    if (count == 1) continue;
    gl.Lightf(light, GL_QUADRATIC_ATTENUATION, 0.02f);
    if (i % 2 == 0) continue;
    const float inwards[3] = {-position[0], -position[1], -7};
    gl.Lightfv(light, GL_SPOT_DIRECTION, inwards);
    gl.Lightf(light, GL_SPOT_CUTOFF, 50);
    gl.Lightf(light, GL_SPOT_EXPONENT, 3);
  }
  if (count > 1) {
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  }
  const float ambient[4] = {0.1f, 0.1f, 0.12f, 1}, diffuse[4] = {0.3f, 0.6f, 0.7f, 1},
              specular[4] = {0.5f, 0.5f, 0.5f, 1};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ambient);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 30);
}

class MeshWorkload : public Workload {
public:
  MeshWorkload(const Gl& gl, int size, const MeshPlan& plan, double scale)
      : Workload(gl, size), plan_(plan),
        mesh_(make_shell(scaled(plan.around, scale), scaled(plan.along, scale))) {
    units = double(mesh_.indices.size()) / (plan.mode == GL_LINES ? 2e6 : 3e6);
    if (plan.mode == GL_LINES) unit = "Mline/s";
    gl.ClearColor(0.1f, 0.1f, 0.1f, 1);
    gl.Enable(GL_DEPTH_TEST);
    gl.MatrixMode(GL_PROJECTION);
    gl.Frustum(-0.5, 0.5, -0.5, 0.5, 1, 10);
    gl.MatrixMode(GL_MODELVIEW);
    use_lights(gl, plan.lights);
    gl.ShadeModel(plan.shade_model);
    if (plan.textured) use_texture(gl, true);
    if (plan.source == Source::Buffers || plan.source == Source::ClientArrays) set_arrays();
    if (plan.source == Source::List) {
      gl.NewList(1, GL_COMPILE);
      immediate();
      gl.EndList();
    }
  }

  void frame(int turn) override {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.LoadIdentity();
    gl.Translatef(0, 0, -3);
    gl.Rotatef(25 + 3 * float(turn), 0.3f, 1, 0.1f);
    draw();
  }

protected:
  virtual void draw() {
    if (plan_.source == Source::List)
      gl.CallList(1);
    else if (plan_.source == Source::Immediate)
      immediate();
    else
      gl.DrawElements(plan_.mode, GLsizei(mesh_.indices.size()), GL_UNSIGNED_INT,
                      plan_.source == Source::Buffers ? nullptr : mesh_.indices.data());
  }

  const MeshPlan plan_;
  const Mesh mesh_;

private:
  void set_arrays() {
    const char* base = reinterpret_cast<const char*>(mesh_.vertices.data());
    if (plan_.source == Source::Buffers) {
      GLuint name[2];
      gl.GenBuffers(2, name);
      gl.BindBuffer(GL_ARRAY_BUFFER, name[0]);
      gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh_.vertices.size() * sizeof(MeshVertex)), base,
                    GL_STATIC_DRAW);
      gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, name[1]);
      gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh_.indices.size() * 4), mesh_.indices.data(),
                    GL_STATIC_DRAW);
      base = nullptr;
    }
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_NORMAL_ARRAY);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, sizeof(MeshVertex), base);
    gl.NormalPointer(GL_FLOAT, sizeof(MeshVertex), base + offsetof(MeshVertex, normal));
    gl.TexCoordPointer(2, GL_FLOAT, sizeof(MeshVertex), base + offsetof(MeshVertex, texcoord));
  }
  void immediate() {
    gl.Begin(plan_.mode);
    for (uint32_t i : mesh_.indices) {
      gl.Normal3fv(mesh_.vertices[i].normal);
      gl.Vertex3fv(mesh_.vertices[i].position);
    }
    gl.End();
  }
};

/// Many small objects, each with a material and a place of its own.
class SmallDraws : public MeshWorkload {
public:
  SmallDraws(const Gl& gl, int size, double scale)
      : MeshWorkload(gl, size, {6, 4, 2}, 1), side_(scaled(100, scale)) {
    units = double(side_) * side_ / 1e6;
    unit = "Mdraw/s";
  }

private:
  void draw() override {
    const float step = 2.4f / float(side_);
    for (int j = 0; j < side_; j++)
      for (int i = 0; i < side_; i++) {
        const float color[4] = {float(i) / float(side_), float(j) / float(side_), 0.4f, 1};
        gl.Materialfv(GL_FRONT, GL_DIFFUSE, color);
        gl.PushMatrix();
        gl.Translatef((float(i) + 0.5f) * step - 1.2f, (float(j) + 0.5f) * step - 1.2f, 0);
        gl.Scalef(0.4f * step, 0.4f * step, 0.4f * step);
        MeshWorkload::draw();
        gl.PopMatrix();
      }
  }
  const int side_;
};

/// Layers that cover the whole picture.
enum class Layer { Opaque, Blended, Textured };
class Layers : public Workload {
public:
  Layers(const Gl& gl, int size, Layer kind, double scale)
      : Workload(gl, size), count_(std::max(2, int(20 * scale))) {
    units = double(count_) * size * size / 1e6;
    unit = "Mpixel/s";
    if (kind == Layer::Opaque) gl.Enable(GL_DEPTH_TEST);
    if (kind == Layer::Textured) use_texture(gl, true);
    if (kind != Layer::Blended) return;
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  void frame(int turn) override {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < count_; i++) {
      const float t = float(i) / float(count_), z = 0.9f - 1.8f * t, shift = 0.01f * float(turn);
      gl.Begin(GL_TRIANGLE_STRIP);
      for (int corner = 0; corner < 4; corner++) {
        const float x = corner & 1 ? 1.0f : -1.0f, y = corner & 2 ? 1.0f : -1.0f;
        gl.Color4f(0.5f + 0.5f * x, 0.5f + 0.5f * y, t, 0.2f + 0.2f * float(corner));
        gl.TexCoord2f(3 * x + shift, 3 * y + t);
        gl.Vertex3f(x, y, z);
      }
      gl.End();
    }
  }

private:
  const int count_;
};

template <int Around, int Along, int Lights, Source From, bool Textured = false, GLenum Mode = GL_TRIANGLES,
          GLenum ShadeModel = GL_SMOOTH>
std::unique_ptr<Workload> make_mesh(const Gl& gl, int size, double scale) {
  return std::make_unique<MeshWorkload>(
      gl, size, MeshPlan{Around, Along, Lights, From, Textured, Mode, ShadeModel}, scale);
}
template <Layer Kind> std::unique_ptr<Workload> make_layers(const Gl& gl, int size, double scale) {
  return std::make_unique<Layers>(gl, size, Kind, scale);
}
std::unique_ptr<Workload> make_small_draws(const Gl& gl, int size, double scale) {
  return std::make_unique<SmallDraws>(gl, size, scale);
}

} // namespace

static std::vector<WorkloadKind> mesh_workloads() {
  return {
      {"one_shot", "load the library, one picture of 70 thousand triangles",
       make_mesh<256, 136, 1, Source::Buffers>, true},
      {"mesh", "a million lit triangles from buffer objects", make_mesh<1024, 512, 1, Source::Buffers>,
       false},
      {"mesh_70k", "70 thousand lit triangles from buffer objects", make_mesh<256, 136, 1, Source::Buffers>,
       false},
      {"phong_70k",
       "the same, Phong-shaded: by GL_WIN_phong_shading or, where there is none, by shaders/glsl",
       make_mesh<256, 136, 1, Source::Buffers, false, GL_TRIANGLES, GL_PHONG_WIN>, false, true},
      {"client_arrays", "a million lit triangles from the program's memory",
       make_mesh<1024, 512, 1, Source::ClientArrays>, false},
      {"lights", "a quarter of a million triangles under eight lights, four of them spots",
       make_mesh<512, 256, 8, Source::Buffers>, false},
      {"list", "a quarter of a million triangles from a display list", make_mesh<512, 256, 1, Source::List>,
       false},
      {"immediate", "the same with glBegin, glNormal3fv, glVertex3fv",
       make_mesh<512, 256, 1, Source::Immediate>, false},
      {"textured_mesh", "70 thousand triangles, two lights, trilinear texture",
       make_mesh<256, 136, 2, Source::Buffers, true>, false},
      {"lines", "the edges of 70 thousand triangles as lit lines",
       make_mesh<256, 136, 1, Source::Buffers, false, GL_LINES>, false},
      {"small_draws", "ten thousand objects of 48 triangles, each with its own material and matrix",
       make_small_draws, false},
      {"fill", "twenty layers over the whole picture, smooth colors, depth test", make_layers<Layer::Opaque>,
       false},
      {"blend", "twenty translucent layers", make_layers<Layer::Blended>, false},
      {"texture", "twenty layers with a trilinear texture", make_layers<Layer::Textured>, false},
  };
}

const std::vector<WorkloadKind>& workloads() {
  static const std::vector<WorkloadKind> all = [] {
    std::vector<WorkloadKind> kinds = mesh_workloads();
    for (const WorkloadKind& kind : program_workloads()) kinds.push_back(kind);
    return kinds;
  }();
  return all;
}

} // namespace softgl::bench
