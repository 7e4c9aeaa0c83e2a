// How a component of a vertex array becomes a float.
#pragma once

#include <string.h>

#include "shaders/common/vertex_attributes.h"

namespace softgl {

/// One component of an array as float (GL 1.5, table 2.9): unsigned types with OSMesa's rounding of arrays,
/// signed ones as the entry points convert them (OSMesa's arrays divide by 2^(b-1) - 1, see
/// reference/DEVIATIONS.md).
static inline float convert_component(const unsigned char* p, ComponentType type, bool normalized,
                                      int component) {
  switch (type) {
  case ComponentType::Float: {
    float v;
    memcpy(&v, p + 4 * component, 4);
    return v;
  }
  case ComponentType::Double: {
    double v;
    memcpy(&v, p + 8 * component, 8);
    return float(v);
  }
  case ComponentType::Byte: {
    int8_t v;
    memcpy(&v, p + component, 1);
    return normalized ? (2.0f * float(v) + 1.0f) * (1.0f / 255.0f) : float(v);
  }
  case ComponentType::UnsignedByte: {
    const uint8_t v = p[component];
    return normalized ? float(v) * (1.0f / 255.0f) : float(v);
  }
  case ComponentType::Short: {
    int16_t v;
    memcpy(&v, p + 2 * component, 2);
    return normalized ? (2.0f * float(v) + 1.0f) * (1.0f / 65535.0f) : float(v);
  }
  case ComponentType::UnsignedShort: {
    uint16_t v;
    memcpy(&v, p + 2 * component, 2);
    return normalized ? float(v) * (1.0f / 65535.0f) : float(v);
  }
  case ComponentType::Int: {
    int32_t v;
    memcpy(&v, p + 4 * component, 4);
    // The 1 of 2c + 1 is below a float's precision, so this is the specification and OSMesa.
    return normalized ? float(v) * (1.0f / 2147483648.0f) : float(v);
  }
  case ComponentType::UnsignedInt: {
    uint32_t v;
    memcpy(&v, p + 4 * component, 4);
    // OSMesa keeps the upper 23 bits.
    return normalized ? (float(v >> 9) * (1.0f / 8388608.0f)) * float(8388608.0 / 8388607.0) : float(v);
  }
  }
  return 0.0f;
}

} // namespace softgl
