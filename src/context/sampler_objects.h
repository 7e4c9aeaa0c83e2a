// Sampler objects (GL_ARB_sampler_objects, 3.9.2).
#pragma once

#include <memory>
#include <string>

#include "shaders/common/limits.h"
#include "texture/texture_object.h"

namespace softgl {

struct SamplerObject {
  explicit SamplerObject(GLuint name) : name(name) {}
  GLuint name;
  std::string label; // GL_KHR_debug
  SamplingParameters parameters;
};

/// By texture unit; null: the parameters are those of the unit's texture. In no attribute group. A deleted
/// object lives as long as another context has bound it.
using SamplerBindings = std::shared_ptr<SamplerObject>[kMaxTextureUnits];

} // namespace softgl
