// GL 1.5, 6.1: what is set is what is read, converted to the type that is asked for; stacks give back what
// they saved.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

#include "spec/state_commands.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

GLint integer(const Gl& gl, GLenum token) {
  GLint v[16] = {};
  gl.GetIntegerv(token, v);
  return v[0];
}

} // namespace

TEST_CASE("every capability can be enabled and disabled and is read by every query", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (const StateRow& row : state_rows()) {
    if (row.kind != 'C' && row.kind != 'A') continue;
    INFO(row.name);
    for (GLboolean value : {GL_TRUE, GL_FALSE, GL_TRUE}) {
      if (row.kind == 'C')
        (value ? gl.Enable : gl.Disable)(row.token);
      else
        (value ? gl.EnableClientState : gl.DisableClientState)(row.token);
      GLboolean b = 2;
      GLfloat f = 2;
      GLdouble d = 2;
      gl.GetBooleanv(row.token, &b);
      gl.GetFloatv(row.token, &f);
      gl.GetDoublev(row.token, &d);
      REQUIRE(gl.IsEnabled(row.token) == value);
      REQUIRE((b == value && f == value && d == value && integer(gl, row.token) == value));
    }
    REQUIRE(gl.GetError() == GL_NO_ERROR);
  }
}

TEST_CASE("glEnable switches vertex arrays, as in EXT_vertex_array, and a list records it", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (const StateRow& row : state_rows()) {
    if (row.kind != 'A') continue;
    INFO(row.name);
    gl.Enable(row.token);
    REQUIRE(gl.IsEnabled(row.token));
    gl.NewList(1, GL_COMPILE);
    gl.Disable(row.token);
    gl.EndList();
    REQUIRE(gl.IsEnabled(row.token));
    gl.CallList(1);
    REQUIRE_FALSE(gl.IsEnabled(row.token));
    REQUIRE(gl.GetError() == GL_NO_ERROR);
  }
}

TEST_CASE("capabilities of texture units belong to the active unit", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.ActiveTexture(GL_TEXTURE3);
  gl.Enable(GL_TEXTURE_2D);
  gl.Enable(GL_TEXTURE_GEN_T);
  gl.ActiveTexture(GL_TEXTURE0);
  REQUIRE_FALSE(gl.IsEnabled(GL_TEXTURE_2D));
  REQUIRE_FALSE(gl.IsEnabled(GL_TEXTURE_GEN_T));
  gl.PushAttrib(GL_ENABLE_BIT);
  gl.ActiveTexture(GL_TEXTURE3);
  gl.Disable(GL_TEXTURE_2D);
  gl.PopAttrib();
  REQUIRE(integer(gl, GL_ACTIVE_TEXTURE) == GL_TEXTURE3);
  REQUIRE(gl.IsEnabled(GL_TEXTURE_2D));
  REQUIRE(gl.IsEnabled(GL_TEXTURE_GEN_T));
}

TEST_CASE("integer queries map colors to the whole range and round other numbers", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLint v[4];
  gl.BlendColor(1, 0.5f, 0, 0.25f);
  gl.GetIntegerv(GL_BLEND_COLOR, v);
  REQUIRE((v[0] == INT32_MAX && v[1] == 1073741823 && v[2] == 0 && v[3] == 536870911));
  gl.DepthRange(0.5, 1);
  gl.GetIntegerv(GL_DEPTH_RANGE, v);
  REQUIRE((v[0] == 1073741823 && v[1] == INT32_MAX));
  gl.LineWidth(2.5f);
  REQUIRE(integer(gl, GL_LINE_WIDTH) == 3);
  gl.PolygonOffset(-1.5f, 3e20f);
  REQUIRE(integer(gl, GL_POLYGON_OFFSET_FACTOR) == -2);
  // What the type cannot hold becomes the nearest value that it can.
  REQUIRE(integer(gl, GL_POLYGON_OFFSET_UNITS) == INT32_MAX);
  gl.Color4f(-9, 9, 0, 1);
  gl.GetIntegerv(GL_CURRENT_COLOR, v);
  REQUIRE((v[0] == INT32_MIN && v[1] == INT32_MAX && v[2] == 0 && v[3] == INT32_MAX));
  // Matrices are numbers like others (6.1.2).
  gl.Translatef(3.25f, 2.5f, -1);
  GLint m[16];
  gl.GetIntegerv(GL_MODELVIEW_MATRIX, m);
  REQUIRE((m[0] == 1 && m[12] == 3 && m[13] == 3 && m[14] == -1));
  gl.ActiveTexture(GL_TEXTURE2);
  gl.MatrixMode(GL_TEXTURE);
  gl.Translatef(1, 2, 3);
  gl.GetIntegerv(GL_TRANSPOSE_TEXTURE_MATRIX, m);
  REQUIRE((m[3] == 1 && m[7] == 2 && m[11] == 3));
}

TEST_CASE("integer parameters of colors are mapped to [-1, 1]", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLint most[4] = {INT32_MAX, INT32_MIN, 0, 1 << 30};
  GLfloat v[4];
  gl.Lightiv(GL_LIGHT2, GL_AMBIENT, most);
  gl.GetLightfv(GL_LIGHT2, GL_AMBIENT, v);
  REQUIRE((v[0] == 1 && v[1] == -1 && v[2] == Approx(0).margin(1e-9) && v[3] == 0.5f));
  const GLint position[4] = {1, 2, 3, 0};
  gl.Lightiv(GL_LIGHT2, GL_POSITION, position);
  gl.GetLightfv(GL_LIGHT2, GL_POSITION, v);
  REQUIRE((v[0] == 1 && v[1] == 2 && v[2] == 3 && v[3] == 0));
}

TEST_CASE("matrix stacks overflow and underflow at their depths", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  struct Stack {
    GLenum mode, depth, limit;
  };
  for (const Stack& s : {Stack{GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH, GL_MAX_MODELVIEW_STACK_DEPTH},
                         Stack{GL_PROJECTION, GL_PROJECTION_STACK_DEPTH, GL_MAX_PROJECTION_STACK_DEPTH},
                         Stack{GL_TEXTURE, GL_TEXTURE_STACK_DEPTH, GL_MAX_TEXTURE_STACK_DEPTH}}) {
    gl.MatrixMode(s.mode);
    const GLint limit = integer(gl, s.limit);
    for (GLint i = 1; i < limit; ++i) gl.PushMatrix();
    REQUIRE(gl.GetError() == GL_NO_ERROR);
    REQUIRE(integer(gl, s.depth) == limit);
    gl.PushMatrix();
    REQUIRE(gl.GetError() == GL_STACK_OVERFLOW);
    REQUIRE(integer(gl, s.depth) == limit);
    for (GLint i = 1; i < limit; ++i) gl.PopMatrix();
    REQUIRE(gl.GetError() == GL_NO_ERROR);
    gl.PopMatrix();
    REQUIRE(gl.GetError() == GL_STACK_UNDERFLOW);
  }
}

TEST_CASE("attribute stacks overflow at their depth", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (int i = 0; i < 16; ++i)
    gl.PushAttrib(GL_ALL_ATTRIB_BITS), gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  REQUIRE(gl.GetError() == GL_NO_ERROR);
  REQUIRE(integer(gl, GL_ATTRIB_STACK_DEPTH) == 16);
  REQUIRE(integer(gl, GL_CLIENT_ATTRIB_STACK_DEPTH) == 16);
  gl.PushAttrib(0);
  REQUIRE(gl.GetError() == GL_STACK_OVERFLOW);
  gl.PushClientAttrib(0);
  REQUIRE(gl.GetError() == GL_STACK_OVERFLOW);
}

TEST_CASE("pushing and popping everything leaves everything as it was", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  Random random(7);
  const auto disturb = [&] {
    for (int i = 0; i < 250; ++i) {
      const StateCommand command = random_state_command(random);
      // Matrices and the stacks themselves are not saved by PushAttrib; every other state is.
      bool skip = false;
      for (const char* name :
           {"Matri", "Identity", "Rotate", "Translate", "Scalef", "Frustum", "Ortho", "Attrib"})
        skip = skip || command.text.find(name) != std::string::npos;
      if (!skip || command.text.find("MatrixMode") != std::string::npos) command.run(gl);
    }
    while (gl.GetError() != GL_NO_ERROR) {}
  };
  for (int round = 0; round < 10; ++round) {
    disturb();
    const StateSnapshot before = take_snapshot(gl, true);
    gl.PushAttrib(GL_ALL_ATTRIB_BITS);
    gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    disturb();
    gl.PopAttrib();
    gl.PopClientAttrib();
    const std::string difference = compare_snapshots(before, take_snapshot(gl, true));
    INFO(difference);
    REQUIRE(difference.empty());
  }
}

TEST_CASE("an outer PopAttrib restores what was changed inside an inner one", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.PushAttrib(GL_LINE_BIT | GL_POINT_BIT);
  gl.PushAttrib(GL_POINT_BIT);
  gl.LineWidth(5);
  gl.PointSize(6);
  gl.PopAttrib();
  REQUIRE(integer(gl, GL_LINE_WIDTH) == 5);
  REQUIRE(integer(gl, GL_POINT_SIZE) == 1);
  gl.PopAttrib();
  REQUIRE(integer(gl, GL_LINE_WIDTH) == 1);
}

TEST_CASE("GL_ENABLE_BIT saves which lights are on", "[spec][state]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    gl->Enable(GL_LIGHT3);
    gl->PushAttrib(GL_ENABLE_BIT);
    gl->Enable(GL_LIGHT1);
    gl->Disable(GL_LIGHT3);
    gl->PopAttrib();
    const bool restored = !gl->IsEnabled(GL_LIGHT1) && gl->IsEnabled(GL_LIGHT3);
    CHECK(restored == (gl == &softgl_library()));
  }
}

TEST_CASE("matrix commands follow the texture unit that PopAttrib makes active", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.ActiveTexture(GL_TEXTURE7);
  gl.MatrixMode(GL_TEXTURE);
  gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  gl.ActiveTexture(GL_TEXTURE1);
  gl.MatrixMode(GL_PROJECTION);
  gl.PopAttrib();
  gl.Scalef(2, 3, 4);
  GLfloat m[16];
  gl.GetFloatv(GL_TEXTURE_MATRIX, m);
  REQUIRE((m[0] == 2 && m[5] == 3 && m[10] == 4));
}

TEST_CASE("a popped texture binding and its parameters are the pushed ones", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLuint names[2];
  gl.GenTextures(2, names);
  gl.BindTexture(GL_TEXTURE_2D, names[0]);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.PushAttrib(GL_TEXTURE_BIT);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.BindTexture(GL_TEXTURE_2D, names[1]);
  gl.PopAttrib();
  REQUIRE(GLuint(integer(gl, GL_TEXTURE_BINDING_2D)) == names[0]);
  GLint filter = 0;
  gl.GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &filter);
  REQUIRE(filter == GL_NEAREST);
  // An object deleted meanwhile does not come back.
  gl.PushAttrib(GL_TEXTURE_BIT);
  gl.DeleteTextures(2, names);
  gl.PopAttrib();
  REQUIRE(integer(gl, GL_TEXTURE_BINDING_2D) == 0);
  REQUIRE(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("color material follows the color and keeps the last one", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const auto red = [&](GLenum face, GLenum pname) {
    GLfloat v[4];
    gl.GetMaterialfv(face, pname, v);
    return v[0];
  };
  gl.ColorMaterial(GL_FRONT, GL_DIFFUSE);
  gl.Color3f(0.25f, 0, 0);
  REQUIRE(red(GL_FRONT, GL_DIFFUSE) == 0.8f);
  gl.Enable(GL_COLOR_MATERIAL); // also at this moment (2.14.3)
  REQUIRE(red(GL_FRONT, GL_DIFFUSE) == 0.25f);
  gl.Color3f(0.5f, 0, 0);
  REQUIRE(red(GL_FRONT, GL_DIFFUSE) == 0.5f);
  REQUIRE(red(GL_BACK, GL_DIFFUSE) == 0.8f);
  const GLfloat ignored[4] = {0.9f, 0, 0, 1};
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, ignored); // the color rules
  REQUIRE(red(GL_FRONT, GL_DIFFUSE) == 0.5f);
  gl.ColorMaterial(GL_BACK, GL_EMISSION);
  REQUIRE(red(GL_FRONT, GL_DIFFUSE) == 0.5f);
  REQUIRE(red(GL_BACK, GL_EMISSION) == 0.5f);
  gl.Disable(GL_COLOR_MATERIAL);
  gl.Color3f(0.75f, 0, 0);
  REQUIRE(red(GL_BACK, GL_EMISSION) == 0.5f);
}

TEST_CASE("vectors are rounded when they are asked for as integers", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLfloat v[4] = {1.75f, -1.75f, 0.5f, 0};
  GLint i[4] = {};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, v);
  gl.GetLightiv(GL_LIGHT0, GL_POSITION, i);
  REQUIRE((i[0] == 2 && i[1] == -2 && i[2] == 1 && i[3] == 0));
  gl.TexGenfv(GL_T, GL_OBJECT_PLANE, v);
  gl.GetTexGeniv(GL_T, GL_OBJECT_PLANE, i);
  REQUIRE((i[0] == 2 && i[1] == -2 && i[2] == 1 && i[3] == 0));
}

TEST_CASE("a polygon stipple is read back as it was given", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  Random random(11);
  GLubyte pattern[128], read[1024];
  for (GLubyte& byte : pattern) byte = GLubyte(random.bits());
  gl.PolygonStipple(pattern);
  gl.GetPolygonStipple(read);
  REQUIRE(std::equal(pattern, pattern + 128, read));
  gl.PixelStorei(GL_PACK_LSB_FIRST, 1);
  gl.PixelStorei(GL_PACK_ROW_LENGTH, 64);
  gl.PixelStorei(GL_PACK_SKIP_PIXELS, 5);
  std::fill(read, read + 1024, GLubyte(0xff));
  gl.GetPolygonStipple(read);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      const bool bit = read[y * 8 + x / 8] >> (x % 8) & 1;
      const int from = x - 5; // beside the pattern nothing is touched
      REQUIRE(bit == (from < 0 || from >= 32 || (pattern[y * 4 + from / 8] >> (7 - from % 8) & 1)));
    }
}
