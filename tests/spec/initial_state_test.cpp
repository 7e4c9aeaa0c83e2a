// GL 1.5, tables 6.5 to 6.37: every value of a new context.
#include <catch2/catch.hpp>

#include <utility>

#include "spec/state_snapshot.h"

using namespace softgl::test;

TEST_CASE("every value of the state tables has its initial value", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (const StateRow& row : state_rows()) {
    if (row.initial.empty()) continue;
    INFO(row.name);
    double values[16] = {};
    gl.GetDoublev(row.token, values);
    REQUIRE(gl.GetError() == GL_NO_ERROR);
    for (size_t i = 0; i < row.initial.size(); ++i) REQUIRE(values[i] == row.initial[i]);
    if (row.kind == 'C') REQUIRE(gl.IsEnabled(row.token) == GLboolean(row.initial[0]));
  }
}

// OSMesa does not say that its floats are floats (GL_ARB_color_buffer_float).
constexpr const char* kFloatMode =
    "GL_RGBA_FLOAT_MODE_ARB double: 1 | 0 \nGL_RGBA_FLOAT_MODE_ARB float: 1 | 0 \n"
    "GL_RGBA_FLOAT_MODE_ARB bool: 1 | 0 \nGL_RGBA_FLOAT_MODE_ARB int: 1 | 0 \n";

TEST_CASE("a new context answers every query as OSMesa's does", "[spec][state]") {
  for (GLenum type : {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT}) {
    CurrentContext ours(softgl_library(), type), theirs(osmesa_library(), type);
    const std::string difference =
        compare_snapshots(take_snapshot(softgl_library(), true), take_snapshot(osmesa_library(), true));
    INFO(type << ": softgl | OSMesa\n" << difference);
    REQUIRE(difference == (type == GL_FLOAT ? kFloatMode : ""));
  }
}

TEST_CASE("the fourth argument of a texture environment is one at first", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const std::pair<GLenum, GLint> values[] = {{GL_SOURCE3_RGB_NV, GL_ZERO},
                                             {GL_SOURCE3_ALPHA_NV, GL_ZERO},
                                             {GL_OPERAND3_RGB_NV, GL_ONE_MINUS_SRC_COLOR},
                                             {GL_OPERAND3_ALPHA_NV, GL_ONE_MINUS_SRC_ALPHA}};
  for (const auto& [pname, expected] : values) {
    GLint value = -1;
    gl.GetTexEnviv(GL_TEXTURE_ENV, pname, &value);
    CHECK(value == expected);
    gl.TexEnvi(GL_TEXTURE_ENV, pname, expected == GL_ZERO ? GL_TEXTURE : GL_SRC_ALPHA);
    gl.GetTexEnviv(GL_TEXTURE_ENV, pname, &value);
    CHECK(value == (expected == GL_ZERO ? GL_TEXTURE : GL_SRC_ALPHA));
  }
}
