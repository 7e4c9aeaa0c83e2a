// Shapes and cameras that several named scenes use.
#pragma once

#include "support/scene.h"

namespace softgl::test {

/// A perspective camera that looks at the origin from `distance`.
void camera(Stage& s, float distance);
/// A torus with normals and texture coordinates, as triangle strips.
void torus(Stage& s, float outer, float inner, int rings, int sides);
/// A solid of revolution of a teapot-like profile, with spout and handle as bent tubes.
void teapot(Stage& s, int slices);
/// A cube with face normals and texture coordinates, as quads cut into triangles.
void cube(Stage& s, float half);
/// What scenes of an open, clipped shape need: camera, light, two-sided lighting with separate specular
/// color, materials but the front's diffuse one, and a clip plane.
void two_sided_bowl(Stage& s);
/// A chequered texture with mipmaps, bound and enabled.
void checker_texture(Stage& s, int size, bool mipmaps);

} // namespace softgl::test
