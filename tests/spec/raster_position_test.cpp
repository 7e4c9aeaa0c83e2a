// GL 1.5, 2.13: the current raster position.
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/random.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

using Values = std::vector<GLfloat>;

void append(const Gl& gl, GLenum name, int count, Values& out) {
  GLfloat v[4] = {};
  gl.GetFloatv(name, v);
  out.insert(out.end(), v, v + count);
}

Values position(const Gl& gl) {
  Values v;
  append(gl, GL_CURRENT_RASTER_POSITION_VALID, 1, v);
  append(gl, GL_CURRENT_RASTER_POSITION, 4, v);
  append(gl, GL_CURRENT_RASTER_DISTANCE, 1, v);
  return v;
}

Values attributes(const Gl& gl) {
  Values v;
  append(gl, GL_CURRENT_RASTER_COLOR, 4, v);
  append(gl, GL_CURRENT_RASTER_SECONDARY_COLOR, 4, v);
  for (GLenum unit = GL_TEXTURE0; unit < GL_TEXTURE0 + 3; unit++) {
    gl.ActiveTexture(unit);
    append(gl, GL_CURRENT_RASTER_TEXTURE_COORDS, 4, v);
  }
  gl.ActiveTexture(GL_TEXTURE0);
  return v;
}

/// A camera, current attributes and raster positions, of which the last valid one is seen.
void random_positions(const Gl& gl, Random& r) {
  gl.Viewport(r.integer(-20, 20), r.integer(-20, 20), r.integer(1, 90), r.integer(1, 90));
  if (r.chance(50)) gl.DepthRange(r.real(0, 1), r.real(0, 1));
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  if (r.chance(50)) gl.Frustum(-1, 1, -0.7, 1.2, 1, 9);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Translatef(r.real(-1, 1), r.real(-1, 1), r.real(-3, 0));
  gl.Rotatef(r.real(-180, 180), r.real(-1, 1), 1, r.real(-1, 1));
  if (r.chance(40)) gl.Scalef(r.real(0.5f, 2), r.real(0.5f, 2), r.real(0.5f, 2));
  if (r.chance(30)) {
    const GLdouble plane[4] = {r.real(-1, 1), r.real(-1, 1), r.real(-1, 1), r.real(-0.5f, 0.5f)};
    gl.ClipPlane(GL_CLIP_PLANE2, plane);
    gl.Enable(GL_CLIP_PLANE2);
  }
  gl.Fogi(GL_FOG_COORDINATE_SOURCE, r.pick({GL_FRAGMENT_DEPTH, GL_FOG_COORDINATE}));
  gl.FogCoordf(r.real(0, 5));
  gl.Color4f(r.real(0, 1), r.real(0, 1), r.real(0, 1), r.real(0, 1));
  gl.SecondaryColor3f(r.real(0, 1), r.real(0, 1), r.real(0, 1));
  gl.MultiTexCoord4f(GL_TEXTURE0, r.real(-2, 2), r.real(-2, 2), r.real(-2, 2), r.real(1, 2));
  gl.MultiTexCoord2f(GL_TEXTURE2, r.real(-2, 2), r.real(-2, 2));
  gl.MatrixMode(GL_TEXTURE);
  gl.LoadIdentity();
  if (r.chance(50)) gl.Rotatef(r.real(-180, 180), 0, 0, 1);
  for (int i = 0; i < 3; i++)
    if (r.chance(15))
      gl.WindowPos3f(r.real(-9, 99), r.real(-9, 99), r.real(-0.2f, 1.2f));
    else
      gl.RasterPos4f(r.real(-1.5f, 1.5f), r.real(-1.5f, 1.5f), r.real(-1.5f, 1.5f),
                     r.chance(70) ? 1.0f : r.real(0.5f, 2));
}

TEST_CASE("Raster positions are OSMesa's, bit for bit", "[spec][pixels]") {
  int valid = 0;
  for (unsigned seed = 0; seed < 400; seed++) {
    CurrentContext ours(softgl_library(), GL_UNSIGNED_BYTE);
    Random a(seed);
    random_positions(softgl_library(), a);
    const Values p = position(softgl_library()), with_p = attributes(softgl_library());
    CurrentContext theirs(osmesa_library(), GL_UNSIGNED_BYTE);
    Random b(seed);
    random_positions(osmesa_library(), b);
    INFO("seed " << seed);
    CHECK(p == position(osmesa_library()));
    valid += p[0] != 0;
    const Values expected = attributes(osmesa_library());
    for (size_t i = 0; i < 8; i++) CHECK(with_p[i] == expected[i]); // colors
    // Coordinates are a vertex's, whose sums of four products up to 4 have another order: three roundings of
    // 2^-22 at most.
    for (size_t i = 8; i < expected.size(); i++)
      CHECK(std::fabs(with_p[i] - expected[i]) <= 3.0f / (1 << 22));
  }
  CHECK(valid > 100);
  CHECK(valid < 300);
}

TEST_CASE("Every form of glRasterPos and glWindowPos means the same", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl, GL_UNSIGNED_BYTE);
  gl.MatrixMode(GL_PROJECTION);
  gl.Ortho(-10, 10, -10, 10, -10, 10);
  const GLdouble d[4] = {3, -2, 4, 1};
  const GLfloat f[4] = {3, -2, 4, 1};
  const GLint i[4] = {3, -2, 4, 1};
  const GLshort s[4] = {3, -2, 4, 1};
  gl.RasterPos4f(3, -2, 4, 1);
  const Values of_four = position(gl);
  gl.RasterPos4f(3, -2, 0, 1);
  const Values of_two = position(gl);
  gl.WindowPos3f(3, -2, 4);
  const Values window3 = position(gl);
  gl.WindowPos3f(3, -2, 0);
  const Values window2 = position(gl);
  const std::vector<std::pair<const Values*, std::function<void()>>> forms = {
#define FORMS(t, values) \
  {&of_two, [&] { gl.RasterPos2##t(values[0], values[1]); }}, \
      {&of_two, [&] { gl.RasterPos2##t##v(values); }}, \
      {&of_four, [&] { gl.RasterPos3##t(values[0], values[1], values[2]); }}, \
      {&of_four, [&] { gl.RasterPos3##t##v(values); }}, \
      {&of_four, [&] { gl.RasterPos4##t(values[0], values[1], values[2], values[3]); }}, \
      {&of_four, [&] { gl.RasterPos4##t##v(values); }}, \
      {&window2, [&] { gl.WindowPos2##t(values[0], values[1]); }}, \
      {&window2, [&] { gl.WindowPos2##t##v(values); }}, \
      {&window3, [&] { gl.WindowPos3##t(values[0], values[1], values[2]); }}, { \
    &window3, [&] { gl.WindowPos3##t##v(values); } \
  }
      FORMS(d, d), FORMS(f, f), FORMS(i, i), FORMS(s, s)
#undef FORMS
  };
  for (size_t k = 0; k < forms.size(); k++) {
    INFO("form " << k);
    gl.WindowPos2f(50, 50);
    forms[k].second();
    CHECK(position(gl) == *forms[k].first);
    gl.WindowPos2f(50, 50);
    gl.NewList(1, GL_COMPILE);
    forms[k].second();
    gl.EndList();
    CHECK(position(gl) != *forms[k].first);
    gl.CallList(1);
    CHECK(position(gl) == *forms[k].first);
  }
  gl.Begin(GL_POINTS);
  gl.RasterPos2f(0, 0);
  gl.End();
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.Begin(GL_POINTS);
  gl.WindowPos2f(0, 0);
  gl.End();
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
}

TEST_CASE("A window position has the current attributes", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.Color4f(0.25f, 2, 0.5f, 1);
  gl.TexCoord2f(3, 4);
  gl.WindowPos2f(7, 8);
  const Values v = attributes(gl);
  CHECK(std::vector<GLfloat>(v.begin(), v.begin() + 4) == Values{0.25f, 1, 0.5f, 1});
  CHECK(std::vector<GLfloat>(v.begin() + 8, v.begin() + 12) == Values{3, 4, 0, 1});
}

TEST_CASE("A raster position out of view changes nothing but its validity", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl, GL_UNSIGNED_BYTE);
  gl.RasterPos2f(0.5f, 0.5f);
  Values before = position(gl);
  const Values with = attributes(gl);
  gl.Color3f(1, 0, 0);
  gl.RasterPos2f(1.5f, 0);
  before[0] = 0;
  CHECK(position(gl) == before);
  CHECK(attributes(gl) == with);
  gl.RasterPos3f(0, 0, NAN);
  CHECK(position(gl) == before);
  gl.RasterPos2f(0, 0);
  CHECK(position(gl)[0] == 1);
}

bool draws_point; // read by the scene

// A lit point, or its raster position, at a place where the light depends on everything.
void draw_lit(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.Enable(GL_LIGHTING);
  for (int i = 0; i < 3; i++) {
    const GLenum light = GLenum(GL_LIGHT0 + i);
    const Float4 color = r.color(), at = {r.real(-2, 2), r.real(-2, 2), r.real(0, 3), GLfloat(r.chance(60))};
    gl.Enable(light);
    gl.Lightfv(light, GL_DIFFUSE, color.data());
    gl.Lightfv(light, GL_SPECULAR, color.data());
    gl.Lightfv(light, GL_POSITION, at.data());
    gl.Lightf(light, GL_LINEAR_ATTENUATION, r.real(0, 0.5f));
    if (r.chance(30)) gl.Lightf(light, GL_SPOT_CUTOFF, 80);
  }
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, r.chance(50));
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, r.pick({GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR}));
  const GLfloat white[4] = {1, 1, 1, 1};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, r.real(0, 20));
  if (r.chance(40)) gl.Enable(GL_COLOR_MATERIAL);
  gl.Color4f(r.real(0, 1), r.real(0, 1), r.real(0, 1), r.real(0, 1));
  const Float3 normal = r.direction();
  gl.Normal3f(normal[0], normal[1], std::fabs(normal[2]));
  gl.Translatef(0, 0, 0.1f);
  gl.Rotatef(r.real(-30, 30), 1, 1, 0);
  if (r.chance(30)) gl.Scalef(2, 2, 2);
  if (r.chance(50)) gl.Enable(GL_NORMALIZE);
  if (draws_point) {
    gl.PointSize(10);
    gl.Begin(GL_POINTS);
    gl.Vertex2f(0.1f, 0.1f);
    gl.End();
    gl.Finish();
    return;
  }
  gl.RasterPos2f(0.1f, 0.1f);
  GLfloat c[4], specular[4];
  gl.GetFloatv(GL_CURRENT_RASTER_COLOR, c);
  gl.GetFloatv(GL_CURRENT_RASTER_SECONDARY_COLOR, specular);
  gl.ClearColor(c[0] + specular[0], c[1] + specular[1], c[2] + specular[2], c[3]);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

TEST_CASE("A raster position is lit as a vertex is", "[spec][pixels]") {
  for (uint64_t seed = 0; seed < 100; seed++) {
    draws_point = true;
    const Picture point = draw(softgl_library(), {"lit", draw_lit}, seed);
    draws_point = false;
    const Picture cleared = draw(softgl_library(), {"lit", draw_lit}, seed);
    int equal = 0;
    for (size_t i = 0; i < point.color.size(); i += 4)
      equal += std::equal(&point.color[i], &point.color[i] + 4, &cleared.color[i]);
    INFO("seed " << seed);
    CHECK(equal >= 100);
  }
}

// In OSMesa their coordinates are not transformed (reference/DEVIATIONS.md).
TEST_CASE("pixels have the transformed texture coordinates of the raster position", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLubyte texels[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  const GLubyte black[4] = {0, 0, 0, 255};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.MatrixMode(GL_TEXTURE);
  gl.Scalef(3, 1, 1);
  gl.TexCoord2f(0.25f, 0.25f);
  gl.RasterPos2f(0, 0);
  GLfloat coordinates[4];
  gl.GetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, coordinates);
  CHECK(coordinates[0] == 0.75f);
  gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, black);
  GLubyte pixel[4];
  gl.ReadPixels(32, 32, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  CHECK(pixel[0] == 0);
  CHECK(pixel[1] == 255); // the right texel
}

} // namespace

TEST_CASE("a bitmap without an image moves the raster position, in lists, too",
          "[spec][raster_position][deviation]") {
  const Gl& gl = softgl_library();
  const CurrentContext context(gl);
  for (const GLenum list : {GL_NONE, GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    INFO("list " << list);
    gl.WindowPos2i(5, 6);
    if (list) gl.NewList(1, list);
    gl.Bitmap(0, 0, 0, 0, 10, 3, nullptr);
    if (list) gl.EndList();
    if (list == GL_COMPILE) gl.CallList(1);
    GLfloat position[4] = {};
    gl.GetFloatv(GL_CURRENT_RASTER_POSITION, position);
    CHECK(position[0] == 15);
    CHECK(position[1] == 9);
    CHECK(gl.GetError() == GL_NO_ERROR);
  }
}

} // namespace softgl::test
