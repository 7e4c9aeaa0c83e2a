// Limits of OpenGL that arrays of state, snapshots and kernels have in common (GL 1.5, tables 6.28 and 6.29).
#pragma once

namespace softgl {

constexpr int kMaxLights = 8;
constexpr int kMaxClipPlanes = 8;
constexpr int kMaxTextureUnits = 8;
constexpr int kMaxTextureLevels = 15; // 16384 = 2^14

} // namespace softgl
