#include "obj/element_statements.h"

namespace softgl::cli {
namespace {

// An index from 1, or from -1 downwards. False: no digits.
bool read_index(const char*& cursor, size_t count_so_far, IndexList& list, size_t place, int32_t& index) {
  const char* q = cursor;
  const bool negative = *q == '-';
  q += negative || *q == '+';
  const char* first = q;
  uint64_t value = 0;
  unsigned digit;
  while ((digit = uint8_t(*q) - unsigned('0')) < 10) {
    value = value * 10 + digit;
    if (value > 0x7fffffff) [[unlikely]]
      value = 0x7fffffff;
    ++q;
  }
  if (q == first) return false;
  if (*q == '.') { // scripts print whole numbers as 1.0
    ++q;
    while (*q == '0') ++q;
  }
  cursor = q;
  if (negative) {
    index = value ? int32_t(int64_t(count_so_far) - int64_t(value)) : kNowhere;
    if (value == 0x7fffffff) index = kNowhere;
    if (index != kNowhere) list.relative.append(uint32_t(place));
  } else {
    index = value ? int32_t(value) - 1 : kNowhere;
    if (value == 0x7fffffff) index = kNowhere;
  }
  return true;
}

void forget_from(IndexList& list, size_t size) {
  if (list.values.size() > size) list.values.truncate(size);
  while (!list.relative.empty() && list.relative.back() >= size)
    list.relative.truncate(list.relative.size() - 1);
}

// A positive index of at most nine digits; the cursor moves past it.
bool quick_index(const char*& cursor, int32_t& index) {
  const char* q = cursor;
  unsigned digit = uint8_t(*q) - unsigned('0');
  if (digit > 9) return false;
  uint32_t value = digit;
  while ((digit = uint8_t(*++q) - unsigned('0')) < 10) value = value * 10 + digit;
  if (value == 0 || q - cursor > 9) return false;
  cursor = q;
  index = int32_t(value) - 1;
  return true;
}

} // namespace

// One corner: v, v/t, v//n, v/t/n, with empty parts allowed. False: not a corner.
bool ElementStatements::corner() {
  int32_t vertex, texcoord = kAbsent, normal_index = kAbsent;
  const size_t place = out_.corner_vertices.values.size();
  if (!read_index(in_.p, out_.positions.size() / 3, out_.corner_vertices, place, vertex)) return false;
  if (*in_.p == '/') {
    ++in_.p;
    read_index(in_.p, out_.texcoords.size() / 2, out_.corner_texcoords, place, texcoord);
    if (*in_.p == '/') {
      ++in_.p;
      read_index(in_.p, out_.normals.size() / 3, out_.corner_normals, place, normal_index);
    }
    if (!with_slashes_) {
      with_slashes_ = true;
      out_.corner_texcoords.values.fill(place, kAbsent);
      out_.corner_normals.values.fill(place, kAbsent);
    }
  }
  if (!ends_token(*in_.p)) return false;
  out_.corner_vertices.values.append(vertex);
  if (with_slashes_) {
    out_.corner_texcoords.values.append(texcoord);
    out_.corner_normals.values.append(normal_index);
  }
  return true;
}

void ElementStatements::forget_corners(size_t size) {
  forget_from(out_.corner_vertices, size);
  forget_from(out_.corner_texcoords, size);
  forget_from(out_.corner_normals, size);
}

// What nearly all faces are: a few corners of plain positive indices, one blank between them. False: nothing
// has been taken, and face() reads it with all cases in mind.
bool ElementStatements::quick_face() {
  constexpr size_t kMost = 16;
  int32_t* vertices = out_.corner_vertices.values.room(kMost);
  int32_t* texcoords = with_slashes_ ? out_.corner_texcoords.values.room(kMost) : nullptr;
  int32_t* normals = with_slashes_ ? out_.corner_normals.values.room(kMost) : nullptr;
  const char* q = in_.p;
  size_t count = 0;
  for (;;) {
    while (*q == ' ') ++q;
    if (StatementScanner::is_line_end(*q)) break;
    int32_t vertex, texcoord = kAbsent, normal_index = kAbsent;
    if (count == kMost || !quick_index(q, vertex)) return false;
    if (*q == '/') {
      if (!with_slashes_) return false;
      ++q;
      if (*q != '/' && !quick_index(q, texcoord)) return false;
      if (*q == '/' && !quick_index(++q, normal_index)) return false;
    }
    if (uint8_t(*q) > ' ') return false;
    vertices[count] = vertex;
    if (with_slashes_) {
      texcoords[count] = texcoord;
      normals[count] = normal_index;
    }
    ++count;
  }
  if (count < 3 || out_.face_count == wanted_) return false;
  if (count != 3 || !out_.face_sizes.empty()) {
    if (out_.face_sizes.empty()) out_.face_sizes.fill(out_.face_count, 3);
    out_.face_sizes.append(uint32_t(count));
  }
  out_.corner_vertices.values.commit(count);
  if (with_slashes_) {
    out_.corner_texcoords.values.commit(count);
    out_.corner_normals.values.commit(count);
  }
  ++out_.face_count;
  in_.p = q;
  return true;
}

bool ElementStatements::face() {
  if (quick_face()) [[likely]]
    return false;
  const size_t first = out_.corner_vertices.values.size();
  for (;;) {
    in_.skip_blanks();
    if (in_.at_statement_end()) break;
    const char* token = in_.p;
    if (corner()) continue;
    in_.p = token;
    in_.skip_token();
    if (out_.remarks.count("face skipped: a corner is not v/vt/vn")) {
      const std::string corner_text = printable({token, size_t(in_.p - token)}, 40);
      out_.remarks.describe("face skipped: a corner is not v/vt/vn", in_.statement,
                            "\"" + corner_text + "\" is not a corner v/vt/vn" +
                                (has_decimal_comma(token) ? " (it has a decimal comma)" : "") +
                                "; face skipped");
    }
    forget_corners(first);
    in_.skip_tokens();
    return false;
  }
  const size_t count = out_.corner_vertices.values.size() - first;
  if (count < 3) {
    out_.remarks.add("face with fewer than three corners skipped", in_.statement,
                     "a face needs three corners; skipped");
    forget_corners(first);
    return false;
  }
  if (out_.face_count == wanted_) return true;
  if (count != 3 && out_.face_sizes.empty()) out_.face_sizes.fill(out_.face_count, 3);
  if (count != 3 || !out_.face_sizes.empty()) out_.face_sizes.append(uint32_t(count));
  ++out_.face_count;
  return false;
}

void ElementStatements::segments_or_points(bool points) {
  IndexList& list = points ? out_.point_vertices : out_.line_vertices;
  const size_t vertex_count = out_.positions.size() / 3;
  int32_t previous = kAbsent;
  bool previous_relative = false;
  size_t count = 0;
  for (;;) {
    in_.skip_blanks();
    if (in_.at_statement_end()) break;
    IndexList scratch;
    int32_t vertex;
    const char* token = in_.p;
    if (!read_index(in_.p, vertex_count, scratch, 0, vertex)) {
      in_.p = token;
      out_.remarks.add("line or point with an index that is not a number", in_.statement,
                       "an index here is not a number; the rest is skipped");
      in_.skip_tokens();
      break;
    }
    while (!ends_token(*in_.p)) ++in_.p; // texture coordinates of lines are of no use here
    const bool relative = !scratch.relative.empty();
    if (points) {
      if (relative) list.relative.append(uint32_t(list.values.size()));
      list.values.append(vertex);
    } else if (count) {
      if (previous_relative) list.relative.append(uint32_t(list.values.size()));
      list.values.append(previous);
      if (relative) list.relative.append(uint32_t(list.values.size()));
      list.values.append(vertex);
    }
    previous = vertex;
    previous_relative = relative;
    ++count;
  }
  if (count < (points ? 1u : 2u))
    out_.remarks.add("line or point with too few vertices", in_.statement,
                     points ? "a point needs a vertex; skipped" : "a line needs two vertices; skipped");
}

} // namespace softgl::cli
