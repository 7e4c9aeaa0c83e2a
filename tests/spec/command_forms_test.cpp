// Commands that come in several types (GL 1.5, 2.3): every form means what the float form means, at once and
// from a list, and leaves what OSMesa's leaves. The forms of attributes are in attribute_forms_test.cpp,
// those of glRasterPos in raster_position_test.cpp.
#include <catch2/catch.hpp>

#include <climits>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

// The same four numbers in every type.
constexpr GLfloat kF[4] = {3, -2, 4, 2};
constexpr GLdouble kD[4] = {3, -2, 4, 2};
constexpr GLint kI[4] = {3, -2, 4, 2};
constexpr GLshort kS[4] = {3, -2, 4, 2};
constexpr GLfloat kHalfF[2] = {0.5f, 0.25f};
constexpr GLdouble kHalfD[2] = {0.5, 0.25};

constexpr GLfloat kMatrixF[16] = {1, 2, 0, 0, -3, 1, 0.5f, 0, 0, 0, 2, 0, 4, 5, 6, 1};
constexpr GLdouble kMatrixD[16] = {1, 2, 0, 0, -3, 1, 0.5, 0, 0, 0, 2, 0, 4, 5, 6, 1};
constexpr GLfloat kTransposeF[16] = {1, -3, 0, 4, 2, 1, 0, 5, 0, 0.5f, 2, 6, 0, 0, 0, 1};
constexpr GLdouble kTransposeD[16] = {1, -3, 0, 4, 2, 1, 0, 5, 0, 0.5, 2, 6, 0, 0, 0, 1};

constexpr GLfloat kWhiteF[4] = {1, 1, 1, 1};
constexpr GLint kWhiteI[4] = {INT_MAX, INT_MAX, INT_MAX, INT_MAX}; // a color: table 2.9 maps it to [-1, 1]
constexpr GLint kBlend[1] = {GL_BLEND}, kObjectLinear[1] = {GL_OBJECT_LINEAR}, kClamp[1] = {GL_CLAMP};

struct Form {
  const char* text;
  void (*usual)(const Gl&);
  void (*form)(const Gl&);
};
// clang-format off
#define SAME(usual, form) {#form, [](const Gl& gl) { gl.usual; }, [](const Gl& gl) { gl.form; }}

const Form kStateForms[] = {
    SAME(Indexf(3), Indexdv(kD)),
    SAME(Indexf(3), Indexfv(kF)),
    SAME(Indexf(3), Indexiv(kI)),
    SAME(Indexf(3), Indexsv(kS)),
    SAME(Lightf(GL_LIGHT1, GL_SPOT_EXPONENT, 7), Lighti(GL_LIGHT1, GL_SPOT_EXPONENT, 7)),
    SAME(LoadMatrixf(kMatrixF), LoadMatrixd(kMatrixD)),
    SAME(LoadMatrixf(kMatrixF), LoadTransposeMatrixf(kTransposeF)),
    SAME(LoadMatrixf(kMatrixF), LoadTransposeMatrixd(kTransposeD)),
    SAME(MultMatrixf(kMatrixF), MultMatrixd(kMatrixD)),
    SAME(MultMatrixf(kMatrixF), MultTransposeMatrixf(kTransposeF)),
    SAME(MultMatrixf(kMatrixF), MultTransposeMatrixd(kTransposeD)),
    SAME(Translatef(3, -2, 4), Translated(3, -2, 4)),
    SAME(PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 3), PointParameteriv(GL_POINT_FADE_THRESHOLD_SIZE, kI)),
    SAME(TexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND), TexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, kBlend)),
    SAME(TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, kWhiteF), TexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, kWhiteI)),
    SAME(TexGenf(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR), TexGend(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR)),
    SAME(TexGenf(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR), TexGeniv(GL_S, GL_TEXTURE_GEN_MODE, kObjectLinear)),
    SAME(TexGenfv(GL_T, GL_OBJECT_PLANE, kF), TexGendv(GL_T, GL_OBJECT_PLANE, kD)),
    SAME(TexGenfv(GL_T, GL_OBJECT_PLANE, kF), TexGeniv(GL_T, GL_OBJECT_PLANE, kI)),
    SAME(TexGenfv(GL_T, GL_EYE_PLANE, kF), TexGendv(GL_T, GL_EYE_PLANE, kD)),
    SAME(TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP), TexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, kClamp)),
    SAME(TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kWhiteF),
         TexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kWhiteI)),
};

#define VERTICES(letter, a) \
  SAME(Vertex2f(3, -2), Vertex2##letter(a[0], a[1])), SAME(Vertex2f(3, -2), Vertex2##letter##v(a)), \
  SAME(Vertex3f(3, -2, 4), Vertex3##letter(a[0], a[1], a[2])), SAME(Vertex3f(3, -2, 4), Vertex3##letter##v(a)), \
  SAME(Vertex4f(3, -2, 4, 2), Vertex4##letter(a[0], a[1], a[2], a[3])), SAME(Vertex4f(3, -2, 4, 2), Vertex4##letter##v(a))
#define EVALUATIONS(letter, a) \
  SAME(EvalCoord2f(0.5f, 0.25f), EvalCoord2##letter(a[0], a[1])), SAME(EvalCoord2f(0.5f, 0.25f), EvalCoord2##letter##v(a))

/// Between Begin and End.
const Form kVertexForms[] = {
    VERTICES(f, kF), VERTICES(d, kD), VERTICES(i, kI), VERTICES(s, kS),
    EVALUATIONS(f, kHalfF), EVALUATIONS(d, kHalfD),
    SAME(EvalCoord1f(0.5f), EvalCoord1d(kHalfD[0])), SAME(EvalCoord1f(0.5f), EvalCoord1dv(kHalfD)),
    SAME(EvalCoord1f(0.5f), EvalCoord1fv(kHalfF)),
};

#define RECTANGLES(letter, a) \
  SAME(Rectf(3, -2, 4, 2), Rect##letter(a[0], a[1], a[2], a[3])), SAME(Rectf(3, -2, 4, 2), Rect##letter##v(a, a + 2))
const Form kRectangleForms[] = {RECTANGLES(f, kF), RECTANGLES(d, kD), RECTANGLES(i, kI), RECTANGLES(s, kS)};
// clang-format on

using Calls = void (*)(const Gl&);

/// Calls at once, or from a list.
void call(const Gl& gl, Calls calls, bool from_list) {
  if (!from_list) return calls(gl);
  gl.NewList(1, GL_COMPILE);
  calls(gl);
  gl.EndList();
  gl.CallList(1);
}

StateSnapshot state_after(const Gl& gl, Calls calls, bool from_list) {
  CurrentContext context(gl);
  gl.Rotatef(90, 0, 0, 1); // so that a product shows its order
  call(gl, calls, from_list);
  StateSnapshot state = take_snapshot(gl, true);
  GLint wrap = 0;
  GLfloat border[4] = {};
  gl.GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &wrap);
  gl.GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
  state.emplace_back("wrap", std::to_string(wrap));
  state.emplace_back("border", std::to_string(border[0]) + " " + std::to_string(border[3]));
  return state;
}

std::vector<GLfloat> feedback_of(const Gl& gl, Calls calls, bool from_list, bool vertex) {
  CurrentContext context(gl);
  gl.Ortho(-8, 8, -8, 8, -8, 8);
  const GLfloat line[6] = {-3, 0, 1, 4, 2, 0}, sheet[12] = {-3, -2, 0, -1, 3, 1, 4, -1, 2, 5, 3, 0};
  gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, line);
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, sheet);
  gl.Enable(GL_MAP1_VERTEX_3);
  gl.Enable(GL_MAP2_VERTEX_3);
  std::vector<GLfloat> values(256);
  gl.FeedbackBuffer(GLsizei(values.size()), GL_4D_COLOR_TEXTURE, values.data());
  gl.RenderMode(GL_FEEDBACK);
  if (vertex) gl.Begin(GL_POINTS);
  call(gl, calls, from_list);
  if (vertex) gl.End();
  values.resize(size_t(gl.RenderMode(GL_RENDER)));
  CHECK(gl.GetError() == GL_NO_ERROR);
  return values;
}

} // namespace

TEST_CASE("Every form of a command that sets state sets what its float form sets", "[spec][state][lists]") {
  const Gl& gl = softgl_library();
  const StateSnapshot before = state_after(
      gl, [](const Gl&) {}, false);
  for (const Form& form : kStateForms) {
    INFO(form.text);
    const StateSnapshot usual = state_after(gl, form.usual, false);
    CHECK(compare_snapshots(usual, before) != "");
    CHECK(compare_snapshots(state_after(gl, form.form, false), usual) == "");
    CHECK(compare_snapshots(state_after(gl, form.form, true), usual) == "");
    CHECK(compare_snapshots(usual, state_after(osmesa_library(), form.form, false)) == "");
  }
}

TEST_CASE("Every form of glVertex, glEvalCoord and glRect draws what its float form draws", "[spec][lists]") {
  const Gl& gl = softgl_library();
  const auto compare = [&](const Form& form, bool vertex) {
    INFO(form.text);
    const std::vector<GLfloat> usual = feedback_of(gl, form.usual, false, vertex);
    CHECK(usual.size() > 12);
    CHECK(feedback_of(gl, form.form, false, vertex) == usual);
    if (!vertex) CHECK(feedback_of(gl, form.form, true, vertex) == usual);
    CHECK(feedback_of(osmesa_library(), form.form, false, vertex) == usual);
  };
  for (const Form& form : kVertexForms) compare(form, true);
  for (const Form& form : kRectangleForms) compare(form, false);
}

TEST_CASE("The array pointers of EXT_vertex_array are those of GL 1.1 with a count", "[spec][arrays]") {
  const Gl& gl = softgl_library();
  static const GLfloat values[64] = {};
  static const GLboolean flags[64] = {};
  const auto set = [&](const std::function<void()>& pointer, GLenum query, const void* expected) {
    CurrentContext context(gl);
    pointer();
    void* kept = nullptr;
    gl.GetPointerv(query, &kept);
    CHECK(kept == expected);
    return take_snapshot(gl, true);
  };
  const auto same = [&](const char* name, const std::function<void()>& usual,
                        const std::function<void()>& form, GLenum query, const void* expected) {
    INFO(name);
    CHECK(compare_snapshots(set(form, query, expected), set(usual, query, expected)) == "");
  };
  // clang-format off
#define EXTENSION(name) reinterpret_cast<decltype(&::gl##name)>(gl.OSMesaGetProcAddress("gl" #name))
  same("vertices", [&] { gl.VertexPointer(3, GL_DOUBLE, 40, values); },
       [&] { EXTENSION(VertexPointerEXT)(3, GL_DOUBLE, 40, 4, values); }, GL_VERTEX_ARRAY_POINTER, values);
  same("normals", [&] { gl.NormalPointer(GL_SHORT, 40, values); },
       [&] { EXTENSION(NormalPointerEXT)(GL_SHORT, 40, 4, values); }, GL_NORMAL_ARRAY_POINTER, values);
  same("colors", [&] { gl.ColorPointer(3, GL_SHORT, 40, values); },
       [&] { EXTENSION(ColorPointerEXT)(3, GL_SHORT, 40, 4, values); }, GL_COLOR_ARRAY_POINTER, values);
  same("indexes", [&] { gl.IndexPointer(GL_SHORT, 40, values); },
       [&] { EXTENSION(IndexPointerEXT)(GL_SHORT, 40, 4, values); }, GL_INDEX_ARRAY_POINTER, values);
  same("texture coordinates", [&] { gl.TexCoordPointer(2, GL_SHORT, 40, values); },
       [&] { EXTENSION(TexCoordPointerEXT)(2, GL_SHORT, 40, 4, values); }, GL_TEXTURE_COORD_ARRAY_POINTER, values);
  same("edge flags", [&] { gl.EdgeFlagPointer(40, flags); },
       [&] { EXTENSION(EdgeFlagPointerEXT)(40, 4, flags); }, GL_EDGE_FLAG_ARRAY_POINTER, flags);
  // clang-format on
}

TEST_CASE("Interleaved arrays are the pointers of table 2.5, and may begin at the first byte of a buffer",
          "[spec][arrays]") {
  // Where the texture coordinates, color, normal and position begin (-1: none), their sizes, and the stride.
  struct Layout {
    int at[4];
    GLint size[4];
    GLenum color_type;
    GLsizei stride;
  };
  static constexpr Layout layouts[14] = {
      /* V2F */ {{-1, -1, -1, 0}, {0, 0, 0, 2}, 0, 8},
      /* V3F */ {{-1, -1, -1, 0}, {0, 0, 0, 3}, 0, 12},
      /* C4UB_V2F */ {{-1, 0, -1, 4}, {0, 4, 0, 2}, GL_UNSIGNED_BYTE, 12},
      /* C4UB_V3F */ {{-1, 0, -1, 4}, {0, 4, 0, 3}, GL_UNSIGNED_BYTE, 16},
      /* C3F_V3F */ {{-1, 0, -1, 12}, {0, 3, 0, 3}, GL_FLOAT, 24},
      /* N3F_V3F */ {{-1, -1, 0, 12}, {0, 0, 3, 3}, 0, 24},
      /* C4F_N3F_V3F */ {{-1, 0, 16, 28}, {0, 4, 3, 3}, GL_FLOAT, 40},
      /* T2F_V3F */ {{0, -1, -1, 8}, {2, 0, 0, 3}, 0, 20},
      /* T4F_V4F */ {{0, -1, -1, 16}, {4, 0, 0, 4}, 0, 32},
      /* T2F_C4UB_V3F */ {{0, 8, -1, 12}, {2, 4, 0, 3}, GL_UNSIGNED_BYTE, 24},
      /* T2F_C3F_V3F */ {{0, 8, -1, 20}, {2, 3, 0, 3}, GL_FLOAT, 32},
      /* T2F_N3F_V3F */ {{0, -1, 8, 20}, {2, 0, 3, 3}, 0, 32},
      /* T2F_C4F_N3F_V3F */ {{0, 8, 24, 36}, {2, 4, 3, 3}, GL_FLOAT, 48},
      /* T4F_C4F_N3F_V4F */ {{0, 16, 32, 44}, {4, 4, 3, 4}, GL_FLOAT, 60},
  };
  static constexpr GLenum pointers[4] = {GL_TEXTURE_COORD_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER,
                                         GL_NORMAL_ARRAY_POINTER, GL_VERTEX_ARRAY_POINTER};
  const auto answers = [&](const Gl& gl) {
    StateSnapshot snapshot = take_snapshot(gl, false);
    for (GLenum pointer : pointers) {
      void* at = nullptr;
      gl.GetPointerv(pointer, &at);
      snapshot.emplace_back(std::to_string(pointer), std::to_string(reinterpret_cast<uintptr_t>(at)));
    }
    return snapshot;
  };
  for (const Gl* library : {&softgl_library(), &osmesa_library()}) {
    const Gl& gl = *library;
    for (GLenum format = GL_V2F; format <= GL_T4F_C4F_N3F_V4F; ++format)
      for (uintptr_t first : {0, 64}) {
        INFO("format " << format << " from " << first);
        const Layout& l = layouts[format - GL_V2F];
        CurrentContext interleaved(gl);
        gl.BindBuffer(GL_ARRAY_BUFFER, 1);
        gl.BufferData(GL_ARRAY_BUFFER, 4096, nullptr, GL_STATIC_DRAW);
        gl.InterleavedArrays(format, 0, reinterpret_cast<void*>(first));
        const StateSnapshot found = answers(gl);
        CurrentContext apart(gl);
        gl.BindBuffer(GL_ARRAY_BUFFER, 1);
        gl.BufferData(GL_ARRAY_BUFFER, 4096, nullptr, GL_STATIC_DRAW);
        const auto at = [&](int i) { return reinterpret_cast<void*>(first + uintptr_t(l.at[i])); };
        const auto array = [&](int i, GLenum name, const std::function<void()>& pointer) {
          if (l.at[i] < 0) return;
          gl.EnableClientState(name);
          pointer();
        };
        array(0, GL_TEXTURE_COORD_ARRAY, [&] { gl.TexCoordPointer(l.size[0], GL_FLOAT, l.stride, at(0)); });
        array(1, GL_COLOR_ARRAY, [&] { gl.ColorPointer(l.size[1], l.color_type, l.stride, at(1)); });
        array(2, GL_NORMAL_ARRAY, [&] { gl.NormalPointer(GL_FLOAT, l.stride, at(2)); });
        array(3, GL_VERTEX_ARRAY, [&] { gl.VertexPointer(l.size[3], GL_FLOAT, l.stride, at(3)); });
        CHECK(compare_snapshots(found, answers(gl)) == "");
      }
  }
}

REFUSAL_TEST_CASE("Compressed images of formats that are not there are refused", "[spec][errors][textures]") {
  // clang-format off
  static const GLubyte bytes[64] = {};
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, CompressedTexImage1D(GL_TEXTURE_1D, 0, GL_COMPRESSED_RGB, 4, 0, 8, bytes)),
      BAD(INVALID_ENUM, CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA, 4, 4, 0, 8, bytes)),
      BAD(INVALID_ENUM, CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, 64, bytes)),
      BAD(INVALID_ENUM, CompressedTexImage3D(GL_TEXTURE_3D, 0, GL_COMPRESSED_RGB, 4, 4, 1, 0, 8, bytes)),
      BAD(INVALID_ENUM, CompressedTexSubImage1D(GL_TEXTURE_1D, 0, 0, 4, GL_COMPRESSED_RGB, 8, bytes)),
      BAD(INVALID_ENUM, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGB, 8, bytes)),
      BAD(INVALID_OPERATION, GetCompressedTexImage(GL_TEXTURE_2D, 0, const_cast<GLubyte*>(bytes))),
      BAD(INVALID_VALUE, GetCompressedTexImage(GL_TEXTURE_2D, -1, const_cast<GLubyte*>(bytes))),
      BAD(INVALID_VALUE, GetCompressedTexImage(GL_TEXTURE_2D, 99, const_cast<GLubyte*>(bytes))),
      BAD(INVALID_ENUM, GetCompressedTexImage(GL_PROXY_TEXTURE_2D, 0, const_cast<GLubyte*>(bytes))),
      BAD(INVALID_ENUM, GetCompressedTexImage(GL_TEXTURE_CUBE_MAP, 0, const_cast<GLubyte*>(bytes))),
      // The last one is INVALID_OPERATION in OSMesa (reference/DEVIATIONS.md).
      BAD(INVALID_ENUM, CompressedTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 4, 4, 1, GL_COMPRESSED_RGB, 8, bytes)),
  };
  // clang-format on
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    CurrentContext context(*gl);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    const StateSnapshot before = take_snapshot(*gl, false);
    INFO(gl->name);
    const bool ours = gl == &softgl_library();
    expect_refused(*gl, std::span(calls).first(std::size(calls) - (ours ? 0 : 1)),
                   [&] { CHECK(compare_snapshots(before, take_snapshot(*gl, false)) == ""); });
    GLint width = 0, compressed = -1;
    gl->GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    gl->GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED, &compressed);
    CHECK((width == 4 && compressed == 0));
  }
}

} // namespace softgl::test
