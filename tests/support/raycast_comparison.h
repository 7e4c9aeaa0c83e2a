// Tessellated shapes, drawn by softgl, against the same shapes ray-cast: how Phong and Gouraud shading
// converge.
#pragma once

#include <string>
#include <vector>

namespace softgl::test {

/// One picture's worth: the pixels inside the shape whose neighbours are inside, too. `equal` is the share of
/// them whose channels are all within 1/255 of the ray-cast ones, `mean` the mean difference of a channel, in
/// 1/255.
struct ConvergencePoint {
  std::string shape, setup;
  bool reflection = false; // highlights by the reflection vector, not by the half vector
  int slices = 0, pixels = 0;
  double phong_equal = 0, phong_mean = 0, gouraud_equal = 0, gouraud_mean = 0;
};

/// "sphere", "plane" or "box", with every set-up of lights and material, for each number of slices. Draws
/// with softgl.
std::vector<ConvergencePoint> compare_with_raycast(const std::string& shape, bool reflection,
                                                   const std::vector<int>& slices);
/// How many set-ups there are.
int raycast_setups();

} // namespace softgl::test
