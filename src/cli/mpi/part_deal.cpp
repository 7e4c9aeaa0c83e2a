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

std::string packed(const std::vector<NumberedText>& texts) {
  std::string bytes;
  for (const NumberedText& each : texts) bytes += std::to_string(each.number) + " " + each.text + '\0';
  return bytes;
}

std::vector<NumberedText> unpacked(const std::string& bytes) {
  std::vector<NumberedText> texts;
  for (size_t at = 0; at < bytes.size();) {
    const size_t blank = bytes.find(' ', at), end = bytes.find('\0', blank);
    texts.push_back({bytes.substr(blank + 1, end - blank - 1), std::stoull(bytes.substr(at, blank - at))});
    at = end + 1;
  }
  return texts;
}

} // namespace softgl::cli
