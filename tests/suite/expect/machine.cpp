#include "expect/machine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "expect/calls.h"

namespace softgl::suite {

namespace {

// The elements of glCallLists as numbers: bytes of one element go from the greatest to the least (5.4).
std::vector<GLuint> list_offsets(const Call& call) {
  const GLenum type = call.e(1);
  const int bytes = type == GL_2_BYTES ? 2 : type == GL_3_BYTES ? 3 : type == GL_4_BYTES ? 4 : 0;
  std::vector<GLuint> offsets;
  for (size_t i = 0; i < size_t(call.n(0)); i++) {
    if (!bytes) {
      if (call.arguments[2].memory_type != type) throw std::logic_error("offsets of another type");
      offsets.push_back(GLuint(int64_t(std::trunc(call.v(2).at(i)))));
      continue;
    }
    GLuint offset = 0;
    for (int b = 0; b < bytes; b++)
      offset = offset << 8 | GLuint(call.v(2).at(i * size_t(bytes) + size_t(b)));
    offsets.push_back(offset);
  }
  return offsets;
}

} // namespace

Machine::Machine(Expectation& picture, const Precision& precision) : raster_(picture, precision) {
  state_.viewport.box[2] = picture.width, state_.viewport.box[3] = picture.height; // 2.11.1
  state_.scissor.box[2] = picture.width, state_.scissor.box[3] = picture.height;   // 4.1.2
  for (Interval& white : raster_position_.front.primary) white = 1;                // table 6.6
}

void Machine::play(const Call& call) {
  if (std::exchange(skips_next_, false)) {
    if (call.command == Command::PaintPixels) // what is read stays as it is
      paint_elements(packed_elements(state_.pack, {}, call.e(4), call.e(5), int(call.n(6))), call, 7);
    return;
  }
  if (call.error != GL_NO_ERROR || facts_of(call.command).query) { // changes nothing
    claims_ = std::max(claims_, claim(call));
    return;
  }
  if (play_arrays(call)) return;
  if (list_ && facts_of(call.command).in_lists) {
    state_.lists[list_].push_back({call, state_.unpack});
    if (!list_executes_) return;
  }
  for (const auto group :
       {&Machine::play_vertices, &Machine::play_lists, &Machine::play_attributes, &Machine::play_matrices,
        &Machine::play_lighting, &Machine::play_rasterization, &Machine::play_textures, &Machine::play_pixels,
        &Machine::play_fragments, &Machine::play_special, &Machine::play_evaluators, &Machine::play_paint})
    if ((this->*group)(call)) return;
  throw std::logic_error(std::string("the machine does not know gl") + facts_of(call.command).name);
}

void Machine::check_reading() const {
  if (!state_.pixel.transfer.is_default() || state_.pack.row_length || state_.pack.skip_pixels ||
      state_.pack.skip_rows || state_.pack.swap_bytes)
    throw std::logic_error("the picture could not be read with this state");
}

void Machine::call_list(GLuint name) {
  const std::vector<ListedCall> calls = state_.lists[name];
  const PixelStore unpack = state_.unpack;
  const GLuint compiled = std::exchange(list_, 0); // what is executed is not compiled again
  for (const ListedCall& c : calls) state_.unpack = c.unpack, play(c.call);
  list_ = compiled, state_.unpack = unpack;
}

bool Machine::play_lists(const Call& call) { // 5.4
  switch (call.command) {
  case Command::NewList:
    list_ = GLuint(call.n(0)), list_executes_ = call.e(1) == GL_COMPILE_AND_EXECUTE;
    state_.lists[list_].clear();
    return true;
  case Command::EndList: list_ = 0; return true;
  case Command::DeleteLists:
    for (GLuint i = 0; i < GLuint(call.n(1)); i++) state_.lists.erase(GLuint(call.n(0)) + i);
    return true;
  case Command::CallList: call_list(GLuint(call.n(0))); return true;
  case Command::CallLists:
    for (GLuint offset : list_offsets(call)) call_list(state_.list_base + offset);
    return true;
  case Command::ListBase: state_.list_base = GLuint(call.n(0)); return true;
  default: return false;
  }
}

std::vector<double> numbers_of(const Call& call, size_t first) {
  std::vector<double> v;
  for (size_t i = first; i < call.arguments.size(); i++) v.push_back(call.n(i));
  return v;
}

std::vector<double> values_of(const Call& call) {
  return call.arguments[0].numbers.empty() ? numbers_of(call, 0) : call.v(0);
}

Vec4 vec4(const std::vector<double>& v) {
  return {v[0], v.size() > 1 ? v[1] : 0, v.size() > 2 ? v[2] : 0, v.size() > 3 ? v[3] : 1};
}

double signed_unit(double integer, int bits) { return (2 * integer + 1) / (std::ldexp(1, bits) - 1); }

Interval row_times(const Matrix4& m, int row, const Vec4& v) {
  const double terms[4] = {m(row, 0) * v.x, m(row, 1) * v.y, m(row, 2) * v.z, m(row, 3) * v.w};
  double sum = 0, size = 0;
  for (double t : terms) sum += t, size += std::abs(t);
  return spec::widened(sum, kMatrixAccuracy * size);
}

Expectation expected_picture(const Script& script, int width, int height, const Precision& precision,
                             Claims* claims) {
  Expectation picture;
  picture.width = width, picture.height = height;
  picture.pixels.assign(size_t(width * height), std::vector<Answer>(1));
  picture.touched.assign(size_t(width * height), 0), picture.hidden = picture.touched;
  Machine machine(picture, precision);
  for (const Call& call : script.calls) machine.play(call);
  machine.check_reading();
  // What is drawn later may hide pixels of a line, or have the same color.
  std::erase_if(picture.witnesses,
                [&](const Witness& w) { return picture.sum(picture.hidden, w) != w.hidden; });
  for (Witness& w : picture.witnesses)
    if (!w.counts || picture.sum(picture.touched, w) != w.touched) w.least = 1, w.most = 1000;
  if (claims) *claims = machine.claims();
  return picture;
}

} // namespace softgl::suite
