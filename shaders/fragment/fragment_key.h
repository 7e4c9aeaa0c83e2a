// What a fragment program does, in 64 named bits: only state that changes code. Numbers are in
// FragmentConstants.
#pragma once

#include <stdint.h>

#include "shaders/common/surface.h"

namespace softgl {

/// GL_NEVER .. GL_ALWAYS in GL's order.
enum class Compare : uint8_t { Never, Less, Equal, LessEqual, Greater, NotEqual, GreaterEqual, Always };
enum class FogMode : uint8_t { None, Linear, Exp, Exp2 };
enum class StencilOperation : uint8_t {
  Keep,
  Zero,
  Replace,
  Increment,
  Decrement,
  Invert,
  IncrementWrap,
  DecrementWrap
};
enum class BlendFactor : uint8_t {
  Zero,
  One,
  SourceColor,
  OneMinusSourceColor,
  SourceAlpha,
  OneMinusSourceAlpha,
  DestinationAlpha,
  OneMinusDestinationAlpha,
  DestinationColor,
  OneMinusDestinationColor,
  SourceAlphaSaturate,
  ConstantColor,
  OneMinusConstantColor,
  ConstantAlpha,
  OneMinusConstantAlpha
};
/// Separate: the constants have one for rgb and another one for alpha.
enum class BlendEquation : uint8_t { Add, Subtract, ReverseSubtract, Min, Max, Separate };

struct FragmentKey {
  // Which interpolated inputs the stages read.
  uint64_t lit : 1; // lighting makes the color out of normal, eye position and material; otherwise it is
                    // interpolated
  uint64_t secondary : 1, flat : 1;
  uint64_t texture_units : 8; // units whose coordinates are read
  // Stages after texturing.
  uint64_t color_sum : 1;
  uint64_t fog_mode : 2;       // FogMode
  uint64_t alpha_function : 3; // Compare; Always = no test
  // Merging with the framebuffer.
  uint64_t depth_function : 3; // Compare; Always = no test
  uint64_t depth_write : 1;
  uint64_t stencil : 1;
  uint64_t stencil_function : 3;                                       // Compare
  uint64_t stencil_fail : 3, stencil_depth_fail : 3, stencil_pass : 3; // StencilOperation
  uint64_t blend : 1, blend_equation : 3;                              // BlendEquation
  uint64_t blend_source_rgb : 4, blend_destination_rgb : 4; // BlendFactor; with a logic op: its number in
  uint64_t blend_source_alpha : 4,
      blend_destination_alpha : 4; // blend_source_rgb (GL_CLEAR = 0 .. GL_SET = 15)
  uint64_t logic_op : 1;
  uint64_t color_mask : 4;   // bit 0 = red .. bit 3 = alpha
  uint64_t color_format : 2; // ColorFormat
  uint64_t depth_format : 2; // DepthFormat
  uint64_t encoded : 1;      // Rgba8 colors are merged one by one, as FragmentConstants::encoding says
};
static_assert(sizeof(FragmentKey) == 8, "a fragment key is 64 bits");

} // namespace softgl
