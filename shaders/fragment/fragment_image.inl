// Stages that fetch what a pixel rectangle's fragments have of their own.
#pragma once

#include "shaders/common/lane_math.h"
#include "shaders/fragment/fragment_constants.h"
#include "shaders/fragment/pixel_image.h"

namespace softgl {
namespace SOFTGL_ISA {

/// Calls use(lane, element) for all lanes. Dead ones may lie outside the rectangle; theirs is the nearest
/// element.
template <class T, class Use>
static inline void for_each_element(const FragmentBlock& block, const FragmentConstants& constants, Use use) {
  const PixelImage& image = *constants.image;
  const T* element = static_cast<const T*>(image.element);
  auto within = [](int32_t v, int32_t count) { return v < 0 ? 0 : v < count ? v : count - 1; };
  for (int i = 0; i < block.lanes; ++i)
    use(i, element[image.row[within(block.y[i] - image.y0, image.rows)] +
                   image.column[within(block.x[i] - image.x0, image.columns)]]);
}

static void stage_image_floats(FragmentBlock& block, const FragmentConstants& constants, int) {
  for_each_element<PixelFloats>(block, constants, [&](int i, const PixelFloats& e) {
    for (int k = 0; k < 4; ++k) block.color[k][i] = e.rgba[k];
  });
}

static void stage_image_bytes(FragmentBlock& block, const FragmentConstants& constants, int) {
  for_each_element<uint32_t>(block, constants, [&](int i, uint32_t e) {
    for (int k = 0; k < 4; ++k) block.color[k][i] = float(e >> (8 * k) & 255) * (1.0f / 255.0f);
  });
}

static void stage_image_depth(FragmentBlock& block, const FragmentConstants& constants, int) {
  for_each_element<uint32_t>(block, constants, [&](int i, uint32_t e) { block.depth[i] = e; });
}

static void stage_image_bit(FragmentBlock& block, const FragmentConstants& constants, int) {
  for_each_element<uint8_t>(block, constants,
                            [&](int i, uint8_t e) { block.live[i] &= e ? ~uint32_t(0) : 0; });
}

} // namespace SOFTGL_ISA
} // namespace softgl
