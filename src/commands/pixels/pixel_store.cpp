// glPixelStore (GL 1.5, 3.6.1 and 4.3.2).
#include "commands/generated/commands.h"
#include "context/context.h"

namespace softgl::gl {

void PixelStore(Context& c, GLenum pname, GLint param) {
  softgl::PixelStore& pack = c.client.pixel_store.pack;
  softgl::PixelStore& unpack = c.client.pixel_store.unpack;
  GLint* size = nullptr;
  switch (pname) {
  case GL_PACK_SWAP_BYTES: pack.swap_bytes = param != 0; return;
  case GL_PACK_INVERT_MESA: pack.invert = param != 0; return;
  case GL_PACK_LSB_FIRST: pack.lsb_first = param != 0; return;
  case GL_UNPACK_SWAP_BYTES: unpack.swap_bytes = param != 0; return;
  case GL_UNPACK_LSB_FIRST: unpack.lsb_first = param != 0; return;
  case GL_PACK_ALIGNMENT:
  case GL_UNPACK_ALIGNMENT:
    if (param != 1 && param != 2 && param != 4 && param != 8) return set_error(c, GL_INVALID_VALUE, "param");
    (pname == GL_PACK_ALIGNMENT ? pack : unpack).alignment = param;
    return;
  case GL_PACK_ROW_LENGTH: size = &pack.row_length; break;
  case GL_PACK_SKIP_ROWS: size = &pack.skip_rows; break;
  case GL_PACK_SKIP_PIXELS: size = &pack.skip_pixels; break;
  case GL_PACK_IMAGE_HEIGHT: size = &pack.image_height; break;
  case GL_PACK_SKIP_IMAGES: size = &pack.skip_images; break;
  case GL_UNPACK_ROW_LENGTH: size = &unpack.row_length; break;
  case GL_UNPACK_SKIP_ROWS: size = &unpack.skip_rows; break;
  case GL_UNPACK_SKIP_PIXELS: size = &unpack.skip_pixels; break;
  case GL_UNPACK_IMAGE_HEIGHT: size = &unpack.image_height; break;
  case GL_UNPACK_SKIP_IMAGES: size = &unpack.skip_images; break;
  default: return set_error(c, GL_INVALID_ENUM, "pname");
  }
  if (param < 0) return set_error(c, GL_INVALID_VALUE, "param");
  *size = param;
}

} // namespace softgl::gl
