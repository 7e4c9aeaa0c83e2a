// Images in the client's memory (3.6.4, 4.3.2).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "expect/pixel_state.h"

namespace softgl::suite {
namespace {

// The number that a component stands for (table 2.9); indexes stay what they are.
double component_value(const PixelType& type, bool index, std::vector<std::byte> element, int field) {
  if (type.is_float) {
    GLfloat number;
    std::memcpy(&number, element.data(), sizeof number);
    return double(number);
  }
  uint32_t bits = 0; // the suite runs where the least byte comes first
  std::memcpy(&bits, element.data(), element.size());
  if (type.fields > 1) {
    const double greatest = type.greatest(field);
    return double((bits >> type.shift(field)) & uint32_t(greatest)) / greatest;
  }
  if (type.is_signed) {
    const int unused = 32 - 8 * type.bytes;
    const double number = double(int32_t(bits << unused) >> unused);
    return index ? number : (2 * number + 1) / type.greatest(0);
  }
  return index ? double(bits) : double(bits) / type.greatest(0);
}

// Which component of RGBA the n-th of a format is (table 3.6).
int place_of(GLenum format, int n) {
  switch (format) {
  case GL_GREEN: return 1;
  case GL_BLUE: return 2;
  case GL_ALPHA: return 3;
  case GL_BGR:
  case GL_BGRA: return n < 3 ? 2 - n : 3;
  case GL_LUMINANCE_ALPHA: return n == 1 ? 3 : 0;
  }
  return n;
}

bool is_luminance(GLenum format) { return format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA; }

} // namespace

PixelKind kind_of(GLenum format) {
  switch (format) {
  case GL_COLOR_INDEX: return PixelKind::Index;
  case GL_STENCIL_INDEX: return PixelKind::Stencil;
  case GL_DEPTH_COMPONENT: return PixelKind::Depth;
  }
  return PixelKind::Color;
}

size_t group_offset(const PixelStore& store, GLenum format, GLenum type, int width, int height, int x, int y,
                    int z) {
  const PixelType& t = pixel_type(type);
  const int components = t.fields > 1 ? 1 : components_of(format);
  const int length = store.row_length > 0 ? store.row_length : width;
  int row = length * components * t.bytes; // equation 3.12, in bytes
  if (t.bytes < store.alignment) row = (row + store.alignment - 1) / store.alignment * store.alignment;
  const int rows = store.image_height > 0 ? store.image_height : height;
  return size_t(((z + store.skip_images) * rows + y + store.skip_rows) * row +
                (x + store.skip_pixels) * components * t.bytes);
}

PixelImage unpack(const PixelStore& store, const Argument& memory, GLenum format, GLenum type, int width,
                  int height, int depth) {
  PixelImage image{kind_of(format), width, height, depth, {}};
  image.pixels.resize(size_t(width * height * depth));
  if (type == GL_BITMAP) {
    if (depth != 1) throw std::logic_error("bits of an image with three dimensions");
    for (int y = 0; y < height; y++)
      for (int x = 0; x < width; x++)
        image.pixels[size_t(y * width + x)].c[0] = bitmap_bit(store, memory.numbers, width, x, y);
    return image;
  }
  const PixelType& t = pixel_type(type);
  const std::vector<std::byte> bytes = bytes_of(memory.memory_type, memory.numbers);
  if (bytes.empty()) { // nothing is known of what is not given
    for (Pixel& p : image.pixels)
      for (Interval& c : p.c) c = {0, 1};
    return image;
  }
  size_t next = 0;
  for (int z = 0; z < depth; z++)
    for (int y = 0; y < height; y++)
      for (int x = 0; x < width; x++) {
        Pixel& pixel = image.pixels[next++];
        const size_t at = group_offset(store, format, type, width, height, x, y, z);
        pixel.c[3] = 1;
        for (int i = 0; i < components_of(format); i++) {
          const size_t first = at + (t.fields > 1 ? 0 : size_t(i * t.bytes));
          if (first + size_t(t.bytes) > bytes.size()) throw std::logic_error("an image beyond its memory");
          std::vector<std::byte> element(bytes.begin() + long(first), bytes.begin() + long(first) + t.bytes);
          if (store.swap_bytes) std::reverse(element.begin(), element.end());
          pixel.c[place_of(format, i)] = component_value(t, is_index(format), std::move(element), i);
        }
        if (is_luminance(format)) pixel.c[1] = pixel.c[2] = pixel.c[0];
      }
  return image;
}

bool bitmap_bit(const PixelStore& store, const std::vector<double>& bytes, int width, int x, int y) {
  const int length = store.row_length > 0 ? store.row_length : width;
  const int row =
      store.alignment * ((length + 8 * store.alignment - 1) / (8 * store.alignment)); // equation 3.13
  const int bit = x + store.skip_pixels;
  const size_t at = size_t((y + store.skip_rows) * row + bit / 8);
  if (at >= bytes.size()) throw std::logic_error("a bitmap beyond its memory");
  return int(bytes[at]) >> (store.lsb_first ? bit % 8 : 7 - bit % 8) & 1;
}

std::vector<Interval> packed_elements(const PixelStore& store, const PixelImage& image, GLenum format,
                                      GLenum type, int count) {
  const PixelType& t = pixel_type(type);
  const int fields = t.fields;
  const double untouched =
      fields > 1   ? 0
      : t.is_float ? 0.25
                   : (t.is_signed ? 2 * untouched_element(t) + 1 : untouched_element(t)) / t.greatest(0);
  std::vector<Interval> elements(size_t(count * fields),
                                 is_index(format) ? std::min(untouched_element(t) / 255, 1.0) : untouched);
  for (int y = 0; y < image.height; y++)
    for (int x = 0; x < image.width; x++) {
      const Pixel& pixel = image.pixels[size_t(y * image.width + x)];
      const size_t first = group_offset(store, format, type, image.width, image.height, x, y, 0) /
                           size_t(t.bytes) * size_t(fields);
      for (int i = 0; i < components_of(format); i++) {
        if (first + size_t(i) >= elements.size()) throw std::logic_error("pixels beyond their memory");
        Interval value = pixel.c[place_of(format, i)];
        if (is_index(format)) {
          elements[first + size_t(i)] = {value.low / 255, value.high / 255};
          continue;
        }
        if (is_luminance(format) && i == 0) value = pixel.c[0] + pixel.c[1] + pixel.c[2];
        value = spec::clamped(value, 0, 1);
        // Nearest or not: a conversion may be off by less than a step.
        const double step = t.is_float ? 0 : 1 / t.greatest(fields > 1 ? i : 0);
        if (t.is_float || value.low != value.high || (value.low != 0 && value.low != 1))
          value = spec::widened(value, step);
        elements[first + size_t(i)] = spec::clamped(value, 0, 1);
      }
    }
  return elements;
}

} // namespace softgl::suite
