// The parameters that texture objects and sampler objects share (GL 1.5, 3.8.4; GL_ARB_sampler_objects).
#pragma once

#include "base/refusal.h"
#include "texture/texture_object.h"

namespace softgl {

struct Context;

/// Sets the parameter `pname`, or tells why not. `rectangle`: of a texture that cannot repeat and has no
/// mipmaps.
Refusal set_sampling_parameter(SamplingParameters& parameters, GLenum pname, const GLfloat* params,
                               bool rectangle);

/// A parameter as it is asked for. No values: the name is unknown.
struct ParameterValues {
  int count = 0;
  float v[4] = {};
  bool color = false; // as integers the values map [-1, 1] to the whole range (6.1.2)

  ParameterValues() = default;
  explicit ParameterValues(float value) : count(1), v{value} {}
  explicit ParameterValues(GLenum value) : ParameterValues(float(value)) {}
  void store(GLfloat* params) const;
  void store(GLint* params) const;
};
ParameterValues get_sampling_parameter(const Context& c, const SamplingParameters& parameters, GLenum pname);

} // namespace softgl
