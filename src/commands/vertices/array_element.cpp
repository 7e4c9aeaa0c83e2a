#include "commands/vertices/array_element.h"

#include <cstring>

#include "base/normalized.h"
#include "commands/vertices/array_fetch.h"
#include "commands/vertices/attribute_doors.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

template <class T> void load(const unsigned char* p, int count, bool as_fraction, float* out) {
  for (int i = 0; i < count; ++i) {
    T v;
    std::memcpy(&v, p + i * sizeof(T), sizeof v);
    if constexpr (std::is_floating_point_v<T>)
      out[i] = float(v);
    else
      out[i] = as_fraction ? normalized(v) : float(v);
  }
}

} // namespace

void emit_array_element(Context& c, const ArrayCache& arrays, uint32_t index) {
  float position[4];
  for (int i = arrays.count; i-- > 0;) { // the position, which is the first, comes last
    const ArrayCache::Array& array = arrays.array[i];
    const AttributeStream& s = array.stream;
    float v[4] = {0, 0, 0, 1};
    if (index < array.limit) {
      const unsigned char* p = s.data + size_t(index) * s.stride;
      unsigned char converted[4 * sizeof(float)];
      if (array.form != ArrayCache::Form::Plain) copy_element(array, p, converted), p = converted;
      switch (s.type) {
      case ComponentType::Float: load<GLfloat>(p, s.components, false, v); break;
      case ComponentType::Double: load<GLdouble>(p, s.components, false, v); break;
      case ComponentType::Byte: load<GLbyte>(p, s.components, s.normalized, v); break;
      case ComponentType::UnsignedByte: load<GLubyte>(p, s.components, s.normalized, v); break;
      case ComponentType::Short: load<GLshort>(p, s.components, s.normalized, v); break;
      case ComponentType::UnsignedShort: load<GLushort>(p, s.components, s.normalized, v); break;
      case ComponentType::Int: load<GLint>(p, s.components, s.normalized, v); break;
      case ComponentType::UnsignedInt: load<GLuint>(p, s.components, s.normalized, v); break;
      }
    }
    if (array.slot == kPosition)
      std::memcpy(position, v, sizeof v);
    else if (!SOFTGL_FAULT(element_position_only))
      set_attribute4(c, array.slot, v[0], v[1], v[2], v[3]);
  }
  if (arrays.drawable) emit_vertex4(c, position[0], position[1], position[2], position[3]);
}

} // namespace softgl
