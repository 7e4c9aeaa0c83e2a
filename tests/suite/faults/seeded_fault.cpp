// Which fault the library for tests has: in that library only.
#include <cstdlib>
#include <cstring>

#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

SeededFault wanted_fault() {
  const char* wanted = std::getenv("SOFTGL_SEEDED_FAULT");
  if (!wanted) return SeededFault::None;
#define SEEDED_FAULT(name, meaning) \
  if (std::strcmp(wanted, #name) == 0) return SeededFault::name;
#include "shaders/common/seeded_faults.inc"
#undef SEEDED_FAULT
  std::abort(); // a name that nobody knows must not look like a library without a fault
}

} // namespace

const SeededFault seeded_fault = wanted_fault();

} // namespace softgl
