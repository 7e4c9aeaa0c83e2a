// A sheet of pictures in rows, each with a label under it.
#pragma once

#include <string>
#include <vector>

#include "image/picture.h"

namespace softgl::cli {

struct SheetEntry {
  Picture picture;   // RGB, all of one size
  std::string label; // UTF-8, one line or two; loses its middle where it is too long
};

struct SheetRow {
  std::string title; // UTF-8, one line; empty: none
  std::vector<SheetEntry> entries;
};

// At least one row with an entry; `title` is UTF-8, one line, or empty. Throws ProgramError if the
// sheet is larger than a picture's file can be.
Picture compose_sheet(const std::string& title, const std::vector<SheetRow>& rows);

} // namespace softgl::cli
