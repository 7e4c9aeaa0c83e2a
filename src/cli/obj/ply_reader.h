// PLY files: vertices with any properties, and faces; as text or binary of either byte order.
#pragma once

#include "obj/obj_reader.h"

namespace softgl::cli {

bool is_ply(const SourceText& text);

// Of a vertex x y z, nx ny nz, red green blue, and s t (or u v, texture_u texture_v) are taken; of a face its
// list of vertices. What is cut off is read as far as it goes, with a remark. Throws ProgramError for a
// header that cannot be understood.
ObjModel read_ply(const SourceText& text, RemarkList& remarks);

} // namespace softgl::cli
