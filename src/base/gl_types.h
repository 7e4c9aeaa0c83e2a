// GL's scalar types and tokens (GL/gl.h and GL/glext.h of the system), without the prototypes after 1.1, and
// softgl's.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>
#include <softgl/softgl.h>

namespace softgl {
/// Every GL door and OSMesa function is exported with default visibility; all else is hidden.
#define SOFTGL_EXPORT __attribute__((visibility("default")))
} // namespace softgl
