#include "report/report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace softgl::test {
namespace {

constexpr int kAmplification = 16; // of differences: 1 of 255 is to be seen

std::string escape(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
    case '&': out += "&amp;"; break;
    case '<': out += "&lt;"; break;
    case '>': out += "&gt;"; break;
    case '"': out += "&quot;"; break;
    default: out += c;
    }
  }
  return out;
}

std::string base64(const std::vector<uint8_t>& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t present = std::min<size_t>(3, bytes.size() - i);
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k) group = group << 8 | (k < present ? bytes[i + k] : 0u);
    for (size_t k = 0; k < 4; ++k) out += k <= present ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string image(const char* what, int width, int height, const std::vector<uint8_t>& rgba) {
  return std::string("<td><img alt=\"") + what + "\" width=\"" + std::to_string(width) + "\" height=\"" +
         std::to_string(height) + "\" src=\"data:image/png;base64," +
         base64(encode_png(width, height, rgba)) + "\"></td>";
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

// 100 only where all are equal.
std::string percentage(size_t equal, size_t all) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g",
                std::floor(1e6 * static_cast<double>(equal) / static_cast<double>(all)) / 1e4);
  return std::string(text) + "&nbsp;%";
}

struct Tally {
  size_t rows = 0, equal = 0, passed = 0, channels = 0, unequal = 0;
  int largest = 0;
};

std::string cells(std::initializer_list<std::string> texts, const char* tag = "td") {
  std::string out;
  for (const std::string& text : texts) out += std::string("<") + tag + ">" + text + "</" + tag + ">";
  return out;
}

std::string row_html(const ReportRow& row, Tally& tally) {
  const Difference d = compare(row.ours, row.theirs);
  const bool same = !d.any(), passed = passes(row);
  ++tally.rows;
  tally.equal += same;
  tally.passed += passed;
  tally.channels += row.ours.color.size();
  tally.unequal += d.color_bytes;
  tally.largest = std::max(tally.largest, d.max_color);
  std::vector<uint8_t> amplified(row.ours.color.size());
  if (!d.size)
    for (size_t i = 0; i < amplified.size(); ++i)
      amplified[i] = static_cast<uint8_t>(
          std::min(255, kAmplification * std::abs(row.ours.color[i] - row.theirs.color[i])));
  const std::string numbers = same ? "same bytes"
                                   : std::to_string(d.color_bytes) + " of " +
                                         std::to_string(row.ours.color.size()) +
                                         " color bytes differ, by at most " + std::to_string(d.max_color) +
                                         "; " + std::to_string(d.depth_values) + " depths differ";
  const char* state = same ? "equal" : passed ? "within" : "failed";
  return std::string("<tr class=\"scene ") + state + "\" data-state=\"" + state + "\" data-group=\"" +
         escape(row.group) + "\" data-name=\"" + escape(row.name) + "\"><th>" + escape(row.name) + "<small>" +
         escape(row.group) + "</small><small>" + numbers + "</small><code>" + escape(row.again) +
         "</code></th>" + image("softgl", row.ours.width, row.ours.height, row.ours.color) +
         image("compared with", row.theirs.width, row.theirs.height, row.theirs.color) +
         image("difference", row.ours.width, row.ours.height, amplified) + "</tr>\n";
}

// Both axes logarithmic, as errors fall by powers of the fineness.
class Plot {
public:
  explicit Plot(const std::vector<const ReportCurve*>& curves) : curves(curves) {
    for (const ReportCurve* curve : curves)
      for (const auto& [x, y] : curve->points) {
        low_x = std::min(low_x, x), high_x = std::max(high_x, x);
        if (y > 0) low_y = std::min(low_y, y), high_y = std::max(high_y, y);
      }
    if (high_y <= low_y) low_y = 0.5 * (high_y = std::max(high_y, 1.0));
  }

  std::string svg() const {
    std::string out = "<svg viewBox=\"0 0 " + number(kWidth) + " " + number(kHeight) + "\" role=\"img\">";
    out += "<rect x=\"" + number(kLeft) + "\" y=\"" + number(kTop) + "\" width=\"" +
           number(kWidth - kLeft - kRight) + "\" height=\"" + number(kHeight - kTop - kBottom) +
           "\" class=\"frame\"/>";
    for (double decade = std::pow(10, std::floor(std::log10(low_y))); decade <= high_y * 1.001; decade *= 10)
      if (decade >= low_y * 0.999) out += text(kLeft - 6, y_of(decade) + 4, number(decade), "end");
    for (const auto& point : curves.front()->points)
      out += text(x_of(point.first), kHeight - kBottom + 16, number(point.first), "middle");
    for (size_t i = 0; i < curves.size(); ++i) {
      const std::string color = "hsl(" + std::to_string(i * 360 / curves.size()) + " 60% 40%)";
      out += "<polyline fill=\"none\" stroke=\"" + color + "\" points=\"";
      for (const auto& [x, y] : curves[i]->points)
        out += number(x_of(x)) + "," + number(y_of(std::max(y, low_y))) + " ";
      out += "\"/><text x=\"" + number(kWidth - kRight + 8) + "\" y=\"" +
             number(kTop + 12 + 15 * static_cast<double>(i)) + "\" fill=\"" + color + "\">" +
             escape(curves[i]->name) + "</text>";
    }
    return out + "</svg>";
  }

private:
  static constexpr double kWidth = 760, kHeight = 360, kLeft = 60, kRight = 250, kTop = 12, kBottom = 28;

  double x_of(double x) const {
    return kLeft + (kWidth - kLeft - kRight) *
                       (high_x > low_x ? std::log(x / low_x) / std::log(high_x / low_x) : 0.5);
  }
  double y_of(double y) const {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * std::log(y / low_y) / std::log(high_y / low_y);
  }
  static std::string text(double x, double y, const std::string& what, const char* anchor) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" + what +
           "</text>";
  }

  const std::vector<const ReportCurve*>& curves;
  double low_x = 1e9, high_x = 0, low_y = 1e9, high_y = 0;
};

void replace(std::string& page, const std::string& placeholder, const std::string& text) {
  const size_t at = page.find(placeholder);
  if (at == std::string::npos) throw std::runtime_error("the page has no place for " + placeholder);
  page.replace(at, placeholder.size(), text);
}

} // namespace

bool passes(const ReportRow& row) {
  const Difference d = compare(row.ours, row.theirs);
  return !d.size && !d.errors && !(d.depth_values && row.same_depths) && d.max_color <= row.allowed;
}

std::string report_page(const std::string& page, const Report& report) {
  std::map<std::string, Tally> tallies;
  std::string rows, summary, versions, plots;
  for (const ReportRow& row : report.rows) rows += row_html(row, tallies[row.group]);
  for (const auto& [group, t] : tallies)
    summary += "<tr class=\"" + std::string(t.passed == t.rows ? "equal" : "failed") + "\">" +
               cells({escape(group), std::to_string(t.rows), std::to_string(t.equal),
                      std::to_string(t.passed), std::to_string(t.unequal),
                      percentage(t.channels - t.unequal, t.channels), std::to_string(t.largest)}) +
               "</tr>\n";
  for (const std::string& version : report.versions) versions += "<li>" + escape(version) + "</li>\n";
  std::map<std::string, std::vector<const ReportCurve*>> by_plot;
  for (const ReportCurve& curve : report.curves) by_plot[curve.plot].push_back(&curve);
  for (const auto& [plot, curves] : by_plot)
    plots += "<figure><figcaption>" + escape(plot) + "</figcaption>" + Plot(curves).svg() + "</figure>\n";
  std::string out = page;
  replace(out, "<!--versions-->", versions);
  replace(out, "<!--summary-->", summary);
  replace(out, "<!--plots-->", plots);
  replace(out, "<!--rows-->", rows);
  return out;
}

} // namespace softgl::test
