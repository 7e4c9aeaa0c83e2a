// From the environments of all units to one combiner program.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "shaders/common/limits.h"
#include "shaders/texture/combiner_program.h"

namespace softgl {

/// An argument of a texture combiner: where the color comes from and how it is used.
enum class CombineSource : uint8_t { Texture0, Texture7 = 7, Constant, Primary, Previous, Zero, One };
struct CombineArgument {
  CombineSource source;
  uint8_t alpha;      // the source's alpha for every component
  uint8_t complement; // 1 - the value
};
enum class CombineFunction : uint8_t {
  Replace,
  Modulate,
  Add,
  AddSigned,
  Interpolate,
  Subtract,
  ModulateAdd,
  ModulateSignedAdd,
  ModulateSubtract,
  AddProducts,
  AddProductsSigned,
  Dot3Rgb,
  Dot3Rgba
};

/// What decides about the program: all but the colors. Compared byte by byte.
struct CombinerChain {
  struct Unit {
    CombineFunction function[2]; // rgb, alpha
    CombineArgument argument[2][4];
    uint8_t scale[2];
  };
  uint8_t units = 0; // which are on, by bit
  bool color_sum = false;
  Unit unit[kMaxTextureUnits] = {};
};
static_assert(std::has_unique_object_representations_v<CombinerChain>);

std::shared_ptr<const CombinerProgram> make_combiner_program(const CombinerChain& chain);

/// Keeps programs: making one takes longer than drawing a small triangle with it.
class CombinerCache {
public:
  std::shared_ptr<const CombinerProgram> program(const CombinerChain& chain);

private:
  static constexpr size_t kLimit = 64;
  std::vector<std::pair<CombinerChain, std::shared_ptr<const CombinerProgram>>> kept_;
};

} // namespace softgl
