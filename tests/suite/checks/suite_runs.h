// What the checks of softgl-conformance share.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "run/results.h"

namespace softgl::suite {

RunOptions options_for(const std::string& library, const std::string& filter = "");
/// Throws std::runtime_error if there is no context.
RunResult run_quietly(const RunOptions& options);
std::set<std::string> failures(const RunResult& result);
/// Checks that what fails is what known_failures.tsv says of the GL and the tests of the run, and that all
/// but softgl lack GL_WIN_phong_shading, and nothing else but buffers. `door`: rows of this name count, too.
void check_known(const RunResult& result, const std::string& gl, const std::string& door = "");
/// The rows of a table in tests/suite: cells between tabs.
std::vector<std::vector<std::string>> table(const std::string& file);
/// What known_failures.tsv says of a GL.
std::set<std::string> known_failures(const std::string& gl);

} // namespace softgl::suite
