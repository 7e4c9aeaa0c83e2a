// A scene: GL commands that make a picture. Named scenes stand one per file in tests/scenes; families of
// random scenes, one file each, in tests/conformance/families.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "support/gl.h"
#include "support/random.h"

namespace softgl::test {

/// What a scene is drawn with: the library, its own random numbers, and the size of the picture.
struct Stage {
  const Gl& gl;
  Random& random;
  int width, height;
};

struct Scene {
  std::string name;
  std::function<void(Stage& stage)> draw;
  bool random = false;           // the seed decides what is drawn, and the size of the picture
  int width = 160, height = 120; // of a scene that is not random
  bool extension = false;        // uses an extension that OSMesa does not have
  bool clipped =
      false; // by planes of its own: where shaders draw, OSMesa computes the corners that arise another way
  std::string numbers = {};  // draws the random numbers of this name; empty: of its own
  bool floats = false;       // drawn to a buffer of floats: what 8 bits would round away must be equal, too
  bool accumulation = false; // there is an accumulation buffer
  bool framebuffer_object = false; // drawn to renderbuffers of the picture's size
};

/// All scenes with a name of their own, and all families, in alphabetical order: those that OSMesa can draw
/// too.
const std::vector<Scene>& named_scenes();
const std::vector<Scene>& families();
/// Scenes and families that use softgl's extensions.
const std::vector<Scene>& extension_scenes();
const Scene* find_scene(const std::string& name);

/// Registers a scene or a family: `static SceneRegistration registration{{"spot_lights", draw}};`
struct SceneRegistration {
  explicit SceneRegistration(Scene scene);
};

} // namespace softgl::test
