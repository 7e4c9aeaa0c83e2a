// A display list: records of commands, in 8-byte units, and what they point to.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/gl_types.h"
#include "context/vertex_run.h"

namespace softgl {

/// Stands before the arguments of each command. Opcodes below kFirstListOpcode are generated (api/generated).
struct RecordHeader {
  uint32_t opcode;
  uint32_t units; // of 8 bytes, with the header
};
enum ListOpcode : uint16_t {
  kFirstListOpcode = 0xf000,
  kPlayRun = 0xf000, // uint64_t index into runs
  kPlayAttribute,    // AttributeRecord
  kPlayEnd,          // an End whose Begin is elsewhere
  kPlayError, // uint64_t: the code, and 1 in the upper half if the command is allowed between Begin and End
  kPlayCallList, // uint64_t name
  kPlayCallLists // uint64_t count, then GLuint offsets: the list base is added when the list is played (5.4)
};
struct AttributeRecord {
  uint64_t slot;
  float value[4];
};

struct DisplayList {
  std::string label; // GL_KHR_debug
  std::vector<uint64_t> records;
  std::vector<std::shared_ptr<VertexRun>> runs;
  std::vector<std::unique_ptr<unsigned char[]>> payloads;
};

} // namespace softgl
