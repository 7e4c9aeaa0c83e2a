// GL 1.5, 2.9, 3.8.12 and 5.4: names of objects, up to the last one.
#include <catch2/catch.hpp>

#include <set>

#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

constexpr GLuint kLast = 0xffffffffu;

/// `generate(n, names)` gives names that are not used, neither the taken ones nor any twice.
template <class Generate> void expect_unused(std::set<GLuint> taken, Generate generate) {
  for (int round = 0; round < 5; round++) {
    GLuint names[3] = {};
    generate(3, names);
    for (const GLuint name : names) {
      CHECK(name != 0);
      CHECK(taken.insert(name).second);
    }
  }
}

} // namespace

TEST_CASE("names come from the gaps where the last name is used", "[spec][objects]") {
  const Gl& gl = softgl_library();
  for (const GLuint used : {kLast, kLast - 1, kLast - 2}) {
    CurrentContext context(gl);
    INFO(used);
    gl.BindTexture(GL_TEXTURE_2D, 2);
    gl.BindTexture(GL_TEXTURE_2D, used);
    expect_unused({2, used}, [&](GLsizei n, GLuint* names) { gl.GenTextures(n, names); });
    gl.BindBuffer(GL_ARRAY_BUFFER, 2);
    gl.BindBuffer(GL_ARRAY_BUFFER, used);
    expect_unused({2, used}, [&](GLsizei n, GLuint* names) { gl.GenBuffers(n, names); });
    for (const GLuint list : {GLuint(2), used}) gl.NewList(list, GL_COMPILE), gl.EndList();
    expect_unused({2, used}, [&](GLsizei n, GLuint* names) {
      const GLuint first = gl.GenLists(n);
      for (GLsizei i = 0; i < n; i++) names[i] = first ? first + GLuint(i) : 0;
    });
    CHECK(gl.GetError() == GL_NO_ERROR);
  }
}

TEST_CASE("names behind the last one are not deleted", "[spec][objects][lists]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (const GLuint list : {3u, 0xfffffff0u, kLast}) gl.NewList(list, GL_COMPILE), gl.EndList();
  gl.DeleteLists(0xfffffff0u, 0x20);
  CHECK(gl.IsList(3));
  CHECK_FALSE(gl.IsList(0xfffffff0u));
  CHECK_FALSE(gl.IsList(kLast));
  for (const GLuint list : {kLast - 1, kLast}) gl.NewList(list, GL_COMPILE), gl.EndList();
  gl.DeleteLists(kLast, 0x7fffffff); // more names than there are lists
  CHECK(gl.IsList(3));
  CHECK(gl.IsList(kLast - 1));
  CHECK_FALSE(gl.IsList(kLast));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

} // namespace softgl::test
