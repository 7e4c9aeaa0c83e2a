// Vectors of floats.
#pragma once

#include <glm/glm.hpp>

namespace softgl {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;

} // namespace softgl
