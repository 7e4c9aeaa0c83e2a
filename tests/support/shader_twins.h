// OSMesa with per-pixel lighting: glShadeModel(GL_PHONG_WIN) and softgl's lighting extension, done by
// shaders/glsl.
#pragma once

#include "support/gl.h"

namespace softgl::test {

/// Which lit primitives the shaders draw: those that are Phong shaded, or the Gouraud-shaded ones as well.
enum class Twins { Phong, PhongAndGouraud };

/// A table that draws scenes as they are, one context at a time. Not covered: lists that contain shading
/// state, textures other than one of unit 0 that modulates.
Gl with_shaders(const Gl& library, Twins twins);
/// The same of the system's OSMesa.
Gl shader_library(Twins twins);

} // namespace softgl::test
