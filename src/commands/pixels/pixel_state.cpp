// Pixel transfer and zoom (GL 1.5, 3.6.3 and 3.6.5), hints (5.6).
#include <cmath>

#include "commands/generated/commands.h"
#include "commands/get_conversion.h"
#include "context/context.h"

namespace softgl::gl {

void PixelTransfer(Context& c, GLenum pname, GLfloat param) {
  PixelModeState& pixel = c.state.pixel_mode;
  switch (pname) {
  case GL_MAP_COLOR: pixel.map_color = param != 0.0f; break;
  case GL_MAP_STENCIL: pixel.map_stencil = param != 0.0f; break;
  case GL_INDEX_SHIFT: pixel.index_shift = to_integer(std::trunc(param), Conversion::Int); break;
  case GL_INDEX_OFFSET: pixel.index_offset = to_integer(std::trunc(param), Conversion::Int); break;
  case GL_RED_SCALE: pixel.scale.r = param; break;
  case GL_GREEN_SCALE: pixel.scale.g = param; break;
  case GL_BLUE_SCALE: pixel.scale.b = param; break;
  case GL_ALPHA_SCALE: pixel.scale.a = param; break;
  case GL_DEPTH_SCALE: pixel.depth_scale = param; break;
  case GL_RED_BIAS: pixel.bias.r = param; break;
  case GL_GREEN_BIAS: pixel.bias.g = param; break;
  case GL_BLUE_BIAS: pixel.bias.b = param; break;
  case GL_ALPHA_BIAS: pixel.bias.a = param; break;
  case GL_DEPTH_BIAS: pixel.depth_bias = param; break;
  default: return set_error(c, GL_INVALID_ENUM, "pname");
  }
}

void PixelZoom(Context& c, GLfloat x, GLfloat y) {
  c.state.pixel_mode.zoom_x = x;
  c.state.pixel_mode.zoom_y = y;
}

void Hint(Context& c, GLenum target, GLenum mode) {
  if (mode != GL_NICEST && mode != GL_FASTEST && mode != GL_DONT_CARE)
    return set_error(c, GL_INVALID_ENUM, "mode");
  HintState& hint = c.state.hint;
  switch (target) {
  case GL_PERSPECTIVE_CORRECTION_HINT: hint.perspective_correction = mode; break;
  case GL_POINT_SMOOTH_HINT: hint.point_smooth = mode; break;
  case GL_LINE_SMOOTH_HINT: hint.line_smooth = mode; break;
  case GL_POLYGON_SMOOTH_HINT: hint.polygon_smooth = mode; break;
  case GL_FOG_HINT: hint.fog = mode; break;
  case GL_GENERATE_MIPMAP_HINT: hint.generate_mipmap = mode; break;
  case GL_PHONG_HINT_WIN: hint.phong = mode; break;
  case GL_TEXTURE_COMPRESSION_HINT: hint.texture_compression = mode; break;
  default: return set_error(c, GL_INVALID_ENUM, "target");
  }
}

} // namespace softgl::gl
