// The formats and types of pixels in the client's memory (3.6.4, tables 3.5 to 3.11).
#pragma once

#include "script/script.h"

namespace softgl::suite {

/// An element of memory: a number, or several fields of bits that are the components of one pixel.
struct PixelType {
  GLenum type;
  int bytes;
  bool is_float = false, is_signed = false;
  int fields = 1;        // more than one for packed types
  int bits[4] = {};      // of the fields in the order of the components, for packed types
  bool reversed = false; // the first component has the least bits
  /// Where the field begins, from the least bit.
  int shift(int field) const;
  /// Bits of the number, without its sign.
  double greatest(int field) const;
};
/// Throws std::logic_error for a type that the suite does not know.
const PixelType& pixel_type(GLenum type);

/// 3 for GL_RGB. Throws std::logic_error for a format that the suite does not know.
int components_of(GLenum format);
/// Indexes and stencil values are whole numbers; all else is a fraction of the greatest number.
bool is_index(GLenum format);

/// The bytes that the client's memory holds.
std::vector<std::byte> bytes_of(GLenum type, const std::vector<double>& elements);

/// Elements that the suite has memory for before a GL reads pixels into it: a quarter of the greatest number,
/// zeros in packed types.
double untouched_element(const PixelType& type);
/// A component of an element as a color between 0 and 1: a fraction, or an index of 255.
double painted_component(const PixelType& type, bool index, const std::byte* element, int field);

} // namespace softgl::suite
