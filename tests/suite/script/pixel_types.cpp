#include "script/pixel_types.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace softgl::suite {
namespace {

template <class T> void store(std::vector<std::byte>& bytes, const std::vector<double>& numbers) {
  bytes.resize(sizeof(T) * numbers.size());
  for (size_t i = 0; i < numbers.size(); i++) {
    const T value = static_cast<T>(numbers[i]);
    std::memcpy(&bytes[sizeof(T) * i], &value, sizeof(T));
  }
}

template <class T> double load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return double(value);
}

double load_number(const PixelType& type, const std::byte* from) {
  switch (type.type) {
  case GL_FLOAT: return load<GLfloat>(from);
  case GL_BYTE: return load<GLbyte>(from);
  case GL_SHORT: return load<GLshort>(from);
  case GL_INT: return load<GLint>(from);
  default: break;
  }
  return type.bytes == 1 ? load<GLubyte>(from) : type.bytes == 2 ? load<GLushort>(from) : load<GLuint>(from);
}

} // namespace

int PixelType::shift(int field) const {
  int sum = 0;
  for (int i = reversed ? 0 : field + 1; i < (reversed ? field : fields); i++) sum += bits[i];
  return sum;
}

double PixelType::greatest(int field) const {
  return std::ldexp(1, fields > 1 ? bits[field] : 8 * bytes) - 1;
}

const PixelType& pixel_type(GLenum type) {
  static const PixelType types[] = {
      {GL_UNSIGNED_BYTE, 1},
      {GL_BYTE, 1, false, true},
      {GL_UNSIGNED_SHORT, 2},
      {GL_SHORT, 2, false, true},
      {GL_UNSIGNED_INT, 4},
      {GL_INT, 4, false, true},
      {GL_FLOAT, 4, true},
      {GL_UNSIGNED_BYTE_3_3_2, 1, false, false, 3, {3, 3, 2}},
      {GL_UNSIGNED_BYTE_2_3_3_REV, 1, false, false, 3, {3, 3, 2}, true},
      {GL_UNSIGNED_SHORT_5_6_5, 2, false, false, 3, {5, 6, 5}},
      {GL_UNSIGNED_SHORT_5_6_5_REV, 2, false, false, 3, {5, 6, 5}, true},
      {GL_UNSIGNED_SHORT_4_4_4_4, 2, false, false, 4, {4, 4, 4, 4}},
      {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, false, false, 4, {4, 4, 4, 4}, true},
      {GL_UNSIGNED_SHORT_5_5_5_1, 2, false, false, 4, {5, 5, 5, 1}},
      {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, false, false, 4, {5, 5, 5, 1}, true},
      {GL_UNSIGNED_INT_8_8_8_8, 4, false, false, 4, {8, 8, 8, 8}},
      {GL_UNSIGNED_INT_8_8_8_8_REV, 4, false, false, 4, {8, 8, 8, 8}, true},
      {GL_UNSIGNED_INT_10_10_10_2, 4, false, false, 4, {10, 10, 10, 2}},
      {GL_UNSIGNED_INT_2_10_10_10_REV, 4, false, false, 4, {10, 10, 10, 2}, true},
  };
  for (const PixelType& t : types)
    if (t.type == type) return t;
  throw std::logic_error("a type of pixels that the suite does not know");
}

int components_of(GLenum format) {
  switch (format) {
  case GL_RED:
  case GL_GREEN:
  case GL_BLUE:
  case GL_ALPHA:
  case GL_LUMINANCE:
  case GL_COLOR_INDEX:
  case GL_STENCIL_INDEX:
  case GL_DEPTH_COMPONENT: return 1;
  case GL_LUMINANCE_ALPHA: return 2;
  case GL_RGB:
  case GL_BGR: return 3;
  case GL_RGBA:
  case GL_BGRA: return 4;
  }
  throw std::logic_error("a format of pixels that the suite does not know");
}

bool is_index(GLenum format) { return format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX; }

std::vector<std::byte> bytes_of(GLenum type, const std::vector<double>& elements) {
  std::vector<std::byte> bytes;
  const int size = type == GL_NONE || type == GL_BITMAP ? 1 : pixel_type(type).bytes;
  switch (type) {
  case GL_FLOAT: store<GLfloat>(bytes, elements); break;
  case GL_BYTE: store<GLbyte>(bytes, elements); break;
  case GL_SHORT: store<GLshort>(bytes, elements); break;
  case GL_INT: store<GLint>(bytes, elements); break;
  default:
    if (size == 1) store<GLubyte>(bytes, elements);
    if (size == 2) store<GLushort>(bytes, elements);
    if (size == 4) store<GLuint>(bytes, elements);
  }
  return bytes;
}

double untouched_element(const PixelType& type) {
  if (type.fields > 1) return 0;
  return type.is_float ? 0.25 : std::floor(std::ldexp(0.25, 8 * type.bytes - type.is_signed));
}

double painted_component(const PixelType& type, bool index, const std::byte* element, int field) {
  double number = load_number(type, element);
  if (type.fields > 1) {
    number = double((uint32_t(number) >> type.shift(field)) & uint32_t(type.greatest(field)));
  } else if (index) {
    return std::clamp(number / 255, 0.0, 1.0);
  } else if (type.is_signed) {
    number = 2 * number + 1; // table 4.7
  }
  return std::clamp(type.is_float ? number : number / type.greatest(field), 0.0, 1.0);
}

} // namespace softgl::suite
