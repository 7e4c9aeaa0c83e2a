// The one entry of this folder: per family of kernels a struct of function pointers, filled once per instruction set.
#pragma once

#include <stdint.h>

#include "fragment_block.h"
#include "shaded_vertex.h"
#include "surface.h"
#include "vertex_program.h"

namespace softgl {

struct TileJob;      // raster_tile.h
struct TriangleJob;  // raster_triangles.h

/// Eye space to shaded vertices (vertex_kernels.cpp).
struct VertexKernels {
  const char* isa;
  /// Vertices [first, first + count) to `out` (layout.slots each) and `mask`.
  void (*shade)(const VertexJob& job, uint32_t first, uint32_t count, ShadedVertices::Slot* out, uint16_t* mask);
};

/// Window space to pixels (raster_kernels.cpp).
struct RasterKernels {
  const char* isa;
};

/// Texture sampling and environment (texture_kernels.cpp).
struct TextureKernels {
  const char* isa;
};

} // namespace softgl
