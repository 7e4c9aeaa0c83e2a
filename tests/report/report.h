// The conformance report: pictures of two libraries side by side, on one HTML page that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "support/runner.h"

namespace softgl::test {

/// One picture of ours beside what it is compared with.
struct ReportRow {
  std::string group; // what is compared with what
  std::string name;  // scene or family, and seed
  std::string again; // the command that draws it again; may be empty
  Picture ours, theirs;
  bool same_depths = true; // or the depths do not count
  int allowed = 0;         // largest difference of a color byte that the group allows
};

/// The same depths, where they count, no other errors, and colors within what the group allows.
bool passes(const ReportRow& row);

/// One curve of an error against the number of slices.
struct ReportCurve {
  std::string plot, name;
  std::vector<std::pair<double, double>> points;
};

struct Report {
  std::vector<std::string> versions; // what was compared, a line each
  std::vector<ReportRow> rows;
  std::vector<ReportCurve> curves;
};

/// Fills the page `page.html` (its placeholders are comments) and returns it.
std::string report_page(const std::string& page, const Report& report);

} // namespace softgl::test
