// Vertex array objects (GL_ARB_vertex_array_object), and primitives that begin anew at an index
// (GL_NV_primitive_restart and OpenGL 3.1).
#include <catch2/catch.hpp>

#include <cstring>
#include <string>
#include <vector>

#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

GLint get(const Gl& gl, GLenum pname) {
  GLint value = -1;
  gl.GetIntegerv(pname, &value);
  return value;
}

GLuint make_buffer(const Gl& gl, GLenum target, const void* data, size_t bytes) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(target, name);
  gl.BufferData(target, GLsizeiptr(bytes), data, GL_STATIC_DRAW);
  return name;
}

template <class Test> void with_both_libraries(Test test) {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    const CurrentContext current{*gl};
    INFO((gl == &softgl_library() ? "softgl" : "OSMesa"));
    test(*gl);
    CHECK(gl->GetError() == GL_NO_ERROR);
  }
}

/// Columns of the window's middle row in which something is drawn, as text of 8 letters.
std::string drawn_columns(const Gl& gl) {
  std::vector<uint32_t> row(64);
  gl.ReadPixels(0, 32, 64, 1, GL_RGBA, GL_UNSIGNED_BYTE, row.data());
  std::string text;
  for (int i = 0; i < 8; ++i) text += row[size_t(8 * i + 4)] & 0xffffff ? 'x' : '.';
  gl.Clear(GL_COLOR_BUFFER_BIT);
  return text;
}

/// Vertices of eight quadrilaterals side by side: 4 * i to 4 * i + 3 are the corners of column i.
std::vector<float> columns() {
  std::vector<float> v;
  for (int i = 0; i < 8; ++i) {
    const float left = float(i) * 0.25f - 1, right = left + 0.25f;
    v.insert(v.end(), {left, -1, right, -1, right, 1, left, 1});
  }
  return v;
}

} // namespace

TEST_CASE("Names of vertex array objects become objects when they are bound", "[spec][arrays][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    GLuint names[2] = {};
    gl.GenVertexArrays(2, names);
    CHECK((names[0] && names[1] && !gl.IsVertexArray(names[0]) && !gl.IsVertexArray(0)));
    gl.BindVertexArray(names[0]);
    CHECK((gl.IsVertexArray(names[0]) && get(gl, GL_VERTEX_ARRAY_BINDING) == GLint(names[0])));
    gl.BindVertexArray(names[1] + 50);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    CHECK(get(gl, GL_VERTEX_ARRAY_BINDING) == GLint(names[0]));
    gl.DeleteVertexArrays(2, names);
    CHECK((get(gl, GL_VERTEX_ARRAY_BINDING) == 0 && !gl.IsVertexArray(names[0])));
    gl.BindVertexArray(names[0]);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    gl.GenVertexArrays(-1, names);
    CHECK(gl.GetError() == GL_INVALID_VALUE);
    gl.DeleteVertexArrays(-1, names);
    CHECK(gl.GetError() == GL_INVALID_VALUE);
  });
}

TEST_CASE("A vertex array object holds arrays and the buffer of indices", "[spec][arrays][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    const float point[4] = {};
    const GLuint buffer = make_buffer(gl, GL_ARRAY_BUFFER, point, sizeof point),
                 indices = make_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, point, sizeof point);
    GLuint name = 0;
    gl.GenVertexArrays(1, &name);
    gl.BindVertexArray(name);
    // A new object has the initial state; what is not in objects stays.
    CHECK(
        (get(gl, GL_ELEMENT_ARRAY_BUFFER_BINDING) == 0 && get(gl, GL_ARRAY_BUFFER_BINDING) == GLint(buffer)));
    gl.ClientActiveTexture(GL_TEXTURE2);
    gl.VertexPointer(2, GL_FLOAT, 8, nullptr);
    gl.TexCoordPointer(3, GL_SHORT, 6, nullptr);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.BindVertexArray(0);
    CHECK((get(gl, GL_ELEMENT_ARRAY_BUFFER_BINDING) == GLint(indices) && get(gl, GL_VERTEX_ARRAY_SIZE) == 4));
    CHECK((!gl.IsEnabled(GL_VERTEX_ARRAY) && get(gl, GL_VERTEX_ARRAY_BUFFER_BINDING) == 0));
    CHECK(get(gl, GL_CLIENT_ACTIVE_TEXTURE) == GL_TEXTURE2);
    gl.BindVertexArray(name);
    CHECK((get(gl, GL_VERTEX_ARRAY_SIZE) == 2 && get(gl, GL_VERTEX_ARRAY_BUFFER_BINDING) == GLint(buffer)));
    CHECK((get(gl, GL_TEXTURE_COORD_ARRAY_TYPE) == GL_SHORT && gl.IsEnabled(GL_TEXTURE_COORD_ARRAY)));
    // Addresses of the client's memory are for name 0.
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.VertexPointer(3, GL_FLOAT, 0, point);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    gl.NormalPointer(GL_FLOAT, 0, point);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    if (&gl == &softgl_library()) CHECK(get(gl, GL_VERTEX_ARRAY_SIZE) == 2); // OSMesa has changed it
    gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
    CHECK((gl.GetError() == GL_NO_ERROR && get(gl, GL_VERTEX_ARRAY_SIZE) == 3));
  });
}

TEST_CASE("glPopClientAttrib binds the vertex array object that was bound", "[spec][arrays][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    GLuint names[2] = {};
    gl.GenVertexArrays(2, names);
    gl.BindVertexArray(names[0]);
    gl.EnableClientState(GL_NORMAL_ARRAY);
    gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    gl.DisableClientState(GL_NORMAL_ARRAY);
    gl.BindVertexArray(names[1]);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.PopClientAttrib();
    CHECK((get(gl, GL_VERTEX_ARRAY_BINDING) == GLint(names[0]) && gl.IsEnabled(GL_NORMAL_ARRAY)));
    gl.BindVertexArray(names[1]);
    CHECK((gl.IsEnabled(GL_COLOR_ARRAY) && !gl.IsEnabled(GL_NORMAL_ARRAY)));
    // One that is deleted meanwhile does not come back.
    gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    gl.DeleteVertexArrays(1, &names[1]);
    gl.PopClientAttrib();
    CHECK((get(gl, GL_VERTEX_ARRAY_BINDING) == 0 && !gl.IsEnabled(GL_COLOR_ARRAY)));
  });
}

TEST_CASE("Primitives begin anew at the index of glPrimitiveRestartIndex", "[spec][arrays][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    const std::vector<float> vertices = columns();
    gl.VertexPointer(2, GL_FLOAT, 0, vertices.data());
    gl.EnableClientState(GL_VERTEX_ARRAY);
    const GLubyte fans[] = {0, 1, 2, 3, 255, 16, 17, 18, 19, 255, 24, 25, 255, 28, 29, 30, 31};
    const auto draw = [&] {
      gl.DrawElements(GL_TRIANGLE_FAN, sizeof fans, GL_UNSIGNED_BYTE, fans);
      return drawn_columns(gl);
    };
    gl.PrimitiveRestartIndex(255);
    gl.Enable(GL_PRIMITIVE_RESTART);
    CHECK((gl.IsEnabled(GL_PRIMITIVE_RESTART) && gl.IsEnabled(GL_PRIMITIVE_RESTART_NV)));
    CHECK(draw() == "x...x..x");
    gl.Disable(GL_PRIMITIVE_RESTART);
    gl.PrimitiveRestartIndexNV(16);
    gl.EnableClientState(GL_PRIMITIVE_RESTART_NV);
    CHECK((get(gl, GL_PRIMITIVE_RESTART_INDEX) == 16 && get(gl, GL_PRIMITIVE_RESTART_NV) == 1));
    const GLushort quads[] = {0, 1, 2, 3, 8, 9, 16, 12, 13, 14, 15, 4};
    gl.DrawElements(GL_QUADS, 12, GL_UNSIGNED_SHORT, quads);
    CHECK(drawn_columns(gl) == "x..x....");
    // The index is compared before a base is added.
    gl.DrawElementsBaseVertex(GL_QUADS, 12, GL_UNSIGNED_SHORT, quads, 4);
    CHECK(drawn_columns(gl) == ".x..x...");
    // In a list, and element by element.
    gl.PrimitiveRestartIndex(255);
    gl.NewList(1, GL_COMPILE);
    gl.DrawElements(GL_TRIANGLE_FAN, sizeof fans, GL_UNSIGNED_BYTE, fans);
    gl.EndList();
    gl.CallList(1);
    CHECK(drawn_columns(gl) == "x...x..x");
    gl.PrimitiveRestartIndex(16);
    gl.Begin(GL_TRIANGLE_FAN);
    for (GLint i : {0, 1, 2, 3, 16, 20, 21, 22, 23}) gl.ArrayElement(i);
    gl.PrimitiveRestartNV();
    for (GLint i : {28, 29, 30, 31}) gl.ArrayElement(i);
    gl.End();
    CHECK(drawn_columns(gl) == "x....x.x");
    // It does nothing for glDrawArrays.
    gl.PrimitiveRestartIndex(2);
    gl.DrawArrays(GL_QUADS, 0, 8);
    CHECK(drawn_columns(gl) == "xx......");
    gl.DisableClientState(GL_PRIMITIVE_RESTART_NV);
    CHECK(!gl.IsEnabled(GL_PRIMITIVE_RESTART));
  });
}

TEST_CASE("Each pair of commands has its own name of the restart", "[spec][arrays][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    gl.Enable(GL_PRIMITIVE_RESTART_NV);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.EnableClientState(GL_PRIMITIVE_RESTART);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    CHECK(!gl.IsEnabled(GL_PRIMITIVE_RESTART));
    gl.PrimitiveRestartNV();
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    gl.Begin(GL_POINTS);
    gl.PrimitiveRestartIndex(3);
    gl.End();
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    // Both belong to the client's attributes.
    gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    gl.Enable(GL_PRIMITIVE_RESTART);
    gl.PrimitiveRestartIndex(7);
    gl.PopClientAttrib();
    CHECK((!gl.IsEnabled(GL_PRIMITIVE_RESTART) && get(gl, GL_PRIMITIVE_RESTART_INDEX) == 0));
  });
}

TEST_CASE("glGetInteger64v converts as glGetIntegerv does", "[spec][state][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    GLint64 value[4] = {-7, -7, -7, -7};
    gl.GetInteger64v(GL_MAX_TEXTURE_SIZE, value);
    CHECK((value[0] == get(gl, GL_MAX_TEXTURE_SIZE) && value[1] == -7));
    gl.Viewport(1, 2, 30, 40);
    gl.GetInteger64v(GL_VIEWPORT, value);
    CHECK((value[0] == 1 && value[1] == 2 && value[2] == 30 && value[3] == 40));
    gl.LineWidth(2.5f);
    gl.GetInteger64v(GL_LINE_WIDTH, value);
    CHECK(value[0] == 3);
    gl.GetInteger64v(GL_DEPTH_TEST, value);
    CHECK(value[0] == 0);
    gl.GetInteger64v(GL_POINTS, value);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
  });
}

TEST_CASE("glGetStringi gives the extensions one by one", "[spec][state]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  const std::string all = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
  std::string joined;
  const GLint count = get(gl, GL_NUM_EXTENSIONS);
  for (GLint i = 0; i < count; ++i)
    joined += std::string(reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, GLuint(i)))) + " ";
  CHECK(joined == all);
  CHECK((!gl.GetStringi(GL_EXTENSIONS, GLuint(count)) && gl.GetError() == GL_INVALID_VALUE));
  CHECK((!gl.GetStringi(GL_VENDOR, 0) && gl.GetError() == GL_INVALID_ENUM));
}

TEST_CASE("Colors of arrays may be bytes of blue, green, red and alpha", "[spec][arrays][osmesa]") {
  with_both_libraries([](const Gl& gl) {
    const float corners[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
    const GLubyte bgra[16] = {10, 20, 30, 40, 10, 20, 30, 40, 10, 20, 30, 40, 10, 20, 30, 40};
    gl.VertexPointer(2, GL_FLOAT, 0, corners);
    gl.ColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, 0, bgra);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    CHECK((get(gl, GL_COLOR_ARRAY_SIZE) == GL_BGRA && get(gl, GL_COLOR_ARRAY_STRIDE) == 0));
    const auto pixel = [&] {
      uint32_t word = 0;
      gl.ReadPixels(30, 30, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &word);
      return word;
    };
    gl.DrawArrays(GL_TRIANGLE_FAN, 0, 4);
    CHECK(pixel() == 0x280a141e);
    gl.SecondaryColorPointer(GL_BGRA, GL_UNSIGNED_BYTE, 4, bgra);
    gl.EnableClientState(GL_SECONDARY_COLOR_ARRAY);
    gl.Enable(GL_COLOR_SUM);
    gl.DrawArrays(GL_TRIANGLE_FAN, 0, 4);
    CHECK(pixel() == 0x2814283c);
    gl.ColorPointer(GL_BGRA, GL_FLOAT, 0, bgra);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    gl.ColorPointer(GL_BGRA, GL_RGBA, 0, bgra);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.VertexPointer(GL_BGRA, GL_FLOAT, 0, corners);
    CHECK(gl.GetError() == GL_INVALID_VALUE);
  });
}

TEST_CASE("Arrays are locked once, and drawn as before", "[spec][arrays]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLint value[2] = {};
  gl.LockArraysEXT(1, 3);
  gl.GetIntegerv(GL_ARRAY_ELEMENT_LOCK_FIRST_EXT, &value[0]);
  gl.GetIntegerv(GL_ARRAY_ELEMENT_LOCK_COUNT_EXT, &value[1]);
  CHECK((value[0] == 1 && value[1] == 3));
  gl.LockArraysEXT(0, 4);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  const GLfloat corner[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, corner);
  gl.DrawArrays(GL_QUADS, 0, 4);
  gl.UnlockArraysEXT();
  GLubyte rgba[4] = {};
  gl.ReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  CHECK(rgba[0] == 255);
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.UnlockArraysEXT();
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
}

TEST_CASE("Arrays hold floats of 16 bits", "[spec][arrays]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  // 1, 0.5, -0.25, the smallest one, the largest one, minus zero
  const GLushort halves[] = {0x3c00, 0x3800, 0xb400, 0x0001, 0x7bff, 0x8000};
  gl.TexCoordPointer(3, GL_HALF_FLOAT, 0, halves);
  gl.FogCoordPointer(GL_HALF_FLOAT, 2, halves);
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.EnableClientState(GL_FOG_COORDINATE_ARRAY);
  const auto coordinates = [&](GLint element) {
    gl.Begin(GL_POINTS);
    gl.ArrayElement(element);
    gl.End();
    std::vector<float> v(5);
    gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, v.data());
    gl.GetFloatv(GL_CURRENT_FOG_COORDINATE, &v[4]);
    return v;
  };
  CHECK(coordinates(0) == std::vector<float>{1, 0.5f, -0.25f, 1, 1});
  CHECK(coordinates(1) == std::vector<float>{1.0f / 16777216, 65504, 0, 1, 0.5f});
  gl.NormalPointer(GL_HALF_FLOAT, 0, halves);
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.IndexPointer(GL_HALF_FLOAT, 0, halves);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
}

TEST_CASE("Vertices left over in a list belong to no primitive", "[spec][arrays][lists][osmesa]") {
  const auto drawn = [](const Gl& gl) {
    const CurrentContext current{gl};
    const std::vector<float> vertices = columns();
    gl.NewList(1, GL_COMPILE);
    for (const std::vector<int>& primitive :
         {std::vector<int>{0, 1}, std::vector<int>{12, 13, 14, 0}, std::vector<int>{20, 21, 22}}) {
      gl.Begin(GL_TRIANGLES);
      for (const int i : primitive) gl.Vertex2fv(&vertices[size_t(i) * 2]);
      gl.End();
    }
    gl.EndList();
    gl.CallList(1);
    return drawn_columns(gl);
  };
  CHECK(drawn(softgl_library()) == "...x.x..");
  CHECK(drawn(osmesa_library()) != "...x.x..");
}

TEST_CASE("A primitive without vertices takes nothing from the next one", "[spec][arrays][osmesa]") {
  const auto drawn = [](const Gl& gl) {
    const CurrentContext current{gl};
    const std::vector<float> vertices = columns();
    for (const std::vector<int>& primitive :
         {std::vector<int>{0, 1, 2}, std::vector<int>{}, std::vector<int>{12, 13, 14, 15}}) {
      gl.Begin(GL_TRIANGLE_FAN);
      for (const int i : primitive) gl.Vertex2fv(&vertices[size_t(i) * 2]);
      gl.End();
    }
    return drawn_columns(gl);
  };
  CHECK(drawn(softgl_library()) == "x..x....");
  CHECK(drawn(osmesa_library()) != "x..x....");
}

TEST_CASE("glArrayElement and lists know colors b g r a and floats of 16 bits", "[spec][arrays][osmesa]") {
  const auto drawn = [](const Gl& gl, bool in_list, bool halves) {
    const CurrentContext current{gl};
    const float corners[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
    const GLushort half_corners[8] = {0xbc00, 0xbc00, 0x3c00, 0xbc00, 0x3c00, 0x3c00, 0xbc00, 0x3c00};
    const GLubyte colors[16] = {10, 20, 30, 40, 10, 20, 30, 40, 10, 20, 30, 40, 10, 20, 30, 40};
    if (halves)
      gl.VertexPointer(2, GL_HALF_FLOAT, 0, half_corners);
    else
      gl.VertexPointer(2, GL_FLOAT, 0, corners);
    gl.ColorPointer(halves ? 4 : GL_BGRA, GL_UNSIGNED_BYTE, 0, colors);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    if (in_list) {
      gl.NewList(1, GL_COMPILE_AND_EXECUTE);
      gl.DrawArrays(GL_TRIANGLE_FAN, 0, 4);
      gl.EndList();
    } else {
      gl.Begin(GL_TRIANGLE_FAN);
      for (GLint i = 0; i < 4; ++i) gl.ArrayElement(i);
      gl.End();
    }
    uint32_t pixel = 0;
    gl.ReadPixels(30, 30, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    return pixel;
  };
  for (const bool in_list : {false, true}) {
    CHECK(drawn(softgl_library(), in_list, false) == 0x280a141e);
    CHECK(drawn(osmesa_library(), in_list, false) == 0x281e140a);
    CHECK(drawn(softgl_library(), in_list, true) == 0x281e140a);
    CHECK(drawn(osmesa_library(), in_list, true) != 0x281e140a);
  }
}
