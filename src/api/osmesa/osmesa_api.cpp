// The 13 functions of OSMesa, as OSMesa 22.3.6 answers them.
#include <GL/osmesa.h>
#include <softgl/softgl.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

#include "api/call_trace.h"
#include "api/names.h"
#include "commands/framebuffer/flush.h"
#include "context/context.h"
#include "context/current_context.h"
#include "frame/surface_work.h"

using namespace softgl;

struct osmesa_context : Context {
  GLenum format = OSMESA_RGBA;
  bool ever_current = false;
};

namespace {

constexpr int kMaxSize = 16384;     // what is promised
constexpr int kSizeLimit = 1 << 16; // what the rasterizer's fixed-point coordinates can hold

osmesa_context* current() {
  Context* c = current_context;
  return c->guard & kNoContext ? nullptr : static_cast<osmesa_context*>(c);
}

bool known_format(int format) {
  switch (format) {
  case OSMESA_COLOR_INDEX:
  case OSMESA_RGBA:
  case OSMESA_BGRA:
  case OSMESA_ARGB:
  case OSMESA_RGB:
  case OSMESA_BGR:
  case OSMESA_RGB_565: return true;
  default: return false;
  }
}

/// How pixels of this format and type are drawn; false when there is no such buffer.
bool choose_color_format(GLenum format, GLenum type, ColorFormat& chosen) {
  if (format == OSMESA_RGB_565) {
    chosen = ColorFormat::Rgb565;
    return type == GL_UNSIGNED_SHORT_5_6_5;
  }
  if (format == OSMESA_COLOR_INDEX || format == OSMESA_BGR) return false;
  switch (type) {
  case GL_UNSIGNED_BYTE: chosen = ColorFormat::Rgba8; return true;
  case GL_UNSIGNED_SHORT: chosen = ColorFormat::Rgba16; return true;
  case GL_FLOAT: chosen = ColorFormat::RgbaFloat; return true;
  default: return false;
  }
}

/// Samples of a pixel of the window where the program does not say.
int default_samples() {
  const char* samples = std::getenv("SOFTGL_SAMPLES");
  return samples && std::strcmp(samples, "4") == 0 ? kSamples : 0;
}

struct ContextRequest {
  GLenum format = OSMESA_RGBA;
  int depth = 0, stencil = 0, accumulation = 0, major = 1, minor = 0, samples = default_samples();
  int osmesa_quadrilaterals = osmesa_quadrilaterals_by_environment();
  int specification_answers = specification_answers_by_environment();
};

/// False for an attribute or value that is not known.
bool read_attributes(const int* list, ContextRequest& request) {
  for (; list[0] != 0; list += 2) {
    const int value = list[1];
    switch (list[0]) {
    case OSMESA_FORMAT:
      if (!known_format(value)) return false;
      request.format = GLenum(value);
      break;
    case OSMESA_DEPTH_BITS: request.depth = value; break;
    case OSMESA_STENCIL_BITS: request.stencil = value; break;
    case OSMESA_ACCUM_BITS: request.accumulation = value; break;
    case OSMESA_PROFILE:
      // The pipeline of a core profile has no fixed functions: there is none here.
      if (value != OSMESA_COMPAT_PROFILE) return false;
      break;
    case SOFTGL_SAMPLES: request.samples = value; break;
    case OSMESA_CONTEXT_MAJOR_VERSION: request.major = value; break;
    case OSMESA_CONTEXT_MINOR_VERSION: request.minor = value; break;
    case SOFTGL_OSMESA_QUADS:
      if (value != 0 && value != 1) return false;
      request.osmesa_quadrilaterals = value;
      break;
    case SOFTGL_SPECIFICATION_ANSWERS:
      if (value != 0 && value != 1) return false;
      request.specification_answers = value;
      break;
    default:
      std::fprintf(stderr, "OSMesaCreateContextAttribs(unknown attribute 0x%x)\n", unsigned(list[0]));
      return false;
    }
  }
  return request.depth >= 0 && request.stencil >= 0 && request.accumulation >= 0 && request.major >= 1 &&
         request.minor >= 0 && (request.samples == 0 || request.samples == kSamples);
}

/// The picture goes to the caller's buffer before the thread takes another context. False: there was no
/// memory for it.
bool leave(Context& c) noexcept try {
  if (!(c.guard & kNoContext)) finish_and_resolve(c);
  return true;
} catch (...) {
  set_error(c, GL_OUT_OF_MEMORY);
  return false;
}

/// The planes of a context that becomes current.
bool allocate_planes(Context& c, int width, int height, ColorFormat color_format) noexcept try {
  flush_rendering(c);
  if (!c.framebuffer.allocate(width, height, color_format)) throw std::bad_alloc();
  c.framebuffer.unresolved = false;
  c.framebuffer.depth_copy.clear();
  return true;
} catch (...) {
  set_error(c, GL_OUT_OF_MEMORY);
  return false;
}

const struct {
  const char* name;
  OSMESAproc function;
} kFunctions[] = {{"OSMesaCreateContext", OSMESAproc(OSMesaCreateContext)},
                  {"OSMesaCreateContextExt", OSMESAproc(OSMesaCreateContextExt)},
                  {"OSMesaCreateContextAttribs", OSMESAproc(OSMesaCreateContextAttribs)},
                  {"OSMesaDestroyContext", OSMESAproc(OSMesaDestroyContext)},
                  {"OSMesaMakeCurrent", OSMESAproc(OSMesaMakeCurrent)},
                  {"OSMesaGetCurrentContext", OSMESAproc(OSMesaGetCurrentContext)},
                  {"OSMesaPixelStore", OSMESAproc(OSMesaPixelStore)},
                  {"OSMesaGetIntegerv", OSMESAproc(OSMesaGetIntegerv)},
                  {"OSMesaGetDepthBuffer", OSMESAproc(OSMesaGetDepthBuffer)},
                  {"OSMesaGetColorBuffer", OSMESAproc(OSMesaGetColorBuffer)},
                  {"OSMesaGetProcAddress", OSMESAproc(OSMesaGetProcAddress)},
                  {"OSMesaColorClamp", OSMESAproc(OSMesaColorClamp)},
                  {"OSMesaPostprocess", OSMESAproc(OSMesaPostprocess)}};

} // namespace

extern "C" {

SOFTGL_EXPORT OSMesaContext OSMesaCreateContext(GLenum format, OSMesaContext sharelist) {
  SOFTGL_TRACED(OSMesaCreateContext, format, sharelist);
  return OSMesaCreateContextExt(format, 24, 8, 0, sharelist);
}

SOFTGL_EXPORT OSMesaContext OSMesaCreateContextExt(GLenum format, GLint depthBits, GLint stencilBits,
                                                   GLint accumBits, OSMesaContext sharelist) {
  SOFTGL_TRACED(OSMesaCreateContextExt, format, depthBits, stencilBits, accumBits, sharelist);
  const int attributes[] = {OSMESA_FORMAT,     int(format),         OSMESA_DEPTH_BITS,
                            depthBits,         OSMESA_STENCIL_BITS, stencilBits,
                            OSMESA_ACCUM_BITS, accumBits,           0};
  return OSMesaCreateContextAttribs(attributes, sharelist);
}

SOFTGL_EXPORT OSMesaContext OSMesaCreateContextAttribs(const int* attribList, OSMesaContext sharelist) {
  SOFTGL_TRACED(OSMesaCreateContextAttribs, attribList, sharelist);
  ContextRequest request;
  if (attribList && !read_attributes(attribList, request)) return nullptr;
  // What GL 1.5 can be asked for: OSMesa answers with the newest compatible version, which here is 1.5.
  if (request.major > 1 || request.minor > 5) return nullptr;
  try {
    auto context = std::make_unique<osmesa_context>();
    osmesa_context* c = context.get();
    c->format = request.format;
    c->osmesa_quadrilaterals = request.osmesa_quadrilaterals != 0;
    c->specification_answers = request.specification_answers != 0;
    Framebuffer& f = c->framebuffer;
    f.has_alpha = request.format != OSMESA_RGB && request.format != OSMESA_RGB_565;
    f.stencil_bits = request.stencil > 0 ? 8 : 0;
    f.depth_bits = request.depth <= 0                           ? 0
                   : request.stencil > 0 || request.depth >= 24 ? 24
                   : request.depth >= 16                        ? 16
                                                                : 0;
    f.accumulation_bits = request.accumulation > 0 ? 16 : 0;
    f.client.format = request.format;
    f.set_samples(request.samples ? request.samples : 1);
    c->read = &f.seen();
    if (sharelist) c->shared = sharelist->shared;
    return context.release();
  } catch (...) { return nullptr; }
}

SOFTGL_EXPORT void OSMesaDestroyContext(OSMesaContext ctx) {
  SOFTGL_TRACED(OSMesaDestroyContext, ctx);
  if (!ctx) return;
  // The buffer is not written: programs free it first and then destroy the context.
  if (current_context == ctx) current_context = none_context();
  delete ctx;
}

SOFTGL_EXPORT GLboolean OSMesaMakeCurrent(OSMesaContext ctx, void* buffer, GLenum type, GLsizei width,
                                          GLsizei height) {
  SOFTGL_TRACED(OSMesaMakeCurrent, ctx, buffer, type, width, height);
  if (!ctx && !buffer) {
    if (!leave(*current_context)) return GL_FALSE;
    current_context = none_context();
    return GL_TRUE;
  }
  if (!ctx || !buffer || width < 1 || height < 1 || width > kSizeLimit || height > kSizeLimit)
    return GL_FALSE;
  ColorFormat color_format;
  if (!choose_color_format(ctx->format, type, color_format)) {
    std::fprintf(stderr, "OSMesaMakeCurrent(unsupported format/type)\n");
    return GL_FALSE;
  }
  Framebuffer& f = ctx->framebuffer;
  if (current_context != ctx && !leave(*current_context)) return GL_FALSE;
  const bool new_planes =
      f.surface.width != width || f.surface.height != height || f.surface.color_format != color_format;
  if (new_planes && !allocate_planes(*ctx, width, height, color_format)) return GL_FALSE;
  f.client.data = buffer;
  f.client.type = type;
  if (new_planes) prepare_first_frame(*ctx);
  if (!ctx->ever_current) {
    ctx->ever_current = true;
    ctx->state.viewport.width = ctx->state.scissor.width = width;
    ctx->state.viewport.height = ctx->state.scissor.height = height;
  }
  ctx->dirty = kDirtyAll;
  current_context = ctx;
  return GL_TRUE;
}

SOFTGL_EXPORT OSMesaContext OSMesaGetCurrentContext() {
  SOFTGL_TRACED(OSMesaGetCurrentContext);
  return current();
}

SOFTGL_EXPORT void OSMesaPixelStore(GLint pname, GLint value) {
  SOFTGL_TRACED(OSMesaPixelStore, pname, value);
  osmesa_context* c = current();
  if (!c) return;
  switch (pname) {
  case OSMESA_ROW_LENGTH: c->framebuffer.client.row_length = value; return;
  case OSMESA_Y_UP: c->framebuffer.client.y_up = value != 0; return;
  default: std::fprintf(stderr, "OSMesaPixelStore(unknown parameter 0x%x)\n", unsigned(pname)); return;
  }
}

SOFTGL_EXPORT void OSMesaGetIntegerv(GLint pname, GLint* value) {
  SOFTGL_TRACED(OSMesaGetIntegerv, pname, value);
  if (!value) return;
  const osmesa_context* c = current();
  switch (pname) {
  case OSMESA_WIDTH: *value = c ? c->framebuffer.surface.width : 0; return;
  case OSMESA_HEIGHT: *value = c ? c->framebuffer.surface.height : 0; return;
  case OSMESA_FORMAT: *value = c ? GLint(c->format) : 0; return;
  case OSMESA_TYPE: *value = c ? GLint(c->framebuffer.client.type) : 0; return;
  case OSMESA_ROW_LENGTH: *value = c ? c->framebuffer.client.row_length : 0; return;
  case OSMESA_Y_UP: *value = c ? c->framebuffer.client.y_up : 0; return;
  case OSMESA_MAX_WIDTH:
  case OSMESA_MAX_HEIGHT: *value = kMaxSize; return;
  default: std::fprintf(stderr, "OSMesaGetIntegerv(unknown parameter 0x%x)\n", unsigned(pname)); return;
  }
}

SOFTGL_EXPORT GLboolean OSMesaGetDepthBuffer(OSMesaContext c, GLint* width, GLint* height,
                                             GLint* bytesPerValue, void** buffer) {
  SOFTGL_TRACED(OSMesaGetDepthBuffer, c, width, height, bytesPerValue, buffer);
  GLint w = 0, h = 0, bytes = 0;
  void* data = nullptr;
  if (c && c->framebuffer.surface.depth_stencil && depth_copy_bytes(c->framebuffer) > 0) {
    Framebuffer& f = c->framebuffer;
    try {
      if (f.depth_copy.empty()) {
        flush_rendering(*c);
        resolve_samples(f);
        write_tiles(f);
        copy_depth(f);
      }
      w = f.surface.width;
      h = f.surface.height;
      bytes = depth_copy_bytes(f);
      data = f.depth_copy.data();
    } catch (...) { f.depth_copy.clear(); }
  }
  if (width) *width = w;
  if (height) *height = h;
  if (bytesPerValue) *bytesPerValue = bytes;
  if (buffer) *buffer = data;
  return data ? GL_TRUE : GL_FALSE;
}

SOFTGL_EXPORT GLboolean OSMesaGetColorBuffer(OSMesaContext c, GLint* width, GLint* height, GLint* format,
                                             void** buffer) {
  SOFTGL_TRACED(OSMesaGetColorBuffer, c, width, height, format, buffer);
  const bool there = c && c->framebuffer.surface.color;
  if (width) *width = there ? c->framebuffer.surface.width : 0;
  if (height) *height = there ? c->framebuffer.surface.height : 0;
  if (format) *format = there ? GLint(c->format) : 0;
  if (buffer) *buffer = there ? c->framebuffer.client.data : nullptr;
  return there ? GL_TRUE : GL_FALSE;
}

SOFTGL_EXPORT OSMESAproc OSMesaGetProcAddress(const char* funcName) {
  SOFTGL_TRACED(OSMesaGetProcAddress, funcName);
  if (!funcName) return nullptr;
  for (const auto& f : kFunctions)
    if (std::strcmp(f.name, funcName) == 0) return f.function;
  return find_door(funcName);
}

SOFTGL_EXPORT void OSMesaColorClamp(GLboolean enable) {
  SOFTGL_TRACED(OSMesaColorClamp, enable);
} // fixed-point surfaces always clamp, others never

SOFTGL_EXPORT void OSMesaPostprocess(OSMesaContext osmesa, const char* filter, unsigned enable_value) {
  SOFTGL_TRACED(OSMesaPostprocess, osmesa, filter, enable_value);
}

} // extern "C"
