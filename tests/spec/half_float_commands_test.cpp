// GL_NV_half_float: vertices and their attributes as floats of 16 bits, in lists, too.
#include <catch2/catch.hpp>

#include <functional>
#include <limits>
#include <vector>

#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

// 1.5, -2, the smallest number there is, infinity.
const GLhalfNV kHalf[4] = {0x3e00, 0xc000, 0x0001, 0x7c00};
const float kFloat[4] = {1.5f, -2, 0x1p-24f, std::numeric_limits<float>::infinity()};

struct Form {
  GLenum pname;
  int count;
  std::function<void(const Gl& gl)> call;
};

#define FORM(pname, count, call) \
  { \
    pname, count, [](const Gl& gl) { gl.call; } \
  }
// clang-format off
const Form forms[] = {
    FORM(GL_CURRENT_NORMAL, 3, Normal3hNV(kHalf[0], kHalf[1], kHalf[2])), FORM(GL_CURRENT_NORMAL, 3, Normal3hvNV(kHalf)),
    FORM(GL_CURRENT_COLOR, 3, Color3hNV(kHalf[0], kHalf[1], kHalf[2])), FORM(GL_CURRENT_COLOR, 3, Color3hvNV(kHalf)),
    FORM(GL_CURRENT_COLOR, 4, Color4hNV(kHalf[0], kHalf[1], kHalf[2], kHalf[3])), FORM(GL_CURRENT_COLOR, 4, Color4hvNV(kHalf)),
    FORM(GL_CURRENT_SECONDARY_COLOR, 3, SecondaryColor3hNV(kHalf[0], kHalf[1], kHalf[2])),
    FORM(GL_CURRENT_SECONDARY_COLOR, 3, SecondaryColor3hvNV(kHalf)),
    FORM(GL_CURRENT_FOG_COORD, 1, FogCoordhNV(kHalf[0])), FORM(GL_CURRENT_FOG_COORD, 1, FogCoordhvNV(kHalf)),
    FORM(GL_CURRENT_TEXTURE_COORDS, 1, TexCoord1hNV(kHalf[0])), FORM(GL_CURRENT_TEXTURE_COORDS, 1, TexCoord1hvNV(kHalf)),
    FORM(GL_CURRENT_TEXTURE_COORDS, 2, TexCoord2hNV(kHalf[0], kHalf[1])), FORM(GL_CURRENT_TEXTURE_COORDS, 2, TexCoord2hvNV(kHalf)),
    FORM(GL_CURRENT_TEXTURE_COORDS, 3, TexCoord3hNV(kHalf[0], kHalf[1], kHalf[2])),
    FORM(GL_CURRENT_TEXTURE_COORDS, 3, TexCoord3hvNV(kHalf)),
    FORM(GL_CURRENT_TEXTURE_COORDS, 4, TexCoord4hNV(kHalf[0], kHalf[1], kHalf[2], kHalf[3])),
    FORM(GL_CURRENT_TEXTURE_COORDS, 4, TexCoord4hvNV(kHalf)),
    FORM(GL_CURRENT_TEXTURE_COORDS, 1, MultiTexCoord1hNV(GL_TEXTURE0, kHalf[0])),
    FORM(GL_CURRENT_TEXTURE_COORDS, 1, MultiTexCoord1hvNV(GL_TEXTURE0, kHalf)),
    FORM(GL_CURRENT_TEXTURE_COORDS, 2, MultiTexCoord2hNV(GL_TEXTURE0, kHalf[0], kHalf[1])),
    FORM(GL_CURRENT_TEXTURE_COORDS, 2, MultiTexCoord2hvNV(GL_TEXTURE0, kHalf)),
    FORM(GL_CURRENT_TEXTURE_COORDS, 3, MultiTexCoord3hNV(GL_TEXTURE0, kHalf[0], kHalf[1], kHalf[2])),
    FORM(GL_CURRENT_TEXTURE_COORDS, 3, MultiTexCoord3hvNV(GL_TEXTURE0, kHalf)),
    FORM(GL_CURRENT_TEXTURE_COORDS, 4, MultiTexCoord4hNV(GL_TEXTURE0, kHalf[0], kHalf[1], kHalf[2], kHalf[3])),
    FORM(GL_CURRENT_TEXTURE_COORDS, 4, MultiTexCoord4hvNV(GL_TEXTURE0, kHalf)),
};
// clang-format on
#undef FORM

} // namespace

TEST_CASE("attributes of half floats become the current ones", "[spec][half_float]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (bool in_list : {false, true})
    for (size_t i = 0; i < std::size(forms); ++i) {
      INFO("form " << i << (in_list ? " in a list" : ""));
      gl.Color4f(0, 0, 0, 1), gl.TexCoord4f(0, 0, 0, 1), gl.FogCoordf(0);
      if (in_list) gl.NewList(1, GL_COMPILE);
      forms[i].call(gl);
      if (in_list) gl.EndList(), gl.CallList(1);
      GLfloat now[4] = {};
      gl.GetFloatv(forms[i].pname, now);
      for (int k = 0; k < forms[i].count; ++k) CHECK(now[k] == kFloat[k]);
      CHECK(gl.GetError() == GL_NO_ERROR);
    }
  gl.MultiTexCoord1hNV(GL_TEXTURE0 + 8, 0);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
}

TEST_CASE("vertices of half floats are drawn", "[spec][half_float]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLhalfNV one = 0x3c00, minus_one = 0xbc00, zero = 0;
  const GLhalfNV corner[4][4] = {{minus_one, minus_one, zero, one},
                                 {one, minus_one, zero, one},
                                 {one, one, zero, one},
                                 {minus_one, one, zero, one}};
  for (int form = 0; form < 6; ++form) {
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Color3hNV(zero, one, zero);
    gl.Begin(GL_QUADS);
    for (const GLhalfNV* v : corner) switch (form) {
      case 0: gl.Vertex2hNV(v[0], v[1]); break;
      case 1: gl.Vertex2hvNV(v); break;
      case 2: gl.Vertex3hNV(v[0], v[1], v[2]); break;
      case 3: gl.Vertex3hvNV(v); break;
      case 4: gl.Vertex4hNV(v[0], v[1], v[2], v[3]); break;
      default: gl.Vertex4hvNV(v);
      }
    gl.End();
    GLubyte rgba[4] = {};
    gl.ReadPixels(1, 62, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    CHECK(std::vector<int>(rgba, rgba + 4) == std::vector<int>{0, 255, 0, 255});
  }
}
