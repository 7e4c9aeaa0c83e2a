// The results as files.
#pragma once

#include <string>

#include "run/results.h"

namespace softgl::suite {

struct ReportFiles {
  std::string folder, json, junit; // empty: not wanted
};

/// Writes what is wanted. Throws std::runtime_error if a file cannot be written.
void write_reports(const ReportFiles& files, const RunResult& result);

/// The expected pictures as one PNG.
void write_sheet(const std::vector<const Test*>& tests, const std::string& path);

std::string to_json(const RunResult& result);
std::string to_junit(const RunResult& result);

} // namespace softgl::suite
