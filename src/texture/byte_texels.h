// Pixels of unsigned bytes that become texels of bytes as they are, each byte of a texel being one of its
// pixel's, 0 or 255: most images that programs have. Straight loops, which take the time that memory takes.
#pragma once

#include <cstdint>

namespace softgl {

struct PixelFormat;
struct TexelFormat;

class ByteTexels {
public:
  /// Finds out what the bytes of texels are made of; false if it is more than bytes. For pixels that no pixel
  /// transfer changes.
  bool find(const TexelFormat& to, const PixelFormat& from);
  /// A row.
  void store(uint32_t* texels, const uint8_t* pixels, int count) const;

private:
  int components_ = 0;
  uint8_t source_[4] = {}; // the pixel's byte by the texel's
  uint32_t taken_ = 0;     // which bytes are taken from the pixel;
  uint32_t fixed_ = 0;     // the others
};

} // namespace softgl
