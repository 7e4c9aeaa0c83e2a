#include "scene/lighting_setup.h"

#include <string>

#include "common/program_error.h"
#include "scene/gl_functions.h"

namespace softgl::cli {
namespace {

void require_extension(const char* name, const char* what) {
  if (!has_extension(name))
    throw ProgramError(kCannotRead, std::string("this GL library has no ") + what + " (" + name + ")");
}

class LightSetup {
public:
  LightSetup(const Camera& camera, const ModelFrame& frame) : camera_(camera), frame_(frame) {}

  void add(const LightOptions& light) {
    if (light.kind == LightOptions::kKey) {
      const float key[4] = {-0.45f, 0.65f, 0.9f, 0}, fill[4] = {0.9f, -0.15f, 0.45f, 0};
      set(key, 0.975f, 1, light.color);
      set(fill, 0.225f, 0, light.color);
      return;
    }
    if (light.kind == LightOptions::kThreePoint) {
      const float key[4] = {-0.8f, 0.6f, 0.7f, 0}, fill[4] = {0.9f, 0.1f, 0.6f, 0},
                  rim[4] = {0.35f, 0.8f, -0.9f, 0};
      set(key, 0.95f, 1, light.color);
      set(fill, 0.3f, 0, light.color);
      set(rim, 0.75f, 0.75f, light.color);
      return;
    }
    const bool in_model =
        light.kind == LightOptions::kModelDirection || light.kind == LightOptions::kModelPosition;
    if (in_model)
      glLoadMatrixd(camera_.view);
    else
      glLoadIdentity();
    float position[4] = {0, 0, 0, light.kind == LightOptions::kModelPosition ? 1.0f : 0.0f};
    for (int axis = 0; axis < 3; ++axis)
      position[axis] =
          float(light.kind == LightOptions::kModelPosition ? frame_.to_frame(light.value[axis], axis)
                                                           : light.value[axis]);
    const GLenum number = set(position, 1, 1, light.color);
    if (light.kind != LightOptions::kModelPosition) return;
    const float direction[3] = {float(light.spot_direction[0]), float(light.spot_direction[1]),
                                float(light.spot_direction[2])};
    glLightfv(number, GL_SPOT_DIRECTION, direction);
    glLightf(number, GL_SPOT_CUTOFF, light.cutoff);
    glLightf(number, GL_SPOT_EXPONENT, light.exponent);
    // The model was scaled to about 1; the distances of the formula are its own.
    const auto scale = float(frame_.scale);
    glLightf(number, GL_CONSTANT_ATTENUATION, light.attenuation[0]);
    glLightf(number, GL_LINEAR_ATTENUATION, light.attenuation[1] / scale);
    glLightf(number, GL_QUADRATIC_ATTENUATION, light.attenuation[2] / scale / scale);
  }

private:
  GLenum set(const float* position, float diffuse, float specular, const float* color) {
    const GLenum number = GL_LIGHT0 + count_++;
    const float d[4] = {diffuse * color[0], diffuse * color[1], diffuse * color[2], 1};
    const float s[4] = {specular * color[0], specular * color[1], specular * color[2], 1};
    const float a[4] = {0, 0, 0, 1};
    glLightfv(number, GL_POSITION, position);
    glLightfv(number, GL_DIFFUSE, d);
    glLightfv(number, GL_SPECULAR, s);
    glLightfv(number, GL_AMBIENT, a);
    glEnable(number);
    return number;
  }

  const Camera& camera_;
  const ModelFrame& frame_;
  GLenum count_ = 0;
};

} // namespace

unsigned gl_lights_of(const LightingOptions& options) {
  unsigned count = options.lights.empty() ? 2 : 0;
  for (const LightOptions& light : options.lights)
    count += light.kind == LightOptions::kKey ? 2 : light.kind == LightOptions::kThreePoint ? 3 : 1;
  return count;
}

void apply_lighting(const LightingOptions& options, const Camera& camera, const ModelFrame& frame) {
  if (options.shading == Shading::kPhong) require_extension("GL_WIN_phong_shading", "shading per pixel");
  glShadeModel(options.shading == Shading::kFlat      ? GL_FLAT
               : options.shading == Shading::kGouraud ? GL_SMOOTH
                                                      : GL_PHONG_WIN);
  if (options.reflection_vector || options.terms != kAllTerms) {
    require_extension("GL_SOFTGL_phong_illumination", "reflection vector and no choice of terms");
    glLightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL,
                  options.reflection_vector ? GL_REFLECTION_VECTOR_SOFTGL : GL_HALF_VECTOR_SOFTGL);
    glLightModeli(GL_LIGHT_MODEL_TERMS_SOFTGL, GLint(options.terms));
  }
  const float ambient[4] = {options.ambient[0], options.ambient[1], options.ambient[2], 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  LightSetup lights(camera, frame);
  if (options.lights.empty()) lights.add({});
  for (const LightOptions& light : options.lights) lights.add(light);
}

} // namespace softgl::cli
