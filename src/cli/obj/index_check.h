// Faces, segments and points lead to vertices that exist and are finite.
#pragma once

#include "obj/obj_range.h"
#include "obj/obj_reader.h"

namespace softgl::cli {

// Leaves out what leads nowhere, with remarks, and counts what is left. `of_file`: how many of each kind the
// file has, for the remarks; the model may have some of them only.
void check_indices(ObjModel& model, const ElementCounts& of_file, RemarkList& remarks);

} // namespace softgl::cli
