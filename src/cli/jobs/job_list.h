// A list of models to draw, as text.
#pragma once

#include <string>
#include <vector>

#include "common/source_text.h"

namespace softgl::cli {

struct JobLine {
  std::string model;
  std::vector<std::string> options; // words of a command line
  std::string output;               // empty: that of the command line
  std::string where;                // FILE:LINE
  std::string fault;                // a sentence; the line is no job then
};

// A line has MODEL, OPTIONS and OUTPUT with tabs between them; the later ones may be missing. Options are
// cut into words as a shell does it. Or it is a JSON object with "model", "options" (a text, or a list of
// words) and "output". Empty lines and lines that begin with # are left out.
std::vector<JobLine> read_job_list(const SourceText& text);

// Words between blanks; quotation marks of both kinds hold blanks, and a backslash any character. Throws
// std::invalid_argument if a quotation mark is left open.
std::vector<std::string> split_words(const std::string& text);

} // namespace softgl::cli
