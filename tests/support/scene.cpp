#include "support/scene.h"

#include <algorithm>

namespace softgl::test {

static std::vector<Scene>& registry() {
  static std::vector<Scene> scenes;
  return scenes;
}

SceneRegistration::SceneRegistration(Scene scene) { registry().push_back(std::move(scene)); }

static std::vector<Scene> sorted(bool random) {
  std::vector<Scene> result;
  for (const Scene& scene : registry())
    if (scene.random == random) result.push_back(scene);
  std::sort(result.begin(), result.end(), [](const Scene& a, const Scene& b) { return a.name < b.name; });
  return result;
}

// Static objects of other files register themselves: these lists must not be asked for before main or a test
// registration that runs after them, so they are rebuilt as long as scenes arrive.
const std::vector<Scene>& named_scenes() {
  static std::vector<Scene> scenes;
  static size_t known = 0;
  if (known != registry().size()) known = registry().size(), scenes = sorted(false);
  return scenes;
}

const std::vector<Scene>& families() {
  static std::vector<Scene> scenes;
  static size_t known = 0;
  if (known != registry().size()) known = registry().size(), scenes = sorted(true);
  return scenes;
}

const Scene* find_scene(const std::string& name) {
  for (const Scene& scene : registry())
    if (scene.name == name) return &scene;
  return nullptr;
}

} // namespace softgl::test
