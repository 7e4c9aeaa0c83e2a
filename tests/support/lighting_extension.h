// The tokens of per-pixel lighting that scenes use.
#pragma once

#include <GL/gl.h>

namespace softgl::test {

constexpr GLenum kSpecularVector = 0x7001, kReflectionVector = 0x7002, kHalfVector = 0x7003; // placeholders
constexpr GLenum kTermMask = 0x7004;
constexpr GLint kEmissionTerm = 1, kAmbientTerm = 2, kDiffuseTerm = 4, kSpecularTerm = 8, kAllTerms = 15;

} // namespace softgl::test
