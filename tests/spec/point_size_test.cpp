// GL 1.5, 3.3: the size of points.
#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

#include "spec/state_snapshot.h"

namespace softgl::test {

TEST_CASE("a point's size is clamped whether it depends on the distance or not", "[spec][points]") {
  const Gl& gl = softgl_library();
  struct Case {
    GLfloat size, least, most;
    int pixels;
  };
  for (const Case& c : {Case{10, 0, 4, 16}, Case{2, 8, 20, 64}, Case{10, 0, 0.5f, 1}, Case{6, 2, 9, 36}})
    for (const GLfloat quadratic : {0.0f, 1e-20f}) { // the second asks for the distance
      CurrentContext context(gl);
      gl.PointSize(c.size);
      gl.PointParameterf(GL_POINT_SIZE_MIN, c.least);
      gl.PointParameterf(GL_POINT_SIZE_MAX, c.most);
      const GLfloat attenuation[3] = {1, 0, quadratic};
      gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
      gl.Begin(GL_POINTS);
      gl.Vertex2f(0, 0);
      gl.End();
      std::vector<GLubyte> p(64 * 64 * 4);
      gl.ReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, p.data());
      INFO(c.size << " within " << c.least << " and " << c.most);
      CHECK(std::count(p.begin(), p.end(), GLubyte(255)) == 4 * c.pixels);
    }
}

} // namespace softgl::test
