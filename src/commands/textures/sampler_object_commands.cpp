// Sampler objects: naming, binding and parameters (GL_ARB_sampler_objects, 3.9.2 and 6.1.5).
#include "context/sampler_objects.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "commands/generated/commands.h"
#include "commands/textures/sampling_parameters.h"
#include "context/context.h"

namespace softgl::gl {

namespace {

constexpr uint32_t kDirtySamplers = kDirtyTexture | kDirtyTextureObjects;

/// Null, and the error, for what is no sampler object.
std::shared_ptr<SamplerObject> find_sampler(Context& c, GLuint name) {
  auto object = c.shared->samplers.find(name);
  if (!object) set_error(c, GL_INVALID_OPERATION);
  return object;
}

/// Sets a parameter, or the error.
void change(Context& c, SamplerObject& object, GLenum pname, const GLfloat* params) {
  if (const Refusal refusal = set_sampling_parameter(object.parameters, pname, params, false))
    return set_error(c, refusal);
  c.dirty |= kDirtySamplers;
}

/// Border colors keep the bits of integers; other parameters are converted.
template <class T> void change_integers(Context& c, GLuint sampler, GLenum pname, const T* params) {
  const auto object = find_sampler(c, sampler);
  if (!object) return;
  if (get_sampling_parameter(c, object->parameters, pname).count == 0)
    return set_error(c, GL_INVALID_ENUM, "pname");
  GLfloat values[4] = {};
  if (pname == GL_TEXTURE_BORDER_COLOR)
    for (int i = 0; i < 4; ++i) values[i] = std::bit_cast<GLfloat>(params[i]);
  else
    values[0] = GLfloat(params[0]);
  change(c, *object, pname, values);
}

template <class T> void get_integers(Context& c, GLuint sampler, GLenum pname, T* params) {
  const auto object = find_sampler(c, sampler);
  if (!object) return;
  const ParameterValues values = get_sampling_parameter(c, object->parameters, pname);
  if (values.count == 0) return set_error(c, GL_INVALID_ENUM, "pname");
  if (pname == GL_TEXTURE_BORDER_COLOR) {
    for (int i = 0; i < 4; ++i) params[i] = std::bit_cast<T>(object->parameters.border_color[i]);
    return;
  }
  GLint value = 0;
  values.store(&value);
  params[0] = T(value);
}

template <class T> void get_sampler_parameter(Context& c, GLuint sampler, GLenum pname, T* params) {
  const auto object = find_sampler(c, sampler);
  if (!object) return;
  const ParameterValues values = get_sampling_parameter(c, object->parameters, pname);
  if (values.count == 0) return set_error(c, GL_INVALID_ENUM, "pname");
  values.store(params);
}

} // namespace

void GenSamplers(Context& c, GLsizei count, GLuint* samplers) {
  if (count < 0) return set_error(c, GL_INVALID_VALUE, "count");
  if (!samplers) return;
  // They are there as soon as they have a name (issue 10).
  std::vector<std::shared_ptr<SamplerObject>> made(static_cast<size_t>(count));
  for (auto& object : made) object = std::make_shared<SamplerObject>(0u);
  if (!c.shared->samplers.reserve(count, samplers)) return set_error(c, GL_OUT_OF_MEMORY);
  for (size_t i = 0; i < made.size(); ++i) {
    made[i]->name = samplers[i];
    c.shared->samplers.set(samplers[i], std::move(made[i]));
  }
}

void DeleteSamplers(Context& c, GLsizei count, const GLuint* samplers) {
  if (count < 0) return set_error(c, GL_INVALID_VALUE, "count");
  if (!samplers) return;
  for (GLsizei i = 0; i < count; ++i) {
    const auto object = c.shared->samplers.erase(samplers[i]);
    if (!object) continue;
    for (auto& bound : c.samplers)
      if (bound == object) bound = nullptr;
  }
  c.dirty |= kDirtySamplers;
}

GLboolean IsSampler(Context& c, GLuint sampler) {
  return sampler != 0 && c.shared->samplers.find(sampler) ? GL_TRUE : GL_FALSE;
}

void BindSampler(Context& c, GLuint unit, GLuint sampler) {
  if (unit >= GLuint(kMaxTextureUnits)) return set_error(c, GL_INVALID_VALUE, "unit");
  auto object = sampler ? find_sampler(c, sampler) : nullptr;
  if (sampler && !object) return;
  c.samplers[unit] = std::move(object);
  c.dirty |= kDirtySamplers; // to bind what is bound brings what another context has done to it
}

void SamplerParameter(Context& c, GLuint sampler, GLenum pname, const GLfloat* params) {
  if (const auto object = find_sampler(c, sampler)) change(c, *object, pname, params);
}
void SamplerParameterIiv(Context& c, GLuint sampler, GLenum pname, const GLint* params) {
  change_integers(c, sampler, pname, params);
}
void SamplerParameterIuiv(Context& c, GLuint sampler, GLenum pname, const GLuint* params) {
  change_integers(c, sampler, pname, params);
}

void GetSamplerParameterfv(Context& c, GLuint sampler, GLenum pname, GLfloat* params) {
  get_sampler_parameter(c, sampler, pname, params);
}
void GetSamplerParameteriv(Context& c, GLuint sampler, GLenum pname, GLint* params) {
  get_sampler_parameter(c, sampler, pname, params);
}
void GetSamplerParameterIiv(Context& c, GLuint sampler, GLenum pname, GLint* params) {
  get_integers(c, sampler, pname, params);
}
void GetSamplerParameterIuiv(Context& c, GLuint sampler, GLenum pname, GLuint* params) {
  get_integers(c, sampler, pname, params);
}

} // namespace softgl::gl
