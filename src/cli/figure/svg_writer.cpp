#include "figure/svg_writer.h"

#include <cstdio>

#include "figure/formula.h"
#include "image/png_encoder.h"

namespace softgl::cli {
namespace {

// At most three digits behind the point: a page is about a thousand units wide.
std::string decimal(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", value);
  std::string result = text;
  while (result.back() == '0') result.pop_back();
  if (result.back() == '.') result.pop_back();
  return result == "-0" ? "0" : result;
}

std::string color_text(const Color& color) {
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color[0], color[1], color[2]);
  return text;
}

std::string base64(const GrowingArray<uint8_t>& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = bytes.size() - i;
    const unsigned triple = unsigned(bytes[i]) << 16 | (left > 1 ? unsigned(bytes[i + 1]) << 8 : 0) |
                            (left > 2 ? bytes[i + 2] : 0u);
    for (size_t k = 0; k < 4; ++k) text += k <= left ? kDigits[triple >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

class SvgWriter {
public:
  explicit SvgWriter(PngEffort effort) : effort_(effort) {}

  std::string text;

  void operator()(const Shape& shape) {
    text += "<path";
    if (!shape.name.empty()) {
      add("class", "curve");
      add("data-name", escaped(shape.name));
      add("data-origin", decimal(shape.scale.origin.x) + " " + decimal(shape.scale.origin.y));
      add("data-unit", decimal(shape.scale.unit.x) + " " + decimal(shape.scale.unit.y));
    }
    std::string path;
    for (size_t i = 0; i < shape.points.size(); ++i)
      path += (i == 0 ? "M" : " L") + decimal(shape.points[i].x) + " " + decimal(shape.points[i].y);
    if (shape.closed) path += " Z";
    add("d", path);
    add("fill", shape.fill ? color_text(*shape.fill) : "none");
    if (shape.fill && shape.opacity < 1) add("fill-opacity", decimal(shape.opacity));
    if (shape.line) {
      add("stroke", color_text(*shape.line));
      add("stroke-width", decimal(shape.width));
      add("stroke-linejoin", "round");
      add("stroke-linecap", "round");
      if (shape.dashed) add("stroke-dasharray", decimal(3 * shape.width) + " " + decimal(3 * shape.width));
    }
    text += "/>\n";
  }

  void operator()(const Words& words) {
    static constexpr const char* kAnchors[] = {"start", "middle", "end"};
    text += "<text";
    add("x", decimal(words.at.x));
    add("y", decimal(words.at.y));
    add("font-size", decimal(words.size));
    if (words.anchor != Words::kStart) add("text-anchor", kAnchors[words.anchor]);
    add("fill", color_text(words.color));
    text += '>';
    if (words.formula)
      add_formula(words);
    else
      text += escaped(words.text);
    text += "</text>\n";
  }

  void operator()(const PlacedPicture& placed) {
    text += "<image";
    add("data-name", escaped(placed.name));
    add("x", decimal(placed.at.x));
    add("y", decimal(placed.at.y));
    add("width", decimal(placed.width));
    add("height", decimal(placed.height));
    add("href", "data:image/png;base64," + base64(encode_png(*placed.picture, effort_)));
    text += "><title>" + escaped(placed.description) + "</title></image>\n";
  }

private:
  void add(const char* name, const std::string& value) { (((text += ' ') += name) += "=\"") += value + '"'; }

  void add_formula(const Words& words) {
    double raised = 0; // by the run before
    for (const FormulaRun& run : formula_runs(words.text)) {
      const double height = run.level == FormulaRun::kBelow   ? -kMovedDown * words.size
                            : run.level == FormulaRun::kAbove ? kMovedUp * words.size
                                                              : 0;
      text += "<tspan";
      if (height != raised) add("dy", decimal(raised - height));
      if (run.level != FormulaRun::kBase) add("font-size", decimal(kSmallLetters * words.size));
      text += '>' + escaped(run.text) + "</tspan>";
      raised = height;
    }
  }

  PngEffort effort_;
};

} // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result;
}

std::string svg_element(const Drawing& drawing, const std::string& description, PngEffort effort) {
  SvgWriter writer(effort);
  writer.text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + decimal(drawing.width) + " " +
                decimal(drawing.height) + "\" width=\"" + decimal(drawing.width) + "\" height=\"" +
                decimal(drawing.height) +
                "\" role=\"img\" font-family=\"'DejaVu Sans', Verdana, sans-serif\">\n<title>" +
                escaped(description) + "</title>\n";
  for (const DrawingPart& part : drawing.parts) std::visit(writer, part);
  return writer.text + "</svg>\n";
}

std::string svg_file(const Drawing& drawing, const std::string& description, const char* language,
                     PngEffort effort) {
  std::string text = svg_element(drawing, description, effort);
  text.insert(4, std::string(" xml:lang=\"") + language + "\"");
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + text;
}

} // namespace softgl::cli
