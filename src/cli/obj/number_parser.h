// Decimal numbers of OBJ and MTL text, correctly rounded.
#pragma once

#include <bit>
#include <cstdint>

namespace softgl::cli {

// What ends a token: blanks, line ends, NUL, '#' (comment) and '\' (line continuation).
extern const bool kEndsToken[256];
inline bool ends_token(char c) { return kEndsToken[uint8_t(c)]; }
// The same without '#', which may stand in what is no number (1.#QNAN).
extern const bool kEndsNumber[256];

// The slow, exact way: any length, inf and nan, +signs. Moves the cursor past the token. False: not a number.
bool read_unusual_number(const char*& cursor, double& value);
float round_to_float_exactly(const char* first, const char* last, double value);

inline constexpr double kPowerOfTen[23] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                           1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                           1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// Reads the number at `cursor` (text ends with a zero byte) and moves it past the token. False: not a number;
// the cursor has still moved past the token.
inline bool read_number(const char*& cursor, double& value) {
  const char* p = cursor;
  const bool negative = *p == '-';
  p += negative || *p == '+';
  const char* first_digit = p;
  uint64_t mantissa = 0;
  unsigned digit;
  while ((digit = uint8_t(*p) - unsigned('0')) < 10) mantissa = mantissa * 10 + digit, ++p;
  long digits = p - first_digit;
  long exponent = 0;
  if (*p == '.') {
    const char* first_decimal = ++p;
    while ((digit = uint8_t(*p) - unsigned('0')) < 10) mantissa = mantissa * 10 + digit, ++p;
    exponent = first_decimal - p;
    digits -= exponent;
  }
  if ((*p | 32) == 'e' && digits > 0) {
    const char* e = p + 1;
    const bool minus = *e == '-';
    e += minus || *e == '+';
    int power = 0;
    const char* first_power_digit = e;
    while ((digit = uint8_t(*e) - unsigned('0')) < 10 && power < 10000) power = power * 10 + int(digit), ++e;
    if (e > first_power_digit) {
      exponent += minus ? -power : power;
      p = e;
    }
  }
  // Both factors exact in double, so one rounding: the correctly rounded value.
  if (kEndsNumber[uint8_t(*p)] && digits > 0 && digits <= 19 && mantissa <= (uint64_t(1) << 53) &&
      exponent >= -22 && exponent <= 22) [[likely]] {
    double magnitude = double(int64_t(mantissa));
    magnitude = exponent < 0 ? magnitude / kPowerOfTen[-exponent] : magnitude * kPowerOfTen[exponent];
    value = std::bit_cast<double>(std::bit_cast<uint64_t>(magnitude) | uint64_t(negative) << 63);
    cursor = p;
    return true;
  }
  return read_unusual_number(cursor, value);
}

// True if the token looks like a number with a decimal comma, as in 1,5.
bool has_decimal_comma(const char* token);

// The same for a float: rounding twice goes wrong only if the double lies on a halfway case of float.
inline bool read_number(const char*& cursor, float& value) {
  const char* first = cursor;
  double exact;
  const bool good = read_number(cursor, exact);
  if (!good) return false;
  const uint64_t tail = std::bit_cast<uint64_t>(exact) & 0x1fffffff;
  if (tail - 0x0fffffff <= 2) [[unlikely]]
    value = round_to_float_exactly(first, cursor, exact);
  else
    value = float(exact);
  return true;
}

} // namespace softgl::cli
