// The state of the specification's machine: what the calls of a script have set, in double.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "expect/evaluators.h"
#include "expect/texture_state.h"
#include "script/script.h"
#include "spec/lighting_bounds.h"

namespace softgl::suite {

using spec::Interval;
using spec::Matrix4;
using spec::Vec3;
using spec::Vec4;

// One group of attributes each, as glPushAttrib saves them (table 6.5 and on).
struct CurrentState {
  Vec4 color{1, 1, 1, 1};
  Vec3 normal{0, 0, 1};
  Vec4 texture_coordinate[kTextureUnits];
  double fog_coordinate = 0;
  bool edge = true;
  bool color_known = true, normal_known = true, edge_known = true; // not behind an array (2.8)
};
struct LightingState {
  LightingState();
  bool lighting = false, color_material = false, enabled[8] = {};
  spec::LightModel model;
  spec::LightBounds light[8];
  spec::Material material[2];
  GLenum tracked_face = GL_FRONT_AND_BACK, tracked = GL_AMBIENT_AND_DIFFUSE, shade_model = GL_SMOOTH;
};
constexpr int kClipPlanes = 6;
struct TransformState {
  bool clip_enabled[kClipPlanes] = {};
  Vec4 clip_plane[kClipPlanes]; // in eye coordinates
  bool normalize = false, rescale_normal = false;
  GLenum matrix_mode = GL_MODELVIEW;
};
struct PolygonState {
  bool cull = false;
  GLenum cull_face = GL_BACK, front_face = GL_CCW, mode[2] = {GL_FILL, GL_FILL}; // of front and back
  bool smooth = false, stippled = false, offset_point = false, offset_line = false, offset_fill = false;
  double offset_factor = 0, offset_units = 0;
};
struct FogState {
  bool on = false;
  GLenum mode = GL_EXP;
  double density = 1, start = 0, end = 1;
  GLenum source = GL_FRAGMENT_DEPTH;
  Vec4 color{0, 0, 0, 0};
};
struct ColorBufferState {
  bool alpha_test = false, blend = false, logic = false, mask[4] = {true, true, true, true}, drawn = true;
  bool dither = true;
  GLenum equation = GL_FUNC_ADD, operation = GL_COPY;
  Vec4 constant{0, 0, 0, 0};
  GLenum alpha_function = GL_ALWAYS;
  GLenum source[2] = {GL_ONE, GL_ONE}, destination[2] = {GL_ZERO, GL_ZERO}; // of RGB and of alpha
  double alpha_reference = 0;
  Vec4 clear_color{0, 0, 0, 0};
};
struct DepthState {
  bool test = false, mask = true;
  GLenum function = GL_LESS;
  double clear = 1;
};
struct PixelModeState {
  PixelTransferState transfer;
  double zoom[2] = {1, 1};
};
struct StencilState {
  bool test = false;
  GLenum function = GL_ALWAYS, fail = GL_KEEP, depth_fail = GL_KEEP, depth_pass = GL_KEEP;
  int reference = 0, clear = 0;
  unsigned mask = ~0u, write_mask = ~0u;
};
struct ScissorState {
  bool test = false;
  int box[4] = {0, 0, 0, 0};
};
struct PointState {
  double size = 1, least = 0, greatest = 1e9, attenuation[3] = {1, 0, 0};
  bool smooth = false;
};
struct LineState {
  double width = 1;
  bool smooth = false, stippled = false;
  int stipple_factor = 1;
  unsigned stipple_pattern = 0xffff;
};

struct ViewportState {
  int box[4] = {0, 0, 0, 0};
  double near = 0, far = 1;
};

struct Attributes {
  CurrentState current;
  LightingState lighting;
  TransformState transform;
  PolygonState polygon;
  FogState fog;
  ColorBufferState color_buffer;
  DepthState depth;
  StencilState stencil;
  ScissorState scissor;
  Vec4 accumulation_clear{0, 0, 0, 0};
  std::vector<bool> polygon_stipple = std::vector<bool>(1024, true); // bit x + 32 y
  TextureState texture;
  PixelModeState pixel;
  PointState point;
  LineState line;
  ViewportState viewport;
  EvaluatorState evaluators;
  GLuint list_base = 0;
};

struct SavedAttributes {
  GLbitfield mask;
  Attributes attributes;
};

struct ArrayState { // of the client (2.8)
  bool on = false;
  int size = 4, stride = 0; // stride in elements, not 0
  int given_stride = 0;     // in bytes, as it is asked for
  GLenum type = GL_FLOAT;
  std::vector<double> elements;
};

/// A call in a list, and how it unpacks images: by the state of when it was compiled (5.4).
struct ListedCall {
  Call call;
  PixelStore unpack;
};

/// What glPushClientAttrib saves (tables 6.6, 6.21 and 6.22).
struct ClientState {
  ArrayState vertex_array, normal_array, color_array, edge_flag_array, texture_array;
  PixelStore pack, unpack;
};

struct SavedClient {
  GLbitfield mask;
  ClientState client;
};

struct State : Attributes, ClientState {
  std::vector<Matrix4> modelview{1}, projection{1};
  std::vector<Matrix4> texture_matrix[kTextureUnits] = {std::vector<Matrix4>(1), std::vector<Matrix4>(1),
                                                        std::vector<Matrix4>(1), std::vector<Matrix4>(1)};
  std::vector<SavedAttributes> saved;
  std::vector<SavedClient> saved_clients;
  std::map<GLuint, std::vector<ListedCall>> lists;
};

/// Copies what the bits of `mask` name (tables 6.5 to 6.30).
void restore(State& state, const SavedAttributes& saved);
void restore(State& state, const SavedClient& saved);

} // namespace softgl::suite
