// What lies behind the pointers of a command that goes into a display list (5.4): the list keeps a copy, made
// at compile time, of images as the unpacking state then describes them.
#pragma once

#include <cstdint>
#include <type_traits>

#include "commands/buffers/pixel_buffers.h"
#include "commands/generated/list_records.h"
#include "commands/vertices/list_compilation.h"
#include "context/context.h"

namespace softgl {

/// Copies into the list that is being compiled; null for a null pointer or nothing.
const void* keep_bytes(Context& c, const void* data, size_t bytes);
/// The same for values that may lie in the unpack buffer (GL_ARB_pixel_buffer_object).
template <class T> const T* keep_pixels(Context& c, const T* data, size_t bytes) {
  const void* from = data;
  size_t element = 1;
  if constexpr (!std::is_void_v<T>) element = sizeof(T);
  if (!bytes || !find_unpack_memory(c, from, array_span(bytes / element, element))) return nullptr;
  return static_cast<const T*>(keep_bytes(c, from, bytes));
}
/// Parameters of a pname; of one that GL does not know, zeros: the command looks at them before it raises the
/// error.
inline const GLfloat* keep_values(Context& c, const GLfloat* values, size_t count) {
  static constexpr GLfloat kNone[4] = {};
  if (count == 0) return kNone;
  return static_cast<const GLfloat*>(keep_bytes(c, values, count * sizeof(GLfloat)));
}
/// A byte count from GL's signed sizes: 0 for a negative one (the command itself raises the error).
inline size_t payload_size(int64_t bytes) { return bytes > 0 ? size_t(bytes) : 0; }

/// What a list keeps of glMap1 and glMap2: the control points in tight rows, and the strides of those. Where
/// an argument is bad no point is read, and the command finds the same error when it is played.
Map1fArguments keep_map(Context& c, GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order,
                        const GLfloat* points);
Map1dArguments keep_map(Context& c, GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
                        const GLdouble* points);
Map2fArguments keep_map(Context& c, GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder,
                        GLfloat v1, GLfloat v2, GLint vstride, GLint vorder, const GLfloat* points);
Map2dArguments keep_map(Context& c, GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder,
                        GLdouble v1, GLdouble v2, GLint vstride, GLint vorder, const GLdouble* points);

/// Of glPixelMap; 0 when the size is bad.
constexpr int64_t pixel_map_bytes(GLsizei size, int bytes_per_value) {
  return size >= 1 && size <= 256 ? int64_t(size) * bytes_per_value : 0;
}

/// The proxy of a command that specifies images of so many dimensions: it is asked at once (GL 1.5, 5.4).
inline bool is_proxy(int dimensions, GLenum target) {
  switch (target) {
  case GL_PROXY_TEXTURE_1D: return dimensions == 1;
  case GL_PROXY_TEXTURE_2D:
  case GL_PROXY_TEXTURE_CUBE_MAP:
  case GL_PROXY_TEXTURE_RECTANGLE_ARB: return dimensions == 2;
  case GL_PROXY_TEXTURE_3D: return dimensions == 3;
  default: return false;
  }
}

/// The image in tight rows: alignment 1, no skips, host byte order, most significant bit first.
const void* keep_image(Context& c, int dimensions, GLsizei width, GLsizei height, GLsizei depth,
                       GLenum format, GLenum type, const void* pixels);

} // namespace softgl
