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

// What ranks tell each other: names of files with their sizes, sentences with the numbers of their parts.
struct NumberedText {
  std::string text; // without zero bytes
  uint64_t number = 0;
};
std::string packed(const std::vector<NumberedText>& texts);
std::vector<NumberedText> unpacked(const std::string& bytes);

} // namespace softgl::cli
