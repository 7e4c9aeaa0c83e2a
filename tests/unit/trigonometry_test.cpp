#include "base/trigonometry.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace softgl;

TEST_CASE("sine and cosine stay within 0.57 units in the last place", "[base]") {
  for (int i = -720000; i <= 720000; i += 37) {
    const float x = float(i * 0.005f * 3.14159265358979323846 / 180.0);
    const double exact_sine = std::sin(double(x)), exact_cosine = std::cos(double(x));
    const auto unit = [](double v) { return std::ldexp(1.0, std::ilogb(v == 0 ? 1.0 : v) - 23); };
    REQUIRE(std::fabs(sine(x) - exact_sine) <= 0.57 * unit(exact_sine));
    REQUIRE(std::fabs(cosine(x) - exact_cosine) <= 0.57 * unit(exact_cosine));
  }
}

TEST_CASE("sine and cosine of huge, tiny and special arguments", "[base]") {
  REQUIRE(sine(0.0f) == 0.0f);
  REQUIRE(std::signbit(sine(-0.0f)));
  REQUIRE(cosine(0.0f) == 1.0f);
  REQUIRE(std::isnan(sine(INFINITY)));
  REQUIRE(std::isnan(cosine(-INFINITY)));
  for (float x : {1e3f, 12345.678f, 1e9f, 1.5e20f, 3.4e38f, -7e12f}) {
    REQUIRE(double(sine(x)) == Approx(std::sin(double(x))).margin(1e-7));
    REQUIRE(double(cosine(x)) == Approx(std::cos(double(x))).margin(1e-7));
  }
}

TEST_CASE("sine and cosine of half degrees are the bits glRotate needs", "[base]") {
  // What the C library answers on a host with FMA; correct rounding would give the other neighbour for these.
  REQUIRE(sine(-0x1.3a22c6p+9f) == 0x1.7fc35ep-5f);
  REQUIRE(cosine(-0x1.39a96ep+9f) == 0x1.16d854p-1f);
  REQUIRE(sine(-0x1.d0f4aap+6f) == 0x1.a44af8p-20f);
}
