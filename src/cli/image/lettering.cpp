#define STB_TRUETYPE_IMPLEMENTATION
#include "image/lettering.h"

#include <cmath>

#include "image/stb_truetype_functions.h"
#include "image/typeface.h"

#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wconversion"
#endif
#include <stb/stb_easy_font.h>
#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif

namespace softgl::cli {
namespace {

constexpr double kPlainSize = 11; // the size at which a step of the plain letters is a pixel
constexpr double kPlainAscent = 7;

// The next letter of UTF-8; what is none gives U+FFFD, a byte at a time.
char32_t next_letter(std::string_view text, size_t& at) {
  const auto byte = [&](size_t i) { return i < text.size() ? uint8_t(text[i]) : 0; };
  const unsigned first = byte(at++);
  if (first < 0x80) return first;
  const unsigned count = first >= 0xf0 && first < 0xf8 ? 3 : first >= 0xe0 ? 2 : 1;
  if (first < 0xc2 || first >= 0xf8) return 0xfffd;
  char32_t letter = first & (0x3fu >> count);
  for (size_t i = 0; i < count; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return 0xfffd;
    letter = letter << 6 | (byte(at + i) & 0x3f);
  }
  at += count;
  return letter;
}

// stb_truetype keeps what it found in the font's tables.
const stbtt_fontinfo* font() {
  static const auto loaded = [] {
    struct {
      stbtt_fontinfo info;
      bool usable;
    } font{};
    font.usable = !typeface().empty() && stbtt_InitFont(&font.info, typeface().data(), 0);
    return font;
  }();
  return loaded.usable ? &loaded.info : nullptr;
}

// Calls use(glyph, x) for each letter, and returns where the next one would be; x from 0.
template <class Use>
double each_glyph(const stbtt_fontinfo& info, std::string_view text, double scale, Use use) {
  double x = 0;
  int previous = 0;
  for (size_t at = 0; at < text.size();) {
    const int glyph = stbtt_FindGlyphIndex(&info, int(next_letter(text, at)));
    if (previous) x += scale * stbtt_GetGlyphKernAdvance(&info, previous, glyph);
    use(glyph, x);
    int advance = 0;
    stbtt_GetGlyphHMetrics(&info, glyph, &advance, nullptr);
    x += scale * advance;
    previous = glyph;
  }
  return x;
}

struct PlainVertex { // stb_easy_font's
  float position[3];
  uint8_t color[4];
};

void draw_plain(Picture& picture, double x, double y, double size, std::string text, const Color& color) {
  std::vector<PlainVertex> vertices(4 * 70 * (text.size() + 1)); // at most 70 quadrilaterals a letter
  const int quads = stb_easy_font_print(0, 0, text.data(), nullptr, vertices.data(),
                                        int(vertices.size() * sizeof(PlainVertex)));
  const double step = size / kPlainSize;
  std::vector<std::vector<Point>> polygons;
  for (size_t i = 0; i < size_t(quads); ++i) {
    std::vector<Point>& polygon = polygons.emplace_back();
    for (size_t k = 0; k < 4; ++k) {
      const float* p = vertices[4 * i + k].position;
      polygon.push_back({x + step * double(p[0]), y + step * (double(p[1]) - kPlainAscent)});
    }
  }
  fill_polygons(picture, polygons, color);
}

const char* ascii_name(char32_t letter) {
  static constexpr struct {
    char32_t letter;
    const char* name;
  } kNames[] = {{U'ä', "ae"},  {U'ö', "oe"},    {U'ü', "ue"},   {U'Ä', "Ae"},  {U'Ö', "Oe"}, {U'Ü', "Ue"},
                {U'ß', "ss"},  {U'·', "."},     {U'°', " deg"}, {U'−', "-"},   {U'×', "x"},  {U'θ', "theta"},
                {U'φ', "phi"}, {U'α', "alpha"}, {U'Σ', "sum "}, {U'ε', "eps"}, {U'²', "^2"}, {U'√', "sqrt"},
                {U'…', "..."}, {U'≥', ">="},    {U'≤', "<="},   {U'≈', "~"},   {U'–', "-"}};
  for (const auto& entry : kNames)
    if (entry.letter == letter) return entry.name;
  return "?";
}

} // namespace

std::string ascii_only(std::string_view text) {
  std::string out;
  for (size_t at = 0; at < text.size();) {
    const char32_t letter = next_letter(text, at);
    if ((letter >= U' ' && letter <= U'~') || letter == U'\n')
      out += char(letter);
    else
      out += ascii_name(letter);
  }
  return out;
}

double text_width(std::string_view text, double size) {
  if (const stbtt_fontinfo* info = font())
    return each_glyph(*info, text, double(stbtt_ScaleForMappingEmToPixels(info, float(size))),
                      [](int, double) {});
  return stb_easy_font_width(ascii_only(text).data()) * size / kPlainSize;
}

void draw_text(Picture& picture, double x, double y, double size, std::string_view text, const Color& color) {
  const stbtt_fontinfo* info = font();
  if (!info) return draw_plain(picture, x, y, size, ascii_only(text), color);
  const float scale = stbtt_ScaleForMappingEmToPixels(info, float(size));
  std::vector<uint8_t> mask;
  const auto fraction = [](double value) { return float(value - std::floor(value)); };
  each_glyph(*info, text, double(scale), [&](int glyph, double along) {
    const double start = x + along;
    int left, top, right, bottom;
    stbtt_GetGlyphBitmapBoxSubpixel(info, glyph, scale, scale, fraction(start), fraction(y), &left, &top,
                                    &right, &bottom);
    const int width = right - left, height = bottom - top;
    if (width <= 0 || height <= 0) return;
    mask.assign(size_t(width) * size_t(height), 0);
    stbtt_MakeGlyphBitmapSubpixel(info, mask.data(), width, height, width, scale, scale, fraction(start),
                                  fraction(y), glyph);
    blend_mask(picture, mask.data(), int(std::floor(start)) + left, int(std::floor(y)) + top, width, height,
               color);
  });
}

std::string shortened(const std::string& text, double size, double most) {
  if (text_width(text, size) <= most) return text;
  const auto cut = [&text](size_t at) { // never inside of a letter
    while (at > 0 && at < text.size() && (uint8_t(text[at]) & 0xc0) == 0x80) --at;
    return at;
  };
  for (size_t kept = text.size() - 1; kept > 0; --kept) {
    const size_t begin = cut(kept / 2), end = cut(text.size() - (kept - kept / 2));
    std::string shorter = text.substr(0, begin) + "..." + text.substr(end);
    if (text_width(shorter, size) <= most) return shorter;
  }
  return "...";
}

} // namespace softgl::cli
