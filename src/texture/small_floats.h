// Floats of 16 and fewer bits (GL_ARB_half_float_pixel, GL_EXT_packed_float) and three numbers with one
// exponent (GL_EXT_texture_shared_exponent).
#pragma once

#include <cstdint>

namespace softgl {

/// 1 bit of sign, 5 of exponent, 10 of mantissa.
float half_to_float(uint16_t half);
/// The nearest one, ties to even; infinite where there is none.
uint16_t float_to_half(float value);
/// The next one towards zero, at most 65504; infinity stays what it is.
uint16_t float_to_half_towards_zero(float value);

/// half_to_float(float_to_half_towards_zero(v)) and half_to_float(float_to_half(v)) of `count` numbers.
void reduce_to_halves(float* v, int count);
void round_to_halves(float* v, int count);

/// 5 bits of exponent, `mantissa` (6 or 5) bits of mantissa, no sign.
float unsigned_float(uint32_t bits, int mantissa);
/// The next one towards zero. Negative ones and those too small for a normal one become 0.
uint32_t to_unsigned_float(float value, int mantissa);

/// unsigned_float(to_unsigned_float(value, mantissa), mantissa).
float reduce_to_unsigned_float(float value, int mantissa);

/// Three mantissas of 9 bits and, above them, an exponent.
void shared_exponent_to_floats(uint32_t word, float* rgb);
uint32_t floats_to_shared_exponent(const float* rgb);

} // namespace softgl
