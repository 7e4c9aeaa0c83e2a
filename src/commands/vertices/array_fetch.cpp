#include "commands/vertices/array_fetch.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/fast_paths.h"
#include "commands/vertices/index_range.h"
#include "context/buffer_objects.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"
#include "texture/small_floats.h"

namespace softgl {
namespace {

constexpr size_t kSpareBytes = BufferStorage::kSpareBytes;

struct TypeInfo {
  ComponentType type;
  uint32_t bytes;
};
TypeInfo type_info(GLenum type) {
  switch (type) {
  case GL_BYTE: return {ComponentType::Byte, 1};
  case GL_UNSIGNED_BYTE: return {ComponentType::UnsignedByte, 1};
  case GL_SHORT: return {ComponentType::Short, 2};
  case GL_UNSIGNED_SHORT:
    return {SOFTGL_FAULT(unsigned_array_signed) ? ComponentType::Short : ComponentType::UnsignedShort, 2};
  case GL_INT: return {ComponentType::Int, 4};
  case GL_UNSIGNED_INT: return {ComponentType::UnsignedInt, 4};
  case GL_DOUBLE: return {ComponentType::Double, 8};
  case GL_HALF_FLOAT: return {ComponentType::Float, 2}; // after its conversion
  default: return {ComponentType::Float, 4};
  }
}

bool is_valid(const Context& c) {
  if (c.dirty & kDirtyArrays) return false;
  const ArrayCache& a = c.arrays;
  for (int i = 0; i < a.watched_count; ++i)
    if (a.watched[i].object->version != a.watched[i].version) return false;
  return true;
}

void watch(ArrayCache& a, const BufferObject& object) {
  for (int i = 0; i < a.watched_count; ++i)
    if (a.watched[i].object == &object) return;
  a.watched[a.watched_count++] = {&object, object.version};
}

void add_array(ArrayCache& a, int slot, const VertexArray& array) {
  const TypeInfo type = type_info(array.type);
  ArrayCache::Array& entry = a.array[a.count];
  const bool bgra = array.size == GL_BGRA;
  // A secondary color's alpha is not used.
  const uint32_t components = SOFTGL_FAULT(array_alpha_lost) && slot == kColor ? 3
                              : !bgra                                          ? uint32_t(array.size)
                              : slot == kSecondaryColor                        ? 3
                                                                               : 4;
  entry.slot = slot;
  entry.form = bgra                          ? ArrayCache::Form::Bgra
               : array.type == GL_HALF_FLOAT ? ArrayCache::Form::Half
                                             : ArrayCache::Form::Plain;
  entry.bytes = bgra ? 4 : components * type.bytes;
  entry.converted = entry.form == ArrayCache::Form::Half ? 4 * components : entry.bytes;
  a.converts = a.converts || entry.form != ArrayCache::Form::Plain;
  entry.client = !array.object;
  entry.stream.stride = array.stride ? uint32_t(array.stride) : entry.bytes;
  if (SOFTGL_FAULT(array_stride_ignored)) entry.stream.stride = components * type.bytes;
  if (SOFTGL_FAULT(array_stride_between) && array.stride) entry.stream.stride += entry.bytes;
  entry.stream.components = uint8_t(components);
  entry.stream.type = type.type;
  entry.stream.normalized = slot == kNormal || slot == kColor || slot == kSecondaryColor;
  if (SOFTGL_FAULT(array_positions_scaled)) entry.stream.normalized |= slot == kPosition;
  if (SOFTGL_FAULT(array_colors_not_scaled)) entry.stream.normalized = slot == kNormal;
  if (array.object) {
    watch(a, *array.object);
    const size_t offset = reinterpret_cast<size_t>(array.pointer), size = array.object->size();
    entry.limit = offset < size && size - offset >= entry.bytes
                      ? (size - offset - entry.bytes) / entry.stream.stride + 1
                      : 0;
    if (!entry.limit) a.limit = 0;
    entry.stream.data = entry.limit ? array.object->storage->bytes + offset : nullptr;
  } else {
    if (!array.pointer) return; // enabled, but never given: like not enabled
    entry.limit = uint64_t(1) << 32;
    entry.stream.data = static_cast<const unsigned char*>(array.pointer);
    a.client = true;
  }
  a.limit = std::min(a.limit, entry.limit);
  ++a.count;
  if (slot == kPosition) a.drawable = true;
}

VertexSource* new_source(Context& c) {
  auto* source = c.frame.arena().allocate_array<VertexSource>(1); // only the present streams are written
  source->present = 0;
  return source;
}
void set_stream(VertexSource& source, int slot, const AttributeStream& stream) {
  source.stream[slot] = stream;
  source.present |= 1u << slot;
}

void rebuild(Context& c) {
  ArrayCache& a = c.arrays;
  a.count = a.watched_count = 0;
  a.drawable = a.client = a.converts = false;
  a.limit = uint64_t(1) << 32;
  a.source = nullptr;
  a.retained_indices = nullptr;
  for (int slot = 0; slot < kMaterial0; ++slot)
    if (c.client.vertex_array.array[slot].enabled &&
        !(SOFTGL_FAULT(edge_flag_array_ignored) && slot == kEdgeFlag))
      add_array(a, slot, c.client.vertex_array.array[slot]);
  for (const VertexArray& array : c.client.vertex_array.array)
    if (array.enabled && array.object && array.object->storage)
      c.frame.retain(array.object->storage, array.object->storage->size);
  // No memory of the arena is taken here: ArrayElement comes by while the builder has a chunk of it open.
  c.dirty &= ~kDirtyArrays;
}

/// Where element 0 would be, if the copy of elements low.. began at `copy`. Arithmetic on integers: it may
/// lie outside.
const unsigned char* element_zero(const unsigned char* copy, uint32_t low, uint32_t stride) {
  return reinterpret_cast<const unsigned char*>(reinterpret_cast<uintptr_t>(copy) - uintptr_t(low) * stride);
}

/// Elements low..high of one array, without what lies between them.
AttributeStream copy_tight(Context& c, const ArrayCache::Array& array, uint32_t low, uint32_t high) {
  const uint32_t stride = (array.converted + 3) & ~3u;
  const size_t count = size_t(high - low) + 1;
  auto* to = static_cast<unsigned char*>(c.frame.arena().allocate(count * stride + kSpareBytes));
  const unsigned char* from = array.stream.data + size_t(low) * array.stream.stride;
  for (size_t i = 0; i < count; ++i) copy_element(array, from + i * array.stream.stride, to + i * stride);
  AttributeStream stream = array.stream;
  stream.data = element_zero(to, low, stride);
  stream.stride = stride;
  return stream;
}

} // namespace

void copy_element(const ArrayCache::Array& array, const unsigned char* from, unsigned char* to) {
  switch (array.form) {
  case ArrayCache::Form::Plain: std::memcpy(to, from, array.bytes); return;
  case ArrayCache::Form::Bgra: to[0] = from[2], to[1] = from[1], to[2] = from[0], to[3] = from[3]; return;
  case ArrayCache::Form::Half:
    for (int i = 0; i < array.stream.components; ++i) {
      uint16_t half;
      std::memcpy(&half, from + 2 * i, 2);
      const float value = half_to_float(half);
      std::memcpy(to + 4 * i, &value, 4);
    }
  }
}

ArrayCache* current_arrays(Context& c) {
  if (!is_valid(c) || !takes(FastPath::KeptArrays)) rebuild(c);
  ArrayCache& a = c.arrays;
  for (int i = 0; i < a.watched_count; ++i)
    if (a.watched[i].object->mapped) {
      set_error(c, GL_INVALID_OPERATION);
      return nullptr;
    }
  return &a;
}

const VertexSource* fetch_range(Context& c, ArrayCache& a, uint32_t low, uint32_t high) {
  if (a.source) return a.source;
  VertexSource* source = new_source(c);
  if (!a.client && !a.converts) a.source = source;
  // The memory that each array uses; arrays that are interleaved overlap and are copied in one go.
  struct Span {
    const unsigned char *begin, *end;
    const ArrayCache::Array* array;
  } span[kMaterial0];
  int spans = 0;
  for (int i = 0; i < a.count; ++i) {
    const ArrayCache::Array& array = a.array[i];
    if (array.form != ArrayCache::Form::Plain) {
      set_stream(*source, array.slot, copy_tight(c, array, low, high));
      continue;
    }
    if (!array.client) {
      set_stream(*source, array.slot, array.stream);
      continue;
    }
    const unsigned char* begin = array.stream.data + size_t(low) * array.stream.stride;
    span[spans++] = {begin, begin + size_t(high - low) * array.stream.stride + array.bytes, &array};
  }
  std::sort(span, span + spans, [](const Span& x, const Span& y) { return x.begin < y.begin; });
  for (int i = 0; i < spans;) {
    const unsigned char* end = span[i].end;
    size_t wanted = 0;
    int next = i;
    for (; next < spans && span[next].begin <= end; ++next) {
      end = std::max(end, span[next].end);
      wanted += (size_t(high - low) + 1) * span[next].array->bytes;
    }
    const size_t bytes = size_t(end - span[i].begin);
    if (bytes > 4 * wanted + 4096) { // mostly something else, perhaps not even readable
      for (; i < next; ++i)
        set_stream(*source, span[i].array->slot, copy_tight(c, *span[i].array, low, high));
      continue;
    }
    auto* copy = static_cast<unsigned char*>(c.frame.arena().allocate(bytes + kSpareBytes));
    std::memcpy(copy, span[i].begin, bytes);
    for (const unsigned char* begin = span[i].begin; i < next; ++i) {
      AttributeStream stream = span[i].array->stream;
      stream.data = element_zero(copy + (span[i].begin - begin), low, stream.stride);
      set_stream(*source, span[i].array->slot, stream);
    }
  }
  return source;
}

CompactVertices compact(Context& c, ArrayCache& a, const void* indices, GLenum type, uint32_t count) {
  Arena& arena = c.frame.arena();
  auto* renamed = arena.allocate_array<uint32_t>(count);
  size_t size = 64;
  while (size < 2 * size_t(count)) size *= 2;
  a.table.assign(size, 0); // number of the used vertex + 1
  a.used.clear();
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t index = load_index(indices, type, i);
    size_t at = (index * 0x9e3779b1u >> 7) & (size - 1);
    while (a.table[at] && a.used[a.table[at] - 1] != index) at = (at + 1) & (size - 1);
    if (!a.table[at]) {
      a.used.push_back(index);
      a.table[at] = uint32_t(a.used.size());
    }
    renamed[i] = a.table[at] - 1;
  }
  VertexSource* source = new_source(c);
  for (int i = 0; i < a.count; ++i) {
    const ArrayCache::Array& array = a.array[i];
    const uint32_t stride = (array.converted + 3) & ~3u;
    auto* to = static_cast<unsigned char*>(arena.allocate(a.used.size() * stride + kSpareBytes));
    AttributeStream stream = array.stream;
    stream.data = to;
    stream.stride = stride;
    for (const uint32_t index : a.used) {
      if (index < array.limit)
        copy_element(array, array.stream.data + size_t(index) * array.stream.stride, to);
      else
        std::memset(to, 0, array.converted);
      to += stride;
    }
    set_stream(*source, array.slot, stream);
  }
  return {source, renamed, uint32_t(a.used.size())};
}

} // namespace softgl
