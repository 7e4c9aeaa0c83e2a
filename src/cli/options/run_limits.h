// What a run may use, for models of unknown origin.
#pragma once

#include <cstdint>

namespace softgl::cli {

struct LoadLimits {
  bool strict_materials = false; // what the material file says, even where exporters mean something else
  bool any_path = false;         // a model may name files outside of its folder
  uint64_t triangles = 0;        // 0: any number
};

// 0: no limit.
struct RunLimits {
  LoadLimits load;
  uint64_t input_bytes = 0; // but for pipes, see SourceText
  uint64_t memory_bytes = 0;
  int picture_side = 0;
  double seconds = 0;
  bool sandbox = false;
};

} // namespace softgl::cli
