#include "context/texture_bindings.h"

#include <mutex>

#include "context/context.h"

namespace softgl {

std::shared_ptr<TextureObject> default_texture(const Context& c, TextureTarget target) {
  static std::mutex mutex; // contexts of one share group may ask at once
  std::lock_guard lock(mutex);
  auto& object = c.shared->default_texture[target];
  if (!object) object = std::make_shared<TextureObject>(0, target);
  return object;
}

std::shared_ptr<TextureObject> proxy_texture(Context& c, TextureTarget target) {
  auto& object = c.proxy_texture[target];
  if (!object) object = std::make_shared<TextureObject>(0, target);
  return object;
}

std::shared_ptr<TextureObject> bound_texture(const Context& c, int unit, TextureTarget target) {
  const auto& object = c.bound_texture[unit][target];
  return object ? object : default_texture(c, target);
}

} // namespace softgl
