// The end of a frame.
#pragma once

#include "surface/tile_reader.h"

namespace softgl {

struct Context;

/// Does the work that waits in the frame, so that the surface holds the picture; a reader sees each tile when
/// it is finished. Vertices that wait in the builder stay there. Afterwards all snapshots have to be made
/// anew.
void execute_frame(Context& context, const TileReader* reader = nullptr);
/// Does the work that waits, but keeps the frame's memory: what lies in it stays valid.
void execute_frame_so_far(Context& context);
/// As execute_frame(), and the planes know all of it (write_tiles).
void flush_frame(Context& context);

} // namespace softgl
