#include "pixels/scenes.h"

#include <cmath>

#include "gl/subject.h"

namespace softgl::suite {

Test pixel_test(const char* name, const char* section, const char* sentence,
                std::function<void(Script&)> body, Need need, const char* open) {
  return {std::string("pixels.") + name, section, sentence, open, std::move(body), need};
}

void place(Script& s, double x, double y) {
  s.RasterPos3f(float(x / kWindowWidth * 2.4 - 1.2), float(y / kWindowHeight * 2.43 - 1.235), 0.0f);
}

Memory elements_of(GLenum type, int count, bool index) {
  const PixelType& t = pixel_type(type);
  Memory m{type, {}};
  for (int i = 0; i < count; i++) {
    const double part = std::fmod(i * 0.618 + (i / 7) * 0.1731 + 0.11, 1);
    const double range = std::ldexp(1, 8 * t.bytes);
    if (index)
      m.elements.push_back(std::floor(part * 16));
    else if (t.is_float)
      m.elements.push_back(double(float(part * 1.4 - 0.2)));
    else
      m.elements.push_back(std::floor(part * range) - (t.is_signed ? range / 2 : 0));
  }
  return m;
}

void draw_image(Script& s, GLenum format, GLenum type, int width, int height, double zoom) {
  const int components = pixel_type(type).fields > 1 ? 1 : components_of(format);
  place(s, 8.3, 8.2), s.PixelZoom(zoom, zoom), s.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  s.DrawPixels(width, height, format, type, elements_of(type, width * height * components, is_index(format)));
}

void index_maps(Script& s) {
  const V values[] = {{0, 0.3, 0.6, 0.9, 0.2, 0.5, 0.8, 1},
                      {1, 0.1, 0.7, 0.4},
                      {0.5, 0, 1, 0.25, 0.75, 0.1, 0.9, 0.6},
                      {1, 0.6}};
  for (int i = 0; i < 4; i++) s.PixelMapfv(GLenum(GL_PIXEL_MAP_I_TO_R + i), int(values[i].size()), values[i]);
}

void show_alpha(Script& s) { s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND); }

void varied_sheet(Script& s, double z_left, double z_right) {
  s.Begin(GL_TRIANGLES);
  for (int corner : {0, 1, 3, 0, 3, 2}) {
    const float x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1;
    s.Color4f(x > 0 ? 1.0f : 0.2f, y > 0 ? 0.9f : 0.1f, x * y > 0 ? 0.2f : 0.8f, y > 0 ? 1.0f : 0.5f);
    s.Vertex3f(x, y, float(x > 0 ? z_right : z_left));
  }
  s.End();
}

} // namespace softgl::suite
