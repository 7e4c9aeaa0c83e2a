// Other clip volumes (GL_ARB_clip_control): what the random scenes of [clip_control] do not show.
#include <catch2/catch.hpp>

#include <vector>

#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

GLboolean position_valid(const Gl& gl) {
  GLboolean valid = 7;
  gl.GetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
  return valid;
}

/// Whether a polygon that is counter-clockwise before the origin turns it upside down is drawn.
bool is_drawn(const Gl& gl) {
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Begin(GL_TRIANGLES);
  gl.Vertex2f(-1, -1), gl.Vertex2f(1, -1), gl.Vertex2f(0, 1);
  gl.End();
  GLubyte pixel[4] = {};
  gl.ReadPixels(32, 32, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  return pixel[0] != 0;
}

} // namespace

TEST_CASE("Raster positions before the near plane are not valid where depths begin at zero",
          "[spec][clip_control]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl.RasterPos3f(0, 0, -0.5f);
  CHECK(!position_valid(gl));
  gl.RasterPos3f(0, 0.5f, 0.25f);
  CHECK(position_valid(gl));
  GLfloat window[4] = {};
  gl.GetFloatv(GL_CURRENT_RASTER_POSITION, window);
  CHECK((window[0] == 32 && window[1] == 48 && window[2] == 0.25f));
  gl.ClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  gl.RasterPos3f(0, 0.5f, -0.5f);
  gl.GetFloatv(GL_CURRENT_RASTER_POSITION, window);
  CHECK((position_valid(gl) && window[1] == 16 && window[2] == 0.25f));
  gl.WindowPos3f(5, 6, 0.75f); // has no clip coordinates
  gl.GetFloatv(GL_CURRENT_RASTER_POSITION, window);
  CHECK((window[1] == 6 && window[2] == 0.75f));
}

TEST_CASE("An origin above does not change which polygons are front-facing", "[spec][clip_control]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.Enable(GL_CULL_FACE);
  for (GLenum origin : {GL_LOWER_LEFT, GL_UPPER_LEFT})
    for (GLenum mode : {GL_FILL, GL_LINE}) {
      gl.ClipControl(origin, GL_ZERO_TO_ONE);
      gl.PolygonMode(GL_BACK, mode);
      gl.FrontFace(GL_CCW);
      CHECK(is_drawn(gl));
      gl.FrontFace(GL_CW);
      CHECK(!is_drawn(gl));
    }
}

TEST_CASE("The clip control belongs to GL_TRANSFORM_BIT and goes into lists", "[spec][clip_control]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.NewList(1, GL_COMPILE);
  gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  gl.EndList();
  gl.PushAttrib(GL_TRANSFORM_BIT);
  gl.CallList(1);
  GLint origin = 0, mode = 0;
  gl.GetIntegerv(GL_CLIP_ORIGIN, &origin);
  gl.GetIntegerv(GL_CLIP_DEPTH_MODE, &mode);
  CHECK((origin == GL_UPPER_LEFT && mode == GL_ZERO_TO_ONE));
  gl.PopAttrib();
  gl.GetIntegerv(GL_CLIP_ORIGIN, &origin);
  gl.GetIntegerv(GL_CLIP_DEPTH_MODE, &mode);
  CHECK((origin == GL_LOWER_LEFT && mode == GL_NEGATIVE_ONE_TO_ONE));
}

TEST_CASE("Feedback has the window coordinates of the clip control", "[spec][clip_control][osmesa]") {
  std::vector<float> answers[2];
  for (int i = 0; i < 2; ++i) {
    const Gl& gl = i == 0 ? softgl_library() : osmesa_library();
    CurrentContext context(gl);
    GLfloat values[64] = {};
    gl.FeedbackBuffer(64, GL_3D, values);
    gl.RenderMode(GL_FEEDBACK);
    gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    gl.DepthRange(0.25, 0.75);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex3f(-0.5f, -0.5f, 0.5f), gl.Vertex3f(0.5f, -0.5f, 0.25f), gl.Vertex3f(0, 0.75f, -0.25f);
    gl.End();
    answers[i].assign(values, values + gl.RenderMode(GL_RENDER));
  }
  CHECK(answers[0] == answers[1]);
  CHECK(answers[0].size() > 10);
}
