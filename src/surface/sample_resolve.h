// From the samples of a pixel to one color.
#pragma once

#include <cstddef>
#include <cstdint>

#include "shaders/common/surface.h"

namespace softgl {

/// Means of the samples of pixels (x .. x + count - 1, y) of the surface, y counts its rows, which all lie in
/// it: added as floats, in their order, as OSMesa 22.3.6 does. `row` (16 bytes a pixel) and `sample` are
/// scratch memory. `linear`: the numbers are bytes of sRGB, and are made linear first.
void average_samples(const Surface& surface, int x, int y, int count, bool linear, unsigned char* row,
                     float (*sample)[4], float (*pixels)[4]);

/// The same of a rectangle of a surface of bytes, as the bytes that are drawn of the means; `row`: pixels
/// from one row of `bytes` to the next one.
void average_bytes(const Surface& surface, int x, int y, int width, int height, uint8_t (*bytes)[4],
                   size_t row);

/// Sets the pixels of a tile of `to`, which has one sample a pixel, from those of `from`: colors are
/// averaged, depths and stencil values are those of the first sample. Nothing of the tiles may wait to be
/// written.
void resolve_samples(const Surface& from, const Surface& to, uint32_t tile);

} // namespace softgl
