// Other clip volumes (GL_ARB_clip_control): an origin above, depths from zero.
#include "conformance/families/common.h"

namespace softgl::test {
namespace {

/// Moves depths of [-1, 1] to [0, 1]: what the extension's issue 6 puts before a projection.
void halve_depths(Stage& s) {
  GLfloat projection[16];
  s.gl.GetFloatv(GL_PROJECTION_MATRIX, projection);
  s.gl.MatrixMode(GL_PROJECTION);
  s.gl.LoadIdentity();
  s.gl.Translatef(0, 0, 0.5f);
  s.gl.Scalef(1, 1, 0.5f);
  s.gl.MultMatrixf(projection);
  s.gl.MatrixMode(GL_MODELVIEW);
}

void random_clip_control(Stage& s) {
  const GLenum origin = s.random.chance(60) ? GL_UPPER_LEFT : GL_LOWER_LEFT;
  const GLenum depth = s.random.chance(65) ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE;
  s.gl.ClipControl(origin, depth);
  if (depth == GL_ZERO_TO_ONE && s.random.chance(60)) halve_depths(s);
}

void random_polygon_state(Stage& s) {
  random_culling(s);
  s.gl.FrontFace(s.random.chance(50) ? GL_CW : GL_CCW);
  const bool lines = s.random.chance(25), points = s.random.chance(15);
  s.gl.PolygonMode(GL_FRONT, lines ? GL_LINE : GL_FILL);
  s.gl.PolygonMode(GL_BACK, points ? GL_POINT : GL_FILL);
  s.gl.Disable(GL_POLYGON_OFFSET_FILL);
  if (!lines && !points && s.random.chance(25)) {
    const float factor = s.random.real(-2, 2), units = s.random.real(-4, 4);
    s.gl.PolygonOffset(factor, units);
    s.gl.Enable(GL_POLYGON_OFFSET_FILL);
  }
  if (s.random.chance(25)) {
    const float ambient[] = {0.1f, 0.2f, 0.3f, 1}, position[] = {0.3f, -0.4f, 1, 0};
    s.gl.Enable(GL_LIGHTING);
    s.gl.Enable(GL_LIGHT0);
    s.gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    s.gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
    s.gl.Materialfv(GL_BACK, GL_AMBIENT, ambient);
  } else {
    s.gl.Disable(GL_LIGHTING);
  }
}

void random_clip_plane(Stage& s) {
  double plane[4];
  for (double& x : plane) x = double(s.random.real(-1, 1));
  s.gl.ClipPlane(GL_CLIP_PLANE0, plane);
  s.gl.Enable(GL_CLIP_PLANE0);
}

/// Where depths begin at zero OSMesa takes raster positions with others, too: those have a test of their own.
void rectangle_of_pixels(Stage& s) {
  static const unsigned char pixels[12] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0};
  s.gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  s.gl.MatrixMode(GL_PROJECTION);
  s.gl.LoadIdentity();
  s.gl.MatrixMode(GL_MODELVIEW);
  s.gl.LoadIdentity();
  const float x = s.random.real(-1, 1), y = s.random.real(-1, 1), z = s.random.real(0, 1);
  if (s.random.chance(25))
    s.gl.WindowPos3f(x * 30 + 30, y * 30 + 30, z);
  else
    s.gl.RasterPos3f(x, y, z);
  s.gl.PixelZoom(4, 5);
  s.gl.DrawPixels(2, 2, GL_RGB, GL_UNSIGNED_BYTE, pixels);
}

void draw_clip_control(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(2, 4); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    const bool saved = s.random.chance(20);
    if (saved) s.gl.PushAttrib(GL_TRANSFORM_BIT);
    random_clip_control(s);
    random_depth(s, 80);
    random_polygon_state(s);
    if (s.random.chance(20)) s.gl.Enable(GL_DEPTH_CLAMP);
    if (s.random.chance(20)) random_clip_plane(s);
    PrimitiveOptions options;
    options.mode = s.random.chance(25) ? GLenum(s.random.pick({GL_LINES, GL_POINTS})) : random_filled_mode(s);
    options.spread = s.random.chance(70) ? Spread::Any : Spread::Beyond;
    options.normals = true;
    s.gl.PointSize(4);
    s.gl.LineWidth(s.random.chance(30) ? 3.0f : 1.0f);
    random_primitive(s, options);
    if (s.random.chance(25)) rectangle_of_pixels(s);
    s.gl.Disable(GL_DEPTH_CLAMP);
    if (saved) {
      s.gl.PopAttrib();
      random_primitive(s, options);
    }
    s.gl.Disable(GL_CLIP_PLANE0);
  }
}

SceneRegistration clip_control{{"clip_control", draw_clip_control, true}};

} // namespace
} // namespace softgl::test
