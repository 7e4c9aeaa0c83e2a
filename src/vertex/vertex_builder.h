#pragma once

namespace softgl {

struct VertexBuilder {};

} // namespace softgl
