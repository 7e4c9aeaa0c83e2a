// Which rank gets which part of a model.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace softgl::cli {

enum class Deal {
  kBlocks, // neighbours in the list, as many bytes as the other ranks have
  kTurns,  // one each, and again
};

// A rank for each part.
std::vector<int> deal_parts(const std::vector<uint64_t>& sizes, int ranks, Deal deal);

// The list of parts as text, so that one rank can tell the others.
struct PartFile {
  std::string path;
  uint64_t bytes = 0;
};
std::string as_text(const std::vector<PartFile>& parts);
std::vector<PartFile> parts_from(const std::string& text);

} // namespace softgl::cli
