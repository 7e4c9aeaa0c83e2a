// What lies behind the pointers of a command that goes into a display list (5.4): the list keeps a copy, made
// at compile time, of images as the unpacking state then describes them.
#pragma once

#include <cstdint>

#include "commands/vertices/list_compilation.h"
#include "context/context.h"

namespace softgl {

/// Copies into the list that is being compiled; null for a null pointer or nothing.
const void* keep_bytes(Context& c, const void* data, size_t bytes);
/// Parameters of a pname; of one that GL does not know, zeros: the command looks at them before it raises the
/// error.
inline const GLfloat* keep_values(Context& c, const GLfloat* values, size_t count) {
  static constexpr GLfloat kNone[4] = {};
  if (count == 0) return kNone;
  return static_cast<const GLfloat*>(keep_bytes(c, values, count * sizeof(GLfloat)));
}
/// A byte count from GL's signed sizes: 0 for a negative one (the command itself raises the error).
inline size_t payload_size(int64_t bytes) { return bytes > 0 ? size_t(bytes) : 0; }

/// Bytes of the control points of glMap1 and glMap2; 0 when an argument is bad.
int64_t map1_bytes(GLenum target, GLint stride, GLint order, int bytes_per_value);
int64_t map2_bytes(GLenum target, GLint ustride, GLint uorder, GLint vstride, GLint vorder,
                   int bytes_per_value);

/// Of glPixelMap; 0 when the size is bad.
constexpr int64_t pixel_map_bytes(GLsizei size, int bytes_per_value) {
  return size >= 1 && size <= 256 ? int64_t(size) * bytes_per_value : 0;
}

inline bool is_proxy(GLenum target) {
  return target == GL_PROXY_TEXTURE_1D || target == GL_PROXY_TEXTURE_2D || target == GL_PROXY_TEXTURE_3D ||
         target == GL_PROXY_TEXTURE_CUBE_MAP || target == GL_PROXY_TEXTURE_RECTANGLE_ARB;
}

/// The image in tight rows: alignment 1, no skips, host byte order, most significant bit first.
const void* keep_image(Context& c, int dimensions, GLsizei width, GLsizei height, GLsizei depth,
                       GLenum format, GLenum type, const void* pixels);

} // namespace softgl
