#include "obj_chunk.h"

#include "number_parser.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace softgl::cli {
namespace {

constexpr double kLargestCoordinate = 1e100; // squares and products must stay finite in double

class ChunkParser {
public:
  ChunkParser(ObjChunk& chunk, uint32_t find_face) : out(chunk), p(chunk.begin), end(chunk.end), wanted(find_face) {}

  const char* parse() {
    while (p < end) {
      skip_blanks();
      if (p >= end) break;
      statement = p;
      switch (*p) {
      case 'v': vertex_statement(); break;
      case 'f':
        if (is_blank(p[1])) {
          p += 1;
          if (face()) return statement;
        } else if (p[1] == 'o' && is_blank(p[2])) { // `fo`: the name of `f` in old files
          p += 2;
          if (face()) return statement;
        } else {
          other_statement();
        }
        break;
      case '#': finish_line(); continue;
      case '\n':
      case '\r': break;
      default: other_statement();
      }
      end_statement();
    }
    return nullptr;
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\0' || c == '\\'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }

  // Blanks, NUL bytes inside the text and line continuations.
  void skip_blanks() {
    for (;;) {
      if (*p == ' ' || *p == '\t') {
        ++p;
      } else if (*p == '\\' && p + 1 < end && is_line_end(p[1])) {
        p += p[1] == '\r' && p[2] == '\n' ? 3 : 2;
      } else if ((*p == '\0' && p < end) || *p == '\v' || *p == '\f') {
        ++p;
      } else {
        return;
      }
    }
  }

  bool at_statement_end() const { return is_line_end(*p) || *p == '#' || p >= end; }

  void skip_token() {
    if (*p == '\\' || *p == '#') ++p;
    while (!ends_token(*p)) ++p;
  }

  // To the next line; a comment is not continued by a backslash.
  void finish_line() {
    const auto rest = static_cast<size_t>(end - p);
    const char* line_feed = static_cast<const char*>(std::memchr(p, '\n', rest));
    const char* limit = line_feed ? line_feed : end;
    if (const auto* carriage_return = static_cast<const char*>(std::memchr(p, '\r', static_cast<size_t>(limit - p))))
      limit = carriage_return;
    p = limit;
    if (p < end) ++p;
  }

  void end_statement() {
    if (*p == '\n' && p < end) {
      ++p;
      return;
    }
    while (!at_statement_end()) { // more than the statement needs, such as a fourth texture coordinate
      skip_token();
      skip_blanks();
    }
    if (p >= end) return;
    finish_line();
  }

  // Up to `limit` numbers; the rest is left. A token that is no number sets `bad`.
  template <class T> int numbers(T* values, int limit, bool& bad) {
    int count = 0;
    for (; count < limit; ++count) {
      skip_blanks();
      if (at_statement_end()) break;
      const char* token = p;
      if (!read_number(p, values[count])) {
        if (p == token) skip_token();
        values[count] = std::numeric_limits<T>::quiet_NaN();
        bad = true;
      }
    }
    return count;
  }

  void vertex_statement() {
    if (is_blank(p[1])) {
      p += 1;
      position();
    } else if (p[1] == 't' && is_blank(p[2])) {
      p += 2;
      texture_coordinate();
    } else if (p[1] == 'n' && is_blank(p[2])) {
      p += 2;
      normal();
    } else if (p[1] == 'p' && is_blank(p[2])) {
      skip_rest(); // parameter-space points belong to free-form geometry
    } else if (ends_token(p[1])) {
      p += 1;
      position(); // `v` alone still counts as a vertex
    } else {
      other_statement();
    }
  }

  // Three numbers and the end of the line.
  bool quick_position() {
    double* xyz = out.positions.room(3);
    const char* q = p;
    for (int i = 0; i < 3; ++i) {
      while (*q == ' ') ++q;
      if (!read_number(q, xyz[i]) || !(std::fabs(xyz[i]) <= kLargestCoordinate)) return false;
    }
    while (*q == ' ') ++q;
    if (!is_line_end(*q) || !out.colours.empty()) return false;
    out.positions.commit(3);
    p = q;
    return true;
  }

  void position() {
    if (quick_position()) [[likely]]
      return;
    double values[8];
    bool bad = false;
    const int count = numbers(values, 8, bad);
    skip_blanks();
    if (count < 3 || bad) {
      if (out.remarks.count("vertex without three numbers: faces that use it are skipped"))
        out.remarks.describe("vertex without three numbers: faces that use it are skipped", statement,
                             "a vertex needs three numbers; faces that use it are skipped");
      for (int i = 0; i < 3; ++i)
        if (bad || i >= count) values[i] = std::numeric_limits<double>::quiet_NaN();
    }
    if (!(std::fabs(values[0]) <= kLargestCoordinate && std::fabs(values[1]) <= kLargestCoordinate &&
          std::fabs(values[2]) <= kLargestCoordinate)) [[unlikely]] {
      if (!bad && count >= 3 && out.remarks.count("vertex that is not a finite place"))
        out.remarks.describe("vertex that is not a finite place", statement,
                             "this vertex is not a finite place; faces that use it are skipped");
      values[0] = values[1] = values[2] = std::numeric_limits<double>::quiet_NaN();
      out.has_unusable_position = true;
    }
    double* xyz = out.positions.extend(3);
    xyz[0] = values[0];
    xyz[1] = values[1];
    xyz[2] = values[2];
    // 4 numbers: x y z w (w matters to free-form geometry only); 6: x y z r g b; 7: x y z r g b a.
    const bool coloured = (count == 6 || count == 7) && !bad;
    if (!coloured && out.colours.empty()) return;
    if (out.colours.empty()) out.colours.fill(out.positions.size() - 3, std::numeric_limits<float>::quiet_NaN());
    float* rgb = out.colours.extend(3);
    for (int i = 0; i < 3; ++i)
      rgb[i] = coloured ? static_cast<float>(values[3 + i]) : std::numeric_limits<float>::quiet_NaN();
  }

  void texture_coordinate() {
    float values[2] = {0, 0};
    bool bad = false;
    numbers(values, 2, bad);
    skip_blanks();
    if (!(std::isfinite(values[0]) && std::isfinite(values[1]))) {
      out.remarks.add("texture coordinate that is not a number", statement,
                      "this texture coordinate is not a number; 0 0 is used");
      values[0] = values[1] = 0;
    }
    float* uv = out.texcoords.extend(2);
    uv[0] = values[0];
    uv[1] = values[1];
  }

  void normal() {
    float values[3] = {0, 0, 0};
    bool bad = false;
    const int count = numbers(values, 3, bad);
    skip_blanks();
    // A normal of no direction is replaced by a generated one; the number 0 0 0 marks it.
    const float largest = std::max({std::fabs(values[0]), std::fabs(values[1]), std::fabs(values[2])});
    if (count < 3 || !(largest > 0) || !std::isfinite(values[0] + values[1] + values[2])) {
      out.remarks.add("normal without a direction: replaced", statement,
                      "this normal has no direction; a generated one replaces it");
      values[0] = values[1] = values[2] = 0;
    }
    float* xyz = out.normals.extend(3);
    for (int i = 0; i < 3; ++i) xyz[i] = values[i];
  }

  // An index from 1, or from -1 downwards. False: no digits.
  static bool read_index(const char*& cursor, size_t count_so_far, IndexList& list, size_t place, int32_t& index) {
    const char* q = cursor;
    const bool negative = *q == '-';
    q += negative || *q == '+';
    const char* first = q;
    uint64_t value = 0;
    unsigned digit;
    while ((digit = static_cast<unsigned char>(*q) - unsigned('0')) < 10) {
      value = value * 10 + digit;
      if (value > 0x7fffffff) [[unlikely]]
        value = 0x7fffffff;
      ++q;
    }
    if (q == first) return false;
    cursor = q;
    if (negative) {
      index = value ? static_cast<int32_t>(static_cast<int64_t>(count_so_far) - static_cast<int64_t>(value)) : kNowhere;
      if (value == 0x7fffffff) index = kNowhere;
      if (index != kNowhere) list.relative.append(static_cast<uint32_t>(place));
    } else {
      index = value ? static_cast<int32_t>(value) - 1 : kNowhere;
      if (value == 0x7fffffff) index = kNowhere;
    }
    return true;
  }

  // One corner: v, v/t, v//n, v/t/n, with empty parts allowed. False: not a corner.
  bool corner() {
    int32_t vertex, texcoord = kAbsent, normal_index = kAbsent;
    const size_t place = out.corner_vertices.values.size();
    if (!read_index(p, out.positions.size() / 3, out.corner_vertices, place, vertex)) return false;
    if (*p == '/') {
      ++p;
      read_index(p, out.texcoords.size() / 2, out.corner_texcoords, place, texcoord);
      if (*p == '/') {
        ++p;
        read_index(p, out.normals.size() / 3, out.corner_normals, place, normal_index);
      }
      if (!with_slashes) {
        with_slashes = true;
        out.corner_texcoords.values.fill(place, kAbsent);
        out.corner_normals.values.fill(place, kAbsent);
      }
    }
    if (!ends_token(*p)) return false;
    out.corner_vertices.values.append(vertex);
    if (with_slashes) {
      out.corner_texcoords.values.append(texcoord);
      out.corner_normals.values.append(normal_index);
    }
    return true;
  }

  static void forget_from(IndexList& list, size_t size) {
    if (list.values.size() > size) list.values.truncate(size);
    while (!list.relative.empty() && list.relative.back() >= size) list.relative.truncate(list.relative.size() - 1);
  }

  void forget_corners(size_t size) {
    forget_from(out.corner_vertices, size);
    forget_from(out.corner_texcoords, size);
    forget_from(out.corner_normals, size);
  }

  // A positive index of at most nine digits; the cursor moves past it.
  static bool quick_index(const char*& cursor, int32_t& index) {
    const char* q = cursor;
    unsigned digit = static_cast<unsigned char>(*q) - unsigned('0');
    if (digit > 9) return false;
    uint32_t value = digit;
    while ((digit = static_cast<unsigned char>(*++q) - unsigned('0')) < 10) value = value * 10 + digit;
    if (value == 0 || q - cursor > 9) return false;
    cursor = q;
    index = static_cast<int32_t>(value) - 1;
    return true;
  }

  // What nearly all faces are: a few corners of plain positive indices, one blank between them. False: nothing has been
  // taken, and face() reads it with all cases in mind.
  bool quick_face() {
    constexpr size_t kMost = 16;
    int32_t* vertices = out.corner_vertices.values.room(kMost);
    int32_t* texcoords = with_slashes ? out.corner_texcoords.values.room(kMost) : nullptr;
    int32_t* normals = with_slashes ? out.corner_normals.values.room(kMost) : nullptr;
    const char* q = p;
    size_t count = 0;
    for (;;) {
      while (*q == ' ') ++q;
      if (is_line_end(*q)) break;
      int32_t vertex, texcoord = kAbsent, normal_index = kAbsent;
      if (count == kMost || !quick_index(q, vertex)) return false;
      if (*q == '/') {
        if (!with_slashes) return false;
        ++q;
        if (*q != '/' && !quick_index(q, texcoord)) return false;
        if (*q == '/' && !quick_index(++q, normal_index)) return false;
      }
      if (static_cast<unsigned char>(*q) > ' ') return false;
      vertices[count] = vertex;
      if (with_slashes) {
        texcoords[count] = texcoord;
        normals[count] = normal_index;
      }
      ++count;
    }
    if (count < 3 || out.face_count == wanted) return false;
    if (count != 3 || !out.face_sizes.empty()) {
      if (out.face_sizes.empty()) out.face_sizes.fill(out.face_count, 3);
      out.face_sizes.append(static_cast<uint32_t>(count));
    }
    out.corner_vertices.values.commit(count);
    if (with_slashes) {
      out.corner_texcoords.values.commit(count);
      out.corner_normals.values.commit(count);
    }
    ++out.face_count;
    p = q;
    return true;
  }

  // True if this is the face looked for.
  bool face() {
    if (quick_face()) [[likely]]
      return false;
    const size_t first = out.corner_vertices.values.size();
    for (;;) {
      skip_blanks();
      if (at_statement_end()) break;
      const char* token = p;
      if (corner()) continue;
      p = token;
      skip_token();
      if (out.remarks.count("face skipped: a corner is not v/vt/vn")) {
        const std::string corner_text = printable(token, p);
        out.remarks.describe("face skipped: a corner is not v/vt/vn", statement,
                             "\"" + corner_text + "\" is not a corner v/vt/vn; face skipped");
      }
      forget_corners(first);
      while (!at_statement_end()) {
        skip_token();
        skip_blanks();
      }
      return false;
    }
    const size_t count = out.corner_vertices.values.size() - first;
    if (count < 3) {
      out.remarks.add("face with fewer than three corners skipped", statement,
                      "a face needs three corners; skipped");
      forget_corners(first);
      return false;
    }
    if (out.face_count == wanted) return true;
    if (count != 3 && out.face_sizes.empty()) out.face_sizes.fill(out.face_count, 3);
    if (count != 3 || !out.face_sizes.empty()) out.face_sizes.append(static_cast<uint32_t>(count));
    ++out.face_count;
    return false;
  }

  void line_element(bool points) {
    IndexList& list = points ? out.point_vertices : out.line_vertices;
    const size_t vertex_count = out.positions.size() / 3;
    int32_t previous = kAbsent;
    bool previous_relative = false;
    size_t count = 0;
    for (;;) {
      skip_blanks();
      if (at_statement_end()) break;
      IndexList scratch;
      int32_t vertex;
      const char* token = p;
      if (!read_index(p, vertex_count, scratch, 0, vertex)) {
        p = token;
        out.remarks.add("line or point with an index that is not a number", statement,
                        "an index here is not a number; the rest is skipped");
        while (!at_statement_end()) {
          skip_token();
          skip_blanks();
        }
        break;
      }
      while (!ends_token(*p)) ++p; // texture coordinates of lines are of no use here
      const bool relative = !scratch.relative.empty();
      if (points) {
        if (relative) list.relative.append(static_cast<uint32_t>(list.values.size()));
        list.values.append(vertex);
      } else if (count) {
        if (previous_relative) list.relative.append(static_cast<uint32_t>(list.values.size()));
        list.values.append(previous);
        if (relative) list.relative.append(static_cast<uint32_t>(list.values.size()));
        list.values.append(vertex);
      }
      previous = vertex;
      previous_relative = relative;
      ++count;
    }
    if (count < (points ? 1u : 2u))
      out.remarks.add("line or point with too few vertices", statement,
                      points ? "a point needs a vertex; skipped" : "a line needs two vertices; skipped");
  }

  // The rest of the line, without blanks at its ends, continued lines included as they stand.
  std::string_view rest_of_line() {
    skip_blanks();
    const char* first = p;
    while (p < end && !is_line_end(*p)) {
      if (*p == '\\' && p + 1 < end && is_line_end(p[1])) p += p[1] == '\r' && p[2] == '\n' ? 2 : 1;
      ++p;
    }
    if (p > end) p = end;
    const char* last = p;
    while (last > first && ends_token(last[-1]) && last[-1] != '#' && last[-1] != '\\') --last;
    return {first, static_cast<size_t>(last - first)};
  }

  void skip_rest() {
    while (p < end && !is_line_end(*p)) {
      if (*p == '\\' && p + 1 < end && is_line_end(p[1])) p += p[1] == '\r' && p[2] == '\n' ? 2 : 1;
      ++p;
    }
  }

  void change(StateChange::Kind kind, std::string_view name, int32_t group = 0) {
    out.changes.push_back({kind, group, name, out.face_count, static_cast<uint32_t>(out.line_vertices.values.size() / 2),
                           static_cast<uint32_t>(out.point_vertices.values.size())});
  }

  void smoothing_group() {
    const std::string_view value = rest_of_line();
    int32_t group = 0;
    for (const char c : value) {
      if (c < '0' || c > '9') break;
      group = group > 100000000 ? 100000000 : group * 10 + (c - '0');
    }
    if (value.substr(0, 2) == "on") group = 1;
    change(StateChange::kSmoothingGroup, {}, group);
  }

  static std::string printable(const char* first, const char* last) {
    std::string text;
    for (; first < last && text.size() < 40; ++first)
      text += static_cast<unsigned char>(*first) < 32 || *first == 127 ? '?' : *first;
    return text;
  }

  void other_statement() {
    const char* first = p;
    while (!ends_token(*p)) ++p;
    if (p == first) ++p; // a lone backslash
    const std::string_view keyword(first, static_cast<size_t>(p - first));
    if (keyword == "usemtl")
      change(StateChange::kMaterial, rest_of_line());
    else if (keyword == "mtllib")
      change(StateChange::kLibrary, rest_of_line());
    else if (keyword == "s")
      smoothing_group();
    else if (keyword == "o")
      change(StateChange::kObject, rest_of_line());
    else if (keyword == "g")
      change(StateChange::kGroup, rest_of_line());
    else if (keyword == "l")
      line_element(false);
    else if (keyword == "p")
      line_element(true);
    else {
      ignored_statement(keyword);
      skip_rest();
    }
  }

  void ignored_statement(std::string_view keyword) {
    static constexpr std::string_view kFreeForm[] = {"cstype", "deg",  "bmat", "step", "curv", "curv2",
                                                     "surf",   "parm", "trim", "hole", "scrv", "sp",
                                                     "end",    "con",  "stech", "ctech"};
    if (std::find(std::begin(kFreeForm), std::end(kFreeForm), keyword) != std::end(kFreeForm)) {
      out.remarks.add_once("free-form", statement, "free-form geometry ignored");
      return;
    }
    const std::string name = printable(keyword.data(), keyword.data() + keyword.size());
    const char* why = keyword == "call" || keyword == "csh" ? " is never executed" : " ignored";
    out.remarks.add_once("keyword " + name, statement, "unknown statement \"" + name + "\"" + why);
  }

  ObjChunk& out;
  const char* p;
  const char* end;
  const char* statement = nullptr;
  const uint32_t wanted;
  bool with_slashes = false;
};

} // namespace

const char* parse_obj_chunk(ObjChunk& chunk, uint32_t find_face) { return ChunkParser(chunk, find_face).parse(); }

} // namespace softgl::cli
