// Blending of colors that are floats (GL 1.5, 4.1.7; GL_ARB_texture_float): which factors leave a product out
// shows in the sign of zero.
#include <catch2/catch.hpp>

#include <cstring>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/texture_target.h"

namespace softgl::test {
namespace {

/// The bits of a pixel after each way of blending.
std::vector<uint32_t> blended(const Gl& gl, GLint format) {
  const CurrentContext current(gl);
  bound_framebuffer(gl);
  attach_texture(gl, format);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  CHECK(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  for (const GLenum what : {GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR})
    gl.ClampColor(what, GL_FALSE);
  constexpr GLenum kFactors[] = {GL_ZERO, GL_ONE, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_SRC_COLOR};
  std::vector<uint32_t> bits;
  for (const GLenum equation : {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT})
    for (const GLenum source : kFactors)
      for (const GLenum destination : kFactors)
        for (const GLenum alpha : {source, GLenum(GL_ZERO), GLenum(GL_ONE)}) { // of source and destination
          gl.Disable(GL_BLEND);
          fill(gl, -0.25f, 0, 0.75f, 1);
          gl.Enable(GL_BLEND);
          gl.BlendEquation(equation);
          gl.BlendFuncSeparate(source, destination, alpha, alpha);
          fill(gl, -0.5f, -0.125f, 0, 0.25f);
          float rgba[4] = {};
          gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_FLOAT, rgba);
          uint32_t words[4];
          std::memcpy(words, rgba, sizeof words);
          bits.insert(bits.end(), words, words + 4);
        }
  CHECK(gl.GetError() == GL_NO_ERROR);
  return bits;
}

} // namespace

TEST_CASE("Blended floats have OSMesa's bits, whatever the factors", "[spec][formats]") {
  for (const GLint format : {GL_RGBA32F, GL_RGB32F, GL_RG32F, GL_R32F, GL_ALPHA32F_ARB, GL_LUMINANCE32F_ARB,
                             GL_LUMINANCE_ALPHA32F_ARB, GL_INTENSITY32F_ARB, GL_RGBA16F, GL_R16F}) {
    INFO("format " << format);
    const std::vector<uint32_t> ours = blended(softgl_library(), format),
                                theirs = blended(osmesa_library(), format);
    size_t different = 0;
    for (size_t i = 0; i < ours.size(); ++i)
      if (ours[i] != theirs[i] && different++ < 3)
        UNSCOPED_INFO("combination " << i / 4 << " component " << i % 4 << ": " << ours[i] << " "
                                     << theirs[i]);
    CHECK(different == 0);
  }
}

} // namespace softgl::test
