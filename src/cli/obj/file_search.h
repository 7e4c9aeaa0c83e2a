// Where the files are that a model names: names written on Windows, with spaces, in another case, by absolute
// path.
#pragma once

#include <string>
#include <string_view>

namespace softgl::cli {

// The folder part of a path, "." if there is none.
std::string folder_of(const std::string& path);

// The readable regular file that `name`, found in a file of `folder`, most probably means; empty if there is
// none. Tried in order: the name as it stands, its last part beside the file, the same ignoring case.
std::string find_named_file(const std::string& folder, std::string_view name, bool any_case = true);

} // namespace softgl::cli
