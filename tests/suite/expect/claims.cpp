// Errors and queries of a script: whether they are what the specification says. A script that is cut down to
// fewer calls must still be right.
#include <algorithm>

#include "expect/calls.h"

namespace softgl::suite {
namespace {

constexpr double kAnswerAccuracy = 5e-5; // as the player compares

std::vector<double> numbers(const Matrix4& m) { return {m.m, m.m + 16}; }
std::vector<double> numbers(const Vec4& v) { return {v.x, v.y, v.z, v.w}; }

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::abs(x - y) <= kAnswerAccuracy * std::max(std::abs(y), 0.02);
  });
}

Claims right_if(bool right) { return right ? Claims::Right : Claims::Wrong; }

} // namespace

const ArrayState* Machine::array_named(GLenum name) const {
  switch (name) {
  case GL_VERTEX_ARRAY: return &state_.vertex_array;
  case GL_NORMAL_ARRAY: return &state_.normal_array;
  case GL_COLOR_ARRAY: return &state_.color_array;
  case GL_EDGE_FLAG_ARRAY: return &state_.edge_flag_array;
  case GL_TEXTURE_COORD_ARRAY: return &state_.texture_array;
  }
  return nullptr;
}

std::vector<double> Machine::answer(GLenum name) {
  const State& s = state_;
  const LitVertex& raster = raster_position_;
  const auto size = [](const auto& stack) { return std::vector<double>{double(stack.size())}; };
  const auto valid = [&](std::vector<double> values) {
    return raster_position_valid_ ? values : std::vector<double>();
  };
  switch (name) {
  case GL_CURRENT_COLOR: return s.current.color_known ? numbers(s.current.color) : std::vector<double>();
  case GL_CURRENT_NORMAL:
    if (!s.current.normal_known) return {};
    return {s.current.normal.x, s.current.normal.y, s.current.normal.z};
  case GL_CURRENT_TEXTURE_COORDS: return numbers(s.current.texture_coordinate[s.texture.active]);
  case GL_CURRENT_RASTER_POSITION_VALID: return {double(raster_position_valid_)};
  case GL_CURRENT_RASTER_POSITION:
    return valid({raster.window.x, raster.window.y, raster.window.z, raster.w});
  case GL_CURRENT_RASTER_DISTANCE: // one of two distances is right (3.10)
    if (raster.fog_distance.high - raster.fog_distance.low > 1e-3) return {};
    return valid({raster.fog_distance.middle()});
  case GL_CURRENT_RASTER_COLOR: {
    std::vector<double> color;
    for (const Interval& c : raster.front.primary) color.push_back(c.middle());
    return valid(color);
  }
  case GL_MATRIX_MODE: return {double(s.transform.matrix_mode)};
  case GL_MODELVIEW_MATRIX: return numbers(s.modelview.back());
  case GL_PROJECTION_MATRIX: return numbers(s.projection.back());
  case GL_TEXTURE_MATRIX: return numbers(s.texture_matrix[s.texture.active].back());
  case GL_MODELVIEW_STACK_DEPTH: return size(s.modelview);
  case GL_PROJECTION_STACK_DEPTH: return size(s.projection);
  case GL_TEXTURE_STACK_DEPTH: return size(s.texture_matrix[s.texture.active]);
  case GL_ATTRIB_STACK_DEPTH: return size(s.saved);
  case GL_CLIENT_ATTRIB_STACK_DEPTH: return size(s.saved_clients);
  case GL_VIEWPORT: return {s.viewport.box, s.viewport.box + 4};
  case GL_DEPTH_RANGE: return {s.viewport.near, s.viewport.far};
  case GL_LIST_BASE: return {double(s.list_base)};
  case GL_RENDER_MODE: return {double(render_mode_.mode)};
  case GL_NAME_STACK_DEPTH: return {double(render_mode_.names.size())};
  case GL_SELECTION_BUFFER_SIZE: return {std::max(render_mode_.selection_size, 0) * 1.0};
  case GL_FEEDBACK_BUFFER_SIZE: return {std::max(render_mode_.feedback_size, 0) * 1.0};
  case GL_FEEDBACK_BUFFER_TYPE: return {double(render_mode_.feedback_type)};
  case GL_MAP1_GRID_SEGMENTS: return {double(s.evaluators.grid1.count)};
  case GL_MAP1_GRID_DOMAIN: return {s.evaluators.grid1.first, s.evaluators.grid1.last};
  case GL_MAP2_GRID_SEGMENTS:
    return {double(s.evaluators.grid2[0].count), double(s.evaluators.grid2[1].count)};
  case GL_MAP2_GRID_DOMAIN:
    return {s.evaluators.grid2[0].first, s.evaluators.grid2[0].last, s.evaluators.grid2[1].first,
            s.evaluators.grid2[1].last};
  case GL_VERTEX_ARRAY_SIZE: return {double(s.vertex_array.size)};
  case GL_VERTEX_ARRAY_TYPE: return {double(s.vertex_array.type)};
  case GL_VERTEX_ARRAY_STRIDE: return {double(s.vertex_array.given_stride)};
  case GL_COLOR_ARRAY_SIZE: return {double(s.color_array.size)};
  case GL_COLOR_ARRAY_STRIDE: return {double(s.color_array.given_stride)};
  }
  return {};
}

std::vector<double> Machine::query_answer(const Call& call) {
  if (call.command == Command::GetQueryiv) // how many bits a counter has is the subject's own
    return call.e(1) == GL_CURRENT_QUERY ? std::vector<double>{double(query_)} : std::vector<double>();
  const GLuint name = call.e(0);
  if (name == query_ || !queries_.contains(name)) return {-1}; // raises an error
  if (call.e(1) == GL_QUERY_RESULT_AVAILABLE)                  // for certain behind the result
    return complete_.contains(name) ? std::vector<double>{1} : std::vector<double>();
  complete_.insert(name);
  const FragmentCount& count = queries_[name];
  return count.low == count.high ? std::vector<double>{double(count.low)} : std::vector<double>();
}

Claims Machine::error_claim(const Call& call) {
  switch (call.error) {
  case GL_INVALID_ENUM:
  case GL_INVALID_VALUE: // of the arguments alone, but for lists
    if (open_ || call.command == Command::CallList || call.command == Command::CallLists)
      return Claims::Unknown;
    return Claims::Right;
  case GL_INVALID_OPERATION:
    if (call.command == Command::End) return right_if(!open_);
    if (call.command == Command::EndList) return right_if(open_ || !list_);
    if (call.command == Command::NewList) return right_if(open_ || list_);
    if (call.command == Command::RenderMode)
      return right_if(
          open_ || (call.e(0) == GL_SELECT ? render_mode_.selection_size : render_mode_.feedback_size) < 0);
    if (call.command == Command::SelectBuffer) return right_if(open_ || render_mode_.mode == GL_SELECT);
    if (call.command == Command::FeedbackBuffer) return right_if(open_ || render_mode_.mode == GL_FEEDBACK);
    if (call.command == Command::LoadName)
      return right_if(open_ || (render_mode_.mode == GL_SELECT && render_mode_.names.empty()));
    if (call.command == Command::BeginQuery) return right_if(open_ || query_ || call.n(1) == 0);
    if (call.command == Command::EndQuery) return right_if(open_ || !query_);
    if (call.command == Command::DeleteQueries) return right_if(open_ || query_);
    if (call.command == Command::GetQueryObjectuiv)
      return right_if(open_ || !queries_.contains(call.e(0)) || query_ == call.e(0));
    return open_ ? Claims::Right : Claims::Unknown;
  case GL_STACK_UNDERFLOW:
    if (call.command == Command::PopMatrix) return right_if(matrices().size() == 1);
    if (call.command == Command::PopAttrib) return right_if(state_.saved.empty());
    if (call.command == Command::PopClientAttrib) return right_if(state_.saved_clients.empty());
    if (call.command == Command::PopName)
      return right_if(render_mode_.mode == GL_SELECT && render_mode_.names.empty());
    break;
  }
  return Claims::Unknown;
}

Claims Machine::claim(const Call& call) {
  if (call.error != GL_NO_ERROR) return error_claim(call);
  if (call.command == Command::IsEnabled) {
    const GLenum name = call.e(0);
    if (name >= GL_CLIP_PLANE0 && name < GL_CLIP_PLANE0 + kClipPlanes)
      return right_if(state_.transform.clip_enabled[name - GL_CLIP_PLANE0] == (call.n(1) != 0));
    if (name == GL_AUTO_NORMAL) return right_if(state_.evaluators.auto_normal == (call.n(1) != 0));
    if (const int dimensions = map_dimensions(name))
      return right_if(state_.evaluators.on[dimensions - 1][map_index(name)] == (call.n(1) != 0));
    if (name == GL_LIGHTING) return right_if(state_.lighting.lighting == (call.n(1) != 0));
    const ArrayState* array = array_named(name);
    return array ? right_if(array->on == (call.n(1) != 0)) : Claims::Unknown;
  }
  if (call.command == Command::IsList) // an empty one is one, too
    return right_if((state_.lists.count(call.e(0)) > 0) == (call.n(1) != 0));
  if (call.command == Command::IsQuery) return right_if(queries_.contains(call.e(0)) == (call.n(1) != 0));
  const std::vector<double> known = call.command == Command::GetFloatv  ? answer(call.e(0))
                                    : call.command == Command::GetMapfv ? map_answer(call.e(0), call.e(1))
                                                                        : query_answer(call);
  return known.empty() ? Claims::Unknown : right_if(same(known, call.arguments.back().numbers));
}

} // namespace softgl::suite
