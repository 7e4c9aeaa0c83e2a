#include "raster/scenes.h"

#include <cmath>

#include "gl/subject.h"

namespace softgl::suite {

Test raster_test(const std::string& name, const char* section, const char* sentence,
                 std::function<void(Script&)> body, Need need, const char* open) {
  return {"raster." + name, section, sentence, open, std::move(body), need};
}

void pixel_vertex(Script& s, double x, double y, double z) {
  s.Vertex3f(x / kWindowWidth * 2.4 - 1.2, y / kWindowHeight * 2.43 - 1.235, z); // as in prologue
}

void box(Script& s, double left, double bottom, double right, double top, double z) {
  s.Begin(GL_QUADS);
  pixel_vertex(s, left, bottom, z), pixel_vertex(s, right, bottom, z), pixel_vertex(s, right, top, z),
      pixel_vertex(s, left, top, z);
  s.End();
}

void triangle(Script& s, std::initializer_list<std::pair<double, double>> corners, double z) {
  s.Begin(GL_TRIANGLES);
  for (const auto& [x, y] : corners) pixel_vertex(s, x, y, z);
  s.End();
}

void star(Script& s, double inner, bool varied) {
  s.Begin(GL_LINES);
  for (int i = 0; i < 12; i++) {
    const double x = std::cos(0.5236 * i + 0.11), y = std::sin(0.5236 * i + 0.11);
    tint(s, i), pixel_vertex(s, 48.2 + inner * x, 48.3 + inner * y), tint(s, i + varied),
        pixel_vertex(s, 48.2 + 43 * x, 48.3 + 43 * y);
  }
  s.End();
}

void two_faces(Script& s) {
  tint(s, 1), triangle(s, {{10.2, 12.3}, {44.1, 15.2}, {28.4, 80.3}});
  tint(s, 3), triangle(s, {{52.2, 12.3}, {68.4, 80.3}, {86.1, 15.2}});
}

void slope(Script& s, double moved) {
  s.Begin(GL_TRIANGLES);
  pixel_vertex(s, 6.2, 10.1, -11 + moved), pixel_vertex(s, 90.3, 14.2, 2 + moved),
      pixel_vertex(s, 12.4, 88.3, -11 + moved);
  s.End();
}

void stripes(Script& s) {
  for (int i = 0; i < 4; i++)
    s.Color4ub(255 - 70 * i, 30 + 60 * i, 60 * (i * 3 % 4), 60 + 60 * i),
        box(s, 8 + 20 * i, 5, 28 + 20 * i, 91);
}

void crossing_stripes(Script& s) {
  for (int i = 0; i < 4; i++)
    s.Color4ub(20 + 60 * i, 240 - 70 * i, 80 * ((i * 3 + 1) % 4), 250 - 75 * i),
        box(s, 5, 10 + 20 * i, 91, 24 + 20 * i);
}

} // namespace softgl::suite
