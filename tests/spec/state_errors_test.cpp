// GL 1.5: every argument that a state command must refuse. The error is the specification's, and nothing has
// changed.
#include <catch2/catch.hpp>
#include <cmath>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

constexpr float kFour[4] = {1, 2, 3, 4};
constexpr float kNegative[4] = {-1, -1, -1, -1};
constexpr double kPlane[4] = {1, 2, 3, 4};

const BadCall bad_calls[] = {
    // 2.11 transformation
    BAD(INVALID_ENUM, MatrixMode(GL_COLOR)),
    BAD(INVALID_ENUM, MatrixMode(0)),
    BAD(INVALID_VALUE, Frustum(-1, 1, -1, 1, 0, 1)),
    BAD(INVALID_VALUE, Frustum(-1, 1, -1, 1, 1, -1)),
    BAD(INVALID_VALUE, Frustum(1, 1, -1, 1, 1, 2)),
    BAD(INVALID_VALUE, Frustum(-1, 1, 2, 2, 1, 2)),
    BAD(INVALID_VALUE, Frustum(-1, 1, -1, 1, 2, 2)),
    BAD(INVALID_VALUE, Ortho(1, 1, 0, 1, 0, 1)),
    BAD(INVALID_VALUE, Ortho(0, 1, 1, 1, 0, 1)),
    BAD(INVALID_VALUE, Ortho(0, 1, 0, 1, 3, 3)),
    BAD(STACK_UNDERFLOW, PopMatrix()),
    BAD(INVALID_VALUE, Viewport(0, 0, -1, 1)),
    BAD(INVALID_VALUE, Viewport(0, 0, 1, -1)),
    BAD(INVALID_ENUM, ClipPlane(GL_CLIP_PLANE0 + 8, kPlane)),
    BAD(INVALID_ENUM, ClipPlane(0, kPlane)),
    BAD(INVALID_ENUM, ActiveTexture(GL_TEXTURE0 + 8)),
    BAD(INVALID_ENUM, ActiveTexture(0)),
    BAD(INVALID_ENUM, ClientActiveTexture(GL_TEXTURE0 + 8)),
    BAD(INVALID_ENUM, TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_REPEAT)),
    BAD(INVALID_ENUM, TexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP)),
    BAD(INVALID_ENUM, TexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP)),
    BAD(INVALID_ENUM, TexGeni(GL_S - 1, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR)),
    BAD(INVALID_ENUM, TexGenfv(GL_S, GL_TEXTURE_ENV, kFour)),
    BAD(INVALID_ENUM, TexGenf(GL_S, GL_OBJECT_PLANE, 1)),
    // 2.14 lighting
    BAD(INVALID_ENUM, Lightfv(GL_LIGHT0 + 8, GL_AMBIENT, kFour)),
    BAD(INVALID_ENUM, Lightfv(GL_LIGHT0 - 1, GL_AMBIENT, kFour)),
    BAD(INVALID_ENUM, Lightfv(GL_LIGHT0, GL_SHININESS, kFour)),
    BAD(INVALID_VALUE, Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, -0.5f)),
    BAD(INVALID_VALUE, Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 128.5f)),
    BAD(INVALID_VALUE, Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 90.5f)),
    BAD(INVALID_VALUE, Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, -1)),
    BAD(INVALID_VALUE, Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, -1)),
    BAD(INVALID_VALUE, Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -1)),
    BAD(INVALID_VALUE, Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, -1)),
    BAD(INVALID_ENUM, Lightf(GL_LIGHT0, GL_POSITION, 1)),
    BAD(INVALID_ENUM, LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_LIGHTING)),
    BAD(INVALID_ENUM, LightModeli(GL_LIGHTING, 1)),
    BAD(INVALID_ENUM, LightModelf(GL_LIGHT_MODEL_AMBIENT, 1)),
    BAD(INVALID_ENUM, Materialfv(GL_LEFT, GL_AMBIENT, kFour)),
    BAD(INVALID_ENUM, Materialfv(GL_FRONT, GL_POSITION, kFour)),
    BAD(INVALID_VALUE, Materialf(GL_FRONT, GL_SHININESS, -0.1f)),
    BAD(INVALID_VALUE, Materialf(GL_FRONT, GL_SHININESS, 128.1f)),
    BAD(INVALID_ENUM, ColorMaterial(GL_LEFT, GL_AMBIENT)),
    BAD(INVALID_ENUM, ColorMaterial(GL_FRONT, GL_SHININESS)),
    BAD(INVALID_ENUM, ColorMaterial(GL_FRONT, GL_COLOR_INDEXES)),
    BAD(INVALID_ENUM, ShadeModel(GL_FILL)),
    BAD(INVALID_ENUM, FrontFace(GL_FRONT)),
    // 3.3 to 3.5 rasterization
    BAD(INVALID_VALUE, PointSize(0)),
    BAD(INVALID_VALUE, PointSize(-1)),
    BAD(INVALID_VALUE, LineWidth(0)),
    BAD(INVALID_VALUE, PointParameterf(GL_POINT_SIZE_MIN, -1)),
    BAD(INVALID_VALUE, PointParameterf(GL_POINT_SIZE_MAX, -1)),
    BAD(INVALID_VALUE, PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, -1)),
    BAD(INVALID_ENUM, PointParameterf(GL_POINT_SIZE, 1)),
    BAD(INVALID_ENUM, CullFace(GL_CCW)),
    BAD(INVALID_ENUM, PolygonMode(GL_CCW, GL_LINE)),
    BAD(INVALID_ENUM, PolygonMode(GL_FRONT, GL_LINES)),
    // 3.6 pixels, 3.8.13 texture environment, 3.10 fog
    BAD(INVALID_ENUM, PixelTransferf(GL_ZOOM_X, 1)),
    BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_MODULATE)),
    BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_INTERPOLATE)),
    BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGB)),
    BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_TEXTURE0 + 8)),
    BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_NEAREST)),
    BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_SOURCE3_ALPHA_NV, GL_TEXTURE0 + 8)),
    BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_OPERAND3_ALPHA_NV, GL_SRC_COLOR)),
    BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGB_EXT)),
    BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_COLOR)),
    BAD(INVALID_VALUE, TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3)),
    BAD(INVALID_VALUE, TexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 0)),
    BAD(INVALID_ENUM, TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_ENV_MODE, 1)),
    BAD(INVALID_VALUE, TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, 2)),
    BAD(INVALID_ENUM, Fogi(GL_FOG_MODE, GL_NEAREST)),
    BAD(INVALID_VALUE, Fogf(GL_FOG_DENSITY, -1)),
    BAD(INVALID_ENUM, Fogf(GL_FOG, 1)),
    BAD(INVALID_ENUM, Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG)),
    BAD(INVALID_ENUM, Fogi(GL_FOG_DISTANCE_MODE_NV, GL_FRAGMENT_DEPTH)),
    BAD(INVALID_ENUM, Fogf(GL_FOG_COLOR, 1)),
    BAD(INVALID_VALUE, Fogfv(GL_FOG_DENSITY, kNegative)),
    // 4.1 fragments, 4.2 framebuffer
    BAD(INVALID_VALUE, Scissor(0, 0, -1, 1)),
    BAD(INVALID_VALUE, Scissor(0, 0, 1, -1)),
    BAD(INVALID_ENUM, AlphaFunc(GL_ALWAYS + 1, 0)),
    BAD(INVALID_ENUM, StencilFunc(GL_KEEP, 0, 0)),
    BAD(INVALID_ENUM, StencilOp(GL_KEEP, GL_ALWAYS, GL_KEEP)),
    BAD(INVALID_ENUM, StencilOp(GL_SET, GL_KEEP, GL_KEEP)),
    BAD(INVALID_ENUM, StencilFuncSeparate(GL_CCW, GL_LESS, 0, 0)),
    BAD(INVALID_ENUM, StencilFuncSeparate(GL_FRONT, GL_KEEP, 0, 0)),
    BAD(INVALID_ENUM, StencilFuncSeparateATI(GL_LESS, GL_KEEP, 0, 0)),
    BAD(INVALID_ENUM, StencilFuncSeparateATI(GL_KEEP, GL_LESS, 0, 0)),
    BAD(INVALID_ENUM, StencilOpSeparate(GL_LEFT, GL_KEEP, GL_KEEP, GL_KEEP)),
    BAD(INVALID_ENUM, StencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_LESS)),
    BAD(INVALID_ENUM, StencilMaskSeparate(GL_FRONT_LEFT, 0)),
    BAD(INVALID_ENUM, ActiveStencilFaceEXT(GL_FRONT_AND_BACK)),
    BAD(INVALID_VALUE, DepthBoundsEXT(0.5, 0.25)),
    BAD(INVALID_ENUM, ClipControl(GL_FRONT, GL_ZERO_TO_ONE)),
    BAD(INVALID_ENUM, ClipControl(GL_LOWER_LEFT, GL_UPPER_LEFT)),
    BAD(INVALID_ENUM, DepthFunc(GL_NEVER - 1)),
    BAD(INVALID_ENUM, BlendFunc(GL_SRC_ALPHA, GL_SRC_ALPHA_SATURATE)),
    BAD(INVALID_ENUM, BlendFunc(GL_FUNC_ADD, GL_ONE)),
    BAD(INVALID_ENUM, BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, 2)),
    BAD(INVALID_ENUM, BlendEquation(GL_ADD)),
    BAD(INVALID_ENUM, BlendEquationSeparate(GL_FUNC_ADD, GL_ONE)),
    BAD(INVALID_ENUM, BlendEquationSeparate(GL_ADD, GL_MIN)),
    BAD(INVALID_ENUM, LogicOp(GL_SET + 1)),
    BAD(INVALID_ENUM, DrawBuffer(GL_RGBA)),
    BAD(INVALID_OPERATION, DrawBuffer(GL_RIGHT)),
    BAD(INVALID_OPERATION, DrawBuffer(GL_AUX0)),
    BAD(INVALID_ENUM, ReadBuffer(GL_NONE)),
    BAD(INVALID_ENUM, ReadBuffer(GL_FRONT_AND_BACK)),
    BAD(INVALID_OPERATION, ReadBuffer(GL_FRONT_RIGHT)),
    // 5.6, 6.1
    BAD(INVALID_ENUM, Hint(GL_FOG, GL_NICEST)),
    BAD(INVALID_ENUM, Hint(GL_FOG_HINT, GL_FOG)),
    BAD(INVALID_ENUM, Enable(GL_FOG_MODE)),
    BAD(INVALID_ENUM, Enable(0)),
    BAD(INVALID_ENUM, Disable(0xffffffff)),
    BAD(INVALID_ENUM, EnableClientState(GL_FOG)),
    BAD(INVALID_ENUM, DisableClientState(GL_VERTEX_ARRAY_SIZE)),
    BAD(INVALID_ENUM, IsEnabled(GL_FOG_MODE)),
    BAD(INVALID_ENUM, Materialf(GL_FRONT, GL_AMBIENT, 1)),
    BAD(STACK_UNDERFLOW, PopAttrib()),
    BAD(STACK_UNDERFLOW, PopClientAttrib()),
};

} // namespace

REFUSAL_TEST_CASE("a refused argument gives the specification's error and changes nothing", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const StateSnapshot before = take_snapshot(gl, true), quick = take_snapshot(gl, false);
  expect_refused(gl, bad_calls, [&] { CHECK(compare_snapshots(quick, take_snapshot(gl, false)) == ""); });
  REQUIRE(compare_snapshots(before, take_snapshot(gl, true)).empty());
}

REFUSAL_TEST_CASE("glMaterial refuses its arguments between Begin and End as elsewhere", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const StateSnapshot before = take_snapshot(gl, false);
  static const BadCall calls[] = {
    BAD(INVALID_ENUM, Begin(GL_POINTS); gl.Materialf(GL_FRONT, GL_AMBIENT, 1); gl.End()),
    BAD(INVALID_ENUM, Begin(GL_POINTS); gl.Materiali(GL_FRONT, GL_COLOR_INDEXES, 1); gl.End()),
    BAD(INVALID_ENUM, Begin(GL_POINTS); gl.Materialf(GL_LEFT, GL_SHININESS, 1); gl.End()),
    BAD(INVALID_VALUE, Begin(GL_POINTS); gl.Materialf(GL_FRONT, GL_SHININESS, 129); gl.End())
  };
  expect_refused(gl, calls, [&] { CHECK(compare_snapshots(before, take_snapshot(gl, false)) == ""); });
}

TEST_CASE("a query that does not exist gives GL_INVALID_ENUM and writes nothing", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLfloat values[4] = {7, 7, 7, 7};
  const auto refused = [&] {
    const bool untouched = values[0] == 7 && values[1] == 7 && values[2] == 7 && values[3] == 7;
    return untouched && gl.GetError() == GL_INVALID_ENUM;
  };
  gl.GetFloatv(0, values);
  REQUIRE(refused());
  gl.GetFloatv(GL_RGBA, values);
  REQUIRE(refused());
  gl.GetLightfv(GL_LIGHT0 + 8, GL_AMBIENT, values);
  REQUIRE(refused());
  gl.GetLightfv(GL_LIGHT0, GL_SHININESS, values);
  REQUIRE(refused());
  gl.GetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, values);
  REQUIRE(refused());
  gl.GetMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, values);
  REQUIRE(refused());
  gl.GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS, values);
  REQUIRE(refused());
  gl.GetTexGenfv(GL_S, GL_TEXTURE_ENV_MODE, values);
  REQUIRE(refused());
}

TEST_CASE("the first error stays until it is read", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.Viewport(0, 0, -1, 0);
  gl.Enable(0);
  gl.PopMatrix();
  REQUIRE(gl.GetError() == GL_INVALID_VALUE);
  REQUIRE(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("state commands between Begin and End are refused and change nothing", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const StateSnapshot before = take_snapshot(gl, true);
  void (*const calls[])(const Gl&) = {
      [](const Gl& g) { g.Enable(GL_FOG); },
      [](const Gl& g) { g.Disable(GL_DITHER); },
      [](const Gl& g) { g.MatrixMode(GL_TEXTURE); },
      [](const Gl& g) { g.Translatef(1, 2, 3); },
      [](const Gl& g) { g.PushMatrix(); },
      [](const Gl& g) { g.Lightfv(GL_LIGHT1, GL_DIFFUSE, kFour); },
      [](const Gl& g) { g.ShadeModel(GL_FLAT); },
      [](const Gl& g) { g.PointSize(3); },
      [](const Gl& g) { g.Fogf(GL_FOG_END, 3); },
      [](const Gl& g) { g.BlendFunc(GL_ONE, GL_ONE); },
      [](const Gl& g) { g.DepthMask(0); },
      [](const Gl& g) { g.Scissor(1, 1, 1, 1); },
      [](const Gl& g) { g.Viewport(1, 1, 1, 1); },
      [](const Gl& g) { g.PushAttrib(GL_ALL_ATTRIB_BITS); },
      [](const Gl& g) { g.Hint(GL_FOG_HINT, GL_NICEST); },
      [](const Gl& g) { g.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD); },
      [](const Gl& g) { g.ActiveTexture(GL_TEXTURE1); },
      [](const Gl& g) { g.ClipPlane(GL_CLIP_PLANE0, kPlane); },
      [](const Gl& g) { g.ColorMaterial(GL_FRONT, GL_AMBIENT); },
      [](const Gl& g) { g.ClearColor(1, 1, 1, 1); },
      [](const Gl& g) {
        GLint v;
        g.GetIntegerv(GL_FOG_MODE, &v);
      },
      [](const Gl& g) { g.IsEnabled(GL_FOG); }};
  for (auto call : calls) {
    gl.Begin(GL_POINTS);
    call(gl);
    gl.End();
    REQUIRE(gl.GetError() == GL_INVALID_OPERATION);
  }
  REQUIRE(compare_snapshots(before, take_snapshot(gl, true)).empty());
}
