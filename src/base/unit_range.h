// What GL calls clamping to [0,1].
#pragma once

namespace softgl {

/// `v` in [0,1]; what is not a number becomes 0.
inline float unit_range(float v) { return v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f; }

} // namespace softgl
