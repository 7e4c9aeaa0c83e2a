// Path levels: a test is drawn again under state that must not matter, which takes a GL other ways to the
// same picture.
#pragma once

#include <optional>

#include "run/test.h"

namespace softgl::suite {

struct PathLevel {
  const char* name;
  const char* meaning;
  /// The whole script of the test on this path, or nothing if the test uses the state itself.
  std::optional<Script> (*make)(const Script& body);
};

/// The first is "plain": the test as it stands.
const std::vector<PathLevel>& path_levels();

} // namespace softgl::suite
