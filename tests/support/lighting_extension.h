// The tokens of softgl's lighting extension (reference/extensions/SOFTGL_phong_illumination.txt) that scenes use.
#pragma once

#include "support/gl.h"

namespace softgl::test {

constexpr GLenum kSpecularVector = 0x5F6000;
constexpr GLint kHalfVector = 0x5F6001, kReflectionVector = 0x5F6002;
constexpr GLenum kTermMask = 0x5F6003;
constexpr GLint kEmissionTerm = 1, kAmbientTerm = 2, kDiffuseTerm = 4, kSpecularTerm = 8, kAllTerms = 15;

} // namespace softgl::test
