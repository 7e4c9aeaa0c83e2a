// What one stretch of an OBJ file says, before indices are resolved.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "common/growing_array.h"
#include "common/warnings.h"

namespace softgl::cli {

// Indices count from 0 here. Relative indices (negative in the file) are counted from the chunk's first
// vertex until resolve_indices() adds what came before; kAbsent: not written; kNowhere: no such element.
inline constexpr int32_t kAbsent = std::numeric_limits<int32_t>::min();
inline constexpr int32_t kNowhere = std::numeric_limits<int32_t>::max();

// A statement that holds for the elements after it.
struct StateChange {
  enum Kind : uint8_t { kMaterial, kSmoothingGroup, kObject, kGroup, kLibrary };
  Kind kind;
  int32_t group = 0;          // kSmoothingGroup
  std::string_view name;      // the rest of the line otherwise
  uint32_t face, line, point; // elements of the chunk before it
};

// Indices into one kind of element; `relative` lists the places where a relative index stands.
struct IndexList {
  GrowingArray<int32_t> values;
  GrowingArray<uint32_t> relative;
};

struct ObjChunk {
  const char* begin = nullptr;
  const char* end = nullptr;

  GrowingArray<double> positions; // x y z; NaN where the file had no usable number
  GrowingArray<float> colors;     // r g b per position; empty, or NaN where a vertex has none
  GrowingArray<float> painted;    // r g b of ZBrush's #MRGB comments
  GrowingArray<float> texcoords;  // u v
  GrowingArray<float> normals;    // x y z

  uint32_t face_count = 0;
  GrowingArray<uint32_t> face_sizes; // empty while all faces are triangles
  IndexList corner_vertices;
  IndexList corner_texcoords; // both empty while no corner has a slash
  IndexList corner_normals;
  IndexList line_vertices; // pairs: every polyline is cut into segments
  IndexList point_vertices;

  std::vector<StateChange> changes;
  RemarkList remarks;
  bool has_unusable_position = false;
};

// Parses [begin, end); end is the text's end or follows a line end. With `find_face`, stops at the face of
// that number and returns where its statement begins (for messages).
const char* parse_obj_chunk(ObjChunk& chunk, uint32_t find_face = std::numeric_limits<uint32_t>::max());

} // namespace softgl::cli
