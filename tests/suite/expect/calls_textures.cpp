// Texture images, parameters and environments (3.8).
#include "expect/calls.h"

namespace softgl::suite {

void Machine::texture(const Call& call) {
  const std::vector<double>& texels = call.v(8);
  const size_t components = call.e(6) == GL_RGB ? 3 : 4;
  for (size_t i = 0; i < texels.size(); i++)
    if (texels[i] != texels[i % components]) throw std::logic_error("a texture of more than one color");
  state_.texture.color = {texels[0] / 255, texels[1] / 255, texels[2] / 255,
                          components == 4 ? texels[3] / 255 : 1};
}

bool Machine::play_textures(const Call& call) {
  switch (call.command) {
  case Command::TexImage2D: texture(call); return true;
  case Command::TexEnvi: state_.texture.environment = call.e(2); return true;
  case Command::TexParameteri: return true;
  default: return false;
  }
}

} // namespace softgl::suite
