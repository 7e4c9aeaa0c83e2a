#include "options/option_values.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "obj/number_parser.h"

namespace softgl::cli {
namespace {

[[noreturn]] void refuse_value(const std::string& what, const std::string& text) {
  throw std::invalid_argument("\"" + text + "\" is not " + what);
}

std::string lower(std::string text) {
  for (char& c : text) c = char(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return text;
}

bool parse_numbers(const std::string& text, std::vector<double>& values) {
  size_t begin = 0;
  for (;;) {
    const size_t comma = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, comma - begin);
    const char* cursor = part.c_str();
    double value;
    if (part.empty() || !read_number(cursor, value) || cursor != part.c_str() + part.size() ||
        !std::isfinite(value))
      return false;
    values.push_back(value);
    if (comma == text.size()) return true;
    begin = comma + 1;
  }
}

struct NamedColor {
  const char* name;
  uint32_t rgb;
};
constexpr NamedColor kColors[] = {
    {"black", 0x000000},      {"white", 0xffffff},     {"red", 0xff0000},       {"green", 0x008000},
    {"lime", 0x00ff00},       {"blue", 0x0000ff},      {"yellow", 0xffff00},    {"cyan", 0x00ffff},
    {"magenta", 0xff00ff},    {"gray", 0x808080},      {"grey", 0x808080},      {"silver", 0xc0c0c0},
    {"darkgray", 0xa9a9a9},   {"darkgrey", 0xa9a9a9},  {"lightgray", 0xd3d3d3}, {"lightgrey", 0xd3d3d3},
    {"whitesmoke", 0xf5f5f5}, {"orange", 0xffa500},    {"gold", 0xffd700},      {"tomato", 0xff6347},
    {"coral", 0xff7f50},      {"salmon", 0xfa8072},    {"crimson", 0xdc143c},   {"maroon", 0x800000},
    {"brown", 0xa52a2a},      {"sienna", 0xa0522d},    {"tan", 0xd2b48c},       {"beige", 0xf5f5dc},
    {"ivory", 0xfffff0},      {"olive", 0x808000},     {"teal", 0x008080},      {"navy", 0x000080},
    {"purple", 0x800080},     {"violet", 0xee82ee},    {"indigo", 0x4b0082},    {"pink", 0xffc0cb},
    {"hotpink", 0xff69b4},    {"turquoise", 0x40e0d0}, {"skyblue", 0x87ceeb},   {"steelblue", 0x4682b4},
    {"royalblue", 0x4169e1},  {"slategray", 0x708090}, {"slategrey", 0x708090}, {"forestgreen", 0x228b22},
    {"seagreen", 0x2e8b57},   {"darkgreen", 0x006400}, {"darkblue", 0x00008b},  {"darkred", 0x8b0000},
    {"chocolate", 0xd2691e},  {"khaki", 0xf0e68c},     {"plum", 0xdda0dd},      {"orchid", 0xda70d6},
};

std::array<uint8_t, 3> split(uint32_t rgb) { return {uint8_t(rgb >> 16), uint8_t(rgb >> 8), uint8_t(rgb)}; }

constexpr float kDefaultCutoff = 30; // degrees, of a spot that does not say

LightOptions parse_light_kind(const std::string& text) {
  static const std::string what =
      "a light: key, headlight, three-point, x,y,z, model:x,y,z, at:x,y,z or an axis such as +Y";
  LightOptions light;
  if (text == "key") return light;
  light.kind = LightOptions::kHeadlight;
  if (text == "headlight" || text == "head") return light;
  light.kind = LightOptions::kThreePoint;
  if (text == "three-point") return light;
  light.kind = LightOptions::kDirection;
  std::string rest = text;
  if (text.rfind("model:", 0) == 0) {
    light.kind = LightOptions::kModelDirection;
    rest = text.substr(6);
  } else if (text.rfind("at:", 0) == 0) {
    light.kind = LightOptions::kModelPosition;
    rest = text.substr(3);
  }
  if (rest.size() == 2 && (rest[0] == '+' || rest[0] == '-') && light.kind != LightOptions::kModelPosition) {
    const char axis = lower(rest)[1];
    if (axis < 'x' || axis > 'z') refuse_value(what, text);
    light.kind = LightOptions::kModelDirection;
    light.value[0] = light.value[1] = light.value[2] = 0;
    light.value[axis - 'x'] = rest[0] == '-' ? -1 : 1;
    return light;
  }
  std::vector<double> values;
  if (!parse_numbers(rest, values) || values.size() != 3) refuse_value(what, text);
  for (size_t i = 0; i < 3; ++i) light.value[i] = values[i];
  if (light.kind == LightOptions::kModelPosition) return light;
  const double largest = std::max({std::fabs(values[0]), std::fabs(values[1]), std::fabs(values[2])});
  if (!(largest > 0)) refuse_value(what, text);
  for (double& value : light.value) value /= largest;
  return light;
}

void parse_light_property(const std::string& text, LightOptions& light) {
  static const std::string what =
      "a property of a light: color:COLOR for any; for at:x,y,z also spot:x,y,z, cutoff:0..90, "
      "exponent:0..128 and attenuation:constant,linear,quadratic";
  const size_t colon = text.find(':');
  if (colon == std::string::npos) refuse_value(what, text);
  const std::string name = lower(text.substr(0, colon)), value = text.substr(colon + 1);
  if (name == "color" || name == "colour") {
    const std::array<float, 3> color = parse_reflectance(value);
    std::copy(color.begin(), color.end(), light.color);
    return;
  }
  std::vector<double> values;
  if (light.kind != LightOptions::kModelPosition || !parse_numbers(value, values)) refuse_value(what, text);
  const size_t count = values.size();
  const bool from_zero = std::all_of(values.begin(), values.end(), [](double number) { return number >= 0; });
  if (name == "spot" && count == 3 && (values[0] != 0 || values[1] != 0 || values[2] != 0)) {
    const double largest = std::max({std::fabs(values[0]), std::fabs(values[1]), std::fabs(values[2])});
    for (size_t i = 0; i < 3; ++i) light.spot_direction[i] = values[i] / largest;
    if (light.cutoff == 180) light.cutoff = kDefaultCutoff;
  } else if (name == "cutoff" && count == 1 && from_zero && values[0] <= 90) {
    light.cutoff = float(values[0]);
  } else if (name == "exponent" && count == 1 && from_zero && values[0] <= 128) {
    light.exponent = float(values[0]);
  } else if (name == "attenuation" && count == 3 && from_zero && values[0] + values[1] + values[2] > 0) {
    for (size_t i = 0; i < 3; ++i) light.attenuation[i] = float(values[i]);
  } else {
    refuse_value(what, text);
  }
}

} // namespace

std::array<uint8_t, 3> parse_color(const std::string& text) {
  static const std::string what = "a color (#rrggbb, r,g,b from 0 to 1, or a name such as steelblue)";
  const std::string name = lower(text);
  for (const NamedColor& color : kColors)
    if (name == color.name) return split(color.rgb);
  if (!name.empty() && name[0] == '#') {
    if (name.find_first_not_of("0123456789abcdef", 1) != std::string::npos ||
        (name.size() != 4 && name.size() != 7))
      refuse_value(what, text);
    uint32_t value = 0;
    for (size_t i = 1; i < name.size(); ++i) {
      const auto digit = uint32_t(name[i] <= '9' ? name[i] - '0' : name[i] - 'a' + 10);
      value = name.size() == 4 ? value << 8 | digit * 17 : value << 4 | digit;
    }
    return split(value);
  }
  std::vector<double> values;
  if (!parse_numbers(text, values) || values.size() != 3) refuse_value(what, text);
  std::array<uint8_t, 3> result;
  for (size_t i = 0; i < 3; ++i) {
    if (values[i] < 0 || values[i] > 1) refuse_value(what, text);
    result[i] = uint8_t(values[i] * 255 + 0.5);
  }
  return result;
}

void parse_size(const std::string& text, int& width, int& height) {
  std::string commas = lower(text);
  const size_t cross = commas.find('x');
  if (cross != std::string::npos) commas[cross] = ',';
  std::vector<double> values;
  if (!parse_numbers(commas, values) || values.size() > 2) refuse_value("a size such as 800x600", text);
  const double w = values[0], h = values.back();
  if (w != std::floor(w) || h != std::floor(h) || w < 1 || h < 1 || w > 16384 || h > 16384)
    refuse_value("a size from 1x1 to 16384x16384", text);
  width = int(w);
  height = int(h);
}

void parse_sheet(const std::string& text, int& columns, int& rows) {
  rows = 0;
  int unused;
  if (text.find_first_of("xX,") == std::string::npos)
    parse_size(text, columns, unused);
  else
    parse_size(text, columns, rows);
  if (columns > 100 || rows > 100) refuse_value("a sheet of at most 100 columns and rows", text);
}

UpAxis parse_up_axis(const std::string& text) {
  const std::string name = lower(text);
  if (name == "auto") return UpAxis::kAuto;
  const bool sign = !name.empty() && (name[0] == '+' || name[0] == '-');
  const std::string axis = name.substr(sign ? 1 : 0);
  if (axis.size() != 1 || axis[0] < 'x' || axis[0] > 'z')
    refuse_value("an axis such as +Y, -Z or auto", text);
  return UpAxis(2 * (axis[0] - 'x') + (name[0] == '-'));
}

std::array<double, 3> parse_triple(const std::string& text) {
  std::vector<double> values;
  if (!parse_numbers(text, values) || values.size() != 3) refuse_value("three numbers, x,y,z", text);
  return {values[0], values[1], values[2]};
}

std::vector<std::string> parse_views(const std::string& text) {
  std::vector<std::string> names = split_list(text);
  double unused;
  for (const std::string& name : names)
    if (!named_view(name, unused, unused))
      refuse_value("a view: iso, front, back, left, right, top or bottom", name);
  return names;
}

std::vector<Pass> parse_passes(const std::string& text) {
  static const std::string what = "a list of passes, each once: color, depth, normal, uv, id, ambient, "
                                  "diffuse, specular, emission, coverage";
  std::vector<Pass> passes;
  for (const std::string& name : split_list(text)) {
    Pass pass;
    if (!named_pass(lower(name), pass) || std::find(passes.begin(), passes.end(), pass) != passes.end())
      refuse_value(what, text);
    passes.push_back(pass);
  }
  return passes;
}

LightOptions parse_light(const std::string& text) {
  size_t end = std::min(text.find('/'), text.size());
  LightOptions light = parse_light_kind(text.substr(0, end));
  while (end < text.size()) {
    const size_t begin = end + 1;
    end = std::min(text.find('/', begin), text.size());
    parse_light_property(text.substr(begin, end - begin), light);
  }
  return light;
}

unsigned parse_terms(const std::string& text) {
  static constexpr struct {
    const char* name;
    unsigned term;
  } kTerms[] = {{"ambient", kAmbient},
                {"diffuse", kDiffuse},
                {"specular", kSpecular},
                {"emission", kEmission},
                {"all", kAllTerms}};
  unsigned terms = 0;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t comma = std::min(text.find(',', begin), text.size());
    const std::string name = lower(text.substr(begin, comma - begin));
    const auto* found =
        std::find_if(std::begin(kTerms), std::end(kTerms), [&](const auto& t) { return name == t.name; });
    if (found == std::end(kTerms))
      refuse_value("a list of terms: ambient, diffuse, specular, emission or all", text);
    terms |= found->term;
    begin = comma + 1;
  }
  return terms;
}

std::array<float, 3> parse_reflectance(const std::string& text) {
  std::vector<double> values;
  if (!parse_numbers(text, values)) {
    const std::array<uint8_t, 3> rgb = parse_color(text);
    return {float(rgb[0]) / 255, float(rgb[1]) / 255, float(rgb[2]) / 255};
  }
  if (values.size() == 1) values.resize(3, values[0]);
  const bool inside =
      std::all_of(values.begin(), values.end(), [](double value) { return value >= 0 && value <= 1; });
  if (values.size() != 3 || !inside)
    refuse_value("a number from 0 to 1, three of them (r,g,b), or a color", text);
  return {float(values[0]), float(values[1]), float(values[2])};
}

Background parse_background(const std::string& text) {
  Background background;
  if (lower(text) == "transparent" || lower(text) == "none") {
    background.transparent = true;
    return background;
  }
  if (text.rfind("picture:", 0) == 0) {
    background.file = text.substr(8);
    return background;
  }
  const size_t colon = std::min(text.find(':'), text.size());
  const std::array<uint8_t, 3> color = parse_color(text.substr(0, colon));
  for (size_t i = 0; i < 3; ++i) background.color[i] = color[i];
  if (colon < text.size()) background.below = parse_color(text.substr(colon + 1));
  return background;
}

std::array<float, 4> parse_tolerance(const std::string& text) {
  std::vector<double> values;
  const bool numbers = parse_numbers(text, values);
  if (values.size() == 1) values.resize(4, values[0]);
  if (values.size() == 3) values.push_back(0);
  const bool inside =
      std::all_of(values.begin(), values.end(), [](double value) { return value >= 0 && value <= 255; });
  if (!numbers || values.size() != 4 || !inside)
    refuse_value("a number from 0 to 255, r,g,b or r,g,b,a", text);
  return {float(values[0]), float(values[1]), float(values[2]), float(values[3])};
}

double parse_count_or_percentage(const std::string& text) {
  const bool percentage = !text.empty() && text.back() == '%';
  std::vector<double> values;
  if (!parse_numbers(text.substr(0, text.size() - percentage), values) || values.size() != 1 ||
      values[0] < 0 || (percentage ? values[0] > 100 : values[0] != std::floor(values[0])))
    refuse_value("a whole number or a percentage", text);
  return values[0];
}

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t comma = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, comma - begin));
    begin = comma + 1;
  }
  return parts;
}

} // namespace softgl::cli
