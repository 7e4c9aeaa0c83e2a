// A vertex program: what a draw needs from eye space to shaded vertices, as a key of few bits and immutable
// constants.
#pragma once

#include "shaders/common/lighting.h"
#include "shaders/common/limits.h"
#include "shaders/common/shaded_vertex.h"
#include "shaders/common/vertex_attributes.h"

namespace softgl {

/// Matrices are in OpenGL's column order.
struct TransformConstants {
  float mvp[16], modelview[16];
  float normal_matrix[3][3]; // column i of the modelview's inverse: eye normal i = dot(normal, column i)
  float normal_scale;        // 1 = leave it alone
  float window_scale[3], window_offset[3];
};

/// Clip planes in clip coordinates, those that are enabled, in order.
struct ClipPlaneConstants {
  int32_t count;
  uint8_t index[kMaxClipPlanes]; // GL_CLIP_PLANEi: its bit in the clip mask is kClipUser0 << i
  float plane[kMaxClipPlanes][4];
};

enum class TexGen : uint8_t { None, ObjectLinear, EyeLinear, SphereMap, ReflectionMap, NormalMap };

/// Generation and transformation of one unit's texture coordinates (GL 1.5, 2.11.4).
struct CoordinateConstants {
  TexGen mode[4];
  bool transform;    // by `matrix`; false when it is the identity
  float plane[4][4]; // of the linear modes
  float matrix[16];
};

struct PointConstants {
  float size, minimum, maximum, attenuation[3];
};

/// What the distance of fog is (GL_NV_fog_distance).
enum class FogDistance : uint8_t { PlaneAbsolute, Plane, Radial };

enum class PolygonMode : uint8_t { Fill, Line, Point };

/// What becomes of polygons before they come to the raster (GL 1.5, 3.5.1, 3.5.4, 3.5.5).
struct PolygonConstants {
  PolygonMode mode[2]; // of counter-clockwise polygons and of the others
  bool ccw_is_front;
  bool cull_front, cull_back;
  bool two_sided; // the vertices carry back colors
  bool offset[3]; // by mode; RasterConstants say how far
  bool whole; // 2.12: polygons are cut as a whole, and all edges along the clip volume are boundaries. Else
              // as by OSMesa 22.3.6: their triangles are, and edges along the view volume are none
};

struct VertexProgram {
  bool eye_position;      // some stage needs it, before fog
  bool eye_position_late; // texture generation needs it, after fog
  bool eye_unit;
  bool normal, normal_to_eye;
  bool normalize;   // as OSMesa does: a normal of zero becomes not a number
  bool unit_normal; // made a unit vector; a normal of zero stays zero, and so does the eye's
  bool lit;
  bool fog, fog_from_attribute;
  FogDistance fog_distance; // Radial: needs the eye position
  bool depth_clamp;         // the near and the far plane clip nothing
  bool depths_from_zero;    // the near plane is z = 0 instead of z = -w
  bool clamp_colors;        // GL_ARB_color_buffer_float
  bool point_attenuated;
  bool from_eye;   // a point's distance is that from the eye, not the absolute value of z (3.3)
  bool signed_fog; // fog coordinates may be less than 0 (3.10), and are not made positive
  const TransformConstants* transform;
  const ClipPlaneConstants* clip_planes;                    // null: none enabled
  const LightingConstants* lighting;                        // null: not lit
  const CoordinateConstants* coordinates[kMaxTextureUnits]; // null: passed through
  bool reflection_z;                                        // r of some unit is that of the reflection vector
  PointConstants point;
  const PolygonConstants* polygons; // null: all are filled, and the raster culls, colors and offsets them
  bool line_stipple;                // cut lines by the pattern while assembling
  uint16_t stipple_pattern, stipple_factor;
};

/// What the vertex kernels need of a draw.
struct VertexJob {
  const VertexProgram* program;
  ShadedLayout layout;
  uint32_t present;              // bit s: stream[s] feeds attribute s; otherwise it is constant[s]
  const AttributeStream* stream; // [kAttributeSlots]
  const float (*constant)[4];    // [kMaterial0]
  uint32_t end;                  // vertices from here on may not be read
};

} // namespace softgl
