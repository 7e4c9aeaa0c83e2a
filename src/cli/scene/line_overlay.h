// A mesh's edges and vertices as lines and points.
#pragma once

#include "mesh/mesh_builder.h"
#include "scene/look.h"
#include "scene/uploaded_mesh.h"

namespace softgl::cli {

// The surface's depth alone, so that it hides what is behind it.
void draw_depth_only(const Mesh& mesh, const UploadedMesh& uploaded);

// The mesh's edges, or with kPoints its vertices, over what is there. `scale`: samples a pixel on a side.
void draw_lines(const Mesh& mesh, const UploadedMesh& uploaded, const LineOptions& options,
                const std::array<float, 3>& color, float scale);

} // namespace softgl::cli
