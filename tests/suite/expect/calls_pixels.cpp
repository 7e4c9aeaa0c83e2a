// The raster position (2.13), bitmaps and pixel rectangles (3.6, 3.7).
#include "expect/calls.h"

namespace softgl::suite {

void Machine::bitmap(const Call& call) {
  for (double byte : call.v(6))
    if (byte != 255) throw std::logic_error("a bitmap that is not all ones");
  const int x = int(std::floor(raster_position_.window.x - call.n(2)));
  const int y = int(std::floor(raster_position_.window.y - call.n(3)));
  raster_.rectangle(state_, x, y, int(call.n(0)), int(call.n(1)), raster_position_.front,
                    raster_position_.window.z);
  raster_position_.window.x += call.n(4), raster_position_.window.y += call.n(5);
}

bool Machine::play_pixels(const Call& call) {
  switch (call.command) {
  case Command::RasterPos3f: raster_position_ = transform(vec4(numbers_of(call, 0))); return true;
  case Command::Bitmap: bitmap(call); return true;
  case Command::PixelStorei: return true;
  default: return false;
  }
}

} // namespace softgl::suite
