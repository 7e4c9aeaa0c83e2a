// Normals where the file gives none.
#pragma once

#include "mesh/model_frame.h"
#include "obj/obj_reader.h"

namespace softgl::cli {

// Faces that meet at a smaller angle are shaded as one smooth surface where no smoothing groups are given. At
// 30 scanned models show facets, at 60 the edges of machine parts smear.
inline constexpr double kDefaultCreaseAngle = 40;

struct NormalOptions {
  double crease_angle = kDefaultCreaseAngle; // degrees
  bool ignore_groups = false;                // use the angle even where the file has smoothing groups
};

// Gives every corner of the (triangulated) model a normal. A generated normal is the mean of the face normals
// around the position, weighted by the faces' angles there, over the faces that belong together: those of the
// same smoothing group, or - before the first `s` statement or without any - those within the crease angle.
// Group 0 (`s off`) is flat. Places count, not pairs of position and texture coordinate, nor vertices:
// neither a texture seam nor a vertex that the file repeats shows. Returns how many corners were given one.
uint64_t generate_normals(ObjModel& model, const ModelFrame& frame, const NormalOptions& options);

} // namespace softgl::cli
