#include "frame/frame.h"

#include <algorithm>
#include <new>
#include <optional>

#include "base/assert.h"
#include "base/fast_paths.h"
#include "base/float_environment.h"
#include "base/thread_pool.h"
#include "frame/frame_plan.h"
#include "frame/frame_trace.h"
#include "frame/frame_workers.h"
#include "frame/tile_worker.h"
#include "geometry/geometry.h"
#include "raster/raster_draws.h"
#include "raster/smooth_primitives.h"
#include "raster/tile_binner.h"
#include "shaders/fragment/fragment_program.h"

namespace softgl {

namespace {

// Work is cut by these constants only, never by the number of threads, so that bins and bits do not depend on
// it.
constexpr uint32_t kPortionSteps = 2048; // assembly steps (or vertices) of a portion
constexpr uint32_t kSmallDraw =
    1024; // draws of up to so many steps and vertices are shaded inside their portion
// Steps whose bins are in memory at the same time. The first frames have little memory, which takes longer to
// come than the waits for each other at the end of a round; later ones have it.
constexpr uint32_t kFirstRoundSteps = 1u << 14, kRoundSteps = 1u << 19;

/// True when steps read neighbouring vertices, each few times: then those of a piece are shaded with it,
/// which saves writing and reading all of them (262,144 immediate triangles: 67 MB instead of 103, 3 to 7 %
/// of the time).
bool reads_in_order(const DrawRecord& draw) {
  const DrawCall& call = draw.call;
  if (call.indices || draw.vertex->line_stipple) return false; // the stipple counts the lines in front
  return std::all_of(call.primitives, call.primitives + call.primitive_count, [&](const PrimitiveRange& p) {
    return assembly_steps(p) == 0 || elements_of_steps(draw, p, 0, 1).count > 0;
  });
}

} // namespace

/// One flush.
class FrameWork {
public:
  FrameWork(Frame& frame, const Surface& surface, const TileReader* reader)
      : frame_(frame), surface_(surface), reader_(reader),
        tiles_(size_t(surface.tiles_x) * size_t(surface.tiles_y)), head_(frame.plan_->head),
        tail_(frame.plan_->tail), busy_(frame.plan_->busy), vertices_(frame.plan_->vertices),
        pieces_(frame.plan_->pieces), portions_(frame.plan_->portions) {
    frame.plan_->begin(tiles_);
  }

  /// Does all of it; returns in how many rounds.
  int run() {
    const std::vector<Frame::Item>& items = frame_.items_;
    for (size_t i = 0; i < items.size(); ++i) {
      const Frame::Item& item = items[i];
      if (item.clear) {
        if (i + 1 < items.size() && items[i + 1].clear && clear_hides_clear(*items[i + 1].clear, *item.clear))
          continue;
        close_portion();
        portions_.push_back({});
        portions_.back().clear = item.clear;
        portions_.back().stencil_drawn = stencil_drawn_;
        portions_.back().samples_counted = samples_counted_;
        stencil_drawn_ = stencil_drawn_ || item.clear->stencil;
        open_steps_ = 0;
      } else {
        add_draw(*item.draw);
      }
    }
    finish_round(reader_);
    return rounds_;
  }

private:
  void close_portion() {
    if (pieces_.size() > portion_start_) {
      portions_.push_back({});
      portions_.back().first_piece = static_cast<uint32_t>(portion_start_);
      portions_.back().piece_count = static_cast<uint32_t>(pieces_.size() - portion_start_);
    }
    portion_start_ = pieces_.size();
    open_steps_ = 0;
  }

  void add_draw(const DrawRecord& draw) {
    const DrawCall& call = draw.call;
    uint64_t steps = draw.rectangle ? 1 : 0;
    for (uint32_t i = 0; i < call.primitive_count; ++i) steps += assembly_steps(call.primitives[i]);
    if (steps == 0 || (call.vertex_count == 0 && !draw.rectangle)) return;
    stencil_drawn_ = stencil_drawn_ || draw.fragment->key.stencil ||
                     (draw.back_fragment && draw.back_fragment->key.stencil);
    samples_counted_ = samples_counted_ || draw.samples;
    const RasterDraw* raster = shared_raster_draw(draw);
    if (steps <= kSmallDraw && call.vertex_count <= kSmallDraw) {
      const bool before = !draw.rectangle && !takes(FastPath::OrderedVertices);
      pieces_.push_back({&draw, raster, before ? vertices_.add(draw, frame_.arena_) : nullptr, 0, 0, 0});
      count_steps(static_cast<uint32_t>(std::max<uint64_t>(steps, call.vertex_count)));
      return;
    }
    close_portion();
    const bool in_order = reads_in_order(draw) && takes(FastPath::OrderedVertices);
    const ShadedVertices* vertices = in_order ? nullptr : vertices_.add(draw, frame_.arena_);
    for (uint32_t i = 0; i < call.primitive_count; ++i) {
      const uint32_t count = assembly_steps(call.primitives[i]);
      for (uint32_t first = 0; first < count;) {
        const uint32_t part = std::min(kPortionSteps - open_steps_, count - first);
        pieces_.push_back({&draw, raster, vertices, i, first, part});
        first += part;
        count_steps(part);
      }
    }
    close_portion();
  }

  /// Draws that come to the same share one: 10,000 small draws with a matrix of their own take 8 % less time
  /// of one thread.
  const RasterDraw* shared_raster_draw(const DrawRecord& draw) {
    if (!latest_ || !have_same_raster_draw(*latest_, draw)) latest_raster_ = raster_draw(draw);
    latest_ = &draw;
    return latest_raster_;
  }

  const RasterDraw* raster_draw(const DrawRecord& draw) {
    auto* raster = frame_.arena_.make<RasterDraw>(make_raster_draw(draw));
    if (draw.smooth) add_smooth_draws(draw, *raster, frame_.arena_);
    if (draw.back_fragment) {
      DrawRecord back = draw;
      back.fragment = draw.back_fragment, back.smooth = draw.back_smooth, back.back_fragment = nullptr;
      raster->back_face = raster_draw(back);
    }
    return raster;
  }

  void count_steps(uint32_t steps) {
    open_steps_ += steps;
    round_steps_ += steps;
    if (open_steps_ >= kPortionSteps) close_portion();
    if (round_steps_ >= frame_.most_round_steps_ && takes(FastPath::Rounds)) finish_round();
  }

  /// Does everything planned so far and forgets it.
  void finish_round(const TileReader* reader = nullptr) {
    close_portion();
    if (portions_.empty() && !reader) return;
    ++rounds_;
    ThreadPool& pool = ThreadPool::instance();
    for (int i = 0; i < pool.workers(); ++i) {
      (*frame_.workers_)[i].arena.reset();
      (*frame_.workers_)[i].vertices.reset();
    }
    vertices_.shade();
    pool.run(portions_.size(),
             [this](size_t i, int worker) { bin(portions_[i], (*frame_.workers_)[worker]); });
    join();
    auto execute = [this](uint32_t tile, int worker) {
      if (!head_[tile]) return;
      Frame::Workers::Scratch& scratch = *(*frame_.workers_)[worker].scratch;
      execute_tile(surface_, tile, head_[tile], *kernels().raster, scratch.block, scratch.no_colors);
      head_[tile] = nullptr;
    };
    // In the order of the surface: so a worker mostly has the tiles of the frame before in its cache.
    if (reader) {
      pool.run(tiles_, [&](size_t tile, int worker) {
        execute(uint32_t(tile), worker);
        reader->read(uint32_t(tile)); // while it is in the cache
      });
    } else {
      std::sort(busy_.begin(), busy_.end());
      pool.run(busy_.size(), [&](size_t i, int worker) { execute(busy_[i], worker); });
    }
    portions_.clear();
    pieces_.clear();
    busy_.clear();
    portion_start_ = 0;
    round_steps_ = open_steps_ = 0;
  }

  static const ShadedVertices* shade_piece(const Piece& piece, Arena& arena) {
    const DrawCall& call = piece.draw->call;
    uint32_t first = call.first_vertex, count = call.vertex_count;
    if (piece.count) {
      const PrimitiveRange& range = call.primitives[piece.primitive];
      const ElementRange elements = elements_of_steps(*piece.draw, range, piece.first, piece.count);
      SOFTGL_ASSERT(elements.count && uint64_t(elements.first) + elements.count <= range.count);
      first = range.first + elements.first, count = elements.count;
    }
    return shade_vertices_of_piece(*piece.draw, first, count, arena);
  }

  static void assemble_piece(const Piece& piece, const ShadedVertices& vertices, Arena& arena,
                             PrimitiveSink& sink) {
    const DrawCall& call = piece.draw->call;
    if (piece.count)
      return assemble(*piece.draw, vertices, call.primitives[piece.primitive], piece.first, piece.count,
                      arena, sink);
    for (uint32_t k = 0; k < call.primitive_count; ++k)
      assemble(*piece.draw, vertices, call.primitives[k], 0, assembly_steps(call.primitives[k]), arena, sink);
  }

  void bin(Portion& portion, Frame::Workers::Worker& worker) {
    if (portion.clear) return;
    worker.lists.begin(tiles_, worker.arena);
    TileBinner binner(surface_, worker.lists, worker.arena, worker.scratch->binner);
    for (uint32_t i = 0; i < portion.piece_count; ++i) {
      const Piece& piece = pieces_[portion.first_piece + i];
      binner.set_draw(piece.raster, !piece.vertices);
      if (piece.draw->rectangle) {
        binner.rectangle(*piece.draw->rectangle);
        continue;
      }
      const Arena::Mark mark = worker.vertices.mark();
      const ShadedVertices* vertices = piece.vertices ? piece.vertices : shade_piece(piece, worker.vertices);
      if (!vertices->clipped) assemble_piece(piece, *vertices, worker.arena, binner);
      if (!binner.keeps_vertices()) worker.vertices.rewind(mark); // the next piece's stay in the cache
    }
    const auto& touched = worker.lists.finish();
    auto* copy = worker.arena.allocate_array<TileLists::Touched>(touched.size());
    std::copy(touched.begin(), touched.end(), copy);
    portion.touched = copy;
    portion.touched_count = static_cast<uint32_t>(touched.size());
  }

  /// Links the portions' lists of each tile in the order of the portions.
  void join() {
    [[maybe_unused]] uint32_t piece = 0;
    for (const Portion& portion : portions_) {
      SOFTGL_ASSERT(portion.clear || portion.first_piece == piece);
      piece += portion.piece_count;
      if (portion.clear) {
        join_clear(portion);
        continue;
      }
      for (uint32_t i = 0; i < portion.touched_count; ++i)
        link(portion.touched[i].tile, portion.touched[i].first, portion.touched[i].last);
    }
  }

  void link(uint32_t tile, TileChunk* first, TileChunk* last) {
    SOFTGL_ASSERT(tile < tiles_ && first && last && !last->next);
    if (head_[tile])
      tail_[tile]->next = first;
    else
      head_[tile] = first, busy_.push_back(tile);
    tail_[tile] = last;
  }

  void join_clear(const Portion& portion) {
    const ClearRecord& c = *portion.clear;
    if (c.x0 >= c.x1 || c.y0 >= c.y1) return;
    SOFTGL_ASSERT(c.x0 >= 0 && c.y0 >= 0 && c.x1 <= surface_.width && c.y1 <= surface_.height);
    for (int32_t ty = c.y0 >> 6; ty <= (c.y1 - 1) >> 6; ++ty)
      for (int32_t tx = c.x0 >> 6; tx <= (c.x1 - 1) >> 6; ++tx) {
        const auto tile = static_cast<uint32_t>(ty * surface_.tiles_x + tx);
        auto* chunk =
            static_cast<TileChunk*>(frame_.arena_.allocate(sizeof(TileChunk) + sizeof(TileSegment)));
        *chunk = {nullptr, sizeof(TileSegment), 0};
        auto* segment = new (chunk + 1) TileSegment;
        segment->kind = TileSegment::Clear;
        segment->capacity = 0;
        segment->count = 0;
        segment->clear = &c;
        if (head_[tile] && !portion.samples_counted &&
            clear_hides_all(c, surface_, tile, portion.stencil_drawn)) {
          head_[tile] = tail_[tile] = chunk; // earlier work of the tile cannot be seen
          continue;
        }
        link(tile, chunk, chunk);
      }
  }

  Frame& frame_;
  const Surface& surface_;
  const TileReader* reader_;
  const size_t tiles_;
  std::vector<TileChunk*>&head_, &tail_;
  std::vector<uint32_t>& busy_;
  PlannedVertices& vertices_;
  std::vector<Piece>& pieces_;
  std::vector<Portion>& portions_;
  const DrawRecord* latest_ = nullptr; // whose RasterDraw is
  const RasterDraw* latest_raster_ = nullptr;
  size_t portion_start_ = 0;
  uint32_t open_steps_ = 0, round_steps_ = 0;
  bool stencil_drawn_ = false, samples_counted_ = false;
  int rounds_ = 0;
};

Frame::Frame() : most_round_steps_(kFirstRoundSteps), plan_(std::make_unique<Plan>()) {}
Frame::~Frame() = default;

void Frame::append(const DrawRecord* draw) {
  SOFTGL_ASSERT(draw->raster && draw->fragment && draw->layout.slots >= 1);
  SOFTGL_ASSERT(draw->rectangle ? draw->call.primitive_count == 0 : draw->vertex != nullptr);
  if (tracing) [[unlikely]]
    trace_draw(*draw);
  items_.push_back({draw, nullptr});
}

void Frame::prepare(std::vector<Pages>& pages) {
  // 70,000 triangles of a mesh make 1.2 MB of vertices, and in lists, where each takes 32 bytes for every
  // tile it touches, 0.8 MB for each of two workers in the first frame's rounds. More would be made zero for
  // nothing.
  static_assert(sizeof(Workers::Scratch) < kHugePage / 8);
  make_workers(kHugePage / 2);
  const Pages& memory = workers_->memory.front();
  pages.push_back({memory.memory, std::min(memory.bytes, 2 * kHugePage)});
  const Pages block = arena_.prepare();
  pages.push_back({block.memory, std::min(block.bytes, kHugePage)});
}

void Frame::make_workers(size_t bytes) {
  if (!workers_) workers_ = std::make_unique<Workers>();
  // No allocation inside the workers.
  workers_->make(ThreadPool::instance().workers(),
                 std::max(bytes, (sizeof(Workers::Scratch) + 63) & ~size_t(63)));
}

void Frame::flush(const Surface& surface, const TileReader* reader, bool keep_memory) try {
  if (!items_.empty() && surface.tiles_x > 0 && surface.tiles_y > 0) {
    SOFTGL_ASSERT(surface.tiles_x == (surface.width + kTileSize - 1) / kTileSize &&
                  surface.tiles_y == (surface.height + kTileSize - 1) / kTileSize);
    const FloatEnvironment environment;
    make_workers(0);
    std::optional<FlushTrace> trace;
    if (tracing) trace.emplace(items_, surface.name);
    const int rounds = FrameWork(*this, surface, reader).run();
    if (trace) trace->end(arena_.used(), rounds, ThreadPool::instance().workers());
    most_round_steps_ = std::min(2 * most_round_steps_, kRoundSteps);
  }
  if (keep_memory)
    items_.clear();
  else
    forget_work();
} catch (...) {
  // Tried again it would fail again: it is dropped, and the memory goes back to those who need it.
  forget_work();
  arena_.release();
  plan_->release();
  workers_.reset();
  throw;
}

void Frame::forget_work() {
  items_.clear();
  retained_.clear();
  retained_bytes_ = 0;
  next_count_ = kBudgetBytes;
  arena_.reset();
}

size_t Frame::abandoned_bytes() {
  std::sort(retained_.begin(), retained_.end(),
            [](const Retained& a, const Retained& b) { return a.object < b.object; });
  retained_.erase(std::unique(retained_.begin(), retained_.end(),
                              [](const Retained& a, const Retained& b) { return a.object == b.object; }),
                  retained_.end());
  size_t abandoned = 0, kept = 0;
  for (const Retained& r : retained_) (r.object.use_count() == 1 ? abandoned : kept) += r.bytes;
  retained_bytes_ = abandoned + kept;
  next_count_ = retained_bytes_ + kBudgetBytes;
  return abandoned;
}

} // namespace softgl
