// The ways that are faster than the general one and draw the same bytes. SOFTGL_DISABLE=name,name,...
// switches them off, "all" all of them: where a picture changes by that, the path has a fault.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

namespace softgl {

enum class FastPath : uint32_t {
  Tiny,
  Small,
  Quads,
  SharedPlanes,
  Points,
  Lines,
  Bitmaps,
  Direct,
  WholeBlocks,
  OpaqueColors,
  EarlyDepth,
  FinalDepth,
  EarlyAlpha,
  DepthWords,
  WaitingClears,
  HidingClears,
  OrderedVertices,
  ClippedDraws,
  UncoveredTriangles,
  Rounds,
  EarlyCopies,
  JoinedVertices,
  CachedRanges,
  CompactVertices,
  KeptArrays,
  KeptSnapshots,
  KeptCombiners,
  FusedTextures,
  CopiedRows,
  EarlyPages,
  HugePages,
  Count
};

constexpr uint32_t bit_of(FastPath path) { return 1u << static_cast<uint32_t>(path); }
constexpr uint32_t kAllFastPaths = bit_of(FastPath::Count) - 1;

/// Bit by bit what SOFTGL_DISABLE leaves on. Written when the library is loaded, and by tests.
extern uint32_t enabled_fast_paths;
/// The paths that were taken since somebody made this zero.
extern std::atomic<uint32_t> taken_fast_paths;

inline bool is_enabled(FastPath path) { return (enabled_fast_paths & bit_of(path)) != 0; }

inline void count_as_taken(FastPath path) {
  if (!(taken_fast_paths.load(std::memory_order_relaxed) & bit_of(path)))
    taken_fast_paths.fetch_or(bit_of(path), std::memory_order_relaxed);
}

/// To be asked where a path fits. True if it is on; then it counts as taken. Costs two tests: to be asked for
/// a draw or a batch, not for a vertex or a pixel.
inline bool takes(FastPath path) {
  if (!is_enabled(path)) return false;
  count_as_taken(path);
  return true;
}

/// Names, parted by commas, of the paths whose bits are set.
std::string to_names(uint32_t paths);
/// The bits of the paths that a list of names leaves on. `unknown`: the first name that is none.
uint32_t enabled_by(std::string_view disabled, std::string& unknown);

} // namespace softgl
