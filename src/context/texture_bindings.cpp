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
  if (const GLuint name = c.state.texture.unit[unit].bound[target])
    if (auto object = c.shared->textures.find(name); object && object->target == target) return object;
  return default_texture(c, target);
}

} // namespace softgl
