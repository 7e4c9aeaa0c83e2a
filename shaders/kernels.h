// The one entry of this folder: per family of kernels a struct of function pointers, filled once per instruction set.
#pragma once

#include <stdint.h>

#include "fragment_block.h"
#include "shaded_vertex.h"
#include "surface.h"

namespace softgl {

struct TileJob;      // raster_tile.h
struct TriangleJob;  // raster_triangles.h

/// Eye space to shaded vertices (vertex_kernels.cpp).
struct VertexKernels {
  const char* isa;
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
