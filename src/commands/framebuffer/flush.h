// Flush, Finish (GL 1.5, 5.5) and what else asks for the picture.
#pragma once

namespace softgl {

struct Context;

/// Finishes everything asked for so far, so that the surface holds the picture (not yet the caller's buffer).
void flush_rendering(Context& context);
/// Finishes everything, too, but what the planes need not be told yet stays untold (TileWords): before other
/// images are drawn to.
void draw_what_waits(Context& context);
/// Finishes everything and makes Context::read the surface that is read from. False where it is not complete.
bool flush_for_reading(Context& context);
/// Finishes all rendering and brings the caller's buffer up to date if something was drawn since the last
/// time.
void finish_and_resolve(Context& context);
/// To be called when the planes are new: has the memory of the first frame brought in while the caller
/// prepares it.
void prepare_first_frame(Context& context) noexcept;

} // namespace softgl
