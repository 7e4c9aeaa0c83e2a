// From arrays to shaded vertices: fetching by component type, lighting by number and kind of lights.
#include <cmath>

#include "base/float_environment.h"
#include "geometry/geometry.h"
#include "harness.h"

namespace softgl::bench {
namespace {

void shade(benchmark::State& state) {
  const DrawRecord& draw = recorded_draw();
  ShadedMemory memory(draw);
  const FloatEnvironment environment;
  for (auto _ : state) shade_vertices(draw, draw.call.first_vertex, draw.call.vertex_count, memory.vertices);
  count_work(state, "vertex", draw.call.vertex_count);
  print_hash(state, memory.hash(draw));
}

// Positions and colors that a program gives as numbers of type T, without lighting.
template <class T, GLenum type> void vertex_fetch(benchmark::State& state) {
  Canvas canvas(64);
  constexpr int kVertices = 20000;
  std::vector<T> positions(kVertices * 3), colors(kVertices * 4);
  for (size_t i = 0; i < positions.size(); i++) positions[i] = T(i * 7 % 100);
  for (size_t i = 0; i < colors.size(); i++) colors[i] = T(i * 3 % 120);
  glOrtho(0, 100, 0, 100, -100, 100);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glVertexPointer(3, type, 0, positions.data());
  glColorPointer(4, type, 0, colors.data());
  glDrawArrays(GL_POINTS, 0, kVertices);
  shade(state);
}

void vertex_lights(benchmark::State& state, bool local) {
  Canvas canvas(64);
  const Mesh mesh = make_shell(160, 100);
  set_mesh(mesh);
  if (state.range(0)) glEnable(GL_LIGHTING);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, local);
  const float specular[4] = {0.5f, 0.5f, 0.5f, 1};
  glMaterialfv(GL_FRONT, GL_SPECULAR, specular);
  glMaterialf(GL_FRONT, GL_SHININESS, 30);
  for (int i = 0; i < state.range(0); i++) {
    const GLenum light = GLenum(GL_LIGHT0 + i);
    const float position[4] = {2 * std::cos(float(i)), 2 * std::sin(float(i)), 2, local ? 1.0f : 0.0f};
    glEnable(light);
    glLightfv(light, GL_POSITION, position);
    glLightfv(light, GL_DIFFUSE, specular);
    glLightfv(light, GL_SPECULAR, specular);
    if (!local) continue;
    glLightf(light, GL_LINEAR_ATTENUATION, 0.1f);
    glLightf(light, GL_SPOT_CUTOFF, 80);
  }
  glDrawElements(GL_TRIANGLES, GLsizei(mesh.indices.size()), GL_UNSIGNED_INT, mesh.indices.data());
  shade(state);
}

BENCHMARK_TEMPLATE(vertex_fetch, GLfloat, GL_FLOAT);
BENCHMARK_TEMPLATE(vertex_fetch, GLdouble, GL_DOUBLE);
BENCHMARK_TEMPLATE(vertex_fetch, GLshort, GL_SHORT);
BENCHMARK_CAPTURE(vertex_lights, infinite, false)->Arg(0)->Arg(1)->Arg(2)->Arg(4)->Arg(8);
BENCHMARK_CAPTURE(vertex_lights, local_spots, true)->Arg(1)->Arg(8);

} // namespace
} // namespace softgl::bench
