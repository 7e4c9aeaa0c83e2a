#include "scene/float_target.h"

#include <cstring>
#include <initializer_list>
#include <string>

#include "common/program_error.h"

namespace softgl::cli {
namespace {

// Not every library of OSMesa's ABI exports them.
template <class Function> Function find(const char* name) {
  const OSMESAproc function = OSMesaGetProcAddress(name);
  if (!function) throw ProgramError(kCannotRead, std::string("this GL library has no ") + name);
  return reinterpret_cast<Function>(function);
}

} // namespace

struct FloatTarget::Functions {
  PFNGLGENFRAMEBUFFERSPROC gen_framebuffers = find<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers");
  PFNGLBINDFRAMEBUFFERPROC bind_framebuffer = find<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
  PFNGLDELETEFRAMEBUFFERSPROC delete_framebuffers = find<PFNGLDELETEFRAMEBUFFERSPROC>("glDeleteFramebuffers");
  PFNGLCHECKFRAMEBUFFERSTATUSPROC check = find<PFNGLCHECKFRAMEBUFFERSTATUSPROC>("glCheckFramebufferStatus");
  PFNGLGENRENDERBUFFERSPROC gen_buffers = find<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers");
  PFNGLBINDRENDERBUFFERPROC bind_buffer = find<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer");
  PFNGLDELETERENDERBUFFERSPROC delete_buffers = find<PFNGLDELETERENDERBUFFERSPROC>("glDeleteRenderbuffers");
  PFNGLRENDERBUFFERSTORAGEPROC storage = find<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage");
  PFNGLFRAMEBUFFERRENDERBUFFERPROC attach =
      find<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer");
  PFNGLCLAMPCOLORARBPROC clamp = find<PFNGLCLAMPCOLORARBPROC>("glClampColorARB");
};

const FloatTarget::Functions& FloatTarget::functions() {
  static const Functions all;
  return all;
}

FloatTarget::FloatTarget(int width, int height, bool clamp)
    : gl_(functions()), width_(width), height_(height) {
  for (const char* extension : {"GL_ARB_framebuffer_object", "GL_ARB_color_buffer_float"})
    if (!has_extension(extension))
      throw ProgramError(kCannotRead, std::string("this GL library draws no floats (") + extension + ")");
  const Functions& gl = gl_;
  gl.gen_framebuffers(1, &framebuffer_);
  gl.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.gen_buffers(2, buffers_);
  const struct {
    GLenum format, attachment;
  } kinds[2] = {{GL_RGBA32F, GL_COLOR_ATTACHMENT0}, {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT}};
  for (size_t i = 0; i < 2; ++i) {
    gl.bind_buffer(GL_RENDERBUFFER, buffers_[i]);
    gl.storage(GL_RENDERBUFFER, kinds[i].format, width, height);
    gl.attach(GL_FRAMEBUFFER, kinds[i].attachment, GL_RENDERBUFFER, buffers_[i]);
  }
  if (glGetError() == GL_OUT_OF_MEMORY) throw std::bad_alloc();
  if (gl.check(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw ProgramError(kCannotRead, "this GL library draws no floats of " + std::to_string(width) + "x" +
                                        std::to_string(height) + " pixels");
  const GLenum how = clamp ? GL_TRUE : GL_FALSE;
  gl.clamp(GL_CLAMP_VERTEX_COLOR_ARB, how);
  gl.clamp(GL_CLAMP_FRAGMENT_COLOR_ARB, how);
  gl.clamp(GL_CLAMP_READ_COLOR_ARB, GL_FALSE);
}

FloatTarget::~FloatTarget() {
  gl_.bind_framebuffer(GL_FRAMEBUFFER, 0);
  gl_.delete_framebuffers(1, &framebuffer_);
  gl_.delete_buffers(2, buffers_);
}

GrowingArray<float> FloatTarget::colors() const { return read(GL_RGBA, 4); }

GrowingArray<float> FloatTarget::depths() const { return read(GL_DEPTH_COMPONENT, 1); }

GrowingArray<float> FloatTarget::read(GLenum format, size_t channels) const {
  const size_t row = size_t(width_) * channels, rows = size_t(height_);
  GrowingArray<float> values, line;
  float* first = values.extend(row * rows);
  line.extend(row);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, format, GL_FLOAT, first);
  for (size_t y = 0; y < rows / 2; ++y) { // GL counts from the bottom
    float *low = first + y * row, *high = first + (rows - 1 - y) * row;
    std::memcpy(line.data(), low, row * sizeof(float));
    std::memcpy(low, high, row * sizeof(float));
    std::memcpy(high, line.data(), row * sizeof(float));
  }
  return values;
}

} // namespace softgl::cli
