#include "mpi/sample_message.h"

#include <cstring>

namespace softgl::cli {

std::vector<uint32_t> pack_samples(const PartSamples& samples, Piece piece) {
  const uint32_t* orders = samples.orders.data();
  std::vector<uint32_t> words(1, 0);
  size_t active = 0;
  for (size_t i = piece.first; i < piece.last;) {
    const size_t empty = i;
    while (i < piece.last && orders[i] == 0) ++i;
    if (i == piece.last) break;
    const size_t first = i;
    while (i < piece.last && orders[i] != 0) ++i;
    words.push_back(uint32_t(first - empty));
    words.push_back(uint32_t(i - first));
    active += i - first;
    ++words[0];
  }
  const uint32_t runs = words[0];
  size_t to = words.size();
  words.resize(to + 3 * active);
  size_t from = piece.first;
  for (uint32_t run = 0; run < runs; ++run) {
    from += words[1 + 2 * run];
    const size_t count = words[2 + 2 * run];
    std::memcpy(&words[to], &samples.colors[4 * from], 4 * count);
    std::memcpy(&words[to + active], &samples.depths[from], 4 * count);
    std::memcpy(&words[to + 2 * active], orders + from, 4 * count);
    from += count;
    to += count;
  }
  return words;
}

void merge_samples(PartSamples& samples, Piece piece, const std::vector<uint32_t>& words) {
  const uint32_t runs = words[0];
  size_t active = 0;
  for (uint32_t run = 0; run < runs; ++run) active += words[2 + 2 * run];
  const uint32_t* colors = words.data() + 1 + 2 * size_t(runs);
  const uint32_t *depths = colors + active, *orders = depths + active;
  size_t to = piece.first, from = 0;
  for (uint32_t run = 0; run < runs; ++run) {
    to += words[1 + 2 * run];
    for (const size_t end = from + words[2 + 2 * run]; from < end; ++from, ++to) {
      const bool seen = samples.orders[to] == 0 || depths[from] < samples.depths[to] ||
                        (depths[from] == samples.depths[to] && orders[from] > samples.orders[to]);
      if (!seen) continue;
      std::memcpy(&samples.colors[4 * to], &colors[from], 4);
      samples.depths[to] = depths[from];
      samples.orders[to] = orders[from];
    }
  }
}

} // namespace softgl::cli
