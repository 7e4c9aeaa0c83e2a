// Reading pixels back from the surface, in GL's coordinates (y up).
#pragma once

#include <cstddef>
#include <cstdint>

#include "shaders/common/surface.h"

namespace softgl {

struct TexelFormat; // texture/texel_format.h

/// The row of the surface that GL's window coordinate y means.
inline int surface_row(const Surface& surface, int y) { return surface.y_up ? y : surface.height - 1 - y; }

/// Pixels (x .. x + count - 1, y) of the surface, y counts its rows, which all lie in it, in the surface's
/// format.
void copy_color_row(const Surface& surface, int x, int y, int count, void* row);
void copy_depth_stencil_row(const Surface& surface, int x, int y, int count, uint32_t* row);
/// The stencil values alone; the surface has some.
void copy_stencil_row(const Surface& surface, int x, int y, int count, uint32_t* row);

/// Colors of a row in the surface's format as bytes or as floats. Bits are repeated or rounded as
/// OSMesa 22.3.6 does. Luminance and intensity are red. sRGB stays what it is.
void color_row_to_bytes(const Surface& surface, const void* row, int count, uint8_t (*rgba)[4]);
void color_row_to_floats(const Surface& surface, const void* row, int count, float (*rgba)[4]);
/// The same of an sRGB surface, made linear.
void color_row_to_linear_floats(const Surface& surface, const void* row, int count, float (*rgba)[4]);
float depth_to_float(DepthFormat format, uint32_t word);
/// Of the words of a row.
void depths_to_floats(DepthFormat format, const uint32_t* word, int count, float* depth);
/// The words of depths of [0, 1]: the nearest integers, or the floats themselves.
void floats_to_depths(DepthFormat format, const float* depth, size_t count, uint32_t* word);

/// Colors that were read as a texture with the same texels gives them: luminance and intensity in all
/// components that they stand for. `texels`: RenderTarget::texels; null changes nothing.
void spread_colors(const TexelFormat* texels, uint8_t (*rgba)[4], size_t count);
void spread_colors(const TexelFormat* texels, float (*rgba)[4], size_t count);

/// Copies a rectangle (lower left corner x, y; bottom row first) as bytes; zeros outside.
void read_rgba8(const Surface& surface, int x, int y, int width, int height, uint8_t (*rgba)[4]);
/// The same as floats (not clamped if the surface is not), the depth as floats, and the stencil values.
void read_rgba_float(const Surface& surface, int x, int y, int width, int height, float (*rgba)[4]);
void read_depth_float(const Surface& surface, int x, int y, int width, int height, float* depth);
void read_stencil(const Surface& surface, int x, int y, int width, int height, uint8_t* stencil);

} // namespace softgl
