// Which texture object a target means (GL 1.5, 3.8.12).
#pragma once

#include <memory>

#include "texture/texture_object.h"

namespace softgl {

struct Context;

/// The object bound to a target of a unit; never null.
std::shared_ptr<TextureObject> bound_texture(const Context& c, int unit, TextureTarget target);
/// The object that an image or parameter command means: of the active unit, or a proxy's. Null for an unknown
/// target.
std::shared_ptr<TextureObject> default_texture(const Context& c, TextureTarget target);
std::shared_ptr<TextureObject> proxy_texture(Context& c, TextureTarget target);

} // namespace softgl
