#include "api/names.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace softgl {

void (*find_door(const char* name))() {
  const NamedDoor* const end = kNamedDoors + kNamedDoorCount;
  const NamedDoor* found =
      std::lower_bound(kNamedDoors, end, name, [](const NamedDoor& door, const char* wanted) {
        return std::strcmp(door.name, wanted) < 0;
      });
  return found != end && std::strcmp(found->name, name) == 0 ? found->door : nullptr;
}

const char* enum_name(uint32_t value) {
  const NamedEnum* const end = kNamedEnums + kNamedEnumCount;
  const NamedEnum* found =
      std::lower_bound(kNamedEnums, end, value, [](const NamedEnum& e, uint32_t v) { return e.value < v; });
  if (found != end && found->value == value) return found->name;
  static thread_local char unknown[16];
  std::snprintf(unknown, sizeof unknown, "0x%04x", value);
  return unknown;
}

} // namespace softgl
