// The attributes of a vertex, and how an array of one is laid out in memory.
#pragma once

#include <stdint.h>

namespace softgl {

/// Vertex attribute slots: the index of an attribute in State::current and in a VertexRun.
/// Every slot holds four floats. Material slots carry glMaterial calls made between Begin and End.
enum AttributeSlot : int {
  kPosition = 0,
  kNormal = 1,
  kColor = 2,
  kSecondaryColor = 3,
  kFogCoordinate = 4,
  kEdgeFlag = 5,
  kColorIndex = 6,
  kTexCoord0 = 8,  // .. kTexCoord0 + kMaxTextureUnits - 1
  kMaterial0 = 16, // .. kMaterial0 + kMaterialSlots - 1, see MaterialParameter
  kAttributeSlots = kMaterial0 + 10
};

/// A material parameter's slot is kMaterial0 + 2 * parameter + face (face 0 = front, 1 = back).
enum MaterialParameter : int {
  kMaterialAmbient,
  kMaterialDiffuse,
  kMaterialSpecular,
  kMaterialEmission,
  kMaterialShininess,
  kMaterialParameters
};
constexpr int kMaterialSlots = 2 * kMaterialParameters;
static_assert(kAttributeSlots == kMaterial0 + kMaterialSlots);
constexpr int material_slot(MaterialParameter parameter, int face) {
  return kMaterial0 + 2 * parameter + face;
}

enum class ComponentType : uint8_t {
  Float,
  Double,
  Byte,
  UnsignedByte,
  Short,
  UnsignedShort,
  Int,
  UnsignedInt
};

/// One attribute of a vertex array: element i starts at data + i * stride. Missing components are 0, 0, 0, 1.
struct AttributeStream {
  const unsigned char* data = nullptr;
  uint32_t stride = 0;    // bytes
  uint8_t components = 4; // 1..4
  ComponentType type = ComponentType::Float;
  bool normalized = false; // integers map to [0,1] or [-1,1] (GL 1.5, 2.7, table 2.9)
};

} // namespace softgl
