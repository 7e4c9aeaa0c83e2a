// An OBJ file as numbers: merged vertex data, and chunks of elements whose indices are all valid.
#pragma once

#include <string>
#include <vector>

#include "common/source_text.h"
#include "common/warnings.h"
#include "obj/obj_chunk.h"

namespace softgl::cli {

struct ObjModel {
  GrowingArray<double> positions; // x y z
  GrowingArray<float> colors; // r g b in 0..1 per position, NaN where a vertex has none; empty without colors
  GrowingArray<float> texcoords; // u v
  GrowingArray<float> normals;   // x y z, never zero where a corner names one
  // In file order. Vertex indices are valid and lead to finite positions; texture coordinates and normals are
  // valid or kAbsent.
  std::vector<ObjChunk> chunks;

  uint64_t position_count = 0, texcoord_count = 0, normal_count = 0;
  uint64_t object_count = 0, group_count = 0;
  uint64_t face_count = 0, segment_count = 0, point_count = 0;
  bool has_smoothing_groups = false;
  bool skips_elements = false; // faces, segments or points whose vertices cannot be used
};

// Throws ProgramError for text that cannot be an OBJ file at all (UTF-16 without a mark). `threads` >= 1.
ObjModel read_obj(const SourceText& text, unsigned threads, RemarkList& remarks);

// Why a text without geometry has none, as one sentence.
std::string explain_missing_geometry(const SourceText& text);

} // namespace softgl::cli
