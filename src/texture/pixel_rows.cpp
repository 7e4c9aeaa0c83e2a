// Rows of colors in client memory, from and to red, green, blue, alpha. Each step is one loop over up to
// kChunk pixels which knows the form of its components, so that the compiler makes vectors of it: turn bytes
// around, convert component by component, put components where they belong.
#include <algorithm>
#include <cstring>
#include <limits>

#include "texture/component_values.h"
#include "texture/pixel_formats.h"
#include "texture/pixel_order.h"
#include "texture/small_floats.h"

namespace softgl {
namespace {

constexpr int kChunk = 128; // pixels
constexpr size_t kMostPixelBytes = 16;

template <class T> T load(const unsigned char* p) {
  T v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

/// Turns the bytes of each element around (GL_UNPACK_SWAP_BYTES).
void swap_elements(unsigned char* p, size_t bytes, int element_bytes) {
  if (element_bytes == 2)
    for (size_t i = 0; i < bytes; i += 2) std::swap(p[i], p[i + 1]);
  else if (element_bytes == 4)
    for (size_t i = 0; i < bytes; i += 4) {
      const auto v = load<uint32_t>(p + i),
                 turned = v >> 24 | (v >> 8 & 0xff00) | (v & 0xff00) << 8 | v << 24;
      std::memcpy(p + i, &turned, 4);
    }
}

template <class T> constexpr T one() { return std::numeric_limits<T>::max(); }
template <> constexpr float one<float>() { return 1.0f; }

/// The bytes of a pixel, which are in the lower bytes of `pixel`, as the word of a color.
template <class O> uint32_t color_word(uint32_t pixel) {
  uint32_t word = 0;
  for (int k = 0; k < 4; ++k) {
    const int from = O::from[k];
    if (from == kOneComponent) word |= 0xffu << 8 * k;
    if (from < 4) word |= (pixel >> 8 * from & 0xff) << 8 * k;
  }
  return word;
}
template <class O> uint32_t pixel_word(uint32_t color) {
  uint32_t word = 0;
  for (int k = 0; k < O::components; ++k) word |= (color >> 8 * O::source(k) & 0xff) << 8 * k;
  return word;
}
/// Two pixels of three bytes, from two colors: six bytes.
template <class O> uint64_t pixel_pair(uint64_t colors) {
  constexpr uint64_t kBytes = 0xff000000ff;
  uint64_t two = 0;
  if constexpr (O::source(0) == 0 && O::source(1) == 1 && O::source(2) == 2)
    two = colors & kBytes * 0x010101;
  else
    for (int k = 0; k < 3; ++k) two |= (colors >> 8 * O::source(k) & kBytes) << 8 * k;
  return (two & 0xffffff) | (two >> 8 & 0xffffff000000);
}

/// Pixels of bytes: color by color in one word.
template <class O> inline __attribute__((always_inline)) void
unpack_bytes(const unsigned char* __restrict p, int count, unsigned char* __restrict rgba) {
  constexpr int n = O::components;
  const auto put = [&](int i, uint32_t pixel) {
    const uint32_t word = color_word<O>(pixel);
    std::memcpy(rgba + 4 * size_t(i), &word, 4);
  };
  if constexpr (n == 3) { // a word has a byte of the next pixel, which the last one has not
    for (int i = 0; i + 1 < count; ++i) put(i, load<uint32_t>(p + 3 * size_t(i)));
    if (count > 0) {
      const unsigned char* last = p + 3 * size_t(count - 1);
      put(count - 1, uint32_t(last[0]) | uint32_t(last[1]) << 8 | uint32_t(last[2]) << 16);
    }
  } else {
    using Word = std::conditional_t<n == 1, uint8_t, std::conditional_t<n == 2, uint16_t, uint32_t>>;
    for (int i = 0; i < count; ++i) put(i, load<Word>(p + sizeof(Word) * size_t(i)));
  }
}
template <class O> inline __attribute__((always_inline)) void
pack_bytes(const unsigned char* __restrict rgba, int count, unsigned char* __restrict p) {
  constexpr int n = O::components;
  const auto pixel = [&](int i) { return pixel_word<O>(load<uint32_t>(rgba + 4 * size_t(i))); };
  if constexpr (n == 3) {
    int i = 0;
    for (; i + 3 <= count; i += 2) { // the two bytes behind two pixels are those of the third one
      const uint64_t two = pixel_pair<O>(load<uint64_t>(rgba + 4 * size_t(i)));
      std::memcpy(p + 3 * size_t(i), &two, 8);
    }
    for (; i < count; ++i) {
      const uint32_t v = pixel(i);
      std::memcpy(p + 3 * size_t(i), &v, 3);
    }
  } else {
    using Word = std::conditional_t<n == 1, uint8_t, std::conditional_t<n == 2, uint16_t, uint32_t>>;
    for (int i = 0; i < count; ++i) {
      const auto v = Word(pixel(i));
      std::memcpy(p + sizeof(Word) * size_t(i), &v, sizeof v);
    }
  }
}

/// Components of In at p in another form.
template <class In, class Out>
void convert(const unsigned char* __restrict p, size_t count, Out* __restrict out) {
  for (size_t i = 0; i < count; ++i) out[i] = component_to<Out>(load<In>(p + i * sizeof(In)));
}
template <class Out, class In>
void convert_back(const In* __restrict in, size_t count, unsigned char* __restrict p) {
  for (size_t i = 0; i < count; ++i) {
    const Out v = component_to<Out>(in[i]);
    std::memcpy(p + i * sizeof(Out), &v, sizeof v);
  }
}

/// Colors of components that are already in their form, and back. All ways of converting share them.
template <class O, class Out>
void order_colors(const Out* __restrict value, int count, Out (*__restrict rgba)[4]) {
  if constexpr (std::is_same_v<Out, unsigned char>) return unpack_bytes<O>(value, count, &rgba[0][0]);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 4; ++k) {
      const int from = O::from[k];
      rgba[i][k] = from == kZeroComponent  ? Out(0)
                   : from == kOneComponent ? one<Out>()
                                           : value[i * O::components + from % O::components];
    }
}
template <class O, class In>
void order_components(const In (*__restrict rgba)[4], int count, In* __restrict value) {
  if constexpr (std::is_same_v<In, unsigned char>) return pack_bytes<O>(&rgba[0][0], count, value);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < O::components; ++k) value[i * O::components + k] = rgba[i][O::source(k)];
}
template <class Out> void order_colors(const PixelFormat& f, const Out* value, int count, Out (*rgba)[4]) {
  with_order(f, [&](auto order) { order_colors<decltype(order)>(value, count, rgba); });
}
template <class In> void order_components(const PixelFormat& f, const In (*rgba)[4], int count, In* value) {
  with_order(f, [&](auto order) { order_components<decltype(order)>(rgba, count, value); });
}

template <class In, class Out>
void unpack_array(const PixelFormat& f, const unsigned char* p, int count, Out (*rgba)[4]) {
  if constexpr (sizeof(In) == 1 && std::is_same_v<In, Out> && !std::is_signed_v<Out>)
    return with_order(f, [&](auto order) { unpack_bytes<decltype(order)>(p, count, &rgba[0][0]); });
  else if (has_order_of_colors(f))
    return convert<In>(p, size_t(count) * 4, &rgba[0][0]);
  else {
    Out value[kChunk * 4];
    convert<In>(p, size_t(count) * f.components, value);
    order_colors(f, value, count, rgba);
  }
}
template <class Out, class In>
void pack_array(const PixelFormat& f, const In (*rgba)[4], int count, unsigned char* p) {
  if constexpr (sizeof(In) == 1 && std::is_same_v<In, Out> && !std::is_signed_v<Out>)
    return with_order(f, [&](auto order) { pack_bytes<decltype(order)>(&rgba[0][0], count, p); });
  else if (has_order_of_colors(f))
    return convert_back<Out>(&rgba[0][0], size_t(count) * 4, p);
  else {
    In value[kChunk * 4];
    order_components(f, rgba, count, value);
    convert_back<Out>(value, size_t(count) * f.components, p);
  }
}

/// The words of packed pixels, and back.
void load_words(const PixelFormat& f, const unsigned char* p, int count, uint32_t* word) {
  if (f.bytes == 1)
    for (int i = 0; i < count; ++i) word[i] = p[i];
  else if (f.bytes == 2)
    for (int i = 0; i < count; ++i) word[i] = load<uint16_t>(p + 2 * size_t(i));
  else
    std::memcpy(word, p, size_t(count) * 4);
}
void store_words(const PixelFormat& f, const uint32_t* word, int count, unsigned char* p) {
  if (f.bytes == 1)
    for (int i = 0; i < count; ++i) p[i] = uint8_t(word[i]);
  else if (f.bytes == 2)
    for (int i = 0; i < count; ++i) {
      const auto v = uint16_t(word[i]);
      std::memcpy(p + 2 * size_t(i), &v, 2);
    }
  else
    std::memcpy(p, word, size_t(count) * 4);
}

/// Whether all components have at most 8 bits.
bool has_narrow_components(const PixelFormat& f) {
  return std::all_of(f.bits, f.bits + f.components, [](uint8_t bits) { return bits <= 8; });
}
/// Colors of bytes as packed words, and back.
template <int kComponents>
void pack_narrow(const PixelFormat& f, const uint8_t (*rgba)[4], int count, uint32_t* word) {
  Narrowing narrow[kComponents];
  int from[kComponents], to[kComponents];
  for (int k = 0; k < kComponents; ++k)
    narrow[k] = narrowing(f.bits[k]), from[k] = 8 * f.target[k], to[k] = f.shift[k];
  for (int i = 0; i < count; ++i) {
    const auto color = load<uint32_t>(rgba[i]);
    uint32_t packed = 0;
    for (int k = 0; k < kComponents; ++k) packed |= narrow[k](color >> from[k] & 255) << to[k];
    word[i] = packed;
  }
}
template <int kComponents>
void unpack_narrow(const PixelFormat& f, const uint32_t* word, int count, uint8_t (*rgba)[4]) {
  Widening widen[kComponents];
  int from[kComponents], to[kComponents];
  uint32_t mask[kComponents];
  for (int k = 0; k < kComponents; ++k) {
    widen[k] = widening(f.bits[k]), mask[k] = (1u << f.bits[k]) - 1;
    from[k] = f.shift[k], to[k] = 8 * f.target[k];
  }
  for (int i = 0; i < count; ++i) {
    uint32_t color = kComponents < 4 ? 0xff000000 : 0;
    for (int k = 0; k < kComponents; ++k) color |= widen[k](word[i] >> from[k] & mask[k]) << to[k];
    std::memcpy(rgba[i], &color, 4);
  }
}

// 8_8_8_8 are arrays of bytes to OSMesa; the smaller ones go by 8 bits, 10_10_10_2 and 16-bit results by
// floats.
template <class Out>
void unpack_packed(const PixelFormat& f, const unsigned char* p, int count, Out (*rgba)[4]) {
  if constexpr (std::is_same_v<Out, uint8_t>)
    if (f.bits[0] == 8)
      return with_order_of_bytes(f,
                                 [&](auto order) { unpack_bytes<decltype(order)>(p, count, &rgba[0][0]); });
  uint32_t word[kChunk];
  load_words(f, p, count, word);
  if constexpr (std::is_same_v<Out, uint8_t>)
    if (has_narrow_components(f))
      return f.components == 3 ? unpack_narrow<3>(f, word, count, rgba)
                               : unpack_narrow<4>(f, word, count, rgba);
  if (f.components < 4)
    for (int i = 0; i < count; ++i) rgba[i][3] = one<Out>();
  for (int k = 0; k < f.components; ++k) {
    const int bits = f.bits[k], shift = f.shift[k], to = f.target[k];
    const uint32_t mask = (1u << bits) - 1;
    const auto put = [&](auto value) {
      for (int i = 0; i < count; ++i) rgba[i][to] = value(word[i] >> shift & mask);
    };
    if constexpr (std::is_same_v<Out, float>)
      put([=](uint32_t v) { return unorm_to_float(v, bits); });
    else if constexpr (std::is_signed_v<Out>)
      put([=](uint32_t v) { return component_to<Out>(unorm_to_float(v, bits)); });
    else if (sizeof(Out) == 1 || bits == 8)
      put([=](uint32_t v) { return Out(convert_unorm(v, bits, int(sizeof(Out) * 8))); });
    else
      put([=](uint32_t v) { return Out(float_to_unorm(unorm_to_float(v, bits), 16)); });
  }
}
template <class In> void pack_packed(const PixelFormat& f, const In (*rgba)[4], int count, unsigned char* p) {
  if constexpr (std::is_same_v<In, uint8_t>)
    if (f.bits[0] == 8)
      return with_order_of_bytes(f, [&](auto order) { pack_bytes<decltype(order)>(&rgba[0][0], count, p); });
  uint32_t word[kChunk] = {};
  if constexpr (std::is_same_v<In, uint8_t>)
    if (has_narrow_components(f)) {
      f.components == 3 ? pack_narrow<3>(f, rgba, count, word) : pack_narrow<4>(f, rgba, count, word);
      return store_words(f, word, count, p);
    }
  const bool wide = f.bits[0] > 8;
  for (int k = 0; k < f.components; ++k) {
    const int bits = f.bits[k], shift = f.shift[k], from = f.target[k];
    const auto put = [&](auto value) {
      for (int i = 0; i < count; ++i) word[i] |= value(rgba[i][from]) << shift;
    };
    const auto put_float = [&](auto as_float) {
      if (bits == 8)
        put([=](In in) { return pack_unorm(as_float(in), 8); });
      else
        put([=](In in) { return pack_unorm(as_float(in), bits); });
    };
    if constexpr (std::is_same_v<In, float>)
      put_float([](float in) { return in; });
    else if constexpr (std::is_signed_v<In>)
      put_float([](In in) { return component_to<float>(in); });
    else if constexpr (sizeof(In) == 1)
      put([=](In in) { return convert_unorm(in, 8, bits); });
    else if (wide)
      put_float([](In in) { return unorm_to_float(in, 16); });
    else
      put([narrow = narrowing(bits)](In in) { return narrow(convert_unorm(in, 16, 8)); });
  }
  store_words(f, word, count, p);
}

template <class Out>
void unpack_packed_floats(const PixelFormat& f, const unsigned char* p, int count, Out (*rgba)[4]) {
  for (int i = 0; i < count; ++i, p += 4) {
    const auto word = load<uint32_t>(p);
    float v[3];
    if (f.type == GL_UNSIGNED_INT_5_9_9_9_REV)
      shared_exponent_to_floats(word, v);
    else
      v[0] = unsigned_float(word & 2047, 6), v[1] = unsigned_float(word >> 11 & 2047, 6),
      v[2] = unsigned_float(word >> 22, 5);
    for (int k = 0; k < 3; ++k) rgba[i][k] = component_to<Out>(v[k]);
    rgba[i][3] = one<Out>();
  }
}
template <class In>
void pack_packed_floats(const PixelFormat& f, const In (*rgba)[4], int count, unsigned char* p) {
  for (int i = 0; i < count; ++i, p += 4) {
    float v[3];
    for (int k = 0; k < 3; ++k) v[k] = component_to<float>(rgba[i][k]);
    const uint32_t word = f.type == GL_UNSIGNED_INT_5_9_9_9_REV
                              ? floats_to_shared_exponent(v)
                              : to_unsigned_float(v[0], 6) | to_unsigned_float(v[1], 6) << 11 |
                                    to_unsigned_float(v[2], 5) << 22;
    std::memcpy(p, &word, 4);
  }
}

/// Up to kChunk pixels.
template <class Out>
void unpack_chunk(const PixelFormat& f, const unsigned char* p, int count, Out (*rgba)[4]) {
  switch (f.channel) {
  case PixelChannel::UnsignedByte: return unpack_array<uint8_t>(f, p, count, rgba);
  case PixelChannel::Byte: return unpack_array<int8_t>(f, p, count, rgba);
  case PixelChannel::UnsignedShort: return unpack_array<uint16_t>(f, p, count, rgba);
  case PixelChannel::Short: return unpack_array<int16_t>(f, p, count, rgba);
  case PixelChannel::UnsignedInt: return unpack_array<uint32_t>(f, p, count, rgba);
  case PixelChannel::Int: return unpack_array<int32_t>(f, p, count, rgba);
  case PixelChannel::Float: return unpack_array<float>(f, p, count, rgba);
  case PixelChannel::Half: return unpack_array<Half>(f, p, count, rgba);
  case PixelChannel::PackedFloat: return unpack_packed_floats(f, p, count, rgba);
  case PixelChannel::Packed: return unpack_packed(f, p, count, rgba);
  case PixelChannel::Bitmap: std::memset(static_cast<void*>(rgba), 0, size_t(count) * sizeof *rgba);
  }
}
template <class In> void pack_chunk(const PixelFormat& f, const In (*rgba)[4], int count, unsigned char* p) {
  switch (f.channel) {
  case PixelChannel::UnsignedByte: return pack_array<uint8_t>(f, rgba, count, p);
  case PixelChannel::Byte: return pack_array<int8_t>(f, rgba, count, p);
  case PixelChannel::UnsignedShort: return pack_array<uint16_t>(f, rgba, count, p);
  case PixelChannel::Short: return pack_array<int16_t>(f, rgba, count, p);
  case PixelChannel::UnsignedInt: return pack_array<uint32_t>(f, rgba, count, p);
  case PixelChannel::Int: return pack_array<int32_t>(f, rgba, count, p);
  case PixelChannel::Float: return pack_array<float>(f, rgba, count, p);
  case PixelChannel::Half: return pack_array<Half>(f, rgba, count, p);
  case PixelChannel::PackedFloat: return pack_packed_floats(f, rgba, count, p);
  case PixelChannel::Packed: return pack_packed(f, rgba, count, p);
  case PixelChannel::Bitmap: return;
  }
}

template <class Out>
void unpack(const PixelFormat& f, const void* row, int count, bool swap, Out (*rgba)[4]) {
  const auto* p = static_cast<const unsigned char*>(row);
  swap = swap && f.element_bytes > 1;
  for (int done = 0; done < count; done += kChunk) {
    const int n = std::min(kChunk, count - done);
    const unsigned char* from = p + size_t(done) * f.bytes;
    unsigned char swapped[kChunk * kMostPixelBytes];
    if (swap) {
      const size_t bytes = size_t(n) * f.bytes;
      std::memcpy(swapped, from, bytes);
      swap_elements(swapped, bytes, f.element_bytes);
      from = swapped;
    }
    unpack_chunk(f, from, n, rgba + done);
  }
}
template <class In> void pack(const PixelFormat& f, const In (*rgba)[4], int count, bool swap, void* row) {
  auto* p = static_cast<unsigned char*>(row);
  for (int done = 0; done < count; done += kChunk) {
    const int n = std::min(kChunk, count - done);
    unsigned char* to = p + size_t(done) * f.bytes;
    pack_chunk(f, rgba + done, n, to);
    if (swap) swap_elements(to, size_t(n) * f.bytes, f.element_bytes);
  }
}

} // namespace

void unpack_pixels(const PixelFormat& f, const void* row, int count, bool swap, uint8_t (*rgba)[4]) {
  unpack(f, row, count, swap, rgba);
}
void unpack_pixels(const PixelFormat& f, const void* row, int count, bool swap, uint16_t (*rgba)[4]) {
  unpack(f, row, count, swap, rgba);
}
void unpack_pixels(const PixelFormat& f, const void* row, int count, bool swap, float (*rgba)[4]) {
  unpack(f, row, count, swap, rgba);
}
void unpack_pixels(const PixelFormat& f, const void* row, int count, bool swap, int8_t (*rgba)[4]) {
  unpack(f, row, count, swap, rgba);
}
void unpack_pixels(const PixelFormat& f, const void* row, int count, bool swap, int16_t (*rgba)[4]) {
  unpack(f, row, count, swap, rgba);
}
void pack_pixels(const PixelFormat& f, const int8_t (*rgba)[4], int count, bool swap, void* row) {
  pack(f, rgba, count, swap, row);
}
void pack_pixels(const PixelFormat& f, const int16_t (*rgba)[4], int count, bool swap, void* row) {
  pack(f, rgba, count, swap, row);
}
void pack_pixels(const PixelFormat& f, const uint8_t (*rgba)[4], int count, bool swap, void* row) {
  pack(f, rgba, count, swap, row);
}
void pack_pixels(const PixelFormat& f, const uint16_t (*rgba)[4], int count, bool swap, void* row) {
  pack(f, rgba, count, swap, row);
}
void pack_pixels(const PixelFormat& f, const float (*rgba)[4], int count, bool swap, void* row) {
  pack(f, rgba, count, swap, row);
}

} // namespace softgl
