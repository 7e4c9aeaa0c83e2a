#include "lighting/scenes.h"

#include <cmath>
#include <numbers>

namespace softgl::suite {

void dark(Script& s) {
  s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0, 0, 0, 1});
  for (GLenum term : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION})
    s.Materialfv(GL_FRONT_AND_BACK, term, V{0, 0, 0, 1});
  s.Enable(GL_LIGHTING);
}

void lamp(Script& s, GLenum light, V position) {
  for (GLenum term : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) s.Lightfv(light, term, V{0, 0, 0, 1});
  s.Lightfv(light, GL_POSITION, position);
  s.Enable(light);
}

void diffuse_scene(Script& s, V position, V color) {
  dark(s), lamp(s, GL_LIGHT0, position);
  s.Lightfv(GL_LIGHT0, GL_DIFFUSE, color);
  s.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, V{1, 1, 1, 1});
}

void specular_scene(Script& s, V position, double shininess) {
  dark(s), lamp(s, GL_LIGHT0, position);
  s.Lightfv(GL_LIGHT0, GL_SPECULAR, V{1, 1, 1, 1});
  s.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, V{0.9, 0.8, 1, 1});
  s.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, shininess);
}

void dome_vertex(Script& s, const Dome& d, double x, double y) {
  const double length = d.normal_length / std::sqrt(1 + d.tilt * d.tilt * (x * x + y * y));
  s.Normal3f(float(d.tilt * x * length), float(d.tilt * y * length), float(length));
  s.Vertex3f(float(d.x + d.size * x), float(d.y + d.size * y), float(0.2 * (1 - x * x - y * y)));
}

void dome(Script& s, const Dome& d) {
  s.Begin(GL_TRIANGLES);
  const auto at = [&](int i) { return 2.0 * i / d.cells - 1; };
  for (int j = 0; j < d.cells; j++)
    for (int i = 0; i < d.cells; i++) {
      const int corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
      for (int k = 0; k < 6; k++) {
        // Clockwise: the second and third vertex of each triangle change places.
        const int from = d.inward ? (k == 1 ? 2 : k == 2 ? 1 : k == 4 ? 5 : k == 5 ? 4 : k) : k;
        dome_vertex(s, d, at(i + corners[from][0]), at(j + corners[from][1]));
      }
    }
  s.End();
}

void sheet(Script& s, double left, double bottom, double right, double top, double z) {
  s.Begin(GL_TRIANGLES);
  s.Vertex3f(float(left), float(bottom), float(z)), s.Vertex3f(float(right), float(bottom), float(z));
  s.Vertex3f(float(right), float(top), float(z)), s.Vertex3f(float(left), float(bottom), float(z));
  s.Vertex3f(float(right), float(top), float(z)), s.Vertex3f(float(left), float(top), float(z));
  s.End();
}

void chart(Script& s, int rows) {
  const double step = 2.0 / rows;
  for (int j = 0; j < rows; j++)
    for (int i = 0; i < rows; i++) {
      const double turn = 2 * std::numbers::pi * i / rows, tilt = (j + 0.5) / rows * std::numbers::pi / 2;
      s.Normal3f(float(std::sin(tilt) * std::cos(turn)), float(std::sin(tilt) * std::sin(turn)),
                 float(std::cos(tilt)));
      sheet(s, -1 + step * i, -1 + step * j, -1 + step * (i + 0.85), -1 + step * (j + 0.85));
    }
}

void perspective(Script& s) {
  s.MatrixMode(GL_PROJECTION), s.LoadIdentity();
  s.Frustum(-0.24, 0.24, -0.247, 0.239, 1.0, 20.0);
  s.MatrixMode(GL_MODELVIEW);
}

} // namespace softgl::suite
