// The repository's text files, as the tests of this folder look at them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace softgl::test {

/// Every file of the repository by its path from the top, with its text; pictures and models without.
using SourceTree = std::map<std::string, std::string>;

const SourceTree& source_tree();

/// True for what a C or C++ compiler reads.
bool is_source(const std::string& path);

/// "src/api" of "src/api/door.h"; "" of "README.md".
std::string folder_of(const std::string& path);

/// The path without "." and "..".
std::string normal_path(const std::string& path);

std::vector<std::string> split(const std::string& text, const std::string& separator);

} // namespace softgl::test
