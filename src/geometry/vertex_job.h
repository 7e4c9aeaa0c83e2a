// A draw as the vertex kernels see it.
#pragma once

#include "frame/draw_record.h"
#include "vertex_program.h"

namespace softgl {

VertexJob make_vertex_job(const DrawRecord& draw);

} // namespace softgl
