// What PushAttrib and PushClientAttrib have saved (GL 1.5, 6.1.14).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "context/state.h"

namespace softgl {

constexpr size_t kMaxAttributeStackDepth = 16;

struct TextureObject;
struct TextureParameters;

struct SavedTexture {
  int unit;
  TextureTarget target;
  std::shared_ptr<TextureObject> object;
  std::shared_ptr<const TextureParameters> parameters;
};

struct SavedAttributes {
  GLbitfield mask = 0;
  std::vector<std::byte> groups;      // the groups of the mask, one behind the other, in table order
  std::vector<SavedTexture> textures; // GL_TEXTURE_BIT: the bound objects and their parameters
  GLenum draw_buffer = GL_NONE, read_buffer = GL_NONE; // of the window or the bound framebuffer object
};
struct SavedClientAttributes {
  GLbitfield mask = 0;
  PixelStoreState pixel_store;
  VertexArrayState vertex_array;
};

struct AttributeStack {
  std::vector<SavedAttributes> server;
  std::vector<SavedClientAttributes> client;
};

} // namespace softgl
