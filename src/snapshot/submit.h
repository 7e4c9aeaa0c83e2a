// The way of a draw into the frame.
#pragma once

#include "draw/draw_call.h"
#include "shaders/common/surface.h"

namespace softgl {

struct Context;
struct PixelImage; // shaders/fragment/pixel_image.h

/// Draws with the context's present state. May flush the frame when its
/// memory is over budget, so pointers into the frame's arena are dead after the call.
void submit(Context& context, const DrawCall& call);

/// Whether the first vertex of a primitive gives it its color (GL_EXT_provoking_vertex).
bool first_provokes(const Context& context);

/// Draws a rectangle of pixels whose fragments have the raster position's attributes, but for what the image
/// gives them. The image lies in the frame's arena. May flush the frame as submit() does.
void submit_pixels(Context& context, const PixelImage& image, const WindowBox& box);
constexpr unsigned kAllSamples = (1u << kSamples) - 1;
/// Stores stencil values under the mask. `samples`: bit s is set for sample s.
void submit_stencils(Context& context, const PixelImage& image, const WindowBox& box, uint32_t write_mask,
                     unsigned samples = kAllSamples);
/// Stores colors, or depths, whatever the tests and masks are but for the scissor test.
void submit_copy(Context& context, const PixelImage& image, const WindowBox& box,
                 unsigned samples = kAllSamples);

} // namespace softgl
