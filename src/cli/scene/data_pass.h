// Pictures of numbers instead of light: depth, normals, texture coordinates, materials.
#pragma once

#include "image/float_picture.h"
#include "mesh/model_frame.h"
#include "scene/camera.h"
#include "scene/pass.h"
#include "scene/uploaded_mesh.h"

namespace softgl::cli {

// What a pass stores:
//   depth     distance from the camera along its axis, in the model's units; infinity where nothing is
//   normal    x y z in the model's axes, unit; 0 0 0 where nothing is
//   uv        u v 0 as the file has them; 0 0 0 where nothing is
//   id        1 for the first material and so on; 0 where nothing is
// With `whole` they are made fit for files of whole numbers, from 0 to 1: depth 0 at the near and 1 at the
// far plane, which the notes name; (n + 1) / 2; fractions of u and v; a color for each material, which the
// notes name.
struct DataPicture {
  FloatPicture picture;
  bool visible = false;
};

// Draws all triangles, lines and points as if they were opaque; where a texture's alpha is below a half there
// is nothing. To the current context, whose picture is left alone.
DataPicture draw_data(Pass pass, const Mesh& mesh, const std::vector<Material>& materials,
                      const ModelFrame& frame, const UploadedMesh& uploaded, const Camera& camera, int width,
                      int height, bool whole);

} // namespace softgl::cli
