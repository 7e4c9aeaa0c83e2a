#pragma once

#include "surface.h"

namespace softgl {

struct Framebuffer {
  Surface surface{}; // what is drawn to
};

} // namespace softgl
