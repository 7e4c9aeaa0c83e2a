#include "fuzz/commands.h"

#include <cmath>
#include <limits>
#include <vector>

namespace softgl::test {

namespace {

// Enumerants of every chapter, and some that no chapter knows.
GLenum any_enum(Random& r) {
  return GLenum(r.pick({0,
                        1,
                        2,
                        4,
                        7,
                        9,
                        15,
                        0xdead,
                        -1,
                        GL_NEVER,
                        GL_LESS,
                        GL_ALWAYS,
                        GL_FRONT,
                        GL_BACK,
                        GL_FRONT_AND_BACK,
                        GL_CW,
                        GL_CCW,
                        GL_POINT,
                        GL_LINE,
                        GL_FILL,
                        GL_MODELVIEW,
                        GL_PROJECTION,
                        GL_TEXTURE,
                        GL_FLAT,
                        GL_SMOOTH,
                        GL_EXP,
                        GL_LINEAR,
                        GL_NEAREST,
                        GL_REPEAT,
                        GL_CLAMP,
                        GL_TEXTURE_2D,
                        GL_LIGHTING,
                        GL_LIGHT0,
                        GL_LIGHT7,
                        GL_LIGHT0 + 8,
                        GL_CLIP_PLANE0,
                        GL_CLIP_PLANE5,
                        GL_AMBIENT,
                        GL_DIFFUSE,
                        GL_POSITION,
                        GL_SPOT_CUTOFF,
                        GL_SHININESS,
                        GL_COLOR_INDEXES,
                        GL_RGBA,
                        GL_RGB,
                        GL_UNSIGNED_BYTE,
                        GL_FLOAT,
                        GL_UNSIGNED_INT,
                        GL_INT,
                        GL_BLEND,
                        GL_FOG,
                        GL_DEPTH_TEST,
                        GL_FOG_MODE,
                        GL_FOG_DENSITY,
                        GL_FOG_COLOR,
                        GL_ZERO,
                        GL_ONE,
                        GL_SRC_ALPHA,
                        GL_FUNC_ADD,
                        GL_MIN,
                        GL_CLEAR,
                        GL_SET,
                        GL_ARRAY_BUFFER,
                        GL_STATIC_DRAW,
                        GL_COMPILE,
                        GL_TEXTURE_ENV,
                        GL_TEXTURE_ENV_MODE,
                        GL_MODULATE,
                        GL_COMBINE,
                        GL_COMBINE_RGB,
                        GL_TEXTURE_MIN_FILTER,
                        GL_TEXTURE_WRAP_S,
                        GL_VERTEX_ARRAY,
                        GL_COLOR_ARRAY,
                        GL_NORMAL_ARRAY,
                        GL_UNPACK_ALIGNMENT,
                        GL_PACK_ROW_LENGTH}));
}
GLenum mostly(Random& r, std::initializer_list<int> good) {
  return r.chance(70) ? GLenum(r.pick(good)) : any_enum(r);
}
// The same without what OSMesa accepts against GL 1.5 (reference/DEVIATIONS.md): vertex arrays given to
// glEnable, names of vectors given to the scalar forms of commands, GL_ONE as a source of texture combiners,
// units of shaders (GL_COMBINE looks like one); nor is 10 among the enumerants, which became a primitive
// later.
GLenum mostly_without(Random& r, std::initializer_list<int> good, std::initializer_list<int> bad) {
  for (;;) {
    const GLenum value = mostly(r, good);
    bool taken = true;
    for (int b : bad) taken = taken && value != GLenum(b);
    if (taken) return value;
  }
}
GLenum capability(Random& r) {
  return mostly_without(r,
                        {GL_BLEND, GL_LIGHTING, GL_LIGHT0, GL_FOG, GL_DEPTH_TEST, GL_TEXTURE_2D,
                         GL_CLIP_PLANE0, GL_NORMALIZE, GL_CULL_FACE},
                        {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY});
}
GLenum scalar_name(Random& r, std::initializer_list<int> good) {
  return mostly_without(r, good, {GL_AMBIENT, GL_DIFFUSE, GL_POSITION, GL_FOG_COLOR, GL_COLOR_INDEXES});
}
GLint small(Random& r) { return r.pick({-1, 0, 1, 2, 3, 4, 5, 8, 16, 17, -100, 64}); }
GLfloat number(Random& r) {
  return r.pick({0.0f, -0.0f, 1.0f, -1.0f, 0.5f, 1e-30f, 1e30f, -1e30f, 90.0f, 91.0f, 128.0f, 129.0f, 180.0f,
                 std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                 std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::denorm_min()});
}
GLfloat tame(Random& r) {
  return r.pick({0.0f, 1.0f, -1.0f, 0.5f, 2.0f, 90.0f, 128.0f, 129.0f, 180.0f, -0.25f});
}

// Client memory that every pointer of the fuzzer points to. OSMesa refuses a stride of -1, and uses 65535:
// 256 such vertices.
alignas(16) unsigned char memory[1 << 25];
void* somewhere(Random& r) { return memory + r.integer(0, 1024); }

// clang-format off
#define COMMAND(name) {#name, [](const Gl& gl, Random& r) {
#define END }},

const FuzzCommand kCommands[] = {
  COMMAND(Enable) gl.Enable(capability(r)); END
  COMMAND(Disable) gl.Disable(capability(r)); END
  COMMAND(Begin) gl.Begin(mostly(r, {GL_TRIANGLES, GL_QUADS, GL_LINES, GL_POLYGON, GL_POINTS})); END
  COMMAND(End) gl.End(); (void)r; END
  COMMAND(Vertex3f) const Float3 v{number(r), number(r), number(r)}; gl.Vertex3f(v[0], v[1], v[2]); END
  COMMAND(Vertex4f) const Float4 v{number(r), number(r), number(r), number(r)}; gl.Vertex4f(v[0], v[1], v[2], v[3]); END
  COMMAND(Vertex2f) const Float2 v{tame(r), tame(r)}; gl.Vertex2f(v[0], v[1]); END
  COMMAND(Color4f) const Float4 v{number(r), number(r), number(r), number(r)}; gl.Color4f(v[0], v[1], v[2], v[3]); END
  COMMAND(Normal3f) const Float3 v{number(r), number(r), number(r)}; gl.Normal3f(v[0], v[1], v[2]); END
  COMMAND(TexCoord4f) const Float4 v{number(r), number(r), number(r), number(r)}; gl.TexCoord4f(v[0], v[1], v[2], v[3]); END
  COMMAND(MatrixMode) gl.MatrixMode(mostly(r, {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE})); END
  COMMAND(PushMatrix) gl.PushMatrix(); (void)r; END
  COMMAND(PopMatrix) gl.PopMatrix(); (void)r; END
  COMMAND(LoadIdentity) gl.LoadIdentity(); (void)r; END
  COMMAND(Rotatef) const Float4 v{number(r), number(r), number(r), number(r)}; gl.Rotatef(v[0], v[1], v[2], v[3]); END
  COMMAND(Scalef) const Float3 v{number(r), number(r), number(r)}; gl.Scalef(v[0], v[1], v[2]); END
  COMMAND(Frustum) const Float4 v{tame(r), tame(r), tame(r), tame(r)}; const float n = tame(r), f = tame(r); gl.Frustum(v[0], v[1], v[2], v[3], n, f); END
  COMMAND(Ortho) const Float4 v{tame(r), tame(r), tame(r), tame(r)}; const float n = tame(r), f = tame(r); gl.Ortho(v[0], v[1], v[2], v[3], n, f); END
  COMMAND(Viewport) const int x = small(r), y = small(r), w = small(r), h = small(r); gl.Viewport(x, y, w, h); END
  COMMAND(Scissor) const int x = small(r), y = small(r), w = small(r), h = small(r); gl.Scissor(x, y, w, h); END
  COMMAND(ClipControl) const GLenum o = mostly(r, {GL_LOWER_LEFT, GL_UPPER_LEFT}); gl.ClipControl(o, mostly(r, {GL_ZERO_TO_ONE, GL_NEGATIVE_ONE_TO_ONE})); END
  COMMAND(DepthBoundsEXT) const float n = number(r), f = number(r); gl.DepthBoundsEXT(n, f); END
  COMMAND(DepthRange) const float n = number(r), f = number(r); gl.DepthRange(n, f); END
  COMMAND(DepthFunc) gl.DepthFunc(mostly(r, {GL_LESS, GL_LEQUAL, GL_ALWAYS})); END
  COMMAND(AlphaFunc) const GLenum f = mostly(r, {GL_LESS, GL_GREATER}); gl.AlphaFunc(f, number(r)); END
  COMMAND(BlendFunc) const GLenum s = mostly(r, {GL_ONE, GL_SRC_ALPHA, GL_SRC_ALPHA_SATURATE}), d = mostly(r, {GL_ZERO, GL_ONE_MINUS_SRC_ALPHA}); gl.BlendFunc(s, d); END
  COMMAND(BlendEquation) gl.BlendEquation(mostly(r, {GL_FUNC_ADD, GL_MIN, GL_MAX})); END
  COMMAND(LogicOp) gl.LogicOp(mostly(r, {GL_CLEAR, GL_SET, GL_XOR})); END
  COMMAND(CullFace) gl.CullFace(mostly(r, {GL_FRONT, GL_BACK})); END
  COMMAND(FrontFace) gl.FrontFace(mostly(r, {GL_CW, GL_CCW})); END
  COMMAND(ShadeModel) gl.ShadeModel(mostly(r, {GL_FLAT, GL_SMOOTH})); END
  COMMAND(PointSize) gl.PointSize(number(r)); END
  COMMAND(LineWidth) gl.LineWidth(number(r)); END
  COMMAND(PolygonOffset) const float f = number(r), u = number(r); gl.PolygonOffset(f, u); END
  COMMAND(Lightf) const GLenum l = mostly(r, {GL_LIGHT0, GL_LIGHT7}), p = scalar_name(r, {GL_SPOT_CUTOFF, GL_SPOT_EXPONENT, GL_LINEAR_ATTENUATION}); gl.Lightf(l, p, tame(r)); END
  COMMAND(Lightfv) const GLenum l = mostly(r, {GL_LIGHT0, GL_LIGHT7}), p = mostly(r, {GL_POSITION, GL_AMBIENT, GL_SPOT_DIRECTION, GL_SPOT_CUTOFF}); const Float4 v{tame(r), tame(r), tame(r), tame(r)}; gl.Lightfv(l, p, v.data()); END
  COMMAND(LightModeli) gl.LightModeli(mostly(r, {GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_LOCAL_VIEWER}), small(r)); END
  COMMAND(Materialf) const GLenum f = mostly(r, {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}), p = scalar_name(r, {GL_SHININESS}); gl.Materialf(f, p, tame(r)); END
  COMMAND(Materialfv) const GLenum f = mostly(r, {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}), p = mostly(r, {GL_AMBIENT, GL_DIFFUSE, GL_SHININESS, GL_EMISSION}); const Float4 v{tame(r), tame(r), tame(r), tame(r)}; gl.Materialfv(f, p, v.data()); END
  COMMAND(ColorMaterial) const GLenum f = mostly(r, {GL_FRONT, GL_BACK}), p = mostly(r, {GL_AMBIENT, GL_DIFFUSE}); gl.ColorMaterial(f, p); END
  COMMAND(Fogf) const GLenum p = scalar_name(r, {GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END, GL_FOG_MODE}); gl.Fogf(p, tame(r)); END
  COMMAND(Fogi) const GLenum p = scalar_name(r, {GL_FOG_MODE, GL_FOG_COORDINATE_SOURCE}); gl.Fogi(p, GLint(mostly(r, {GL_LINEAR, GL_EXP, GL_FOG_COORDINATE}))); END
  COMMAND(ClipPlane) const GLdouble v[4] = {tame(r), tame(r), tame(r), tame(r)}; gl.ClipPlane(mostly(r, {GL_CLIP_PLANE0, GL_CLIP_PLANE5}), v); END
  COMMAND(Clear) gl.Clear(GLbitfield(r.pick({0, GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, 1, -1}))); END
  COMMAND(ClearColor) const Float4 v{number(r), number(r), number(r), number(r)}; gl.ClearColor(v[0], v[1], v[2], v[3]); END
  COMMAND(ClearDepth) gl.ClearDepth(number(r)); END
  COMMAND(PixelStorei) gl.PixelStorei(mostly(r, {GL_UNPACK_ALIGNMENT, GL_PACK_ALIGNMENT, GL_UNPACK_SKIP_ROWS}), r.pick({-1, 0, 1, 2, 3, 4, 8})); END
  COMMAND(PixelStoreReset) (void)r; for (GLenum p : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS}) gl.PixelStorei(p, 0); END
  COMMAND(ReadPixels) const int x = small(r), y = small(r), w = r.pick({-1, 0, 1, 5, 16}), h = r.pick({-1, 0, 1, 5, 16}); const GLenum f = mostly(r, {GL_RGBA, GL_RGB, GL_DEPTH_COMPONENT, GL_LUMINANCE}), t = mostly(r, {GL_UNSIGNED_BYTE, GL_FLOAT, GL_UNSIGNED_SHORT}); gl.ReadPixels(x, y, w, h, f, t, memory + 65536); END
  COMMAND(PushAttrib) gl.PushAttrib(GLbitfield(r.pick({0, GL_ENABLE_BIT, GL_CURRENT_BIT, GL_LIGHTING_BIT, int(GL_ALL_ATTRIB_BITS)}))); END
  COMMAND(PopAttrib) gl.PopAttrib(); (void)r; END
  COMMAND(PushClientAttrib) gl.PushClientAttrib(GLbitfield(r.pick({0, GL_CLIENT_PIXEL_STORE_BIT, GL_CLIENT_VERTEX_ARRAY_BIT}))); END
  COMMAND(PopClientAttrib) gl.PopClientAttrib(); (void)r; END
  COMMAND(NewList) const GLuint n = GLuint(r.integer(0, 4)); gl.NewList(n, mostly(r, {GL_COMPILE})); END
  COMMAND(EndList) gl.EndList(); (void)r; END
  COMMAND(CallList) gl.CallList(GLuint(r.integer(0, 6))); END
  COMMAND(CallLists) const GLsizei n = r.pick({-1, 0, 1, 4}); gl.CallLists(n, mostly(r, {GL_UNSIGNED_BYTE, GL_2_BYTES}), memory + 512); END
  COMMAND(DeleteLists) const GLuint n = GLuint(r.integer(0, 9)); gl.DeleteLists(n, r.pick({-1, 0, 1, 5})); END
  COMMAND(GenLists) gl.GenLists(r.pick({-1, 0, 1, 3})); END
  COMMAND(IsList) gl.IsList(GLuint(r.integer(0, 9))); END
  COMMAND(BindTexture) const GLenum t = mostly(r, {GL_TEXTURE_2D}); gl.BindTexture(t, GLuint(r.integer(0, 4))); END
  COMMAND(TexImage2D) const GLint level = r.pick({-1, 0, 1, 2, 20}); const GLint format = r.chance(80) ? r.pick({GL_RGBA, GL_RGB8, GL_LUMINANCE, 3, 4}) : GLint(any_enum(r)); const int w = r.pick({-1, 0, 1, 2, 4, 7, 16, 1 << 20}), h = r.pick({-1, 0, 1, 4, 16}), border = r.pick({0, 0, 0, 2, -1});
    const GLenum f = mostly(r, {GL_RGBA, GL_RGB, GL_LUMINANCE}), t = mostly(r, {GL_UNSIGNED_BYTE, GL_FLOAT, GL_UNSIGNED_SHORT}); gl.TexImage2D(GL_TEXTURE_2D, level, format, w, h, border, f, t, w < 100 && r.chance(80) ? memory : nullptr); END
  COMMAND(TexSubImage2D) const int x = small(r), y = small(r), w = r.pick({-1, 0, 1, 4, 16}), h = r.pick({-1, 0, 1, 4, 16}); gl.TexSubImage2D(GL_TEXTURE_2D, r.pick({0, 0, 1, -1, 30}), x, y, w, h, GL_RGBA, GL_UNSIGNED_BYTE, memory); END
  COMMAND(TexParameteri) const GLenum t = mostly(r, {GL_TEXTURE_2D}), p = mostly(r, {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_MAX_LEVEL}); gl.TexParameteri(t, p, GLint(mostly(r, {GL_NEAREST, GL_LINEAR, GL_REPEAT, GL_CLAMP, 3}))); END
  COMMAND(TexEnvi) const GLenum p = mostly(r, {GL_TEXTURE_ENV_MODE, GL_COMBINE_RGB, GL_SOURCE0_RGB, GL_RGB_SCALE}); const GLint v = p == GL_RGB_SCALE ? small(r) : GLint(mostly_without(r, {GL_MODULATE, GL_REPLACE, GL_DECAL, GL_TEXTURE}, {GL_ZERO, GL_ONE})); gl.TexEnvi(GL_TEXTURE_ENV, p, v); END
  COMMAND(DeleteTextures) const GLuint names[3] = {GLuint(r.integer(0, 5)), GLuint(r.integer(0, 5)), 0}; gl.DeleteTextures(r.pick({-1, 0, 1, 3}), names); END
  COMMAND(ActiveTexture) gl.ActiveTexture(mostly_without(r, {GL_TEXTURE0, GL_TEXTURE0, GL_TEXTURE7, GL_TEXTURE0 + 200}, {GL_COMBINE, GL_COMBINE_RGB})); END
  COMMAND(EnableClientState) gl.EnableClientState(mostly(r, {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY})); END
  COMMAND(DisableClientState) gl.DisableClientState(mostly(r, {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY})); END
  COMMAND(VertexPointer) const GLint n = r.pick({1, 2, 3, 4, 5, -1}); const GLenum t = mostly(r, {GL_FLOAT, GL_SHORT, GL_DOUBLE}); gl.VertexPointer(n, t, r.pick({0, 0, 16, 40, -1}), somewhere(r)); END
  COMMAND(ColorPointer) const GLint n = r.pick({2, 3, 4, 5}); const GLenum t = mostly(r, {GL_FLOAT, GL_UNSIGNED_BYTE}); gl.ColorPointer(n, t, r.pick({0, 0, 16, -1}), somewhere(r)); END
  COMMAND(NormalPointer) const GLenum t = mostly(r, {GL_FLOAT, GL_BYTE}); gl.NormalPointer(t, r.pick({0, 0, 16, -1}), somewhere(r)); END
  COMMAND(InterleavedArrays) const GLenum f = mostly(r, {GL_V3F, GL_C4UB_V3F, GL_T2F_V3F}); gl.InterleavedArrays(f, r.pick({0, 64, -1}), somewhere(r)); END
  COMMAND(DrawArrays) const GLenum m = mostly(r, {GL_TRIANGLES, GL_LINE_LOOP, GL_QUADS, GL_POLYGON}); const GLint first = r.pick({0, 1, 100}); gl.DrawArrays(m, first, r.pick({-1, 0, 1, 3, 4, 100})); END
  COMMAND(DrawElements) const GLenum m = mostly(r, {GL_TRIANGLES, GL_POINTS, GL_QUAD_STRIP}); const GLsizei n = r.pick({-1, 0, 1, 3, 64}); gl.DrawElements(m, n, mostly(r, {GL_UNSIGNED_BYTE}), memory + 1024); END
  COMMAND(DrawRangeElements) const GLuint a = GLuint(r.integer(0, 5)), b = GLuint(r.pick({255, 255, 0})); gl.DrawRangeElements(GL_TRIANGLES, a, b < a ? b : 255, r.pick({-1, 0, 3, 30}), GL_UNSIGNED_BYTE, memory + 2048); END
  COMMAND(ArrayElement) gl.ArrayElement(r.integer(0, 100)); END
  COMMAND(Rectf) const Float4 v{tame(r), tame(r), tame(r), tame(r)}; gl.Rectf(v[0], v[1], v[2], v[3]); END
  COMMAND(Map1f) const GLenum t = mostly(r, {GL_MAP1_VERTEX_3, GL_MAP1_VERTEX_4, GL_MAP1_COLOR_4, GL_MAP2_NORMAL}); const float a = number(r), b = number(r); const GLint s = small(r); gl.Map1f(t, a, b, s, r.pick({-1, 0, 1, 2, 4, 30, 31}), reinterpret_cast<const GLfloat*>(memory)); END
  COMMAND(Map2f) const GLenum t = mostly(r, {GL_MAP2_VERTEX_3, GL_MAP2_VERTEX_4, GL_MAP2_COLOR_4, GL_MAP1_NORMAL}); const float a = number(r), b = number(r), c = number(r), d = number(r); const GLint su = small(r), sv = small(r), o = r.pick({0, 1, 2, 4, 30, 31}); gl.Map2f(t, a, b, su, o, c, d, sv, r.pick({0, 1, 2, 4, 30, 31}), reinterpret_cast<const GLfloat*>(memory)); END
  COMMAND(MapGrid2f) const float a = number(r), b = number(r), c = number(r), d = number(r); const GLint n = small(r); gl.MapGrid2f(n, a, b, small(r), c, d); END
  COMMAND(EnableMap) gl.Enable(GLenum(r.pick({GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_4, GL_MAP2_COLOR_4, GL_AUTO_NORMAL}))); END
  COMMAND(EvalCoord) const Float2 v{number(r), number(r)}; gl.EvalCoord1f(v[0]); gl.EvalCoord2f(v[0], v[1]); END
  COMMAND(EvalPoint2) const GLint i = small(r); gl.EvalPoint2(i, small(r)); END
  COMMAND(EvalMesh1) const GLenum m = mostly(r, {GL_POINT, GL_LINE}); const GLint i = r.integer(-1, 3); gl.EvalMesh1(m, i, r.integer(-1, 4)); END
  COMMAND(EvalMesh2) const GLenum m = mostly(r, {GL_POINT, GL_LINE, GL_FILL}); const GLint i = r.integer(-1, 3), j = r.integer(-1, 4), k = r.integer(-1, 3); gl.EvalMesh2(m, i, j, k, r.integer(-1, 4)); END
  COMMAND(GetMapfv) const GLenum t = mostly(r, {GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_4}); gl.GetMapfv(t, mostly(r, {GL_COEFF, GL_ORDER, GL_DOMAIN}), reinterpret_cast<GLfloat*>(memory + 131072)); END
  COMMAND(ListBase) gl.ListBase(GLuint(r.integer(0, 3))); END
  COMMAND(Hint) const GLenum t = mostly(r, {GL_FOG_HINT, GL_POINT_SMOOTH_HINT}); gl.Hint(t, mostly(r, {GL_FASTEST, GL_NICEST})); END
  COMMAND(ColorMask) gl.ColorMask(r.chance(50), 1, 1, 1); END
  COMMAND(GetFloatv) gl.GetFloatv(mostly(r, {GL_MODELVIEW_MATRIX, GL_CURRENT_COLOR, GL_VIEWPORT, GL_LINE_WIDTH}), reinterpret_cast<GLfloat*>(memory + 131072)); END
  COMMAND(GetLightfv) const GLenum l = mostly(r, {GL_LIGHT0, GL_LIGHT7}); gl.GetLightfv(l, mostly(r, {GL_POSITION, GL_SPOT_CUTOFF}), reinterpret_cast<GLfloat*>(memory + 131072)); END
  COMMAND(GetMaterialfv) const GLenum f = mostly(r, {GL_FRONT, GL_BACK}); gl.GetMaterialfv(f, mostly(r, {GL_AMBIENT, GL_SHININESS}), reinterpret_cast<GLfloat*>(memory + 131072)); END
  COMMAND(GetTexParameteriv) const GLenum t = mostly(r, {GL_TEXTURE_2D}); gl.GetTexParameteriv(t, mostly(r, {GL_TEXTURE_WRAP_S, GL_TEXTURE_MIN_FILTER}), reinterpret_cast<GLint*>(memory + 131072)); END
  COMMAND(Finish) gl.Finish(); (void)r; END
  COMMAND(IsEnabled) gl.IsEnabled(mostly(r, {GL_BLEND, GL_LIGHT0})); END
};
#undef COMMAND
#undef END
// clang-format on

} // namespace softgl::test

void set_up_arrays(const Gl& gl) {
  gl.VertexPointer(4, GL_FLOAT, 0, memory);
  gl.ColorPointer(4, GL_FLOAT, 0, memory);
  gl.NormalPointer(GL_FLOAT, 0, memory);
}

const FuzzCommand& random_fuzz_command(Random& random) {
  return kCommands[random.integer(0, int(sizeof kCommands / sizeof *kCommands) - 1)];
}

} // namespace softgl::test
