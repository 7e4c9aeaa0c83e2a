// Stretches of an OBJ file: where statements begin, and their chunks.
#pragma once

#include <vector>

#include "common/source_text.h"
#include "obj/obj_chunk.h"

namespace softgl::cli {

// The next place after `from` where a statement begins, or the end.
const char* statement_border(const char* from, const char* end);

// Parses [begin, end), which begins with a statement, in pieces of a few megabytes. `threads` >= 1.
std::vector<ObjChunk> parse_obj_range(const SourceText& text, const char* begin, const char* end,
                                      unsigned threads);

// What an OBJ file has of each kind, or has before some place.
struct ElementCounts {
  uint64_t positions = 0, texcoords = 0, normals = 0;
};

ElementCounts element_counts(const ObjChunk& chunk);

// Makes relative indices absolute, given what stands before the chunk.
void resolve_indices(ObjChunk& chunk, const ElementCounts& before);

// What colors are multiplied by where `largest` is the largest of all: some programs write 0 to 255.
float color_scale(float largest);

} // namespace softgl::cli
