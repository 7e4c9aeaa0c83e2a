// Colors as a surface stores them, without the kernels: what glClear writes, and what is kept of an absent
// alpha.
#pragma once

#include <cstddef>

#include "shaders/common/surface.h"

namespace softgl {

/// Of a surface that keeps all that its format can hold, but for alpha.
ColorEncoding whole_encoding(ColorFormat format, bool has_alpha);

/// Sets alpha to 1 in memory of zeros, for surfaces without alpha. Rgba8 and Rgb565 need nothing.
void fill_alpha(ColorFormat format, const ColorEncoding& encoding, void* memory, size_t bytes);

/// The numbers that a color is stored as by glClear, integers as floats. OSMesa 22.3.6 clears a part of the
/// surface or of its components by drawing a rectangle (`drawn`), which rounds otherwise than storing: where
/// it clears all, halves go up but in 8 bits. `srgb`: red, green and blue become sRGB.
void store_clear_color(const Surface& surface, bool srgb, const float* rgba, bool drawn, float (&value)[4]);

/// Stores colors as if they were drawn; not sRGB, which is kept as it is. `pixels` have the format's size.
void store_drawn_colors(ColorFormat format, const ColorEncoding& encoding, const float (*rgba)[4], int count,
                        void* pixels);

} // namespace softgl
