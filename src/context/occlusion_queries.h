// Query objects (GL 1.5, 4.1.7) of one context: contexts do not share them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "context/object_store.h"

namespace softgl {

struct QueryObject {
  std::string label; // GL_KHR_debug
  /// How many fragments passed since the last BeginQuery. Every frame in which draws of this query wait holds
  /// it, too; the result is complete when nobody else does.
  std::shared_ptr<uint64_t> samples;
};

struct OcclusionQueries {
  NameTable<QueryObject> objects;
  GLuint active = 0;                 // the name of the query that counts now; 0: none does
  std::shared_ptr<uint64_t> samples; // of it; null: none
};

} // namespace softgl
