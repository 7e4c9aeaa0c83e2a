// Stages that fetch what a pixel rectangle's fragments have of their own.
#pragma once

#include "shaders/common/simd.h"
#include "shaders/fragment/fragment_constants.h"
#include "shaders/fragment/pixel_image.h"

namespace softgl {
namespace SOFTGL_ISA {

/// The numbers of all lanes' elements. Dead lanes may lie outside the rectangle; theirs is the nearest
/// element.
SOFTGL_INLINE void find_elements(const FragmentBlock& block, const PixelImage& image,
                                 int32_t (&number)[kLanes]) {
  alignas(64) int32_t row[kLanes], column[kLanes];
  for (int i = 0; i < block.lanes; i += kWidth) {
    store(row + i, min_(max_(load(block.y + i) - image.y0, IntV{}), splat(image.rows - 1)));
    store(column + i, min_(max_(load(block.x + i) - image.x0, IntV{}), splat(image.columns - 1)));
  }
  const int32_t *rows = image.row, *columns = image.column;
  for (int i = 0; i < block.lanes; ++i) number[i] = rows[row[i]] + columns[column[i]];
}

static void stage_image_floats(FragmentBlock& block, const FragmentConstants& constants, int) {
  const auto* element = static_cast<const PixelFloats*>(constants.image->element);
  alignas(64) int32_t number[kLanes];
  find_elements(block, *constants.image, number);
  for (int i = 0; i < block.lanes; i += kWidth) {
    FloatV color[4];
    load_transposed(
        [&](int k) __attribute__((always_inline)) { return element[number[i + k]].rgba; }, color);
    for (int c = 0; c < 4; ++c) store(block.color[c] + i, color[c]);
  }
}

static void stage_image_bytes(FragmentBlock& block, const FragmentConstants& constants, int) {
  const auto* element = static_cast<const uint32_t*>(constants.image->element);
  alignas(64) int32_t number[kLanes];
  find_elements(block, *constants.image, number);
  for (int i = 0; i < block.lanes; i += kWidth) {
    const IntV word =
        load_words([&](int k) __attribute__((always_inline)) { return element + number[i + k]; });
    for (int c = 0; c < 4; ++c)
      store(block.color[c] + i, to_float((IntV)((UintV)word >> (8 * c)) & 255) * (1.0f / 255.0f));
  }
}

static void stage_image_depth(FragmentBlock& block, const FragmentConstants& constants, int) {
  const auto* element = static_cast<const uint32_t*>(constants.image->element);
  alignas(64) int32_t number[kLanes];
  find_elements(block, *constants.image, number);
  for (int i = 0; i < block.lanes; ++i) block.depth[i] = element[number[i]];
}

static void stage_image_bit(FragmentBlock& block, const FragmentConstants& constants, int) {
  const auto* element = static_cast<const uint8_t*>(constants.image->element);
  alignas(64) int32_t number[kLanes];
  find_elements(block, *constants.image, number);
  for (int i = 0; i < block.lanes; ++i) block.live[i] &= element[number[i]] ? ~uint32_t(0) : 0;
}

static void stage_image_stencil(FragmentBlock& block, const FragmentConstants& constants, int) {
  const auto* element = static_cast<const uint8_t*>(constants.image->element);
  alignas(64) int32_t number[kLanes];
  find_elements(block, *constants.image, number);
  for (int i = 0; i < block.lanes; ++i) block.depth[i] = element[number[i]];
}

} // namespace SOFTGL_ISA
} // namespace softgl
