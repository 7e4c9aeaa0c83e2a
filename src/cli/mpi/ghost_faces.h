// Faces of other ranks that meet this rank's faces: generated normals are means over all of them.
#pragma once

#include "mesh/model_frame.h"
#include "mpi/ranks.h"
#include "obj/obj_reader.h"

namespace softgl::cli {

// Adds to the triangulated model, in chunks before and behind its own, the triangles of lower and of higher
// ranks that have a corner at one of its places, in the order of the file, with positions of their own in the
// frame. Returns how many chunks stand before. All ranks call.
size_t add_ghost_faces(ObjModel& model, ModelFrame& frame, const Ranks& ranks);
// Leaves `count` chunks from number `first` on.
void drop_ghost_faces(ObjModel& model, size_t first, size_t count);

} // namespace softgl::cli
