#include "scene/picture_state.h"

#include <algorithm>

#include "image/srgb.h"
#include "scene/background.h"
#include "scene/gl_functions.h"
#include "scene/lighting_setup.h"

namespace softgl::cli {
namespace {

unsigned terms_of(Pass pass, unsigned chosen) {
  switch (pass) {
  case Pass::kAmbient: return kAmbient;
  case Pass::kDiffuse: return kDiffuse;
  case Pass::kSpecular: return kSpecular;
  case Pass::kEmission: return kEmission;
  default: return chosen;
  }
}

float stored_value(const RenderOptions& options, uint8_t value) {
  return options.srgb ? from_srgb(float(value) / 255) : float(value) / 255;
}

} // namespace

RenderOptions settle_for_pass(RenderOptions options) {
  options.lighting.terms = terms_of(options.pass, options.lighting.terms);
  Background& background = options.background;
  if (is_term(options.pass)) {
    std::fill_n(background.color, 3, uint8_t(0));
    background.below.reset();
    background.picture.reset();
  }
  if (options.pass == Pass::kCoverage) background.transparent = true;
  if (options.pass != Pass::kColor) options.ground = false;
  return options;
}

void clear_picture(const RenderOptions& options, int width, int height) {
  // Alpha counts what is drawn: the background has none, whatever its color.
  const uint8_t* color = options.background.color;
  if (options.background.transparent)
    glClearColor(0, 0, 0, 0);
  else
    glClearColor(stored_value(options, color[0]), stored_value(options, color[1]),
                 stored_value(options, color[2]), 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_background(options.background, width, height, options.srgb);
}

void start_picture(const RenderOptions& options, const Camera& camera, const ModelFrame& frame, int width,
                   int height, bool lines_on_surfaces) {
  glViewport(0, 0, width, height);
  clear_picture(options, width, height);
  apply_lighting(options.lighting, camera, frame);
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixd(camera.projection);
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixd(camera.view);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glAlphaFunc(GL_GREATER, 0);
  if (lines_on_surfaces) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 1);
  }
}

} // namespace softgl::cli
