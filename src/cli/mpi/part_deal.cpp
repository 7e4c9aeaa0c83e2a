#include "mpi/part_deal.h"

#include <algorithm>

namespace softgl::cli {

std::vector<int> deal_parts(const std::vector<uint64_t>& sizes, int ranks, Deal deal) {
  std::vector<int> dealt;
  double total = 0, before = 0;
  for (const uint64_t size : sizes) total += double(size);
  for (size_t i = 0; i < sizes.size(); ++i) {
    if (deal == Deal::kTurns || !(total > 0)) {
      dealt.push_back(int(i % size_t(ranks)));
      continue;
    }
    // The rank in whose share the middle of the part lies.
    const double middle = before + double(sizes[i]) / 2;
    dealt.push_back(std::min(ranks - 1, int(middle / total * ranks)));
    before += double(sizes[i]);
  }
  return dealt;
}

// Paths may hold anything but a zero byte.
std::string as_text(const std::vector<PartFile>& parts) {
  std::string text;
  for (const PartFile& part : parts) text += std::to_string(part.bytes) + " " + part.path + '\0';
  return text;
}

std::vector<PartFile> parts_from(const std::string& text) {
  std::vector<PartFile> parts;
  for (size_t at = 0; at < text.size();) {
    const size_t blank = text.find(' ', at), end = text.find('\0', blank);
    parts.push_back({text.substr(blank + 1, end - blank - 1), std::stoull(text.substr(at, blank - at))});
    at = end + 1;
  }
  return parts;
}

} // namespace softgl::cli
