// What the suite paints of a GL's answers (script/paint_commands.inc).
#include "expect/calls.h"

namespace softgl::suite {

void Machine::paint_elements(const std::vector<Interval>& elements, const Call& call, size_t first) {
  const int left = int(call.n(first)), bottom = int(call.n(first + 1)), columns = int(call.n(first + 2)),
            size = int(call.n(first + 3));
  for (size_t i = 0; i < elements.size(); i++) {
    const Interval gray[4] = {elements[i], elements[i], elements[i], 1};
    raster_.paint(left + int(i) % columns * size, bottom + int(i) / columns * size, size, gray);
  }
}

bool Machine::play_paint(const Call& call) {
  const Interval green[4] = {0, 1, 0, 1};
  const auto paint_green = [&](size_t first) {
    raster_.paint(int(call.n(first)), int(call.n(first + 1)), kPaintedSquare, green);
    return true;
  };
  switch (call.command) {
  case Command::Raises:
    expected_error_ = expected_error_ == GL_NO_ERROR ? call.e(0) : expected_error_;
    skips_next_ = true;
    return true;
  case Command::PaintError: {
    const Interval red[4] = {painted_error(expected_error_), 0, 0, 1};
    raster_.paint(int(call.n(0)), int(call.n(1)), kPaintedSquare, red);
    expected_error_ = GL_NO_ERROR;
    return true;
  }
  case Command::PaintInteger: return paint_green(3);
  case Command::PaintTexLevel: return paint_green(5);
  case Command::PaintEqual: return paint_green(4);
  case Command::PaintStack: return paint_green(2);
  case Command::PaintTexParameter:
  case Command::PaintTexEnv: return paint_green(4);
  case Command::PaintPixels: {
    PixelImage image =
        raster_.read(int(call.n(0)), int(call.n(1)), int(call.n(2)), int(call.n(3)), kind_of(call.e(4)));
    transfer(state_.pixel.transfer, image, true);
    paint_elements(packed_elements(state_.pack, image, call.e(4), call.e(5), int(call.n(6))), call, 7);
    return true;
  }
  case Command::PaintQuery: {
    const FragmentCount& count = queries_[GLuint(call.n(0))];
    complete_.insert(GLuint(call.n(0)));
    for (int byte = 0; byte < 2; byte++) {
      const bool known = count.low >> 8 == count.high >> 8;
      const Interval gray = byte == 1 ? Interval(count.low >> 8, count.high >> 8)
                            : known   ? Interval(count.low & 255, count.high & 255)
                                      : Interval(0, 255);
      const Interval part{gray.low / 255, gray.high / 255};
      const Interval color[4] = {part, part, part, 1};
      raster_.paint(int(call.n(1)) + byte * kPaintedSquare, int(call.n(2)), kPaintedSquare, color);
    }
    return true;
  }
  case Command::PaintSame: return paint_green(6);
  case Command::PaintRising: return paint_green(5);
  case Command::PaintTexImage: {
    int face = 0;
    const TextureObject& texture =
        state_.texture.bound(state_.texture.active, texture_target(call.e(0), &face));
    const TextureImage& from = texture.images[face][int(call.n(1))];
    PixelImage image{PixelKind::Color, from.width + 2 * from.border, from.height, 1, from.texels};
    if (from.dimensions != 2 || from.border)
      throw std::logic_error("glGetTexImage of what the machine does not know");
    for (Pixel& p : image.pixels) { // table 6.1
      if (from.base == GL_LUMINANCE || from.base == GL_LUMINANCE_ALPHA || from.base == GL_INTENSITY)
        p.c[1] = p.c[2] = 0;
      if (from.base == GL_INTENSITY) p.c[3] = 1;
    }
    paint_elements(packed_elements(state_.pack, image, call.e(2), call.e(3), int(call.n(4))), call, 5);
    return true;
  }
  default: return false;
  }
}

} // namespace softgl::suite
