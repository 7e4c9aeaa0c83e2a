// PushAttrib, PopAttrib and the client's counterparts (GL 1.5, 6.1.14).
#include "context/attribute_stack.h"
#include "context/texture_bindings.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <type_traits>

#include "commands/generated/commands.h"
#include "commands/lighting/color_material.h"
#include "commands/state/capabilities.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"
#include "texture/texture_object.h"

namespace softgl {
namespace {

static_assert(std::is_trivially_copyable_v<State>, "attribute groups are copied as bytes");

struct Group {
  GLbitfield mask;
  size_t offset, size;
  uint32_t dirty; // DirtyBit
};
// clang-format off
#define GROUP(bit, member) {bit, offsetof(State, member), sizeof(State::member), kDirtyBitsOf<&State::member>}
// clang-format on
const Group groups_of_state[] = {
    {GL_CURRENT_BIT, offsetof(State, current), kMaterial0 * sizeof(Vec4), kDirtyCurrent},
    {GL_LIGHTING_BIT, offsetof(State, current) + kMaterial0 * sizeof(Vec4), kMaterialSlots * sizeof(Vec4),
     kDirtyMaterial},
    GROUP(GL_CURRENT_BIT, raster_position),
    GROUP(GL_TRANSFORM_BIT, transform),
    GROUP(GL_TRANSFORM_BIT, clip_control),
    GROUP(GL_VIEWPORT_BIT, viewport),
    GROUP(GL_FOG_BIT, fog),
    GROUP(GL_LIGHTING_BIT, lighting),
    GROUP(GL_POINT_BIT, point),
    GROUP(GL_LINE_BIT, line),
    GROUP(GL_POLYGON_BIT, polygon),
    GROUP(GL_POLYGON_STIPPLE_BIT, polygon_stipple),
    GROUP(GL_MULTISAMPLE_BIT, multisample),
    GROUP(GL_TEXTURE_BIT, texture),
    GROUP(GL_SCISSOR_BIT, scissor),
    GROUP(GL_COLOR_BUFFER_BIT, color_buffer),
    GROUP(GL_DEPTH_BUFFER_BIT, depth),
    GROUP(GL_STENCIL_BUFFER_BIT, stencil),
    GROUP(GL_ACCUM_BUFFER_BIT, accumulation),
    GROUP(GL_PIXEL_MODE_BIT, pixel_mode),
    GROUP(GL_EVAL_BIT, evaluator),
    GROUP(GL_HINT_BIT, hint),
    GROUP(GL_LIST_BIT, list),
    // GL_ARB_color_buffer_float: of their groups and of GL_ENABLE_BIT, although they are no capabilities.
    {GL_ENABLE_BIT, offsetof(State, lighting) + offsetof(LightingState, clamp_vertex_color), sizeof(GLenum),
     kDirtyLighting},
    {GL_ENABLE_BIT, offsetof(State, color_buffer) + offsetof(ColorBufferState, clamp_fragment_color),
     sizeof(GLenum), kDirtyColorBuffer},
    {GL_ENABLE_BIT, offsetof(State, color_buffer) + offsetof(ColorBufferState, clamp_read_color),
     sizeof(GLenum), kDirtyColorBuffer},
};
#undef GROUP

size_t groups_size(GLbitfield mask) {
  size_t size = 0;
  for (const Group& group : groups_of_state)
    if (group.mask & mask) size += group.size;
  return size;
}

/// Where a capability is in a State: a bool, or bits of a uint32_t.
struct EnablePlace {
  size_t offset;
  uint32_t bits; // 0: a bool
  uint32_t dirty;
  bool get(const std::byte* state) const {
    if (bits == 0) return state[offset] != std::byte(0);
    uint32_t mask;
    std::memcpy(&mask, state + offset, sizeof mask);
    return (mask & bits) != 0;
  }
  void set(std::byte* state, bool value) const {
    if (bits == 0) {
      state[offset] = std::byte(value);
      return;
    }
    uint32_t mask;
    std::memcpy(&mask, state + offset, sizeof mask);
    mask = value ? mask | bits : mask & ~bits;
    std::memcpy(state + offset, &mask, sizeof mask);
  }
};

/// GL_ENABLE_BIT is every capability, in table order; those of texture units eight times.
struct Enables {
  std::vector<EnablePlace> all;
  uint32_t dirty = 0;
  GLbitfield groups = 0; // where these are saved, all capabilities are
  bool in_groups = true; // each is in one

  Enables() {
    State state;
    const auto offset = [&](const void* member) {
      return size_t(static_cast<const std::byte*>(member) - reinterpret_cast<const std::byte*>(&state));
    };
    for (const Capability& e : capabilities())
      for (int unit = 0; unit < (e.per_unit() ? kMaxTextureUnits : 1); ++unit)
        add({e.flag ? offset(e.flag(state, state.texture.unit[unit])) : offset(e.mask(state)),
             e.flag ? 0 : e.bit, e.dirty});
  }
  void add(const EnablePlace& e) {
    all.push_back(e);
    dirty |= e.dirty;
    const auto holds = [&](const Group& g) { return e.offset >= g.offset && e.offset < g.offset + g.size; };
    const Group* group = std::find_if(std::begin(groups_of_state), std::end(groups_of_state), holds);
    if (group == std::end(groups_of_state))
      in_groups = false;
    else
      groups |= group->mask;
  }
  bool saved_by_groups(GLbitfield mask) const { return in_groups && (mask & groups) == groups; }
};
const Enables& enables() {
  static const Enables table;
  return table;
}

void save_textures(Context& c, std::vector<SavedTexture>& saved) {
  saved.reserve(kTextureTargets);
  for (int unit = 0; unit < kMaxTextureUnits; ++unit)
    for (int target = 0; target < kTextureTargets; ++target) {
      // Units that nobody has touched keep the default objects: one copy of those, from unit 0, is enough.
      if (unit != 0 && c.state.texture.unit[unit].bound[target] == 0) continue;
      saved.push_back({unit, TextureTarget(target), bound_texture(c, unit, TextureTarget(target)), nullptr});
    }
  // All parameters in one piece of memory.
  const auto copies = std::make_shared<std::vector<TextureParameters>>(saved.size());
  for (size_t i = 0; i < saved.size(); ++i) {
    (*copies)[i] = saved[i].object->parameters;
    saved[i].parameters = {copies, &(*copies)[i]};
  }
}

void restore_textures(Context& c, const std::vector<SavedTexture>& saved) {
  for (auto& unit : c.bound_texture)
    for (auto& bound : unit) bound = nullptr;
  for (const SavedTexture& texture : saved) {
    const GLuint name = texture.object->name;
    // An object deleted meanwhile is not bound again; the default one takes its place.
    if (name != 0 && c.shared->textures.find(name) != texture.object) {
      c.state.texture.unit[texture.unit].bound[texture.target] = 0;
      continue;
    }
    if (!SOFTGL_FAULT(parameters_not_restored)) texture.object->parameters = *texture.parameters;
    if (name != 0) c.bound_texture[texture.unit][texture.target] = texture.object;
  }
  c.dirty |= kDirtyTextureObjects;
}

/// Whether a name of a draw or read buffer is one of the bound framebuffer object, or of the window.
bool has_buffer(const std::shared_ptr<FramebufferObject>& bound, GLenum name) {
  const bool attachment = name - GL_COLOR_ATTACHMENT0 < GLenum(kMaxColorAttachments);
  return name == GL_NONE || attachment == (bound != nullptr);
}

} // namespace

namespace gl {

void PushAttrib(Context& c, GLbitfield mask) {
  if (c.attribute_stack.server.size() >= kMaxAttributeStackDepth && !SOFTGL_FAULT(attribute_overflow_ignored))
    return set_error(c, GL_STACK_OVERFLOW);
  track_color_material(c);
  SavedAttributes saved;
  saved.mask = mask;
  saved.groups.reserve(groups_size(mask) + 256);
  const std::byte* state = reinterpret_cast<const std::byte*>(&c.state);
  for (const Group& group : groups_of_state)
    if (group.mask & mask)
      saved.groups.insert(saved.groups.end(), state + group.offset, state + group.offset + group.size);
  if (mask & GL_ENABLE_BIT && !enables().saved_by_groups(mask))
    for (const EnablePlace& e : enables().all) saved.groups.push_back(std::byte(e.get(state)));
  if (mask & GL_TEXTURE_BIT) save_textures(c, saved.textures);
  saved.draw_buffer = draw_buffer(c), saved.read_buffer = read_buffer(c);
  c.attribute_stack.server.push_back(std::move(saved));
}

void PopAttrib(Context& c) {
  if (c.attribute_stack.server.empty()) return set_error(c, GL_STACK_UNDERFLOW);
  if (SOFTGL_FAULT(query_ends_with_attributes)) c.queries.samples.reset();
  track_color_material(c);
  const SavedAttributes& saved = c.attribute_stack.server.back();
  const GLenum window_draw_buffer = c.state.color_buffer.draw_buffer,
               window_read_buffer = c.state.pixel_mode.read_buffer;
  std::byte* state = reinterpret_cast<std::byte*>(&c.state);
  const std::byte* from = saved.groups.data();
  for (const Group& group : groups_of_state)
    if (group.mask & saved.mask) {
      const bool forgotten =
          (SOFTGL_FAULT(viewport_not_restored) && group.offset == offsetof(State, viewport)) ||
          (SOFTGL_FAULT(raster_position_not_restored) && group.offset == offsetof(State, raster_position)) ||
          (SOFTGL_FAULT(planes_not_restored) && group.offset == offsetof(State, transform));
      if (!forgotten) std::memcpy(state + group.offset, from, group.size);
      from += group.size;
      c.dirty |= group.dirty;
    }
  if (enables().saved_by_groups(saved.mask))
    c.dirty |= enables().dirty;
  else if (saved.mask & GL_ENABLE_BIT)
    for (const EnablePlace& e : enables().all) {
      const bool value = bool(*from++);
      if (e.get(state) == value) continue;
      if (SOFTGL_FAULT(enable_bit_without_lights) && e.dirty & kDirtyLights) continue;
      c.dirty |= e.dirty;
      e.set(state, value);
    }
  if (saved.mask & GL_TEXTURE_BIT) restore_textures(c, saved.textures);
  // Draw and read buffer are set in what is bound now, if it has such buffers (OSMesa 22.3.6).
  c.state.color_buffer.draw_buffer = window_draw_buffer;
  c.state.pixel_mode.read_buffer = window_read_buffer;
  if (saved.mask & GL_COLOR_BUFFER_BIT && has_buffer(c.bindings.draw, saved.draw_buffer))
    DrawBuffer(c, saved.draw_buffer);
  if (saved.mask & GL_PIXEL_MODE_BIT && has_buffer(c.bindings.read, saved.read_buffer))
    ReadBuffer(c, saved.read_buffer);
  c.attribute_stack.server.pop_back();
}

void PushClientAttrib(Context& c, GLbitfield mask) {
  if (c.attribute_stack.client.size() >= kMaxAttributeStackDepth) return set_error(c, GL_STACK_OVERFLOW);
  c.attribute_stack.client.push_back({mask, c.client.pixel_store, c.client.vertex_array});
}

void PopClientAttrib(Context& c) {
  if (c.attribute_stack.client.empty()) return set_error(c, GL_STACK_UNDERFLOW);
  const SavedClientAttributes& saved = c.attribute_stack.client.back();
  if (saved.mask & GL_CLIENT_PIXEL_STORE_BIT && !SOFTGL_FAULT(pixel_store_not_restored))
    c.client.pixel_store = saved.pixel_store;
  // A vertex array object that is deleted meanwhile is not bound again, and nothing is restored
  // (OSMesa 22.3.6).
  const std::shared_ptr<VertexArrayObject>& bound = saved.vertex_array.bound;
  const bool there = !bound || c.vertex_array_objects.find(bound->name) == bound;
  if (saved.mask & GL_CLIENT_VERTEX_ARRAY_BIT && there) {
    bind_vertex_array(c, bound);
    c.client.vertex_array = saved.vertex_array;
    c.dirty |= kDirtyArrays;
  }
  c.attribute_stack.client.pop_back();
}

} // namespace gl
} // namespace softgl
