#include <catch2/catch.hpp>

#include "obj/number_parser.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>

using namespace softgl::cli;

namespace {

template <class T> bool reads(const std::string& text, T& value) {
  const char* cursor = text.c_str();
  const bool good = read_number(cursor, value);
  CHECK((good || cursor > text.c_str() || text.empty()));
  return good && *cursor == '\0';
}

void check_against_c_library(const std::string& text) {
  INFO(text);
  double d;
  float f;
  REQUIRE(reads(text, d));
  REQUIRE(reads(text, f));
  const double expected_double = std::strtod(text.c_str(), nullptr);
  const float expected_float = std::strtof(text.c_str(), nullptr);
  CHECK(std::memcmp(&d, &expected_double, sizeof d) == 0);
  CHECK(std::memcmp(&f, &expected_float, sizeof f) == 0);
}

} // namespace

TEST_CASE("number parser: correctly rounded", "[models][numbers]") {
  for (const char* text :
       {"0", "-0", "+1", "1.", ".5", "-.5e1", "1e22", "1e23", "8.5e-23", "9007199254740993",
        "9007199254740992.5", "123456789012345678901234567890", "0.000000000000000000000000000012345",
        "1e400", "-1e400", "1e-400", "4.9e-324", "2.2250738585072011e-308", "1.17549435e-38",
        // halfway between two floats, and a hair beside it
        "16777217", "16777217.0000000001", "16777216.9999999999", "1.00000005960464477539062500",
        "1.00000005960464477539062501", "3.4028235677973366e38", "100e-2", "0e5", "1E+00"})
    check_against_c_library(text);
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i) {
    std::string text = random() % 2 ? "-" : "";
    const int whole = int(random() % 10), decimals = int(random() % 14);
    text += std::to_string(random() % 10);
    for (int k = 0; k < whole; ++k) text += char('0' + random() % 10);
    if (random() % 8) text += ".";
    for (int k = 0; k < decimals && text.find('.') != std::string::npos; ++k)
      text += char('0' + random() % 10);
    if (random() % 4 == 0) text += "e" + std::to_string(int(random() % 80) - 40);
    check_against_c_library(text);
  }
}

TEST_CASE("number parser: what is no number", "[models][numbers]") {
  double value;
  for (const char* text :
       {"", "-", "+", ".", "e5", "--3", "+-3", "0x1", "abc", "1,5", "1.2.3", "1e", "1e+", "12a", "1/2"}) {
    INFO(text);
    CHECK_FALSE(reads(text, value));
  }
  REQUIRE(reads("nan", value));
  CHECK(std::isnan(value));
  REQUIRE(reads("-inf", value));
  CHECK(std::isinf(value));
}

TEST_CASE("number parser: stops at blanks, comments, continuations and NUL", "[models][numbers]") {
  for (const char* end : {" ", "\t", "\n", "\r", "#", "\\", ""}) {
    const std::string text = std::string("12.5") + end + "7";
    const std::string ended = *end ? text : std::string("12.5\0", 5) + "7";
    const char* cursor = ended.c_str();
    double value;
    REQUIRE(read_number(cursor, value));
    CHECK(value == 12.5);
    CHECK(cursor == ended.c_str() + 4);
  }
}
