// How OSMesa stores what it draws into a texture: generated mipmaps and copies of the framebuffer.
#pragma once

#include <cstdint>

namespace softgl {

/// 8 bits cut to `bits` (0: all of them) and filled to a byte again.
uint8_t reduced_byte(uint32_t value, int bits);
/// A component of 2 or 10 to 32 bits as a float and back.
float wide_to_float(uint32_t value, int bits);
uint32_t float_to_wide(float value, int bits);

} // namespace softgl
