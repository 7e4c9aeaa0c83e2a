// A draw as the vertex kernels see it.
#pragma once

#include "draw/draw_record.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {

VertexJob make_vertex_job(const DrawRecord& draw);

} // namespace softgl
