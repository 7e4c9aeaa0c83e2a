// Files that are there as a whole or not at all.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/growing_array.h"

namespace softgl::cli {

// To a file, or to standard output for "-". A file is written under another name beside it and then renamed:
// it is the old one or the new one, whole, at any time. Throws ProgramError (kCannotWrite).
void write_file(const std::string& path, const GrowingArray<uint8_t>& bytes);

// What write_file() left beside these files when its process was killed, and those of them that are empty, as
// a machine without power leaves them. What another process is writing stays: it holds a lock.
void remove_unfinished(const std::vector<std::string>& files);

} // namespace softgl::cli
