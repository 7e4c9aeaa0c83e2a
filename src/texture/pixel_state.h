// What pixels go through on their way from and to client memory: state that is passed on as plain data.
#pragma once

#include "base/gl_types.h"
#include "base/vectors.h"

namespace softgl {

/// GL_PIXEL_MODE_BIT (tables 6.23 to 6.25).
struct PixelModeState {
  GLenum read_buffer = GL_FRONT;
  float zoom_x = 1, zoom_y = 1;
  Vec4 scale{1, 1, 1, 1}, bias{0, 0, 0, 0};
  float depth_scale = 1, depth_bias = 0;
  GLint index_shift = 0, index_offset = 0;
  bool map_color = false, map_stencil = false;
};
/// Pixel maps (table 6.25), by GL_PIXEL_MAP_I_TO_I + i. They are in no attribute group.
struct PixelMaps {
  GLint size[10] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  float value[10][256] = {};
};
/// GL_CLIENT_PIXEL_STORE_BIT (table 6.22).
struct PixelStore {
  bool swap_bytes = false, lsb_first = false;
  bool invert = false; // GL_MESA_pack_invert: the first row written is the topmost one
  GLint row_length = 0, skip_rows = 0, skip_pixels = 0, alignment = 4;
  GLint image_height = 0, skip_images = 0; // of use to three-dimensional images only
};

} // namespace softgl
