#include "special/scenes.h"

namespace softgl::suite {

Test special_test(const std::string& name, const char* section, const char* sentence,
                  std::function<void(Script&)> body, Need need, const char* open) {
  return {"special." + name, section, sentence, open, std::move(body), need};
}

void fed_back(Script& s, GLenum type, const std::function<void()>& draw, FedOrder order, int size,
              int numbers) {
  s.FeedbackBuffer(numbers, type, V(size_t(std::max(numbers, 40)), kUntouchedFeedback));
  s.RenderMode(GL_FEEDBACK), draw(), s.RenderMode(GL_RENDER), s.PaintFeedback(int(order), size);
}

void selected(Script& s, const std::function<void()>& draw, int room, int numbers) {
  s.SelectBuffer(numbers, V(size_t(room), kUntouchedName)), s.RenderMode(GL_SELECT), draw();
  s.RenderMode(GL_RENDER), s.PaintSelection(8);
}

void corner(Script& s, int color, double x, double y, double z) {
  tint(s, color), s.TexCoord2f(0.1 * color - 0.3, 1.7 - 0.2 * color), pixel_vertex(s, x, y, z);
}

void shape(Script& s, double x, double y, double z, GLenum mode) {
  s.Begin(mode), corner(s, 0, x - 14.2, y - 11.3, z), corner(s, 1, x + 13.1, y - 7.4, z + 1.3),
      corner(s, 2, x + 2.7, y + 12.6, z - 0.9), s.End();
}

void dot(Script& s, double x, double y, double z) { s.Begin(GL_POINTS), pixel_vertex(s, x, y, z), s.End(); }

void raster_at(Script& s, double x, double y, double z) {
  s.RasterPos3f(x / 96 * 2.4 - 1.2, y / 96 * 2.43 - 1.235, z); // as in prologue
}

} // namespace softgl::suite
