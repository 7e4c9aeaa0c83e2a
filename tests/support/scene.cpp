#include "support/scene.h"

#include <algorithm>

namespace softgl::test {

static std::vector<Scene>& registry() {
  static std::vector<Scene> scenes;
  return scenes;
}

SceneRegistration::SceneRegistration(Scene scene) { registry().push_back(std::move(scene)); }

template <class Wanted> static std::vector<Scene> sorted(Wanted wanted) {
  std::vector<Scene> result;
  for (const Scene& scene : registry())
    if (wanted(scene)) result.push_back(scene);
  std::sort(result.begin(), result.end(), [](const Scene& a, const Scene& b) { return a.name < b.name; });
  return result;
}

// Static objects of other files register themselves: these lists must not be asked for before main or a test
// registration that runs after them, so they are rebuilt as long as scenes arrive.
template <class Wanted> static const std::vector<Scene>& kept(Wanted wanted) {
  static std::vector<Scene> scenes;
  static size_t known = 0;
  if (known != registry().size()) known = registry().size(), scenes = sorted(wanted);
  return scenes;
}

const std::vector<Scene>& named_scenes() {
  return kept([](const Scene& s) { return !s.random && !s.extension; });
}
const std::vector<Scene>& families() {
  return kept([](const Scene& s) { return s.random && !s.extension; });
}
const std::vector<Scene>& extension_scenes() {
  return kept([](const Scene& s) { return s.extension; });
}

const Scene* find_scene(const std::string& name) {
  for (const Scene& scene : registry())
    if (scene.name == name) return &scene;
  return nullptr;
}

} // namespace softgl::test
