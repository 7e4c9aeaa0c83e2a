// Pixel storage and transfer, bitmaps and pixel rectangles (3.6, 3.7, 4.3.3).
#include <algorithm>

#include "expect/calls.h"
#include "expect/clipping.h"

namespace softgl::suite {
namespace {

void set_store(PixelStore& pack, PixelStore& unpack, GLenum name, int value) {
  switch (name) {
  case GL_UNPACK_SWAP_BYTES: unpack.swap_bytes = value != 0; break;
  case GL_UNPACK_LSB_FIRST: unpack.lsb_first = value != 0; break;
  case GL_UNPACK_ROW_LENGTH: unpack.row_length = value; break;
  case GL_UNPACK_SKIP_ROWS: unpack.skip_rows = value; break;
  case GL_UNPACK_SKIP_PIXELS: unpack.skip_pixels = value; break;
  case GL_UNPACK_ALIGNMENT: unpack.alignment = value; break;
  case GL_UNPACK_IMAGE_HEIGHT: unpack.image_height = value; break;
  case GL_UNPACK_SKIP_IMAGES: unpack.skip_images = value; break;
  case GL_PACK_SWAP_BYTES: pack.swap_bytes = value != 0; break;
  case GL_PACK_LSB_FIRST: pack.lsb_first = value != 0; break;
  case GL_PACK_ROW_LENGTH: pack.row_length = value; break;
  case GL_PACK_SKIP_ROWS: pack.skip_rows = value; break;
  case GL_PACK_SKIP_PIXELS: pack.skip_pixels = value; break;
  case GL_PACK_ALIGNMENT: pack.alignment = value; break;
  default: throw std::logic_error("glPixelStore of what the machine does not know");
  }
}

void set_transfer(PixelTransferState& t, GLenum name, double value) {
  const GLenum scales[4] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE},
               biases[4] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
  for (int i = 0; i < 4; i++) {
    if (name == scales[i]) {
      t.scale[i] = value;
      return;
    }
    if (name == biases[i]) {
      t.bias[i] = value;
      return;
    }
  }
  switch (name) {
  case GL_MAP_COLOR: t.map_color = value != 0; break;
  case GL_MAP_STENCIL: t.map_stencil = value != 0; break;
  case GL_INDEX_SHIFT: t.index_shift = int(value); break;
  case GL_INDEX_OFFSET: t.index_offset = int(value); break;
  case GL_DEPTH_SCALE: t.depth_scale = value; break;
  case GL_DEPTH_BIAS: t.depth_bias = value; break;
  default: throw std::logic_error("glPixelTransfer of what the machine does not know");
  }
}

// Which element of `count` lies at the center of a pixel of the window, or -1 (3.6.4).
int element_at(int pixel, double start, double zoom, int count) {
  const double n = (pixel + 0.5 - start) / zoom;
  if (std::abs(n - std::round(n)) < 1e-3)
    throw std::logic_error("an element that ends at the center of a pixel");
  return n < 0 || n >= count ? -1 : int(n);
}

} // namespace

void Machine::draw_image(const PixelImage& image) {
  const Vec3& start = raster_position_.window;
  const double* zoom = state_.pixel.zoom;
  for (int y = 0; y < raster_.height(); y++)
    for (int x = 0; x < raster_.width(); x++) {
      const int i = element_at(x, start.x, zoom[0], image.width),
                j = element_at(y, start.y, zoom[1], image.height);
      if (i < 0 || j < 0) continue;
      const Pixel& pixel = image.pixels[size_t(j * image.width + i)];
      LitVertex at = raster_position_;
      switch (image.kind) {
      case PixelKind::Color:
        for (int c = 0; c < 4; c++) at.front.primary[c] = spec::clamped(pixel.c[c], 0, 1);
        raster_.pixel(state_, x, y, at, at.window.z);
        break;
      case PixelKind::Depth: raster_.pixel(state_, x, y, at, pixel.c[0]); break;
      case PixelKind::Stencil:
        if (pixel.c[0].low != pixel.c[0].high) throw std::logic_error("a stencil value that is not known");
        raster_.stencil(state_, x, y, int(pixel.c[0].low));
        break;
      case PixelKind::Index: throw std::logic_error("an image of indexes");
      }
    }
}

// glWindowPos (2.13): nothing is transformed, lit, generated or clipped.
void Machine::window_position(const Vec4& at) {
  const CurrentState& current = state_.current;
  raster_position_ = {};
  const double near = state_.viewport.near, far = state_.viewport.far;
  raster_position_.window = {at.x, at.y, near + std::clamp(at.z, 0.0, 1.0) * (far - near)};
  const double color[4] = {current.color.x, current.color.y, current.color.z, current.color.w};
  for (int i = 0; i < 4; i++) raster_position_.front.primary[i] = spec::clamped(color[i], 0, 1);
  raster_position_.back = raster_position_.front;
  raster_position_.fog_distance = 0;
  std::copy(current.texture_coordinate, current.texture_coordinate + kTextureUnits,
            raster_position_.texture.begin());
  raster_position_valid_ = true;
}

void Machine::bitmap(const Call& call) {
  for (double at : {raster_position_.window.x - call.n(2), raster_position_.window.y - call.n(3)})
    if (std::abs(at - std::round(at)) < 1e-3 && at != std::round(at))
      throw std::logic_error("a bitmap that a GL may round either way");
  const int x = int(std::floor(raster_position_.window.x - call.n(2)));
  const int y = int(std::floor(raster_position_.window.y - call.n(3)));
  const bool draws = !receives_pixels(GL_BITMAP_TOKEN);
  const int width = int(call.n(0)), height = int(call.n(1));
  for (int j = 0; j < height && draws; j++)
    for (int i = 0; i < width; i++)
      if (bitmap_bit(state_.unpack, call.v(6), width, i, j))
        raster_.pixel(state_, x + i, y + j, raster_position_, raster_position_.window.z);
  raster_position_.window.x += call.n(4), raster_position_.window.y += call.n(5);
}

bool Machine::play_pixels(const Call& call) {
  if (std::string(facts_of(call.command).name).starts_with("RasterPos")) {
    raster_position_ = transform(vec4(values_of(call)));
    raster_position_valid_ = is_inside(state_, raster_position_);
    if (raster_position_valid_) to_window(raster_position_);
    if (raster_position_valid_ && render_mode_.mode == GL_SELECT) note_hit(render_mode_, {raster_position_});
    return true;
  }
  if (std::string(facts_of(call.command).name).starts_with("WindowPos")) {
    window_position(vec4(values_of(call)));
    if (render_mode_.mode == GL_SELECT) note_hit(render_mode_, {raster_position_});
    return true;
  }
  const auto n = [&](size_t i) { return int(call.n(i)); };
  switch (call.command) {
  case Command::Bitmap:
    if (raster_position_valid_) bitmap(call);
    return true;
  case Command::PixelStorei: set_store(state_.pack, state_.unpack, call.e(0), n(1)); return true;
  case Command::PixelTransferi:
  case Command::PixelTransferf: set_transfer(state_.pixel.transfer, call.e(0), call.n(1)); return true;
  case Command::PixelMapfv: state_.pixel.transfer.maps[call.e(0)] = call.v(2); return true;
  case Command::PixelZoom: state_.pixel.zoom[0] = call.n(0), state_.pixel.zoom[1] = call.n(1); return true;
  case Command::DrawPixels: {
    if (!raster_position_valid_ || receives_pixels(GL_DRAW_PIXEL_TOKEN)) return true;
    PixelImage image = unpack(state_.unpack, call.arguments[4], call.e(2), call.e(3), n(0), n(1), 1);
    transfer(state_.pixel.transfer, image, true);
    draw_image(image);
    return true;
  }
  case Command::CopyPixels: {
    if (!raster_position_valid_ || receives_pixels(GL_COPY_PIXEL_TOKEN)) return true;
    const PixelKind kind = call.e(4) == GL_COLOR     ? PixelKind::Color
                           : call.e(4) == GL_STENCIL ? PixelKind::Stencil
                                                     : PixelKind::Depth;
    PixelImage image = raster_.read(n(0), n(1), n(2), n(3), kind);
    transfer(state_.pixel.transfer, image, true);
    draw_image(image);
    return true;
  }
  default: return false;
  }
}

} // namespace softgl::suite
