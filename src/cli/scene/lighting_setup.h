// Lights and the lighting model, as GL calls.
#pragma once

#include "mesh/model_frame.h"
#include "scene/camera.h"
#include "scene/lighting_options.h"

namespace softgl::cli {

inline constexpr unsigned kMostLights = 8; // what GL promises

// GL lights that the options take.
unsigned gl_lights_of(const LightingOptions& options);

// Sets shade model, lighting model and lights of the current context; leaves the modelview matrix changed. At
// most kMostLights. Throws ProgramError if the GL library lacks what is asked for.
void apply_lighting(const LightingOptions& options, const Camera& camera, const ModelFrame& frame);

} // namespace softgl::cli
