#include "spec/state_commands.h"

#include <array>
#include <cmath>
#include <sstream>

#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

template <class... A> std::string format(const char* name, const A&... a) {
  std::ostringstream s;
  s.precision(9);
  s << name << "(";
  [[maybe_unused]] const char* separator = "";
  ((s << separator << +a, separator = ", "), ...);
  s << ")";
  return s.str();
}

template <class F, class... A> StateCommand call(const char* name, F Gl::*member, A... a) {
  return {format(name, a...), [=](const Gl& gl) { (gl.*member)(a...); }};
}
#define CALL(name, ...) call("gl" #name, &Gl::name __VA_OPT__(, ) __VA_ARGS__)

// A command whose last argument is a vector.
template <class F, class T, size_t N, class... A>
StateCommand call_v(const char* name, F Gl::*member, std::array<T, N> v, A... a) {
  std::string text = format(name, a...) + " {";
  for (T x : v) text += std::to_string(x) + " ";
  return {text + "}", [=](const Gl& gl) { (gl.*member)(a..., v.data()); }};
}
#define CALLV(name, vector, ...) call_v("gl" #name, &Gl::name, vector __VA_OPT__(, ) __VA_ARGS__)

float number(Random& r) {
  if (r.chance(3)) return r.pick({1e20f, -1e20f, 1e-30f, -1e-42f, INFINITY, -INFINITY, NAN, -0.0f});
  switch (r.integer(0, 9)) {
  case 0: return 0;
  case 1: return 1;
  case 2: return -1;
  case 3: return float(r.integer(-3, 200));
  case 4: return r.real(-1000, 1000);
  case 5: return r.real(0, 1);
  default: return r.real(-3, 3);
  }
}
GLint whole(Random& r) { return r.chance(30) ? r.integer(-70000, 70000) : r.integer(-2, 300); }
std::array<float, 4> vector4(Random& r) {
  std::array<float, 4> v;
  for (float& x : v) x = number(r);
  return v;
}
std::array<GLint, 4> integers4(Random& r) {
  std::array<GLint, 4> v;
  for (GLint& x : v) x = r.chance(50) ? GLint(r.bits()) : r.integer(-3, 9);
  return v;
}
std::array<float, 16> matrix(Random& r) {
  std::array<float, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const int kind = r.integer(0, 4);
  if (kind == 0)
    for (float& x : m) x = number(r);
  if (kind == 1)
    for (int i : {0, 5, 10, 12, 13, 14}) m[size_t(i)] = number(r);
  if (kind == 2)
    for (int i : {0, 1, 4, 5, 12, 13}) m[size_t(i)] = number(r);
  if (kind == 3)
    for (int c = 0; c < 4; ++c)
      for (int i = 0; i < 3; ++i) m[size_t(c * 4 + i)] = number(r);
  return m;
}

// Any token of any list below now and then, so that commands meet tokens that are good elsewhere.
GLenum token(Random& r, std::initializer_list<int> good) {
  if (r.chance(8))
    return r.pick<GLenum>({0, 1, 2, 0x1234, 0xffffffff, GL_FRONT, GL_NICEST, GL_AMBIENT, GL_LINEAR,
                           GL_TEXTURE_2D, GL_NONE, GL_TEXTURE0 + 40, GL_SRC_ALPHA, GL_LIGHT0, GL_MODELVIEW,
                           GL_RGBA, GL_FILL});
  return GLenum(r.pick(good));
}
#define ANY(...) token(r, {__VA_ARGS__})

GLenum capability(Random& r) {
  static const std::vector<GLenum> tokens = [] {
    std::vector<GLenum> t;
    for (const StateRow& row : state_rows())
      if (row.kind == 'C') t.push_back(row.token);
    return t;
  }();
  return r.chance(4) ? ANY(GL_FOG) : tokens[size_t(r.integer(0, int(tokens.size()) - 1))];
}

StateCommand matrix_command(Random& r) {
  switch (r.integer(0, 11)) {
  case 0: return CALL(MatrixMode, ANY(GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE));
  case 1: return CALL(LoadIdentity);
  case 2: return CALLV(LoadMatrixf, matrix(r));
  case 3: return CALLV(MultMatrixf, matrix(r));
  case 4: return CALLV(LoadTransposeMatrixf, matrix(r));
  case 5: {
    float a = number(r) * 30, x = number(r), y = r.chance(30) ? 0 : number(r),
          z = r.chance(30) ? 0 : number(r);
    return CALL(Rotatef, a, x, y, z);
  }
  case 6: {
    float x = number(r), y = number(r), z = number(r);
    return CALL(Translatef, x, y, z);
  }
  case 7: {
    float x = number(r), y = r.chance(50) ? x : number(r), z = r.chance(50) ? x : number(r);
    return CALL(Scalef, x, y, z);
  }
  case 8: {
    double v[6];
    for (double& x : v) x = number(r);
    return CALL(Frustum, v[0], v[1], v[2], v[3], v[4], v[5]);
  }
  case 9: {
    double v[6];
    for (double& x : v) x = number(r);
    return CALL(Ortho, v[0], v[1], v[2], v[3], v[4], v[5]);
  }
  case 10: return CALL(PushMatrix);
  default: return CALL(PopMatrix);
  }
}

StateCommand lighting_command(Random& r) {
  const GLenum light = ANY(GL_LIGHT0, GL_LIGHT1, GL_LIGHT2, GL_LIGHT7, GL_LIGHT0 + 8);
  const GLenum pname =
      ANY(GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_POSITION, GL_SPOT_DIRECTION, GL_SPOT_EXPONENT,
          GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION);
  const GLenum face = ANY(GL_FRONT, GL_BACK, GL_FRONT_AND_BACK);
  const GLenum parameter = ANY(GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS,
                               GL_AMBIENT_AND_DIFFUSE, GL_COLOR_INDEXES);
  switch (r.integer(0, 11)) {
  case 0:
  case 1: return CALLV(Lightfv, vector4(r), light, pname);
  case 2: return CALLV(Lightiv, integers4(r), light, pname);
  case 3:
    return CALL(Lightf, light,
                ANY(GL_SPOT_EXPONENT, GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION),
                number(r));
  case 4:
    return CALLV(LightModelfv, vector4(r),
                 ANY(GL_LIGHT_MODEL_AMBIENT, GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHT_MODEL_TWO_SIDE));
  case 5:
    return CALL(LightModeli, ANY(GL_LIGHT_MODEL_COLOR_CONTROL, GL_LIGHT_MODEL_TWO_SIDE),
                GLint(ANY(GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR)));
  case 6:
  case 7: return CALLV(Materialfv, vector4(r), face, parameter);
  case 8: return CALLV(Materialiv, integers4(r), face, parameter);
  case 9: return CALL(ColorMaterial, face, parameter);
  case 10: return CALL(ShadeModel, ANY(GL_FLAT, GL_SMOOTH));
  default: {
    auto v = vector4(r);
    return CALL(Color4f, v[0], v[1], v[2], v[3]);
  }
  }
}

StateCommand fragment_command(Random& r) {
  const auto comparison = [&] {
    return ANY(GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS);
  };
  const auto operation = [&] {
    return ANY(GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP);
  };
  const auto factor = [&] {
    return ANY(GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_DST_COLOR, GL_ONE_MINUS_DST_ALPHA,
               GL_SRC_ALPHA, GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA);
  };
  const auto equation = [&] {
    return ANY(GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX);
  };
  const auto face = [&] { return ANY(GL_FRONT, GL_BACK, GL_FRONT_AND_BACK); };
  switch (r.integer(0, 31)) {
  case 0: {
    float v = number(r);
    return CALL(AlphaFunc, comparison(), v);
  }
  case 1: {
    GLint ref = whole(r);
    return CALL(StencilFunc, comparison(), ref, GLuint(r.bits()));
  }
  case 2: {
    GLenum a = operation(), b = operation();
    return CALL(StencilOp, a, b, operation());
  }
  case 3: return CALL(DepthFunc, comparison());
  case 4: {
    GLenum a = factor();
    return CALL(BlendFunc, a, factor());
  }
  case 5: {
    GLenum a = factor(), b = factor(), d = factor();
    return CALL(BlendFuncSeparate, a, b, d, factor());
  }
  case 6: return CALL(BlendEquation, equation());
  case 7: {
    auto v = vector4(r);
    return CALL(BlendColor, v[0], v[1], v[2], v[3]);
  }
  case 8: return CALL(LogicOp, ANY(GL_CLEAR, GL_AND, GL_COPY, GL_XOR, GL_NAND, GL_SET, GL_SET + 1));
  case 9:
    return CALL(DrawBuffer, ANY(GL_FRONT, GL_BACK, GL_NONE, GL_LEFT, GL_RIGHT, GL_AUX0, GL_FRONT_AND_BACK,
                                GL_FRONT_LEFT, GL_BACK_RIGHT));
  // GL_NONE and GL_FRONT_AND_BACK, which OSMesa takes and GL 1.5, 4.3.2 does not, have a test of their own.
  case 10:
    return CALL(ReadBuffer, GLenum(r.pick({GL_FRONT, GL_BACK, GL_LEFT, GL_RIGHT, GL_AUX1, GL_FRONT_LEFT,
                                           GL_BACK_RIGHT, GL_AMBIENT})));
  case 11: {
    GLboolean a = r.chance(50), b = r.chance(50), d = r.chance(50);
    return CALL(ColorMask, a, b, d, GLboolean(r.chance(50)));
  }
  case 12: return CALL(DepthMask, GLboolean(r.chance(50)));
  case 13: return CALL(StencilMask, GLuint(r.bits()));
  case 14: return CALL(IndexMask, GLuint(r.bits()));
  case 15: {
    GLint x = whole(r), y = whole(r), w = whole(r);
    return CALL(Scissor, x, y, w, whole(r));
  }
  case 16: {
    float v = number(r);
    return CALL(SampleCoverage, v, GLboolean(r.chance(50)));
  }
  case 17:
    return CALLV(Fogfv, vector4(r),
                 ANY(GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END, GL_FOG_INDEX, GL_FOG_COLOR));
  case 18:
    return CALL(Fogi, ANY(GL_FOG_MODE, GL_FOG_COORDINATE_SOURCE, GL_FOG_DISTANCE_MODE_NV),
                GLint(ANY(GL_LINEAR, GL_EXP, GL_EXP2, GL_FOG_COORDINATE, GL_FRAGMENT_DEPTH, GL_EYE_PLANE,
                          GL_EYE_RADIAL_NV, GL_EYE_PLANE_ABSOLUTE_NV)));
  case 19: return CALLV(Fogiv, integers4(r), ANY(GL_FOG_DENSITY, GL_FOG_START, GL_FOG_COLOR));
  case 20: {
    auto v = vector4(r);
    return CALL(ClearColor, v[0], v[1], v[2], v[3]);
  }
  case 21: return CALL(ClearDepth, double(number(r)));
  case 22: return CALL(ClearStencil, whole(r));
  case 23: return CALL(ClearIndex, number(r));
  case 24: {
    GLenum rgb = equation();
    return CALL(BlendEquationSeparate, rgb, equation());
  }
  case 25: {
    GLenum f = face(), function = comparison();
    GLint ref = whole(r);
    return CALL(StencilFuncSeparate, f, function, ref, GLuint(r.bits()));
  }
  case 26: {
    GLenum front = comparison(), back = comparison();
    GLint ref = whole(r);
    return CALL(StencilFuncSeparateATI, front, back, ref, GLuint(r.bits()));
  }
  case 27: {
    GLenum f = face(), a = operation(), b = operation();
    return CALL(StencilOpSeparate, f, a, b, operation());
  }
  case 28: {
    GLenum f = face();
    return CALL(StencilMaskSeparate, f, GLuint(r.bits()));
  }
  case 30: {
    double least = r.chance(70) ? r.real(0, 1) : number(r),
           greatest = r.chance(70) ? r.real(0, 1) : number(r);
    return CALL(DepthBoundsEXT, least, greatest);
  }
  case 29: return CALL(ActiveStencilFaceEXT, ANY(GL_FRONT, GL_FRONT, GL_BACK));
  default: {
    auto v = vector4(r);
    return CALL(ClearAccum, v[0], v[1], v[2], v[3]);
  }
  }
}

StateCommand raster_command(Random& r) {
  const GLenum face = ANY(GL_FRONT, GL_BACK, GL_FRONT_AND_BACK);
  switch (r.integer(0, 14)) {
  case 0: return CALL(PointSize, number(r));
  case 14: {
    GLenum origin = ANY(GL_LOWER_LEFT, GL_UPPER_LEFT);
    return CALL(ClipControl, origin, ANY(GL_NEGATIVE_ONE_TO_ONE, GL_ZERO_TO_ONE));
  }
  case 1:
    return CALLV(PointParameterfv, vector4(r),
                 ANY(GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE,
                     GL_POINT_DISTANCE_ATTENUATION));
  case 2: return CALL(LineWidth, number(r));
  case 3: {
    GLint factor = whole(r);
    return CALL(LineStipple, factor, GLushort(r.bits()));
  }
  case 4: return CALL(CullFace, face);
  case 5: return CALL(FrontFace, ANY(GL_CW, GL_CCW));
  case 6: return CALL(PolygonMode, face, ANY(GL_POINT, GL_LINE, GL_FILL));
  case 7: {
    float a = number(r);
    return CALL(PolygonOffset, a, number(r));
  }
  case 8: {
    std::array<GLubyte, 4096> v;
    for (GLubyte& x : v) x = GLubyte(r.bits());
    return {"glPolygonStipple", [=](const Gl& gl) {
              GLint skip = 0; // OSMesa 22.3.6 writes a byte behind its stipple where this is no multiple of 8
              gl.GetIntegerv(GL_UNPACK_SKIP_PIXELS, &skip);
              gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, skip & ~7);
              gl.PolygonStipple(v.data());
            }};
  }
  case 9: {
    GLint x = whole(r), y = whole(r), w = whole(r);
    return CALL(Viewport, x, y, w, whole(r));
  }
  case 10: {
    double n = number(r);
    return CALL(DepthRange, n, double(number(r)));
  }
  case 11: {
    std::array<double, 4> v;
    for (double& x : v) x = number(r);
    return CALLV(ClipPlane, v, ANY(GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE5 + 2, GL_CLIP_PLANE5 + 3));
  }
  case 12:
    return CALL(Hint,
                ANY(GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT,
                    GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT, GL_GENERATE_MIPMAP_HINT,
                    GL_TEXTURE_COMPRESSION_HINT),
                ANY(GL_NICEST, GL_FASTEST, GL_DONT_CARE));
  default:
    return CALL(PointParameteri, GLenum(GL_POINT_SPRITE_COORD_ORIGIN),
                GLint(ANY(GL_UPPER_LEFT, GL_LOWER_LEFT)));
  }
}

StateCommand texture_command(Random& r) {
  const GLenum coord = ANY(GL_S, GL_T, GL_R, GL_Q);
  const GLenum target = ANY(GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP);
  switch (r.integer(0, 12)) {
  // Units 8 and above exist in OSMesa, for shaders; here they are an error (2.7), tested elsewhere.
  // Unit 7: when PopAttrib makes it active, OSMesa's texture matrix commands go on with the matrix of another
  // unit.
  case 0: return CALL(ActiveTexture, GLenum(GL_TEXTURE0) + GLenum(r.integer(0, 6)));
  case 1: return CALL(ClientActiveTexture, GLenum(GL_TEXTURE0) + GLenum(r.integer(0, 7)));
  case 2:
    return CALL(TexEnvi, GLenum(GL_TEXTURE_ENV), GLenum(GL_TEXTURE_ENV_MODE),
                GLint(ANY(GL_MODULATE, GL_BLEND, GL_DECAL, GL_REPLACE, GL_ADD, GL_COMBINE, GL_COMBINE4_NV,
                          GL_REPLACE_EXT)));
  case 3: return CALLV(TexEnvfv, vector4(r), GLenum(GL_TEXTURE_ENV), GLenum(GL_TEXTURE_ENV_COLOR));
  case 4:
    return CALL(
        TexEnvi, GLenum(GL_TEXTURE_ENV), ANY(GL_COMBINE_RGB, GL_COMBINE_ALPHA),
        GLint(r.pick({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT,
                      GL_DOT3_RGB, GL_DOT3_RGBA, GL_LINEAR, GL_MODULATE_ADD_ATI, GL_MODULATE_SIGNED_ADD_ATI,
                      GL_MODULATE_SUBTRACT_ATI, GL_DOT3_RGB_EXT, GL_DOT3_RGBA_EXT})));
  case 5:
    return CALL(TexEnvi, GLenum(GL_TEXTURE_ENV),
                ANY(GL_SOURCE0_RGB, GL_SOURCE1_RGB, GL_SOURCE2_RGB, GL_SOURCE0_ALPHA, GL_SOURCE1_ALPHA,
                    GL_SOURCE2_ALPHA, GL_SOURCE3_RGB_NV, GL_SOURCE3_ALPHA_NV),
                GLint(r.pick({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS, GL_TEXTURE0,
                              GL_TEXTURE5, GL_LINEAR, GL_ZERO, GL_ONE})));
  case 6:
    return CALL(TexEnvi, GLenum(GL_TEXTURE_ENV),
                ANY(GL_OPERAND0_RGB, GL_OPERAND1_RGB, GL_OPERAND2_RGB, GL_OPERAND0_ALPHA, GL_OPERAND1_ALPHA,
                    GL_OPERAND2_ALPHA, GL_OPERAND3_RGB_NV, GL_OPERAND3_ALPHA_NV),
                GLint(ANY(GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)));
  case 7:
    return CALL(TexEnvf, GLenum(GL_TEXTURE_ENV), ANY(GL_RGB_SCALE, GL_ALPHA_SCALE), float(r.integer(0, 4)));
  case 8:
    return r.chance(50)
               ? CALL(TexEnvf, GLenum(GL_TEXTURE_FILTER_CONTROL), GLenum(GL_TEXTURE_LOD_BIAS), number(r))
               : CALL(TexEnvi, GLenum(GL_POINT_SPRITE), GLenum(GL_COORD_REPLACE), r.integer(0, 2));
  case 9:
    return CALL(TexGeni, coord, GLenum(GL_TEXTURE_GEN_MODE),
                GLint(ANY(GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP)));
  case 10: return CALLV(TexGenfv, vector4(r), coord, ANY(GL_OBJECT_PLANE, GL_EYE_PLANE));
  // Every name keeps to one target, so that nothing depends on what was bound before.
  case 11: {
    const int i = r.integer(0, 3);
    return CALL(
        BindTexture,
        std::array<GLenum, 4>{GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP}[size_t(i)],
        r.chance(30) ? 0u : GLuint(1 + i + 4 * r.integer(0, 1)));
  }
  default:
    (void)target;
    return CALL(MultiTexCoord4f, GLenum(GL_TEXTURE0) + GLenum(r.integer(0, 7)), number(r), 1.0f, 2.0f, 3.0f);
  }
}

StateCommand pixel_command(Random& r) {
  switch (r.integer(0, 5)) {
  case 0:
    return CALL(PixelTransferf,
                ANY(GL_RED_SCALE, GL_GREEN_BIAS, GL_ALPHA_SCALE, GL_DEPTH_BIAS, GL_DEPTH_SCALE, GL_BLUE_BIAS,
                    GL_MAP_COLOR, GL_INDEX_SHIFT, GL_INDEX_OFFSET),
                number(r));
  case 1:
    return CALL(PixelTransferi, ANY(GL_INDEX_SHIFT, GL_INDEX_OFFSET, GL_MAP_STENCIL, GL_RED_BIAS), whole(r));
  case 2: {
    float x = number(r);
    return CALL(PixelZoom, x, number(r));
  }
  case 3: return CALL(PixelStorei, ANY(GL_UNPACK_ALIGNMENT, GL_PACK_ALIGNMENT), r.integer(-1, 9));
  case 4:
    return CALL(PixelStorei,
                ANY(GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_PACK_ROW_LENGTH,
                    GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES),
                r.integer(-1, 40));
  default:
    return CALL(PixelStorei,
                ANY(GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST,
                    GL_PACK_INVERT_MESA),
                r.integer(0, 2));
  }
}

StateCommand stack_command(Random& r) {
  switch (r.integer(0, 5)) {
  case 0: {
    GLbitfield mask = r.chance(30) ? GLbitfield(r.bits()) : 1u << r.integer(0, 19);
    if (r.chance(10)) mask = GL_MULTISAMPLE_BIT;
    if (mask & GL_ENABLE_BIT) mask |= GL_LIGHTING_BIT; // "GL_ENABLE_BIT saves which lights are on"
    // An inner level saves everything: OSMesa forgets what was changed inside of it and not saved by it, so
    // that the outer PopAttrib leaves it changed. "an outer PopAttrib restores what was changed inside an
    // inner one".
    return {format("glPushAttrib", mask), [=](const Gl& gl) {
              GLint depth = 0;
              gl.GetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
              gl.PushAttrib(depth > 0 ? GLbitfield(GL_ALL_ATTRIB_BITS) : mask);
            }};
  }
  case 1:
  case 2: return CALL(PopAttrib);
  case 3: return CALL(PushClientAttrib, GLbitfield(r.integer(0, 3)));
  case 4: return CALL(PopClientAttrib);
  default:
    return r.chance(50) ? CALL(EnableClientState,
                               ANY(GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY))
                        : CALL(DisableClientState, ANY(GL_VERTEX_ARRAY, GL_EDGE_FLAG_ARRAY,
                                                       GL_TEXTURE_COORD_ARRAY, GL_INDEX_ARRAY));
  }
}

StateCommand grid_command(Random& r) {
  const GLint un = r.integer(-1, 40), vn = r.integer(-1, 40);
  const float u1 = number(r), u2 = number(r), v1 = number(r), v2 = number(r);
  switch (r.integer(0, 3)) {
  case 0: return CALL(MapGrid1f, un, u1, u2);
  case 1: return CALL(MapGrid1d, un, double(u1), double(u2));
  case 2: return CALL(MapGrid2f, un, u1, u2, vn, v1, v2);
  default: return CALL(MapGrid2d, un, double(u1), double(u2), vn, double(v1), double(v2));
  }
}

} // namespace

StateCommand random_state_command(Random& r) {
  switch (r.integer(0, 9)) {
  case 0:
  case 1: return matrix_command(r);
  case 2: return lighting_command(r);
  case 3: return fragment_command(r);
  case 4: return raster_command(r);
  case 5: return texture_command(r);
  case 6: return pixel_command(r);
  case 7: return r.chance(85) ? stack_command(r) : grid_command(r);
  default: return r.chance(50) ? CALL(Enable, capability(r)) : CALL(Disable, capability(r));
  }
}

} // namespace softgl::test
