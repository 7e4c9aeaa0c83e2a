#include "scene/ground.h"

#include <algorithm>
#include <cmath>

#include "common/trigonometry.h"
#include "scene/camera_axes.h"

namespace softgl::cli {
namespace {

constexpr int kLights = 64;
constexpr double kWidest = 1;     // slope of the outermost light's shadow
constexpr double kDarkest = 0.6;  // part of the light that is missing where all lights are hidden
constexpr double kHighest = 0.15; // part of the model's height that casts a shadow for some lights
constexpr double kGoldenAngle = 137.50776405003785, kGoldenRatio = 0.6180339887498949;

// The shadow of one light: each point goes along the light's direction down to the ground.
void project(const Axes& axes, double ground, double slope_x, double slope_y) {
  double way[3]; // per unit of height
  for (int i = 0; i < 3; ++i) way[i] = slope_x * axes.right[i] + slope_y * axes.back[i] - axes.up[i];
  double matrix[16];
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      matrix[4 * column + row] = (row == column ? 1 : 0) + way[row] * axes.up[column];
    matrix[12 + row] = -way[row] * ground;
    matrix[4 * row + 3] = 0;
  }
  matrix[15] = 1;
  glMultMatrixd(matrix);
}

void invert(const double* view, double* inverse) {
  for (int row = 0; row < 3; ++row) {
    inverse[12 + row] = 0;
    for (int i = 0; i < 3; ++i) {
      inverse[4 * i + row] = view[4 * row + i];
      inverse[12 + row] -= view[4 * row + i] * view[12 + i];
    }
    inverse[4 * row + 3] = 0;
  }
  inverse[15] = 1;
}

} // namespace

void draw_ground_shadow(const Mesh& mesh, const UploadedMesh& uploaded, const Camera& camera, UpAxis up) {
  if (mesh.triangles.empty()) return;
  const Axes axes = model_axes(up);
  double lowest = 1e300, highest = -1e300;
  for_each_position(mesh, [&](const float* p) {
    lowest = std::min(lowest, along(axes.up, p));
    highest = std::max(highest, along(axes.up, p));
  });
  const double ground = lowest - 0.002; // clear of an underside
  double height = -ground;              // of the camera above the ground
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i < 3; ++i) height -= axes.up[i] * camera.view[4 * i + row] * camera.view[12 + row];
  if (!(height > 0) && camera.projection[11] != 0) return;
  if (camera.eye[0] * axes.up[0] + camera.eye[1] * axes.up[1] + camera.eye[2] * axes.up[2] <= 0) return;

  glPushAttrib(GL_ALL_ATTRIB_BITS);
  uploaded.use_vertices();
  for (const GLenum array : {GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
    glDisableClientState(array);
  glDisable(GL_LIGHTING);
  glDisable(GL_TEXTURE_2D);
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (has_extension("GL_ARB_depth_clamp")) glEnable(GL_DEPTH_CLAMP); // shadows are longer than the model
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glEnable(GL_STENCIL_TEST); // a light is hidden once
  glStencilFunc(GL_EQUAL, 0, 1);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  glColor4f(0, 0, 0, float(1 - std::pow(1 - kDarkest, 1.0 / kLights)));
  glEnable(GL_CLIP_PLANE0);
  double back_to_model[16]; // the inverse of the view, a rotation and a translation
  invert(camera.view, back_to_model);
  for (int light = 0; light < kLights; ++light) {
    // Vogel's spiral: lights spread evenly over a disc above.
    const double slope = kWidest * std::sqrt((light + 0.5) / kLights),
                 angle = std::fmod(light * kGoldenAngle, 360.0);
    // What is high above the ground hides few lights: the shadow fades with the height of what casts it.
    const double part = std::fmod(light * kGoldenRatio, 1.0);
    const double limit = ground + kHighest * part * part * (highest - lowest) + 0.004;
    const double plane[4] = {-axes.up[0], -axes.up[1], -axes.up[2], limit};
    glMatrixMode(GL_MODELVIEW);
    glClipPlane(GL_CLIP_PLANE0, plane);
    glClear(GL_STENCIL_BUFFER_BIT);
    // The clip plane sees the model as it stands; only the projection lays it on the ground.
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(camera.projection);
    glMultMatrixd(camera.view);
    project(axes, ground, slope * cosine(angle), slope * sine(angle));
    glMultMatrixd(back_to_model);
    uploaded.draw_triangles();
  }
  glLoadMatrixd(camera.projection);
  glMatrixMode(GL_MODELVIEW);
  glPopAttrib();
}

} // namespace softgl::cli
