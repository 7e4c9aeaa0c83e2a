// From State to the fragment program of a draw.
#pragma once

#include "base/arena.h"
#include "shaders/fragment/fragment_program.h"

namespace softgl {

struct Context;
struct PixelImage; // pixel_image.h
struct State;      // context/state.h

/// The program that the context's state asks for, in `arena`. `key` tells which inputs the vertices must
/// carry: secondary color, fog coordinate and the texture coordinates of the units in texture_units.
/// `image`: of a pixel rectangle, whose fragments have been lit.
const FragmentProgram* make_fragment_program(Context& context, Arena& arena,
                                             const PixelImage* image = nullptr);
/// What depths are clamped to, in the depth buffer's integers (GL_ARB_depth_clamp); where they are not: all.
struct DepthLimits {
  uint32_t least, greatest;
};
DepthLimits depth_limits(const Context& context);
/// The program of back-facing polygons where their stencil test is another one than that of `front`; else
/// null.
const FragmentProgram* make_back_program(const Context& context, const FragmentProgram& front, Arena& arena);
/// The programs of antialiased primitives (GL 1.5, 3.11) beside that of others; null where none is
/// antialiased.
const SmoothPrograms* make_smooth_programs(const Context& context, const FragmentProgram& program,
                                           Arena& arena);
/// Stores an image's stencil values under the mask, whatever the tests are (GL 1.5, 3.6.4, 4.3.3).
const FragmentProgram* make_stencil_program(Context& context, Arena& arena, const PixelImage& image,
                                            uint32_t write_mask);
/// Stores an image's colors, or depths, whatever the tests and masks are.
const FragmentProgram* make_copy_program(Context& context, Arena& arena, const PixelImage& image);

} // namespace softgl
