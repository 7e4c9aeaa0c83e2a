// The work that has been asked for and not yet done: draws and clears in order, and the memory they need.
#pragma once

#include <memory>
#include <vector>

#include "base/arena.h"
#include "base/pages.h"
#include "draw/clear_record.h"
#include "draw/draw_record.h"
#include "shaders/common/surface.h"
#include "surface/tile_reader.h"

namespace softgl {

class Frame {
public:
  Frame();
  ~Frame();
  /// Memory for everything that draws of this frame point to. Freed by flush().
  Arena& arena() { return arena_; }
  /// Keeps an object (buffer storage, texture image, display list run) of so many bytes alive and unchanged
  /// until the flush.
  void retain(std::shared_ptr<const void> object, size_t bytes) {
    retained_.push_back({std::move(object), bytes});
    retained_bytes_ += bytes;
  }
  /// Where memory and retained objects stand, and back there: forgets what was added since.
  struct Mark {
    Arena::Mark arena;
    size_t retained, retained_bytes;
  };
  Mark mark() const { return {arena_.mark(), retained_.size(), retained_bytes_}; }
  void rewind(const Mark& m) {
    arena_.rewind(m.arena);
    retained_.resize(m.retained);
    retained_bytes_ = m.retained_bytes;
  }
  /// Adds a draw or a clear behind all earlier ones. The record lies in arena().
  void append(const DrawRecord* draw);
  void append(const ClearRecord* clear) { items_.push_back({nullptr, clear}); }
  bool empty() const { return items_.empty(); }
  struct Item {
    const DrawRecord* draw;
    const ClearRecord* clear;
  }; // one of the two
  const std::vector<Item>& items() const { return items_; }
  /// True when so much memory is in use that the owner should flush before more work is added.
  bool over_budget() {
    return arena_.used() > kBudgetBytes ||
           (retained_bytes_ > next_count_ && abandoned_bytes() > kBudgetBytes);
  }
  /// Appends the memory that frames of some size will write first, to be brought in early.
  void prepare(std::vector<Pages>& pages);
  /// Does all work on `surface` with all threads and forgets it; snapshots taken from State must be taken
  /// anew after it (kDirtyAll). Same bytes for any number of threads. When memory ends it throws; the rest of
  /// the work is forgotten, too. `keep_memory`: only the draws and clears are forgotten; arena() and retained
  /// objects stay for draws to come.
  void flush(const Surface& surface, const TileReader* reader = nullptr, bool keep_memory = false);

private:
  static constexpr size_t kBudgetBytes = 256u << 20;
  friend class FrameWork;
  Arena arena_;
  struct Retained {
    std::shared_ptr<const void> object;
    size_t bytes;
  };
  std::vector<Retained> retained_;
  size_t retained_bytes_ = 0;        // an object counts as often as it was retained
  size_t next_count_ = kBudgetBytes; // retained_bytes_ at which the abandoned ones are counted
  /// The bytes of objects that only this frame still holds: textures and buffers that were deleted or
  /// specified anew.
  size_t abandoned_bytes();
  std::vector<Item> items_;
  uint32_t most_round_steps_;
  void forget_work();
  void make_workers(size_t bytes); // of scratch memory for each new one, at least
  struct Workers;                  // memory of the workers, kept from flush to flush
  std::unique_ptr<Workers> workers_;
  struct Plan; // of a flush; its memory is kept from flush to flush
  std::unique_ptr<Plan> plan_;
};

} // namespace softgl
