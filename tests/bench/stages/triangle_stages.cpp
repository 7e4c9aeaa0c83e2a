// From shaded vertices to tile lists, and from tile lists to pixels.
#include <cstring>

#include "base/float_environment.h"
#include "frame/tile_worker.h"
#include "geometry/geometry.h"
#include "harness.h"
#include "raster/raster_draws.h"
#include "raster/tile_binner.h"

namespace softgl::bench {
namespace {

/// Takes triangles and remembers a hash of them.
class Hasher final : public PrimitiveSink {
public:
  void triangles(const DrawRecord&, const AssembledTriangles& batch) override {
    for (int i = 0; i < batch.count; i++) // the window positions of all corners
      for (const auto& corner : batch.corner) hash = hash_of(corner[i], 16, hash);
  }
  void lines(const DrawRecord&, const AssembledLines&) override {}
  void points(const DrawRecord&, const AssembledPoints&) override {}
  uint64_t hash = 0;
};
/// Takes triangles and drops them.
class Drop final : public PrimitiveSink {
public:
  void triangles(const DrawRecord&, const AssembledTriangles& batch) override {
    count += uint64_t(batch.count);
  }
  void lines(const DrawRecord&, const AssembledLines&) override {}
  void points(const DrawRecord&, const AssembledPoints&) override {}
  uint64_t count = 0;
};

/// A mesh whose vertices are shaded and whose triangles are still to be assembled.
struct ShadedMesh {
  Canvas canvas;
  Mesh mesh;
  std::unique_ptr<ShadedMemory> memory;
  const DrawRecord* draw;
  const PrimitiveRange* range;
  uint32_t steps;
  Arena arena;
  ShadedMesh(int picture, int cells, float near = 1) : canvas(picture), mesh(make_shell(cells * 2, cells)) {
    set_mesh(mesh);
    if (near != 1) { // cuts through the mesh
      glMatrixMode(GL_PROJECTION);
      glLoadIdentity();
      glFrustum(-0.5, 0.5, -0.5, 0.5, near, 10);
    }
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_CULL_FACE);
    glDrawElements(GL_TRIANGLES, GLsizei(mesh.indices.size()), GL_UNSIGNED_INT, mesh.indices.data());
    draw = &recorded_draw();
    memory = std::make_unique<ShadedMemory>(*draw);
    shade_vertices(*draw, draw->call.first_vertex, draw->call.vertex_count, memory->vertices);
    range = draw->call.primitives;
    steps = assembly_steps(*range);
  }
  void assemble_into(PrimitiveSink& sink) {
    assemble(*draw, memory->vertices, *range, 0, steps, arena, sink);
  }
};

void assembly(benchmark::State& state, float near) {
  const FloatEnvironment environment;
  ShadedMesh scene(512, 128, near);
  Hasher hasher;
  scene.assemble_into(hasher);
  Drop drop;
  for (auto _ : state) {
    scene.arena.reset();
    scene.assemble_into(drop);
  }
  benchmark::DoNotOptimize(drop.count);
  count_work(state, "triangle", scene.steps);
  print_hash(state, hasher.hash);
}

/// Assembly, set-up, binning and, for small triangles, the shading of their fragments.
struct Binning {
  std::unique_ptr<BinnerScratch> scratch = std::make_unique<BinnerScratch>();
  TileLists lists;
  RasterDraw raster;
  const std::vector<TileLists::Touched>& run(ShadedMesh& scene, const Surface& surface) {
    raster = make_raster_draw(*scene.draw);
    scene.arena.reset();
    lists.begin(size_t(surface.tiles_x) * size_t(surface.tiles_y), scene.arena);
    TileBinner binner(surface, lists, scene.arena, *scratch);
    binner.set_draw(&raster);
    scene.assemble_into(binner);
    return lists.finish();
  }
};

/// Works tile lists off. The hash is of the picture: which list a triangle stands in depends on the
/// instruction set.
class Execution {
public:
  explicit Execution(const std::vector<TileLists::Touched>& touched) : touched_(touched) {
    std::memset(surface_.color, 0, pixels_ * 4); // of tiles that stay untouched: what memory held before
    run(); // opens the tiles, which sets their depths: drawn once only, nothing would be in front of those
  }
  void clear_depths() { std::fill_n(surface_.depth_stencil, pixels_, 0xffffffu); }
  void run() {
    for (const auto& t : touched_)
      execute_tile(surface_, t.tile, t.first, *kernels().raster, *block_, nullptr);
  }
  uint64_t hash() const {
    return hash_of(surface_.color, pixels_ * 4, hash_of(surface_.depth_stencil, pixels_ * 4));
  }

private:
  const std::vector<TileLists::Touched>& touched_;
  const Surface surface_ = current_context->framebuffer.surface;
  const size_t pixels_ = size_t(surface_.tiles_x) * size_t(surface_.tiles_y) * kTilePixels;
  std::unique_ptr<FragmentBlock> block_ = std::make_unique<FragmentBlock>();
};

void binning(benchmark::State& state) {
  const FloatEnvironment environment;
  ShadedMesh scene(512, int(state.range(0)));
  const Surface surface = current_context->framebuffer.surface;
  Binning bins;
  for (auto _ : state) bins.run(scene, surface);
  Execution execution(bins.run(scene, surface));
  execution.clear_depths();
  execution.run();
  count_work(state, "triangle", scene.steps);
  print_hash(state, execution.hash());
}

/// The tile lists of the same meshes, worked off.
void tiles(benchmark::State& state) {
  const FloatEnvironment environment;
  ShadedMesh scene(512, int(state.range(0)));
  Binning bins;
  Execution execution(bins.run(scene, current_context->framebuffer.surface));
  for (auto _ : state) {
    state.PauseTiming();
    execution.clear_depths();
    state.ResumeTiming();
    execution.run();
  }
  count_work(state, "triangle", scene.steps);
  print_hash(state, execution.hash());
}

BENCHMARK_CAPTURE(assembly, unclipped, 1.0f)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(assembly, clipped, 2.6f)->Unit(benchmark::kMicrosecond);
// 256 x 512 cells: a quarter of a million triangles of about a pixel; 8 x 16: large ones.
BENCHMARK(binning)->Arg(256)->Arg(64)->Arg(8)->Unit(benchmark::kMicrosecond);
BENCHMARK(tiles)->Arg(256)->Arg(64)->Arg(8)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace softgl::bench
