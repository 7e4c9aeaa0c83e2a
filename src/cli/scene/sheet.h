// A sheet of pictures in rows, each with a label under it.
#pragma once

#include <string>
#include <vector>

#include "image/picture.h"

namespace softgl::cli {

struct SheetEntry {
  Picture picture;   // RGB, all of one size
  std::string label; // ASCII, one line or two
};

struct SheetRow {
  std::string title; // ASCII, one line
  std::vector<SheetEntry> entries;
};

// At least one row with an entry; `title` is UTF-8, one line. Throws ProgramError if GL cannot draw a sheet
// of that size.
Picture compose_sheet(const std::string& title, const std::vector<SheetRow>& rows);

} // namespace softgl::cli
