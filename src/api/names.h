// Tables of names, generated: entry points for OSMesaGetProcAddress, tokens for messages.
#pragma once

#include <cstddef>
#include <cstdint>

namespace softgl {

struct NamedDoor {
  const char* name;
  void (*door)();
};
extern const NamedDoor kNamedDoors[]; // of built commands, sorted by name
extern const size_t kNamedDoorCount;

struct NamedEnum {
  uint32_t value;
  const char* name;
};
extern const NamedEnum kNamedEnums[]; // sorted by value
extern const size_t kNamedEnumCount;

/// The entry point of that name, or null when there is none.
/// One that only raises GL_INVALID_OPERATION does not count.
void (*find_door(const char* name))();
/// "GL_DEPTH_TEST" for 0x0b71; "0x1234" for an unknown one. The pointer is good until the thread's next call.
const char* enum_name(uint32_t value);

} // namespace softgl
