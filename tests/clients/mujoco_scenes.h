// Scenes for MuJoCo: models in its XML, and what is switched on while they are drawn.
#pragma once
#include <span>

#include <mujoco/mujoco.h>

namespace softgl::test {

struct MujocoScene {
  const char* name;
  const char* xml; // a model in MJCF
  int steps;       // of simulation before the picture
  int samples;     // of the offscreen framebuffer object
  double distance; // of the camera, in units of the default
  bool window;     // draws to the window surface instead of the offscreen framebuffer object
  void (*adjust)(mjvOption&, mjvScene&);
  void (*overlay)(mjrRect viewport, mjrContext&); // drawn over the picture
};

std::span<const MujocoScene> mujoco_scenes();

} // namespace softgl::test
