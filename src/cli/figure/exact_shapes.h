// A sphere, a plane and a box, as exact shapes for rays and as triangles for GL.
#pragma once

#include "figure/textbook.h"
#include "scene/renderer.h"

namespace softgl::cli {

class ExactShapes {
public:
  ExactShapes();

  // Size, background and ambient light of the options; the light is the scene's own.
  Picture ray_cast(const RenderOptions& options) const;
  // The sphere in so many slices, Phong shading.
  Picture triangles(const RenderOptions& options, int slices) const;

private:
  Vec3 up_, box_center_, half_[3]; // half edges of the box
  Vec3 sphere_center_;
};

} // namespace softgl::cli
