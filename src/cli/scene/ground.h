// The model's soft shadow on the ground it stands on.
#pragma once

#include "scene/camera.h"
#include "scene/uploaded_mesh.h"

namespace softgl::cli {

// The ground is the plane below the model's lowest point, square to the `up` axis; nothing of it is seen but
// the shadow. Drawn after the opaque model, to a framebuffer of floats with a stencil; needs the model's view
// and projection. Nothing is drawn where the camera is below the ground.
void draw_ground_shadow(const Mesh& mesh, const UploadedMesh& uploaded, const Camera& camera, UpAxis up);

} // namespace softgl::cli
