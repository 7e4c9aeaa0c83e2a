// Letters and shapes on a picture.
#include <catch2/catch.hpp>

#include "image/lettering.h"
#include "image/typeface.h"

using namespace softgl::cli;

namespace {

Picture white(int width, int height) {
  Picture picture;
  picture.width = width;
  picture.height = height;
  picture.pixels.fill(size_t(3) * size_t(width) * size_t(height), 255);
  return picture;
}

// How many pixels' worth of black is in the columns.
double ink(const Picture& picture, int from, int to) {
  double sum = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = from; x < to; ++x)
      sum += (255 - picture.pixels[3 * (size_t(y) * size_t(picture.width) + size_t(x))]) / 255.0;
  return sum;
}

constexpr Color kBlack = {0, 0, 0};

} // namespace

TEST_CASE("lettering: words are where they should be, and as wide as said", "[models][lettering]") {
  const double width = text_width("Phong", 40);
  CHECK(width == Approx(2 * text_width("Phong", 20)).epsilon(0.01));
  CHECK(width > text_width("Phon", 40));
  Picture picture = white(300, 80);
  draw_text(picture, 50, 50, 40, "Phong", kBlack);
  CHECK(ink(picture, 0, 48) == 0);
  CHECK(ink(picture, 48, 52 + int(width)) > 200);
  CHECK(ink(picture, 54 + int(width), 300) == 0);
  // Nothing is written beside the picture.
  for (const double x : {-30.0, 280.0})
    for (const double y : {-5.0, 5.0, 90.0}) draw_text(picture, x, y, 40, "gÄ", kBlack);
}

TEST_CASE("lettering: letters beyond ASCII", "[models][lettering]") {
  if (typeface().empty()) {
    CHECK(text_width("ä", 20) == text_width("ae", 20));
    return;
  }
  for (const char* letter : {"ä", "ß", "·", "Σ", "θ", "φ", "−", "≤", "×", "ε"}) {
    Picture with = white(40, 40), without = white(40, 40);
    draw_text(with, 5, 30, 24, letter, kBlack);
    draw_text(without, 5, 30, 24, "\xf4\x8f\xbf\xbf", kBlack); // U+10FFFF: no letter
    INFO(letter);
    CHECK(ink(with, 0, 40) > 3);
    CHECK(ink(with, 0, 40) != ink(without, 0, 40));
  }
  // Broken UTF-8 is some letter for each byte.
  CHECK(text_width("\xc3", 20) > 0);
  CHECK(text_width("\xe2\x82", 20) > 0);
}

TEST_CASE("lettering: plain letters and short texts", "[models][lettering]") {
  CHECK(ascii_only("größer ≥ 60° · Σ") == "groesser >= 60 deg . sum ");
  CHECK(ascii_only("\xff\xc3") == "??");
  const std::string name = "ein sehr langer Name, und noch länger äöüäöüäöü.obj";
  const std::string cut = shortened(name, 20, 200);
  CHECK(text_width(cut, 20) <= 200);
  CHECK(cut.find("...") != std::string::npos);
  CHECK(ascii_only(cut).find('?') == std::string::npos); // no letter is cut in two
  CHECK(shortened("a", 20, 200) == "a");
  CHECK(shortened("abc", 20, 1) == "...");
}

TEST_CASE("shapes: areas are exact, and count once where they overlap", "[models][lettering]") {
  Picture picture = white(60, 60);
  fill_polygons(picture, {{{10.5, 10}, {30, 10}, {30, 20}, {10.5, 20}}}, kBlack);
  CHECK(ink(picture, 0, 60) == Approx(195).epsilon(0.005));
  CHECK(ink(picture, 10, 11) == Approx(5).epsilon(0.02)); // half covered
  picture = white(60, 60);
  fill_polygons(picture, {{{10, 10}, {30, 10}, {30, 20}, {10, 20}}, {{20, 10}, {20, 20}, {40, 20}, {40, 10}}},
                kBlack);
  CHECK(ink(picture, 0, 60) == Approx(300).epsilon(0.005));
  picture = white(60, 60);
  fill_polygons(picture, {{{-500, 10}, {500, 10}, {500, 20}, {-500, 20}}}, kBlack, 0.5);
  CHECK(ink(picture, 0, 60) == Approx(300).epsilon(0.01));
  picture = white(60, 60);
  stroke_line(picture, {{10, 30}, {50, 30}}, false, 6, kBlack);
  CHECK(ink(picture, 0, 60) == Approx(240 + 3.1416 * 9).epsilon(0.02)); // with half a disk at each end
}
