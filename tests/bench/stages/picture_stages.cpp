// What comes after drawing: the caller's buffer, glReadPixels, glClear; and reading a model from a file's
// text.
#include "commands/framebuffer/flush.h"
#include "frame/surface_work.h"
#include "harness.h"
#include "obj/obj_reader.h"
#include "surface/read_surface.h"

namespace softgl::bench {
namespace {

constexpr int kSize = 512;

void draw_something() {
  glClearColor(0.1f, 0.2f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glBegin(GL_TRIANGLES);
  glColor3f(1, 0, 0), glVertex3f(-1, -1, 0);
  glColor3f(0, 1, 0), glVertex3f(1, -1, 0.3f);
  glColor3f(0, 0, 1), glVertex3f(0, 1, -0.3f);
  glEnd();
}

void resolve_rows(benchmark::State& state, GLenum format) {
  Canvas canvas(kSize);
  draw_something();
  flush_rendering(*current_context);
  ClientBuffer client = current_context->framebuffer.client;
  client.format = format;
  for (auto _ : state) resolve(current_context->framebuffer.surface, client);
  count_work(state, "pixel", double(kSize) * kSize);
  print_hash(state, hash_of(canvas.pixels.data(), canvas.pixels.size() * 4));
}

void read_pixels(benchmark::State& state, GLenum format, GLenum type, size_t bytes) {
  Canvas canvas(kSize);
  draw_something();
  std::vector<uint8_t> rows(size_t(kSize) * kSize * bytes);
  for (auto _ : state) glReadPixels(0, 0, kSize, kSize, format, type, rows.data());
  count_work(state, "pixel", double(kSize) * kSize);
  print_hash(state, hash_of(rows.data(), rows.size()));
}

void clear(benchmark::State& state) {
  Canvas canvas(kSize);
  draw_something();
  for (auto _ : state) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    flush_rendering(*current_context);
  }
  count_work(state, "pixel", double(kSize) * kSize);
  print_hash(state, canvas.picture_hash());
}

std::string obj_text(const Mesh& mesh, bool slashes) {
  std::string text;
  char line[160];
  for (const MeshVertex& v : mesh.vertices) {
    std::snprintf(line, sizeof line, "v %.6f %.6f %.6f\nvt %.4f %.4f\nvn %.4f %.4f %.4f\n",
                  double(v.position[0]), double(v.position[1]), double(v.position[2]), double(v.texcoord[0]),
                  double(v.texcoord[1]), double(v.normal[0]), double(v.normal[1]), double(v.normal[2]));
    text += line;
  }
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const unsigned a = mesh.indices[i] + 1, b = mesh.indices[i + 1] + 1, c = mesh.indices[i + 2] + 1;
    if (slashes)
      std::snprintf(line, sizeof line, "f %u/%u/%u %u/%u/%u %u/%u/%u\n", a, a, a, b, b, b, c, c, c);
    else
      std::snprintf(line, sizeof line, "f %u %u %u\n", a, b, c);
    text += line;
  }
  return text;
}

void obj_reading(benchmark::State& state, bool slashes) {
  const cli::SourceText text =
      cli::SourceText::from_string(obj_text(make_shell(256, 128), slashes), "shell.obj");
  uint64_t hash = 0;
  for (auto _ : state) {
    cli::RemarkList remarks;
    const cli::ObjModel model = cli::read_obj(text, 1, remarks);
    state.PauseTiming();
    hash = hash_of(model.positions.data(), model.positions.size() * sizeof(double));
    for (const cli::ObjChunk& chunk : model.chunks)
      hash = hash_of(chunk.corner_vertices.values.data(), chunk.corner_vertices.values.size() * 4, hash);
    state.ResumeTiming();
  }
  state.SetBytesProcessed(int64_t(state.iterations()) * int64_t(text.size()));
  print_hash(state, hash);
}

BENCHMARK_CAPTURE(resolve_rows, rgba, OSMESA_RGBA);
BENCHMARK_CAPTURE(resolve_rows, bgra, OSMESA_BGRA);
BENCHMARK_CAPTURE(read_pixels, rgba, GL_RGBA, GL_UNSIGNED_BYTE, 4);
BENCHMARK_CAPTURE(read_pixels, rgb, GL_RGB, GL_UNSIGNED_BYTE, 3);
BENCHMARK_CAPTURE(read_pixels, luminance_float, GL_LUMINANCE, GL_FLOAT, 4);
BENCHMARK_CAPTURE(read_pixels, depth, GL_DEPTH_COMPONENT, GL_FLOAT, 4);
BENCHMARK(clear);
BENCHMARK_CAPTURE(obj_reading, positions, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(obj_reading, all, true)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace softgl::bench

BENCHMARK_MAIN();
