// Integers that stand for fractions (GL 1.5, table 2.9).
#pragma once

#include "base/gl_types.h"

namespace softgl {

// Color and normal components: c / (2^b - 1) and (2c + 1) / (2^b - 1). OSMesa 22.3.6: single precision,
// except that the 32-bit types are scaled in double; unsigned bytes are a true division.
inline float normalized(GLubyte c) { return float(c) / 255.0f; }
inline float normalized(GLbyte c) { return (2.0f * float(c) + 1.0f) * (1.0f / 255.0f); }
inline float normalized(GLushort c) { return float(c) * (1.0f / 65535.0f); }
inline float normalized(GLshort c) { return (2.0f * float(c) + 1.0f) * (1.0f / 65535.0f); }
inline float normalized(GLuint c) { return float(double(c) * (1.0 / 4294967295.0)); }
inline float normalized(GLint c) { return float(double(2.0f * float(c) + 1.0f) * (1.0 / 4294967294.0)); }

} // namespace softgl
