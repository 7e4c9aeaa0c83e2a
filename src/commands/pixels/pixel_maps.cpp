// Pixel maps (GL 1.5, 3.6.3).
#include <algorithm>
#include <cmath>

#include "base/unit_range.h"
#include "commands/buffers/pixel_buffers.h"
#include "commands/generated/commands.h"
#include "context/context.h"

namespace softgl {
namespace {

constexpr int kMaps = 10;
constexpr GLsizei kMaxMapSize = 256; // GL_MAX_PIXEL_MAP_TABLE

bool is_map(GLenum map) { return map >= GL_PIXEL_MAP_I_TO_I && map < GL_PIXEL_MAP_I_TO_I + kMaps; }
/// Maps whose values are indexes, and not colors in [0,1].
bool holds_indexes(GLenum map) { return map == GL_PIXEL_MAP_I_TO_I || map == GL_PIXEL_MAP_S_TO_S; }
/// Maps that are looked up by an index: their sizes are powers of two.
bool takes_indexes(GLenum map) { return map <= GL_PIXEL_MAP_I_TO_A; }

/// `value(v)` is what the map shall hold where the client has v.
template <class T, class Value>
void set_map(Context& c, GLenum map, GLsizei size, const T* values, Value value) {
  if (size < 1 || size > kMaxMapSize || (is_map(map) && takes_indexes(map) && (size & (size - 1)) != 0))
    return set_error(c, GL_INVALID_VALUE, "mapsize");
  if (!is_map(map)) return set_error(c, GL_INVALID_ENUM, "map");
  const void* memory = values;
  if (!find_unpack_memory(c, memory, array_span(size_t(size), sizeof(T))) || !memory) return;
  values = static_cast<const T*>(memory);
  const GLenum i = map - GL_PIXEL_MAP_I_TO_I;
  c.state.pixel_maps.size[i] = size;
  for (GLsizei k = 0; k < size; ++k) {
    const float v = value(values[k]);
    c.state.pixel_maps.value[i][k] = map == GL_PIXEL_MAP_S_TO_S   ? std::round(v)
                                     : map == GL_PIXEL_MAP_I_TO_I ? v
                                                                  : unit_range(v);
  }
}

/// `value(v)` is what the client gets where the map holds v.
template <class T, class Value> void get_map(Context& c, GLenum map, T* values, Value value) {
  if (!is_map(map)) return set_error(c, GL_INVALID_ENUM, "map");
  const GLenum i = map - GL_PIXEL_MAP_I_TO_I;
  const GLsizei size = c.state.pixel_maps.size[i];
  void* memory = values;
  if (!find_pack_memory(c, memory, array_span(size_t(size), sizeof(T))) || !memory) return;
  for (GLsizei k = 0; k < size; ++k) static_cast<T*>(memory)[k] = value(c.state.pixel_maps.value[i][k]);
}

/// A value within the integers up to `most`.
double within(float v, double most) { return std::clamp(double(v), 0.0, most); }

} // namespace

namespace gl {

void PixelMapfv(Context& c, GLenum map, GLsizei mapsize, const GLfloat* values) {
  set_map(c, map, mapsize, values, [](float v) { return v; });
}
void PixelMapuiv(Context& c, GLenum map, GLsizei mapsize, const GLuint* values) {
  set_map(c, map, mapsize, values,
          [&](GLuint v) { return holds_indexes(map) ? float(v) : float(v * (1.0 / 4294967295.0)); });
}
void PixelMapusv(Context& c, GLenum map, GLsizei mapsize, const GLushort* values) {
  set_map(c, map, mapsize, values,
          [&](GLushort v) { return holds_indexes(map) ? float(v) : float(v) * (1.0f / 65535.0f); });
}

void GetPixelMapfv(Context& c, GLenum map, GLfloat* values) {
  get_map(c, map, values, [](float v) { return v; });
}
void GetPixelMapuiv(Context& c, GLenum map, GLuint* values) {
  get_map(c, map, values, [&](float v) {
    return holds_indexes(map) ? GLuint(within(v, 4294967295.0)) : GLuint(double(v) * 4294967295.0);
  });
}
void GetPixelMapusv(Context& c, GLenum map, GLushort* values) {
  get_map(c, map, values, [&](float v) {
    return holds_indexes(map) ? GLushort(within(v, 65535.0)) : GLushort(std::lrint(v * 65535.0f));
  });
}

} // namespace gl
} // namespace softgl
