// Enable, Disable, IsEnabled and the client's counterparts (GL 1.5, 2.8 and 6.1.1).
#include <algorithm>
#include <vector>

#include "commands/generated/commands.h"
#include "commands/lighting/color_material.h"
#include "commands/state/capabilities.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

#define CAPABILITY(name, initial, dirty, member) \
  {GLenum(GL_##name), \
   bool(initial), \
   dirty, \
   [](State& s, TextureUnitState& unit) -> bool* { \
     (void)s, (void)unit; \
     return &(member); \
   }, \
   nullptr, \
   0},
#define CAPABILITY_BIT(name, number, dirty, member) \
  {GLenum(GL_##name), false, dirty, nullptr, [](State& s) -> uint32_t* { return &(member); }, 1u << (number)},
const Capability kCapabilities[] = {
#include "context/state_table.inc"
};

std::vector<const Capability*> sorted_table() {
  std::vector<const Capability*> sorted;
  for (const Capability& capability : kCapabilities) sorted.push_back(&capability);
  std::sort(sorted.begin(), sorted.end(), [](auto* a, auto* b) { return a->token < b->token; });
  return sorted;
}

} // namespace

std::span<const Capability> capabilities() { return kCapabilities; }

const Capability* find_capability(GLenum token) {
  static const std::vector<const Capability*> sorted = sorted_table();
  auto it =
      std::lower_bound(sorted.begin(), sorted.end(), token, [](auto* a, GLenum t) { return a->token < t; });
  return it != sorted.end() && (*it)->token == token ? *it : nullptr;
}

bool* find_client_switch(ClientState& client, GLenum token) {
  switch (token) {
// clang-format off
#define ARRAY(name, slot) \
  case GL_##name: return &client.vertex_array.array[slot].enabled;
#define CLIENT_SWITCH(name, value) \
  case GL_##name: return &(value);
#include "context/state_table.inc"
    // clang-format on
  default: return nullptr;
  }
}

namespace gl {
namespace {

/// What glEnableClientState does not know: it is glEnable's alone.
bool is_server_switch(GLenum token) {
  return token == GL_PRIMITIVE_RESTART || token == GL_DEBUG_OUTPUT || token == GL_DEBUG_OUTPUT_SYNCHRONOUS;
}

/// `argument`: what the command calls the token.
void set_client_switch(Context& c, GLenum token, bool value, bool refused, const char* argument) {
  bool* const enabled = refused ? nullptr : find_client_switch(c.client, token);
  if (!enabled) return set_error(c, GL_INVALID_ENUM, argument);
  *enabled = value || SOFTGL_FAULT(arrays_stay_on);
  if (token == GL_DEBUG_OUTPUT) return c.debug.watch(value);
  c.dirty |= kDirtyArrays;
}

void set_capability(Context& c, GLenum token, bool value) {
  const Capability* capability = find_capability(token);
  if (!capability) // EXT_vertex_array switches the arrays here
    return set_client_switch(c, token, value, token == GL_PRIMITIVE_RESTART_NV, "cap");
  const int unit = c.state.texture.active_unit;
  if (capability->get(c.state, unit) == value) return;
  if (token == GL_COLOR_MATERIAL && !value) track_color_material(c); // keeps the last color
  capability->set(c.state, unit, value);
  if (token == GL_COLOR_MATERIAL && value) track_color_material(c);
  c.dirty |= capability->dirty;
}

} // namespace

void Enable(Context& c, GLenum cap) { set_capability(c, cap, true); }
void Disable(Context& c, GLenum cap) { set_capability(c, cap, false); }

GLboolean IsEnabled(Context& c, GLenum cap) {
  if (const Capability* capability = find_capability(cap))
    return capability->get(c.state, c.state.texture.active_unit);
  if (const bool* enabled = find_client_switch(c.client, cap)) return *enabled;
  set_error(c, GL_INVALID_ENUM, "cap");
  return GL_FALSE;
}

void EnableClientState(Context& c, GLenum array) {
  set_client_switch(c, array, true, is_server_switch(array), "array");
}
void DisableClientState(Context& c, GLenum array) {
  set_client_switch(c, array, false, is_server_switch(array), "array");
}

} // namespace gl
} // namespace softgl
