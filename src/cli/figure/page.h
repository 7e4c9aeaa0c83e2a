// A figure of the lecture: what it shows, and what is said about it.
#pragma once

#include <string>
#include <vector>

#include "figure/drawing.h"

namespace softgl::cli {

inline constexpr double kPageWidth = 1000; // units of the page

struct Page {
  std::string name, title;
  std::vector<std::string> sentences, formulas; // as formula.h reads them
  Drawing drawing;                              // as wide as the page
};

// A picture with one line or two below it.
struct PageEntry {
  Picture picture;                  // RGB; all of a page have one size
  std::string name, label, formula; // the name is ASCII without spaces
};

inline constexpr int kPageColumns = 5; // of most pages

// Puts the pictures beside each other, as wide as if there were `columns`, and makes the drawing longer.
void append_pictures(Drawing& drawing, std::vector<PageEntry> entries, int columns,
                     const std::string& title = {});

// The page with its title, formulas and sentences on one drawing.
Drawing lay_out(Page page);

// A formula without marks for letters below the line: ka LA.
std::string plain_formula(const std::string& formula);

} // namespace softgl::cli
