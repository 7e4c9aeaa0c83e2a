// What the stage benchmarks share: a context to record draws in, and hashes of what a stage has computed.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include "base/thread_pool.h"
#include "context/context.h"
#include "frames/mesh.h"

namespace softgl::bench {

inline uint64_t hash_of(const void* data, size_t bytes, uint64_t h = 0xcbf29ce484222325u) {
  const auto* p = static_cast<const uint8_t*>(data);
  for (size_t i = 0; i < bytes; i++) h = (h ^ p[i]) * 0x100000001b3u;
  return h;
}

/// Prints the hash at the end of the benchmark's line.
inline void print_hash(benchmark::State& state, uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  state.SetLabel(text);
}

/// Time per piece of work as a counter called `name`.
inline void count_work(benchmark::State& state, const char* name, double pieces) {
  state.counters[name] =
      benchmark::Counter(pieces, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// A current context with a picture of its own, drawn by one thread: stages are measured without their
/// neighbours.
class Canvas {
public:
  explicit Canvas(int size) : pixels(size_t(size) * size_t(size)), size(size) {
    context_ = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
    OSMesaMakeCurrent(context_, pixels.data(), GL_UNSIGNED_BYTE, size, size);
    threads_ = ThreadPool::instance().workers();
    ThreadPool::instance().set_workers(1);
  }
  ~Canvas() {
    ThreadPool::instance().set_workers(threads_);
    OSMesaDestroyContext(context_);
  }
  uint64_t picture_hash() {
    glFinish();
    return hash_of(pixels.data(), pixels.size() * 4);
  }
  std::vector<uint32_t> pixels;
  const int size;

private:
  OSMesaContext context_;
  int threads_;
};

/// The arrays of a mesh, and a camera that sees all of it.
inline void set_mesh(const Mesh& mesh) {
  const char* base = reinterpret_cast<const char*>(mesh.vertices.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glVertexPointer(3, GL_FLOAT, sizeof(MeshVertex), base);
  glNormalPointer(GL_FLOAT, sizeof(MeshVertex), base + offsetof(MeshVertex, normal));
  glMatrixMode(GL_PROJECTION);
  glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 10);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0, 0, -3);
  glRotatef(25, 0.3f, 1, 0.1f);
  glEnable(GL_DEPTH_TEST);
}

/// The draw that was recorded last and waits in the current context's frame.
inline const DrawRecord& recorded_draw() { return *current_context->frame.items().back().draw; }

/// Memory for the shaded vertices of a draw.
struct ShadedMemory {
  std::vector<ShadedVertices::Slot> slots;
  std::vector<uint16_t> masks;
  ShadedVertices vertices;
  explicit ShadedMemory(const DrawRecord& draw) {
    const size_t rounded = (size_t(draw.call.vertex_count) + 63) & ~size_t(63);
    slots.resize(rounded * draw.layout.slots + 4);
    masks.resize(rounded + 32);
    vertices = {slots.data(), masks.data(), draw.call.first_vertex, draw.call.vertex_count};
  }
  uint64_t hash(const DrawRecord& draw) const {
    const size_t count = draw.call.vertex_count;
    return hash_of(masks.data(), count * 2,
                   hash_of(slots.data(), count * draw.layout.slots * sizeof(ShadedVertices::Slot)));
  }
};

} // namespace softgl::bench
