// Values of options as text: colors, sizes, axes, lights. Each throws std::invalid_argument with a sentence.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/lighting_options.h"
#include "scene/renderer.h"

namespace softgl::cli {

std::array<uint8_t, 3> parse_color(const std::string& text);       // #rgb, #rrggbb, a CSS name, r,g,b in 0..1
void parse_size(const std::string& text, int& width, int& height); // WxH, W,H or one number
// COLUMNSxROWS, or COLUMNS alone: `rows` is then 0.
void parse_sheet(const std::string& text, int& columns, int& rows);
UpAxis parse_up_axis(const std::string& text);
std::array<double, 3> parse_triple(const std::string& text);   // x,y,z
std::vector<std::string> parse_views(const std::string& text); // names that named_view() knows, with commas
std::vector<Pass> parse_passes(const std::string& text);       // names with commas, each once
// KIND[/PROPERTY:VALUE...], as LightOptions describes them.
LightOptions parse_light(const std::string& text);
unsigned parse_terms(const std::string& text); // names of terms with commas between them
// A reflectance: one number or r,g,b, each from 0 to 1, or a color.
std::array<float, 3> parse_reflectance(const std::string& text);
// A color, two with : between (top and bottom), transparent, or picture:FILE, which is not read here.
Background parse_background(const std::string& text);
// One number for all channels, or r,g,b or r,g,b,a; each from 0 to 255.
std::array<float, 4> parse_tolerance(const std::string& text);
double parse_count_or_percentage(const std::string& text);    // a whole number, or one from 0 to 100 and %
std::vector<std::string> split_list(const std::string& text); // at its commas

} // namespace softgl::cli
