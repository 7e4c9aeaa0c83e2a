// Pixel transfer operations (GL 1.5, 3.6.3 and 3.6.5): what happens to pixels on their way from and to client
// memory.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/gl_types.h"
#include "texture/pixel_state.h"

namespace softgl {

struct PixelTransfer {
  const PixelModeState& mode;
  const PixelMaps& maps;

  PixelTransfer(const PixelModeState& m, const PixelMaps& p) : mode(m), maps(p) {}
  /// Changes nothing.
  static const PixelTransfer& none();

  /// True when scale, bias or map change colors.
  bool changes_color() const;
  /// Scale, bias, map. What is not mapped may leave [0,1].
  void color(float (*rgba)[4], int count) const;
  /// The same, clamped to [0,1].
  void clamped_color(float (*rgba)[4], int count) const;

  bool changes_depth() const;
  /// Scale, bias, clamp to [0,1]; also where nothing changes.
  float depth(float value) const;
  void depths(float* value, size_t count) const;

  /// Shift and offset.
  uint32_t index(uint32_t value) const;
  /// The same and GL_PIXEL_MAP_S_TO_S; 8 bits.
  uint32_t stencil(uint32_t value) const;
  /// A color index, shifted and offset, through GL_PIXEL_MAP_I_TO_R .. A.
  void index_to_color(uint32_t index, float rgba[4]) const;
};

/// The stencil values of indexes after the pixel transfer; a table has those of indexes below 256.
class StencilTransfer {
public:
  explicit StencilTransfer(const PixelTransfer& transfer) : transfer_(transfer) {
    for (uint32_t v = 0; v < 256; ++v) table_[v] = uint8_t(transfer.stencil(v));
  }
  uint8_t operator()(uint32_t index) const {
    return index < 256 ? table_[index] : uint8_t(transfer_.stencil(index));
  }

private:
  const PixelTransfer& transfer_;
  uint8_t table_[256];
};

} // namespace softgl
