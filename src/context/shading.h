// Which way lit primitives are shaded (GL 1.5, 2.14.7 and GL_WIN_phong_shading).
#pragma once

#include "context/state.h"

namespace softgl {

/// SOFTGL_SHADING=phong: programs that ask for GL_SMOOTH get GL_PHONG_WIN.
bool smooth_is_phong_by_environment();

/// SOFTGL_QUADS=osmesa: the diagonals of GL_QUADS are those that OSMesa 22.3.6 takes.
bool osmesa_quadrilaterals_by_environment();

/// SOFTGL_ANSWERS=specification: where OSMesa 22.3.6 leaves the specification, so does not softgl.
bool specification_answers_by_environment();

/// True where lighting is done for each fragment. Without lighting GL_PHONG_WIN is GL_SMOOTH.
inline bool lights_fragments(const LightingState& lighting, bool smooth_is_phong) {
  return lighting.enabled &&
         (lighting.shade_model == GL_PHONG_WIN || (smooth_is_phong && lighting.shade_model == GL_SMOOTH));
}

} // namespace softgl
