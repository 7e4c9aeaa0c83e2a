#include "base/fast_paths.h"

#include <cstdio>
#include <cstdlib>
#include <iterator>

namespace softgl {
namespace {

// In the order of FastPath: the fast way; what is done without it.
constexpr const char* kNames[] = {
    // Batches of triangles of a few pixels become fragments at once; else small triangles in tiles.
    "tiny",
    // Triangles up to 48x48 pixels (small_box()) are shaded side by side; else set up one by one, as large
    // ones.
    "small",
    // Small primitives of programs that look at 2x2 quads are packed by quads; else cut into strips.
    "quads",
    // The fragments of a tiny triangle share its planes; else planes for each fragment.
    "shared_planes",
    // Points of a few pixels become fragments at once; else they are set up as boxes.
    "points",
    // Thin lines become fragments at once; else they are set up with four edges.
    "lines",
    // The set bits of a bitmap become fragments at once; else its rectangle's fragments look for their bits.
    "bitmaps",
    // Blocks without stages go straight to the tile; else through a fragment block.
    "direct",
    // No edge is looked at in blocks inside a triangle; else at every pixel.
    "whole_blocks",
    // Alpha is not interpolated where it is 1 at all vertices.
    "opaque_colors",
    // Depth is tested before stages run; else after them alone.
    "early_depth",
    // Where no stage drops fragments, depth is written then, too; else it is tested again when colors are.
    "final_depth",
    // Fragments in shadow whose alpha becomes 0 are dropped before texturing ends; else by the alpha test.
    "early_alpha",
    // Finished fragments compare whole words of depth and stencil; else they are merged.
    "depth_words",
    // A clear of a whole tile waits for a reader; else it is written at once.
    "waiting_clears",
    // A clear drops a tile's earlier work of the frame that it hides; else that is drawn.
    "hiding_clears",
    // Vertices are shaded with the portion of the frame that reads them; else all before.
    "ordered_vertices",
    // Vertices that one plane clips, all of a draw or a portion, are not shaded.
    "clipped_draws",
    // Where no triangle is shaded as a small one, those of few pixels that cover none are not set up.
    "uncovered_triangles",
    // Long frames are cut into rounds; else the lists of all their draws are made first.
    "rounds",
    // A tile is copied to the caller's buffer when it is drawn; else after all have been.
    "early_copies",
    // Equal vertices of a list played twice are joined; else all are shaded.
    "joined_vertices",
    // A buffer remembers ranges of its indices; else they are found for each draw.
    "cached_ranges",
    // Of scattered indices only the vertices named are kept; else all of their range.
    "compact_vertices",
    // What is known of the arrays serves the next draw; else it is found for each draw.
    "kept_arrays",
    // Snapshots of the state serve the next draw; else all are made for each draw.
    "kept_snapshots",
    // Programs of texture environments are kept; else made for each snapshot.
    "kept_combiners",
    // MODULATE is done where texels are sampled; else by a stage of its own.
    "fused_textures",
    // glReadPixels copies rows of bytes as they are; else they are converted.
    "copied_rows",
    // Memory of the first frame is brought in when a context becomes current.
    "early_pages",
    // The system is asked for huge pages.
    "huge_pages",
};
static_assert(std::size(kNames) == static_cast<size_t>(FastPath::Count));

uint32_t read_environment() {
  const char* disabled = std::getenv("SOFTGL_DISABLE");
  if (!disabled) return kAllFastPaths;
  std::string unknown;
  const uint32_t enabled = enabled_by(disabled, unknown);
  if (!unknown.empty())
    std::fprintf(stderr, "softgl: SOFTGL_DISABLE has no fast path \"%s\": there are all,%s\n",
                 unknown.c_str(), to_names(kAllFastPaths).c_str());
  return enabled;
}

} // namespace

std::string to_names(uint32_t paths) {
  std::string names;
  for (size_t i = 0; i < std::size(kNames); ++i)
    if (paths >> i & 1) names.append(names.empty() ? "" : ",").append(kNames[i]);
  return names;
}

uint32_t enabled_by(std::string_view disabled, std::string& unknown) {
  uint32_t enabled = kAllFastPaths;
  while (!disabled.empty()) {
    const size_t comma = disabled.find(',');
    const std::string_view name = disabled.substr(0, comma);
    disabled.remove_prefix(comma == disabled.npos ? disabled.size() : comma + 1);
    uint32_t named = name == "all" ? kAllFastPaths : 0;
    for (size_t i = 0; i < std::size(kNames); ++i)
      if (name == kNames[i]) named = 1u << i;
    if (!named && !name.empty() && unknown.empty()) unknown = name;
    enabled &= ~named;
  }
  return enabled;
}

uint32_t enabled_fast_paths = read_environment();
std::atomic<uint32_t> taken_fast_paths{0};

} // namespace softgl
