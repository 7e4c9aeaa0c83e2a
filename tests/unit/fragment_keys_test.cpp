// Simplified keys: the same picture with fewer bits.
#include <catch2/catch.hpp>

#include "fragment/fragment_keys.h"

using namespace softgl;

namespace {
FragmentKey plain() {
  FragmentKey k{};
  k.alpha_function = k.depth_function = uint64_t(Compare::Always);
  k.color_mask = 15;
  k.color_format = uint64_t(ColorFormat::Rgba8);
  k.depth_format = uint64_t(DepthFormat::Z24S8);
  return k;
}
} // namespace

TEST_CASE("a logic operation disables blending, GL_COPY too", "[fragment]") {
  FragmentKey k = plain();
  k.blend = k.logic_op = 1;
  k.blend_source_rgb = 3; // GL_COPY - GL_CLEAR
  k.blend_destination_rgb = uint64_t(BlendFactor::One);
  CHECK(to_string(simplify(k)) == to_string(plain()));
  k.blend_source_rgb = 6; // GL_XOR - GL_CLEAR
  CHECK(to_string(simplify(k)) == "logic_op:6 mask:rgba rgba8 z24s8");
}

TEST_CASE("blending that copies the source is no blending", "[fragment]") {
  FragmentKey k = plain();
  k.blend = 1;
  k.blend_source_rgb = k.blend_source_alpha = uint64_t(BlendFactor::One);
  CHECK_FALSE(simplify(k).blend);
  k.blend_equation = uint64_t(BlendEquation::ReverseSubtract);
  CHECK(simplify(k).blend);
  k.blend_equation = uint64_t(BlendEquation::Min);
  CHECK(simplify(k).blend);
}

TEST_CASE("without a depth buffer there is neither depth nor stencil test", "[fragment]") {
  FragmentKey k = plain();
  k.depth_function = uint64_t(Compare::Less);
  k.depth_write = k.stencil = 1;
  CHECK(to_string(simplify(k)) == "stencil:never(keep,keep,keep) depth:less,write mask:rgba rgba8 z24s8");
  k.depth_format = uint64_t(DepthFormat::None);
  CHECK(to_string(simplify(k)) == "mask:rgba rgba8 no_depth");
}
