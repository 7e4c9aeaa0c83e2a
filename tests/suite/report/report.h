// The results as files.
#pragma once

#include <map>
#include <string>

#include "run/results.h"

namespace softgl::suite {

struct ReportFiles {
  std::string folder, json, junit, hashes; // empty: not wanted
};

/// Writes what is wanted. For the folder each failure is drawn again and again, with fewer calls. Throws
/// std::runtime_error if a file cannot be written.
void write_reports(const ReportFiles& files, const RunResult& result, const RunOptions& options);

/// The expected pictures as one PNG.
void write_sheet(const std::vector<const Test*>& tests, const std::string& path);

/// With the folders above it. Throws std::runtime_error.
void make_folder(const std::string& path);
/// Throws std::runtime_error if it cannot be written.
void write_file(const std::string& path, const std::string& text);

std::string to_json(const RunResult& result);
/// `programs`: of failed tests, by their names.
std::string to_html(const RunResult& result, const std::map<std::string, std::string>& programs);
std::string to_junit(const RunResult& result);

} // namespace softgl::suite
