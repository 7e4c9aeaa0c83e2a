// Draws the finished runs of display lists.
#pragma once

#include "context/context.h"
#include "context/vertex_run.h"

namespace softgl {

/// Draws the run with the present state, and makes its last attribute values current.
void play_run(Context& context, const std::shared_ptr<VertexRun>& run);

/// Writes the streams of `source` for vertices in `run`'s layout that begin at `vertices`.
void describe_vertices(const VertexRun& run, const float* vertices, VertexSource& source);

} // namespace softgl
