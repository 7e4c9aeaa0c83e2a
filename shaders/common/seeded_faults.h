// Faults that a library for tests can be told to have (tests/suite/faults). In every other library the macro
// is false, and nothing is left of it.
#pragma once

#ifdef SOFTGL_SEEDED_FAULTS

namespace softgl {

enum class SeededFault {
  None,
#define SEEDED_FAULT(name, meaning) name,
#include "shaders/common/seeded_faults.inc"
#undef SEEDED_FAULT
};
/// The fault that the environment variable SOFTGL_SEEDED_FAULT names; none without it.
extern const SeededFault seeded_fault;

} // namespace softgl

#define SOFTGL_FAULT(name) (::softgl::seeded_fault == ::softgl::SeededFault::name)
#else
#define SOFTGL_FAULT(name) false
#endif
