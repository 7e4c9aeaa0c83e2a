// Stretches of a file go to other ranks so that all have as much to draw.
#pragma once

#include <vector>

#include "common/source_text.h"
#include "mpi/ranks.h"
#include "obj/obj_chunk.h"

namespace softgl::cli {

// Where vertices stand first in a file and faces last, some ranks have read nothing to draw. Chunks move,
// without their vertices, so that each rank has about as many corners; their order in the file is that of the
// ranks. Indices are absolute. All ranks map the same file. All ranks call.
void balance_chunks(std::vector<ObjChunk>& chunks, const SourceText& text, const Ranks& ranks);

} // namespace softgl::cli
