// Everything that can be asked about a context's state, for comparing two libraries or two moments.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/gl.h"

namespace softgl::test {

/// A row of src/context/state_table.inc.
struct StateRow {
  std::string name;
  GLenum token;
  std::vector<double> initial; // empty: depends on the window
  char kind; // B, I, U, E, F, N: Bool, Int, Uint, Enum, Float, Normal; C: a capability; A: a vertex array; S:
             // another switch of the client
};
const std::vector<StateRow>& state_rows();

/// The answers by name, as text with exact values.
using StateSnapshot = std::vector<std::pair<std::string, std::string>>;

/// All Get commands of all state: the table with four types and IsEnabled, lights, materials, clip planes,
/// texture units, stipple. `thorough` looks at all texture units, lights and planes, and changes the active
/// unit to do so.
StateSnapshot take_snapshot(const Gl& gl, bool thorough);

/// The names whose answers differ, with both answers; empty if none.
std::string compare_snapshots(const StateSnapshot& a, const StateSnapshot& b);

/// A context with a 64x64 RGBA surface, current while it lives.
class CurrentContext {
public:
  explicit CurrentContext(const Gl& gl, GLenum type = GL_UNSIGNED_BYTE);
  ~CurrentContext();
  CurrentContext(const CurrentContext&) = delete;

private:
  const Gl& gl_;
  void* context_;
  std::vector<float> buffer_ = std::vector<float>(64 * 64 * 4);
};

} // namespace softgl::test
