#include "commands/vertices/array_fetch.h"

#include <algorithm>
#include <cstring>

#include "base/fast_paths.h"
#include "commands/vertices/index_range.h"
#include "context/buffer_objects.h"
#include "context/context.h"

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
  case GL_UNSIGNED_SHORT: return {ComponentType::UnsignedShort, 2};
  case GL_INT: return {ComponentType::Int, 4};
  case GL_UNSIGNED_INT: return {ComponentType::UnsignedInt, 4};
  case GL_DOUBLE: return {ComponentType::Double, 8};
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
  entry.slot = slot;
  entry.bytes = uint32_t(array.size) * type.bytes;
  entry.client = !array.object;
  entry.stream.stride = array.stride ? uint32_t(array.stride) : entry.bytes;
  entry.stream.components = uint8_t(array.size);
  entry.stream.type = type.type;
  entry.stream.normalized = slot == kNormal || slot == kColor || slot == kSecondaryColor;
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
  a.drawable = a.client = false;
  a.limit = uint64_t(1) << 32;
  a.source = nullptr;
  a.retained_indices = nullptr;
  for (int slot = 0; slot < kMaterial0; ++slot)
    if (c.client.vertex_array.array[slot].enabled) add_array(a, slot, c.client.vertex_array.array[slot]);
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
  const uint32_t stride = (array.bytes + 3) & ~3u;
  const size_t count = size_t(high - low) + 1;
  auto* to = static_cast<unsigned char*>(c.frame.arena().allocate(count * stride + kSpareBytes));
  const unsigned char* from = array.stream.data + size_t(low) * array.stream.stride;
  for (size_t i = 0; i < count; ++i)
    std::memcpy(to + i * stride, from + i * array.stream.stride, array.bytes);
  AttributeStream stream = array.stream;
  stream.data = element_zero(to, low, stride);
  stream.stride = stride;
  return stream;
}

} // namespace

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
  if (!a.client) a.source = source;
  // The memory that each array uses; arrays that are interleaved overlap and are copied in one go.
  struct Span {
    const unsigned char *begin, *end;
    const ArrayCache::Array* array;
  } span[kMaterial0];
  int spans = 0;
  for (int i = 0; i < a.count; ++i) {
    const ArrayCache::Array& array = a.array[i];
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
    const uint32_t stride = (array.bytes + 3) & ~3u;
    auto* to = static_cast<unsigned char*>(arena.allocate(a.used.size() * stride + kSpareBytes));
    AttributeStream stream = array.stream;
    stream.data = to;
    stream.stride = stride;
    for (const uint32_t index : a.used) {
      if (index < array.limit)
        std::memcpy(to, array.stream.data + size_t(index) * array.stream.stride, array.bytes);
      else
        std::memset(to, 0, array.bytes);
      to += stride;
    }
    set_stream(*source, array.slot, stream);
  }
  return {source, renamed, uint32_t(a.used.size())};
}

} // namespace softgl
