// A piece of a part's samples as a message: only those that something was drawn to.
#pragma once

#include <cstdint>
#include <vector>

#include "mpi/exchange_plan.h"
#include "scene/part_renderer.h"

namespace softgl::cli {

// Words: the number of runs; for each run how many samples are empty before it and how many are not; then of
// all that are not the colors, the depths and the orders.
std::vector<uint32_t> pack_samples(const PartSamples& samples, Piece piece);

// Puts what another rank drew into the same piece: the smaller depth is seen, and of equal ones the higher
// order. Which rank's samples come first does not matter.
void merge_samples(PartSamples& samples, Piece piece, const std::vector<uint32_t>& words);

} // namespace softgl::cli
