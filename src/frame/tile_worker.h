// Executes one tile's list.
#pragma once

#include "base/kernel_table.h"
#include "raster/tile_list.h"
#include "shaders/common/surface.h"

namespace softgl {

/// Words for the colors of a surface without a color plane: of all samples of a tile.
constexpr int kNoColorWords = kTilePixels * kSamples;

/// Does all work of a chain of chunks on tile number `tile`, in order. `scratch` belongs to the worker, and
/// so does `no_colors`, kNoColorWords of them: kernels always write colors.
void execute_tile(const Surface& surface, uint32_t tile, const TileChunk* work, const RasterKernels& kernels,
                  FragmentBlock& scratch, uint32_t* no_colors);

/// Writes the words that wait (TileWords) to the planes of a tile.
void write_tile(const Surface& surface, uint32_t tile);

/// True when a clear overwrites all that earlier work of the tile can have written. `stencil_drawn`: that
/// work may have written stencil values.
bool clear_hides_all(const ClearRecord& clear, const Surface& surface, uint32_t tile, bool stencil_drawn);
/// True when a clear writes all that the clear right before it has written.
bool clear_hides_clear(const ClearRecord& clear, const ClearRecord& before);

} // namespace softgl
