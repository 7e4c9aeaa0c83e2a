#include "scene/gl_context.h"

#include <new>
#include <string>

#include "common/program_error.h"

namespace softgl::cli {

void GlContext::Destroy::operator()(osmesa_context* context) const { OSMesaDestroyContext(context); }

GlContext::GlContext(uint8_t* pixels, int width, int height, int depth_bits, int stencil_bits)
    : context_(OSMesaCreateContextExt(OSMESA_RGBA, depth_bits, stencil_bits, 0, nullptr)) {
  if (!context_) throw std::bad_alloc(); // a context of this kind is refused for no other reason
  attach(pixels, width, height);
  OSMesaPixelStore(OSMESA_Y_UP, 0);
}

void GlContext::attach(uint8_t* pixels, int width, int height) const {
  if (OSMesaMakeCurrent(context_.get(), pixels, GL_UNSIGNED_BYTE, width, height)) return;
  GLint most_columns = 0, most_rows = 0;
  OSMesaGetIntegerv(OSMESA_MAX_WIDTH, &most_columns);
  OSMesaGetIntegerv(OSMESA_MAX_HEIGHT, &most_rows);
  if (width <= most_columns && height <= most_rows) throw std::bad_alloc();
  throw ProgramError(kUsageError, "GL cannot draw a picture of " + std::to_string(width) + "x" +
                                      std::to_string(height) + " samples");
}

void GlContext::finish() {
  glFinish();
  const GLenum error = glGetError();
  if (error == GL_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error != GL_NO_ERROR)
    throw ProgramError(kCannotRead, "GL error " + std::to_string(error) + " while drawing");
}

} // namespace softgl::cli
