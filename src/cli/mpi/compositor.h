// One picture from the samples of all ranks.
#pragma once

#include "mpi/ranks.h"
#include "scene/part_renderer.h"

namespace softgl::cli {

// The colors of all samples at the first rank, nothing elsewhere. `radix`: see ExchangePlan. `visible`: some
// rank has drawn something, known to all.
PartSamples compose_samples(PartSamples samples, int radix, const Ranks& ranks, bool& visible);

} // namespace softgl::cli
