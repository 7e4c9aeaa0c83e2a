// All faces of a model as triangles.
#pragma once

#include "obj/obj_reader.h"

namespace softgl::cli {

// Afterwards every chunk's corners are triangles (face_sizes empty), and its state changes count triangles.
// The diagonal of a quadrilateral is 1-3, or 2-4 where 1-3 would leave the face.
void triangulate_faces(ObjModel& model);

uint64_t triangle_count(const ObjModel& model);
double surface_area(const ObjModel& model); // of the triangles, in the file's units

} // namespace softgl::cli
