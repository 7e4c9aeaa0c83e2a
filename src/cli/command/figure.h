// The files of softgl figure.
#pragma once

#include <string>
#include <vector>

#include "figure/subject.h"
#include "options/program_options.h"

namespace softgl::cli {

struct FigureFile {
  std::string path;
  GrowingArray<uint8_t> bytes;
};

// Draws what the options name. Throws ProgramError.
std::vector<FigureFile> draw_figures(const FigureSubject& subject, const ProgramOptions& options,
                                     unsigned threads, Warnings& warnings);

// Names and titles, one figure a line.
std::string list_of_figures(Language language);

} // namespace softgl::cli
