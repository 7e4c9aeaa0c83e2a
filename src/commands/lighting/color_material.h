// Color material (GL 1.5, 2.14.3): which material parameters follow the current color.
#pragma once

#include "context/context.h"

namespace softgl {

/// The material slots (bit i = kMaterial0 + i) that a glColorMaterial or glMaterial parameter names; 0 if the
/// face or the parameter is not one.
uint32_t material_slots(GLenum face, GLenum parameter);

/// The slots that follow the current color; 0 while GL_COLOR_MATERIAL is disabled.
inline uint32_t tracked_material_slots(const LightingState& lighting) {
  if (!lighting.color_material_enabled) return 0;
  return material_slots(lighting.color_material_face, lighting.color_material_parameter);
}

/// Copies the current color to the parameters that follow it. Drawing does not need this: lighting takes the
/// vertex color. Call it before these parameters are read or cease to follow.
void track_color_material(Context& c);

} // namespace softgl
