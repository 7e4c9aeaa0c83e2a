// STL files: triangles without materials, as text or binary.
#pragma once

#include "obj/obj_reader.h"

namespace softgl::cli {

bool is_stl(const SourceText& text);

// Equal places become one vertex, so that normals can be made smooth; those of the file are left out, since
// they are the triangles' own. What is cut off is read as far as it goes, with a remark.
ObjModel read_stl(const SourceText& text, RemarkList& remarks);

} // namespace softgl::cli
