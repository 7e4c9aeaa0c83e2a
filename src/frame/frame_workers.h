// What each worker of a frame has for itself.
#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <vector>

#include "base/arena.h"
#include "base/pages.h"
#include "base/thread_pool.h"
#include "frame/frame.h"
#include "frame/tile_worker.h"
#include "raster/tile_binner.h"
#include "raster/tile_list.h"
#include "shaders/fragment/fragment_block.h"

namespace softgl {

struct Frame::Workers {
  /// Zeros at first, which the blocks rely on: fresh pages are, and nothing is written here before a worker
  /// needs it, for the thread that brings them in is another one.
  struct Scratch {
    BinnerScratch binner;
    FragmentBlock block;
    uint32_t no_colors[kNoColorWords]; // of surfaces without a color plane
  };
  struct Worker {
    Scratch* scratch;
    Arena arena;      // begins in what is left of the worker's memory
    Arena vertices{}; // of pieces
    TileLists lists{};
    explicit Worker(Pages memory) : scratch(new (memory.memory) Scratch) {
      static_assert(std::is_trivially_default_constructible_v<Scratch>);
      if (memory.bytes > sizeof(Scratch)) arena.begin_with({scratch + 1, memory.bytes - sizeof(Scratch)});
    }
    Worker(const Worker&) = delete;
  };
  std::unique_ptr<Worker> worker[kMaxWorkers];
  std::vector<Pages> memory; // theirs
  Worker& operator[](int i) { return *worker[i]; }

  Workers() = default;
  Workers(const Workers&) = delete;
  ~Workers() {
    for (const Pages& m : memory) unmap_pages(m.memory, m.bytes);
  }

  /// Makes workers up to `count`, the new ones with so much memory each, all of it in one piece.
  void make(int count, size_t bytes) {
    int first = 0;
    while (first < count && worker[first]) ++first;
    if (first == count) return;
    memory.reserve(memory.size() + 1);
    const Pages all = {map_pages(size_t(count - first) * bytes), size_t(count - first) * bytes};
    if (!all.memory) throw std::bad_alloc();
    memory.push_back(all);
    auto* next = static_cast<unsigned char*>(all.memory);
    for (int i = first; i < count; ++i, next += bytes)
      worker[i] = std::make_unique<Worker>(Pages{next, bytes});
  }
};

} // namespace softgl
