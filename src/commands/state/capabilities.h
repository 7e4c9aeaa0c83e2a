// Everything that glEnable switches, from state_table.inc.
#pragma once

#include <span>

#include "context/state.h"

namespace softgl {

/// A capability is a bool or a bit of a mask; some exist once per texture unit.
struct Capability {
  GLenum token;
  bool initial;
  uint32_t dirty;                           // DirtyBit
  bool* (*flag)(State&, TextureUnitState&); // null: a bit of mask
  uint32_t* (*mask)(State&);
  uint32_t bit;

  bool get(const State& state, int unit) const {
    State& s = const_cast<State&>(state); // the accessors serve both
    return flag ? *flag(s, s.texture.unit[unit]) : (*mask(s) & bit) != 0;
  }
  void set(State& state, int unit, bool value) const {
    if (flag)
      *flag(state, state.texture.unit[unit]) = value;
    else if (value)
      *mask(state) |= bit;
    else
      *mask(state) &= ~bit;
  }
  bool per_unit() const {
    static State state;
    return flag && flag(state, state.texture.unit[0]) != flag(state, state.texture.unit[1]);
  }
};

std::span<const Capability> capabilities();
/// Null if there is none of that name.
const Capability* find_capability(GLenum token);

/// The enable of the client that a token such as GL_VERTEX_ARRAY names, or null.
bool* find_client_switch(ClientState& client, GLenum token);

} // namespace softgl
