#include "obj/vertex_statements.h"

#include <algorithm>
#include <cmath>

namespace softgl::cli {
namespace {

constexpr double kLargestCoordinate = 1e100; // squares and products must stay finite in double

// Why a statement has no usable numbers: what is wrong with them in general, or the comma where it is that.
std::string with_reason(const char* bad, const char* usual, const char* consequence) {
  return std::string(bad && has_decimal_comma(bad) ? "this number has a decimal comma; it needs a point (1.5)"
                                                   : usual) +
         "; " + consequence;
}

} // namespace

// Three numbers and the end of the line.
bool VertexStatements::quick_position() {
  double* xyz = out_.positions.room(3);
  const char* q = in_.p;
  for (int i = 0; i < 3; ++i) {
    while (*q == ' ') ++q;
    if (!read_number(q, xyz[i]) || !(std::fabs(xyz[i]) <= kLargestCoordinate)) return false;
  }
  while (*q == ' ') ++q;
  if (!StatementScanner::is_line_end(*q) || !out_.colors.empty()) return false;
  out_.positions.commit(3);
  in_.p = q;
  return true;
}

void VertexStatements::position() {
  if (quick_position()) [[likely]]
    return;
  double values[8];
  const char* bad = nullptr;
  const int count = in_.numbers(values, 8, bad);
  in_.skip_blanks();
  if (count < 3 || bad) {
    if (out_.remarks.count("vertex without three numbers: faces that use it are skipped"))
      out_.remarks.describe(
          "vertex without three numbers: faces that use it are skipped", in_.statement,
          with_reason(bad, "a vertex needs three numbers", "faces that use it are skipped"));
    for (int i = 0; i < 3; ++i)
      if (bad || i >= count) values[i] = std::numeric_limits<double>::quiet_NaN();
  }
  if (!(std::fabs(values[0]) <= kLargestCoordinate && std::fabs(values[1]) <= kLargestCoordinate &&
        std::fabs(values[2]) <= kLargestCoordinate)) [[unlikely]] {
    if (!bad && count >= 3 && out_.remarks.count("vertex that is not a finite place"))
      out_.remarks.describe("vertex that is not a finite place", in_.statement,
                            "this vertex is not a finite place; faces that use it are skipped");
    values[0] = values[1] = values[2] = std::numeric_limits<double>::quiet_NaN();
    out_.has_unusable_position = true;
  }
  double* xyz = out_.positions.extend(3);
  xyz[0] = values[0];
  xyz[1] = values[1];
  xyz[2] = values[2];
  // 4 numbers: x y z w (w matters to free-form geometry only); 6: x y z r g b; 7: x y z r g b a.
  const bool colored = (count == 6 || count == 7) && !bad && std::isfinite(values[3]) &&
                       std::isfinite(values[4]) && std::isfinite(values[5]);
  if (!colored && out_.colors.empty()) return;
  if (out_.colors.empty())
    out_.colors.fill(out_.positions.size() - 3, std::numeric_limits<float>::quiet_NaN());
  float* rgb = out_.colors.extend(3);
  for (int i = 0; i < 3; ++i)
    rgb[i] = colored ? float(values[3 + i]) : std::numeric_limits<float>::quiet_NaN();
}

void VertexStatements::texture_coordinate() {
  float values[2] = {0, 0};
  const char* bad = nullptr;
  in_.numbers(values, 2, bad);
  in_.skip_blanks();
  if (!(std::isfinite(values[0]) && std::isfinite(values[1]))) {
    out_.remarks.add("texture coordinate that is not a number", in_.statement,
                     with_reason(bad, "this texture coordinate is not a number", "0 0 is used"));
    values[0] = values[1] = 0;
  }
  float* uv = out_.texcoords.extend(2);
  uv[0] = values[0];
  uv[1] = values[1];
}

void VertexStatements::normal() {
  float values[3] = {0, 0, 0};
  const char* bad = nullptr;
  const int count = in_.numbers(values, 3, bad);
  in_.skip_blanks();
  // A normal of no direction is replaced by a generated one; the number 0 0 0 marks it.
  const float largest = std::max({std::fabs(values[0]), std::fabs(values[1]), std::fabs(values[2])});
  if (count < 3 || !(largest > 0) || !std::isfinite(values[0] + values[1] + values[2])) {
    out_.remarks.add("normal without a direction: replaced", in_.statement,
                     with_reason(bad, "this normal has no direction", "a generated one replaces it"));
    values[0] = values[1] = values[2] = 0;
  }
  float* xyz = out_.normals.extend(3);
  for (int i = 0; i < 3; ++i) xyz[i] = values[i];
}

} // namespace softgl::cli
