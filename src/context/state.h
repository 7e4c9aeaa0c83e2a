// What GL remembers: one struct per attribute group (GL 1.5, tables 6.5 to 6.37).
// The default member values ARE the initial state. Derived values live elsewhere.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "base/gl_types.h"
#include "base/vectors.h"
#include "shaders/common/limits.h"
#include "shaders/common/vertex_attributes.h"
#include "texture/pixel_state.h"
#include "texture/texture_target.h"

namespace softgl {

constexpr int kMaxTextureSize = 16384;
constexpr float kMaxAnisotropy = 16;
constexpr int kMax3DTextureSize = 2048;
constexpr int kMaxViewportDimension = 16384;

/// The current vertex attributes (GL_CURRENT_BIT) and the current material (part of GL_LIGHTING_BIT),
/// table 6.5.
struct CurrentAttributes {
  alignas(16) Vec4 slot[kAttributeSlots] = {
      /* position   */ {0, 0, 0, 1},
      /* normal */ {0, 0, 1, 1},
      /* color */ {1, 1, 1, 1},
      /* secondary */ {0, 0, 0, 1},
      /* fog        */ {0, 0, 0, 1},
      /* edge   */ {1, 0, 0, 1},
      /* index  */ {1, 0, 0, 1},
      /* unused    */ {0, 0, 0, 1},
      /* tex coords */ {0, 0, 0, 1},
      {0, 0, 0, 1},
      {0, 0, 0, 1},
      {0, 0, 0, 1},
      {0, 0, 0, 1},
      {0, 0, 0, 1},
      {0, 0, 0, 1},
      {0, 0, 0, 1},
      /* ambient    */ {0.2f, 0.2f, 0.2f, 1},
      {0.2f, 0.2f, 0.2f, 1},
      /* diffuse    */ {0.8f, 0.8f, 0.8f, 1},
      {0.8f, 0.8f, 0.8f, 1},
      /* specular   */ {0, 0, 0, 1},
      {0, 0, 0, 1},
      /* emission   */ {0, 0, 0, 1},
      {0, 0, 0, 1},
      /* shininess  */ {0, 0, 0, 1},
      {0, 0, 0, 1}};
};

/// The current raster position (table 6.5).
struct RasterPosition {
  Vec4 window{0, 0, 0, 1}; // y up, x and y in pixels
  float distance = 0;
  Vec4 color{1, 1, 1, 1}, secondary_color{0, 0, 0, 1};
  Vec4 texcoord[kMaxTextureUnits] = {{0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1},
                                     {0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}};
  bool valid = true;
};

/// GL_TRANSFORM_BIT and GL_VIEWPORT_BIT (table 6.8). The matrices themselves are in matrix_stacks.h.
struct TransformState {
  GLenum matrix_mode = GL_MODELVIEW;
  bool normalize = false, rescale_normal = false;
  bool depth_clamp = false;               // GL_ARB_depth_clamp
  bool raster_position_unclipped = false; // GL_IBM_rasterpos_clip
  uint32_t clip_plane_enabled = 0;        // bit i = GL_CLIP_PLANEi
  Vec4 clip_plane[kMaxClipPlanes] = {};   // eye coordinates (2.11)
};
/// GL_ARB_clip_control; of GL_TRANSFORM_BIT.
struct ClipControlState {
  GLenum origin = GL_LOWER_LEFT, depth_mode = GL_NEGATIVE_ONE_TO_ONE;
};
struct ViewportState {
  GLint x = 0, y = 0;
  GLsizei width = 0, height = 0;
  double near_depth = 0, far_depth = 1;
};

/// GL_FOG_BIT (table 6.9).
struct FogState {
  bool enabled = false, color_sum = false;
  Vec4 color{0, 0, 0, 0};
  float density = 1, start = 0, end = 1, index = 0;
  GLenum mode = GL_EXP, coordinate_source = GL_FRAGMENT_DEPTH;
  GLenum distance_mode = GL_EYE_PLANE_ABSOLUTE_NV; // GL_NV_fog_distance
};

/// GL_LIGHTING_BIT (tables 6.10, 6.11) without the material, which is in CurrentAttributes.
struct Light {
  bool enabled = false;
  Vec4 ambient{0, 0, 0, 1}, diffuse{0, 0, 0, 1},
      specular{0, 0, 0, 1};      // light 0: diffuse, specular = 1 (see LightingState)
  Vec4 position{0, 0, 1, 0};     // eye coordinates
  Vec3 spot_direction{0, 0, -1}; // eye coordinates
  float spot_exponent = 0, spot_cutoff = 180;
  float constant_attenuation = 1, linear_attenuation = 0, quadratic_attenuation = 0;
};
struct LightingState {
  GLenum shade_model = GL_SMOOTH;
  GLenum provoking_vertex = GL_LAST_VERTEX_CONVENTION; // GL_EXT_provoking_vertex
  bool enabled = false, color_material_enabled = false;
  GLenum color_material_face = GL_FRONT_AND_BACK, color_material_parameter = GL_AMBIENT_AND_DIFFUSE;
  Vec4 model_ambient{0.2f, 0.2f, 0.2f, 1};
  bool local_viewer = false, two_side = false;
  GLenum color_control = GL_SINGLE_COLOR;
  GLenum clamp_vertex_color = GL_TRUE;            // GL_ARB_color_buffer_float
  GLenum specular_vector = GL_HALF_VECTOR_SOFTGL; // GL_SOFTGL_phong_illumination
  uint32_t terms = GL_ALL_TERM_BITS_SOFTGL;
  Vec3 material_indexes[2] = {{0, 1, 1},
                              {0, 1, 1}}; // GL_COLOR_INDEXES of front and back: ambient, diffuse, specular
  std::array<Light, kMaxLights> light{};
  LightingState() { light[0].diffuse = light[0].specular = {1, 1, 1, 1}; }
};

/// GL_POINT_BIT, GL_LINE_BIT, GL_POLYGON_BIT, GL_POLYGON_STIPPLE_BIT (tables 6.12, 6.13).
struct PointState {
  float size = 1, size_min = 0, size_max = 255, fade_threshold = 1;
  bool smooth = false, sprite = false;
  Vec3 distance_attenuation{1, 0, 0};
  uint32_t coord_replace = 0; // GL_COORD_REPLACE_ARB by texture unit
  GLenum sprite_origin = GL_UPPER_LEFT;

  bool attenuated() const { return distance_attenuation != Vec3(1, 0, 0); }
};
struct LineState {
  float width = 1;
  bool smooth = false, stipple = false;
  GLint stipple_factor = 1;
  GLushort stipple_pattern = 0xffff;
};
struct PolygonState {
  bool cull = false, smooth = false, stipple = false;
  GLenum cull_face = GL_BACK, front_face = GL_CCW;
  GLenum mode[2] = {GL_FILL, GL_FILL}; // front, back
  float offset_factor = 0, offset_units = 0;
  bool offset_point = false, offset_line = false, offset_fill = false;

  bool culls(bool back) const { return cull && cull_face != (back ? GL_FRONT : GL_BACK); }
  /// The mode of a face, or of the other one where it is culled.
  GLenum seen_mode(bool back) const { return mode[back != culls(back)]; }
  bool all_filled() const { return seen_mode(false) == GL_FILL && seen_mode(true) == GL_FILL; }
};
struct PolygonStippleState {
  uint32_t row[32]; // row 0 = bottom; the most significant bit is the leftmost pixel
  PolygonStippleState() {
    for (auto& r : row) r = 0xffffffffu;
  }
};

/// Multisampling (table 6.14).
struct MultisampleState {
  bool enabled = true, alpha_to_coverage = false, alpha_to_one = false, coverage = false,
       coverage_invert = false;
  float coverage_value = 1;
};

/// Texture environment and generation of one unit (GL_TEXTURE_BIT, tables 6.17 to 6.19).
struct TextureGeneration {
  bool enabled = false;
  GLenum mode = GL_EYE_LINEAR;
  Vec4 object_plane{0, 0, 0, 0}, eye_plane{0, 0, 0, 0};
};
struct TextureUnitState {
  bool enabled[kTextureTargets] = {};
  GLuint bound[kTextureTargets] = {}; // names; the objects are in Context::bound_texture
  GLenum env_mode = GL_MODULATE;
  Vec4 env_color{0, 0, 0, 0};
  float lod_bias = 0;
  GLenum combine_rgb = GL_MODULATE, combine_alpha = GL_MODULATE;
  // The fourth one is of GL_COMBINE4_NV (GL_NV_texture_env_combine4).
  GLenum source_rgb[4] = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT, GL_ZERO},
         source_alpha[4] = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT, GL_ZERO};
  GLenum operand_rgb[4] = {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_COLOR};
  GLenum operand_alpha[4] = {GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
  float rgb_scale = 1, alpha_scale = 1;
  TextureGeneration generation[4]; // s, t, r, q
  TextureUnitState() {
    generation[0].object_plane = generation[0].eye_plane = {1, 0, 0, 0};
    generation[1].object_plane = generation[1].eye_plane = {0, 1, 0, 0};
  }
};
struct TextureState {
  int active_unit = 0;
  TextureUnitState unit[kMaxTextureUnits];
  bool seamless_cube_map = false; // GL_ARB_seamless_cube_map
};

/// GL_SCISSOR_BIT, and the per-fragment operations of GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT,
/// GL_STENCIL_BUFFER_BIT and GL_ACCUM_BUFFER_BIT (tables 6.20, 6.21).
struct ScissorState {
  bool enabled = false;
  GLint x = 0, y = 0;
  GLsizei width = 0, height = 0;
};
struct ColorBufferState {
  bool alpha_test = false;
  GLenum alpha_function = GL_ALWAYS;
  float alpha_reference = 0;
  bool blend = false;
  GLenum blend_source_rgb = GL_ONE, blend_source_alpha = GL_ONE;
  GLenum blend_destination_rgb = GL_ZERO, blend_destination_alpha = GL_ZERO;
  GLenum blend_equation = GL_FUNC_ADD, blend_equation_alpha = GL_FUNC_ADD;
  Vec4 blend_color{0, 0, 0, 0};
  bool dither = true, logic_op = false, index_logic_op = false;
  GLenum logic_op_mode = GL_COPY;
  GLenum draw_buffer = GL_FRONT;
  bool mask[4] = {true, true, true, true};
  GLuint index_mask = 0xffffffffu;
  Vec4 clear_color{0, 0, 0, 0};
  float clear_index = 0;
  bool framebuffer_srgb = false;
  GLenum clamp_fragment_color = GL_FIXED_ONLY, clamp_read_color = GL_FIXED_ONLY; // GL_ARB_color_buffer_float
};
struct DepthState {
  bool test = false, mask = true;
  GLenum function = GL_LESS;
  double clear = 1;
  bool bounds_test = false; // GL_EXT_depth_bounds_test
  double least_bound = 0, greatest_bound = 1;
};
struct StencilFace {
  GLenum function = GL_ALWAYS, fail = GL_KEEP, depth_fail = GL_KEEP, depth_pass = GL_KEEP;
  GLint reference = 0;
  GLuint value_mask = 0xff, write_mask = 0xff; // all ones of the 8 bits there may be, as OSMesa answers

  bool operator==(const StencilFace&) const = default;
};
struct StencilState {
  bool test = false;
  bool two_side = false;         // GL_EXT_stencil_two_side
  GLenum active_face = GL_FRONT; // its glActiveStencilFace
  // That of GL_EXT_stencil_two_side is another one than that of glStencilFuncSeparate.
  StencilFace front, back, two_side_back;
  GLint clear = 0;

  /// What the commands without a face set and ask for; `back` follows the front.
  const StencilFace& active() const { return active_face == GL_BACK ? two_side_back : front; }
  const StencilFace& seen_back() const { return two_side ? two_side_back : back; }
};
struct AccumulationState {
  Vec4 clear{0, 0, 0, 0};
};

struct BufferObject;
struct VertexArrayObject; // vertex_array_objects.h // context/buffer_objects.h

/// A buffer object bound to a target, and its name. A deleted one lives as long as it is bound.
struct BufferBinding {
  GLuint name = 0;
  std::shared_ptr<BufferObject> object; // null for name 0
};

/// GL_CLIENT_PIXEL_STORE_BIT (table 6.22, and GL_ARB_pixel_buffer_object). Where a buffer is bound, the
/// pointers of pixel commands are offsets into it.
struct PixelStoreState {
  PixelStore pack, unpack;
  BufferBinding pack_buffer, unpack_buffer;
};

/// GL_EVAL_BIT (table 6.26). The maps themselves are in evaluator_maps.h.
struct GridDirection {
  GLint count = 1; // partitions between first and last
  float first = 0, last = 1;
};
struct EvaluatorState {
  bool auto_normal = false;
  uint32_t map1_enabled = 0, map2_enabled = 0; // bit: EvaluatorTarget
  GridDirection grid1, grid2[2];               // grid2: u, v
};
/// GL_HINT_BIT (table 6.28) and GL_LIST_BIT.
struct HintState {
  GLenum perspective_correction = GL_DONT_CARE, point_smooth = GL_DONT_CARE, line_smooth = GL_DONT_CARE;
  GLenum polygon_smooth = GL_DONT_CARE, fog = GL_DONT_CARE, generate_mipmap = GL_DONT_CARE,
         texture_compression = GL_DONT_CARE;
  GLenum phong = GL_DONT_CARE; // GL_WIN_phong_shading
};
struct ListState {
  GLuint base = 0;
};
constexpr int kMaxNameStackDepth = 64;

/// Selection and feedback (table 6.32). In no attribute group.
struct RenderModeState {
  GLenum mode = GL_RENDER;
  GLsizei feedback_size = 0, selection_size = 0;
  GLenum feedback_type = GL_2D;
  GLint name_stack_depth = 0;
  GLuint name[kMaxNameStackDepth] = {};
  GLfloat* feedback_buffer = nullptr;
  GLuint* selection_buffer = nullptr;
  uint64_t written = 0; // values, those that found no room counted too
  GLint hits = 0;
  bool hit = false;                          // since the name stack changed last
  float least_depth = 1, greatest_depth = 0; // of that hit
};

/// One vertex array (GL_CLIENT_VERTEX_ARRAY_BIT, tables 6.6, 6.7). `pointer` is an offset when `buffer` is
/// not 0.
struct VertexArray {
  bool enabled = false;
  GLint size = 4;
  GLenum type = GL_FLOAT;
  GLsizei stride = 0;
  const void* pointer = nullptr;
  GLuint buffer = 0;
  std::shared_ptr<BufferObject> object; // of `buffer`: a deleted one lives as long as an array uses it
};
/// What a vertex array object holds.
struct VertexArrays {
  VertexArray array[kTexCoord0 + kMaxTextureUnits]; // by AttributeSlot, kPosition .. kTexCoord0 + 7
  GLuint element_array_buffer = 0;
  std::shared_ptr<BufferObject> element_array_object; // null for name 0
  VertexArrays() {
    array[kNormal].size = array[kSecondaryColor].size = 3;
    array[kFogCoordinate].size = array[kEdgeFlag].size = array[kColorIndex].size = 1;
  }
};
/// The arrays of the bound vertex array object, and what no such object holds.
struct VertexArrayState : VertexArrays {
  std::shared_ptr<VertexArrayObject> bound; // null: name 0
  int active_texture_unit = 0;
  GLuint array_buffer = 0;
  std::shared_ptr<BufferObject> array_object; // null for name 0
  bool restarts = false;                      // GL_PRIMITIVE_RESTART
  GLuint restart_index = 0;
  GLint lock_first = 0; // GL_EXT_compiled_vertex_array
  GLsizei lock_count = 0;
};

/// All server state that is not in objects. PushAttrib saves it by attribute group.
struct State {
  CurrentAttributes current;
  RasterPosition raster_position;
  TransformState transform;
  ClipControlState clip_control;
  ViewportState viewport;
  FogState fog;
  LightingState lighting;
  PointState point;
  LineState line;
  PolygonState polygon;
  PolygonStippleState polygon_stipple;
  MultisampleState multisample;
  TextureState texture;
  ScissorState scissor;
  ColorBufferState color_buffer;
  DepthState depth;
  StencilState stencil;
  AccumulationState accumulation;
  PixelModeState pixel_mode;
  EvaluatorState evaluator;
  HintState hint;
  ListState list;
  PixelMaps pixel_maps;
  RenderModeState render_mode;
};

/// The client's state. PushClientAttrib can save its attribute groups, the first two.
struct ClientState {
  PixelStoreState pixel_store;
  VertexArrayState vertex_array;
  VertexArrays unbound_arrays;         // those of name 0 while a vertex array object is bound
  BufferBinding copy_read, copy_write; // GL_ARB_copy_buffer
  bool debug_output = false, debug_output_synchronous = false; // GL_KHR_debug
};

/// Dirty bits: one per group of State or kind of object. A command sets the bits of the groups that it
/// changes; snapshot/derived_state.cpp makes the snapshots anew that name them as inputs, and clears them.
enum DirtyBit : uint32_t {
  kDirtyModelview = 1u << 0, // the top of the stack
  kDirtyProjection = 1u << 1,
  kDirtyTextureMatrices = 1u << 2,
  kDirtyTransform = 1u << 3, // without the matrix mode
  kDirtyViewport = 1u << 4,
  kDirtyFog = 1u << 5,
  kDirtyLighting = 1u << 6, // LightingState but for what the next two tell
  kDirtyLights = 1u << 7,
  kDirtyMaterial = 1u << 8, // the current material, and which parameters follow the color
  kDirtyPoint = 1u << 9,
  kDirtyLine = 1u << 10,
  kDirtyPolygon = 1u << 11,
  kDirtyPolygonStipple = 1u << 12,
  kDirtyTexture = 1u << 13,           // enables, bindings and environments of the units
  kDirtyTextureGeneration = 1u << 14, // of the units
  kDirtyTextureObjects = 1u << 15,    // parameters and images
  kDirtyScissor = 1u << 16,
  kDirtyColorBuffer = 1u << 17,
  kDirtyDepth = 1u << 18,
  kDirtyStencil = 1u << 19,
  kDirtyFramebuffer = 1u << 20, // its size and formats
  kDirtyCurrent = 1u << 21,     // current attributes below kMaterial0; cleared by commands/vertices/
  kDirtyArrays = 1u << 22,      // vertex arrays and the contents of buffers; cleared by commands/vertices/
  kDirtyMultisample = 1u << 23,
  kDirtyAll = (1u << 24) - 1
};

/// The dirty bits of a group of State; none where no snapshot reads it.
template <auto kGroup> constexpr uint32_t kDirtyBitsOf = 0;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::transform> = kDirtyTransform;
// It moves vertices, and turns the front of polygons round.
template <> inline constexpr uint32_t kDirtyBitsOf<&State::clip_control> = kDirtyTransform | kDirtyPolygon;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::viewport> = kDirtyViewport;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::fog> = kDirtyFog;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::lighting> =
    kDirtyLighting | kDirtyLights | kDirtyMaterial;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::point> = kDirtyPoint;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::line> = kDirtyLine;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::polygon> = kDirtyPolygon;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::polygon_stipple> = kDirtyPolygonStipple;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::texture> = kDirtyTexture | kDirtyTextureGeneration;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::multisample> = kDirtyMultisample;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::scissor> = kDirtyScissor;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::color_buffer> = kDirtyColorBuffer;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::depth> = kDirtyDepth;
template <> inline constexpr uint32_t kDirtyBitsOf<&State::stencil> = kDirtyStencil;

} // namespace softgl
