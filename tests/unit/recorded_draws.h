// What a context has recorded: the vertices of each point, line and triangle, with all attributes expanded.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "context/context.h"

namespace softgl::test {

using AttributeValue = std::array<float, 4>;
/// The attributes below kMaterial0, and of the material those that vary in the draw.
struct ExpandedVertex {
  std::array<AttributeValue, kAttributeSlots> value{};
  bool operator==(const ExpandedVertex&) const = default;
};
/// A point, line, triangle or quad in the order of its vertices; `mode` is GL_POINTS, GL_LINES, GL_TRIANGLES
/// or GL_QUADS.
struct ExpandedPrimitive {
  GLenum mode;
  std::vector<ExpandedVertex> vertex;
  bool operator==(const ExpandedPrimitive&) const = default;
};

/// A context with a surface size but no pixels: draws are recorded and never executed.
std::unique_ptr<Context> make_recording_context();
std::vector<ExpandedPrimitive> recorded_primitives(const Context& context);
size_t recorded_draws(const Context& context);

} // namespace softgl::test
