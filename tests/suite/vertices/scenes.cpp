#include "vertices/scenes.h"

#include <cmath>
#include <numbers>

namespace softgl::suite {

void tint(Script& s, int i) {
  static const double colors[7][3] = {{1, 0.2, 0.1}, {0.2, 1, 0.3},     {0.3, 0.4, 1},  {1, 0.9, 0.2},
                                      {0.9, 0.3, 1}, {0.2, 0.95, 0.95}, {0.9, 0.9, 0.9}};
  s.Color3f(colors[i % 7][0], colors[i % 7][1], colors[i % 7][2]);
}

void arrow(Script& s) {
  s.Begin(GL_TRIANGLES);
  tint(s, 0), s.Vertex3f(-0.41, -0.23, 0);
  tint(s, 1), s.Vertex3f(0.39, -0.11, 0);
  tint(s, 2), s.Vertex3f(-0.13, 0.42, 0);
  s.End();
}

void zigzag(Script& s, GLenum mode, int count) {
  s.Begin(mode);
  for (int i = 0; i < count; i++) {
    tint(s, i);
    s.Vertex3f(-0.95 + 1.9 * i / (count - 1), i % 2 ? 0.83 : -0.81, 0);
  }
  s.End();
}

void ring(Script& s, GLenum mode, int count, bool center) {
  s.Begin(mode);
  if (center) tint(s, 6), s.Vertex3f(0.03, 0.02, 0);
  for (int i = 0; i < count; i++) {
    const double turn = 2 * std::numbers::pi * i / (count - (center ? 1 : 0)) + 0.1;
    tint(s, i), s.Vertex3f(0.95 * std::cos(turn), 0.95 * std::sin(turn), 0);
  }
  s.End();
}

void quads(Script& s, int count, int extra) {
  s.Begin(GL_QUADS);
  for (int i = 0; i < 4 * count + extra; i++) {
    const double x = -0.95 + 1.9 * (i / 4) / (count + 0.4), width = 1.5 / (count + 0.4);
    tint(s, i / 4);
    s.Vertex3f(x + (i % 4 == 1 || i % 4 == 2 ? width : 0), i % 4 >= 2 ? 0.83 : -0.81, 0);
  }
  s.End();
}

void mesh(Script& s, double left, double bottom, double right, double top, int cells, double z_left,
          double z_right) {
  static const int corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
  s.Begin(GL_TRIANGLES);
  for (int j = 0; j < cells; j++)
    for (int i = 0; i < cells; i++)
      for (const auto& corner : corners) {
        const double x = double(i + corner[0]) / cells, y = double(j + corner[1]) / cells;
        s.Color3f(0.2 + 0.8 * x, 1 - 0.8 * y, 0.3 + 0.5 * y);
        // Edges shall not run through the centers of pixels.
        s.Vertex3f(left + 0.007 + x * (right - left), bottom + y * (top - bottom),
                   z_left + x * (z_right - z_left));
      }
  s.End();
}

void patch(Script& s, double x, double y, double half) {
  s.Begin(GL_TRIANGLE_STRIP);
  s.Vertex3f(x - half, y - half, 0), s.Vertex3f(x + half, y - half, 0);
  s.Vertex3f(x - half, y + half, 0), s.Vertex3f(x + half, y + half, 0);
  s.End();
}

Test row(const char* name, const char* section, const char* sentence, std::function<void(Script&)> body,
         Need need) {
  return {std::string("vertices.") + name, section, sentence, "", std::move(body), need};
}

} // namespace softgl::suite
