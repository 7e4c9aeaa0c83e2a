// Points, lines and polygons (GL 1.5, 3.3 to 3.5) and which side of a polygon is its front (2.14.1).
#include <algorithm>

#include "commands/buffers/pixel_buffers.h"
#include "commands/generated/commands.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl::gl {

void PointSize(Context& c, GLfloat size) {
  if (size <= 0.0f) return set_error(c, GL_INVALID_VALUE, "size");
  edit<&State::point>(c).size = size;
}

void PointParameter(Context& c, GLenum pname, const GLfloat* params) {
  PointState& point = edit<&State::point>(c);
  float* size = nullptr;
  switch (pname) {
  case GL_POINT_SIZE_MIN: size = &point.size_min; break;
  case GL_POINT_SIZE_MAX: size = &point.size_max; break;
  case GL_POINT_FADE_THRESHOLD_SIZE: size = &point.fade_threshold; break;
  case GL_POINT_DISTANCE_ATTENUATION: point.distance_attenuation = {params[0], params[1], params[2]}; break;
  case GL_POINT_SPRITE_COORD_ORIGIN:
    if (params[0] != float(GL_LOWER_LEFT) && params[0] != float(GL_UPPER_LEFT))
      return set_error(c, GL_INVALID_VALUE, "params");
    point.sprite_origin = GLenum(params[0]);
    break;
  default: return set_error(c, GL_INVALID_ENUM, "pname");
  }
  if (size) {
    if (params[0] < 0.0f) return set_error(c, GL_INVALID_VALUE, "params");
    *size = params[0];
  }
}

void LineWidth(Context& c, GLfloat width) {
  if (width <= 0.0f) return set_error(c, GL_INVALID_VALUE, "width");
  edit<&State::line>(c).width = width;
}

void LineStipple(Context& c, GLint factor, GLushort pattern) {
  LineState& line = edit<&State::line>(c);
  line.stipple_factor = std::clamp(factor, 1, 256);
  line.stipple_pattern = pattern;
}

void CullFace(Context& c, GLenum mode) {
  if (mode != GL_FRONT && mode != GL_BACK && mode != GL_FRONT_AND_BACK)
    return set_error(c, GL_INVALID_ENUM, "mode");
  edit<&State::polygon>(c).cull_face = mode;
}

void FrontFace(Context& c, GLenum mode) {
  if (mode != GL_CW && mode != GL_CCW) return set_error(c, GL_INVALID_ENUM, "mode");
  if (!SOFTGL_FAULT(front_face_ignored)) edit<&State::polygon>(c).front_face = mode;
}

void PolygonMode(Context& c, GLenum face, GLenum mode) {
  if (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL) return set_error(c, GL_INVALID_ENUM, "mode");
  if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK)
    return set_error(c, GL_INVALID_ENUM, "face");
  PolygonState& polygon = edit<&State::polygon>(c);
  if (face != GL_BACK) polygon.mode[0] = mode;
  if (face != GL_FRONT) polygon.mode[1] = mode;
}

void PolygonOffset(Context& c, GLfloat factor, GLfloat units) {
  PolygonState& polygon = edit<&State::polygon>(c);
  polygon.offset_factor = factor;
  polygon.offset_units = units;
}

namespace {

// Where row y of a 32x32 bitmap begins, and its first bit, by the pixel storage modes (3.6.4, table 3.1).
struct StippleRow {
  size_t byte, bit;
};
StippleRow stipple_row(const softgl::PixelStore& store, int y) {
  const size_t length = store.row_length > 0 ? size_t(store.row_length) : 32,
               alignment = size_t(store.alignment);
  const size_t stride = ((length + 7) / 8 + alignment - 1) / alignment * alignment;
  const size_t bit = size_t(store.skip_pixels);
  return {stride * (size_t(store.skip_rows) + size_t(store.invert ? 31 - y : y)) + bit / 8, bit % 8};
}
PixelSpan stipple_span(const softgl::PixelStore& store) {
  const PixelFormat bits = describe_pixel_format(GL_COLOR_INDEX, GL_BITMAP);
  return image_span(store, layout_image(store, 2, 32, 32, bits), 32, 1, bits);
}
unsigned bit_mask(size_t bit, bool lsb_first) { return lsb_first ? 1u << (bit & 7) : 0x80u >> (bit & 7); }

} // namespace

void PolygonStipple(Context& c, const GLubyte* mask) {
  const softgl::PixelStore& store = c.client.pixel_store.unpack;
  const void* memory = mask;
  if (!find_unpack_memory(c, memory, stipple_span(store)) || !memory) return;
  mask = static_cast<const GLubyte*>(memory);
  PolygonStippleState& stipple = edit<&State::polygon_stipple>(c);
  for (int y = 0; y < 32; ++y) {
    const StippleRow row = stipple_row(store, y);
    uint32_t bits = 0;
    for (size_t x = 0; x < 32; ++x) {
      const size_t bit = row.bit + x;
      bits = bits << 1 | ((mask[row.byte + bit / 8] & bit_mask(bit, store.lsb_first)) != 0);
    }
    stipple.row[y] = bits;
  }
}

void GetPolygonStipple(Context& c, GLubyte* mask) {
  const softgl::PixelStore& store = c.client.pixel_store.pack;
  void* memory = mask;
  if (!find_pack_memory(c, memory, stipple_span(store)) || !memory) return;
  mask = static_cast<GLubyte*>(memory);
  for (int y = 0; y < 32; ++y) {
    const StippleRow row = stipple_row(store, y);
    for (size_t x = 0; x < 32; ++x) {
      const size_t bit = row.bit + x;
      const unsigned m = bit_mask(bit, store.lsb_first);
      GLubyte& byte = mask[row.byte + bit / 8];
      byte = GLubyte(c.state.polygon_stipple.row[y] >> (31 - x) & 1 ? byte | m : byte & ~m);
    }
  }
}

} // namespace softgl::gl
