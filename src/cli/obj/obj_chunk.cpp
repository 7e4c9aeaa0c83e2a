#include "obj/obj_chunk.h"

#include <algorithm>
#include <cstring>

#include "obj/element_statements.h"
#include "obj/vertex_statements.h"

namespace softgl::cli {
namespace {

class ChunkParser {
public:
  ChunkParser(ObjChunk& chunk, uint32_t find_face)
      : out_(chunk), in_{chunk.begin, chunk.end}, vertices_(in_, chunk), elements_(in_, chunk, find_face) {}

  const char* parse() {
    while (in_.p < in_.end) {
      in_.skip_blanks();
      if (in_.p >= in_.end) break;
      in_.statement = in_.p;
      switch (*in_.p) {
      case 'v': vertex_statement(); break;
      case 'f':
        if (StatementScanner::is_blank(in_.p[1])) {
          in_.p += 1;
          if (elements_.face()) return in_.statement;
        } else if (in_.p[1] == 'o' &&
                   StatementScanner::is_blank(in_.p[2])) { // `fo`: the name of `f` in old files
          in_.p += 2;
          if (elements_.face()) return in_.statement;
        } else {
          other_statement();
        }
        break;
      case '#':
        if (std::strncmp(in_.p, "#MRGB ", 6) == 0) painted_vertices();
        in_.finish_line();
        continue;
      case '\n':
      case '\r': break;
      default: other_statement();
      }
      in_.end_statement();
    }
    return nullptr;
  }

private:
  void vertex_statement() {
    if (StatementScanner::is_blank(in_.p[1])) {
      in_.p += 1;
      vertices_.position();
    } else if (in_.p[1] == 't' && StatementScanner::is_blank(in_.p[2])) {
      in_.p += 2;
      vertices_.texture_coordinate();
    } else if (in_.p[1] == 'n' && StatementScanner::is_blank(in_.p[2])) {
      in_.p += 2;
      vertices_.normal();
    } else if (in_.p[1] == 'p' && StatementScanner::is_blank(in_.p[2])) {
      in_.skip_rest(); // parameter-space points belong to free-form geometry
    } else if (ends_token(in_.p[1])) {
      in_.p += 1;
      vertices_.position(); // `v` alone still counts as a vertex
    } else {
      other_statement();
    }
  }

  // For each vertex eight hexadecimal digits: a mask, red, green, blue.
  void painted_vertices() {
    const auto digit = [](char c) {
      return c >= '0' && c <= '9' ? c - '0' : (c | 32) >= 'a' && (c | 32) <= 'f' ? (c | 32) - 'a' + 10 : -1;
    };
    for (const char* q = in_.p + 6;; q += 8) {
      int values[8];
      for (int i = 0; i < 8; ++i)
        if ((values[i] = digit(q[i])) < 0) return; // the text ends with a zero byte
      for (int i = 2; i < 8; i += 2) out_.painted.append(float(16 * values[i] + values[i + 1]) / 255.0f);
    }
  }

  void change(StateChange::Kind kind, std::string_view name, int32_t group = 0) {
    out_.changes.push_back({kind, group, name, out_.face_count,
                            uint32_t(out_.line_vertices.values.size() / 2),
                            uint32_t(out_.point_vertices.values.size())});
  }

  void smoothing_group() {
    const std::string_view value = in_.rest_of_line();
    int32_t group = 0;
    for (const char c : value) {
      if (c < '0' || c > '9') break;
      group = group > 100000000 ? 100000000 : group * 10 + (c - '0');
    }
    if (value.substr(0, 2) == "on") group = 1;
    change(StateChange::kSmoothingGroup, {}, group);
  }

  void other_statement() {
    const char* first = in_.p;
    while (!ends_token(*in_.p)) ++in_.p;
    if (in_.p == first) ++in_.p; // a lone backslash
    const std::string_view keyword(first, size_t(in_.p - first));
    if (keyword == "usemtl")
      change(StateChange::kMaterial, in_.rest_of_line());
    else if (keyword == "mtllib")
      change(StateChange::kLibrary, in_.rest_of_line());
    else if (keyword == "s")
      smoothing_group();
    else if (keyword == "o")
      change(StateChange::kObject, in_.rest_of_line());
    else if (keyword == "g")
      change(StateChange::kGroup, in_.rest_of_line());
    else if (keyword == "l")
      elements_.line();
    else if (keyword == "p")
      elements_.point();
    else {
      ignored_statement(keyword);
      in_.skip_rest();
    }
  }

  void ignored_statement(std::string_view keyword) {
    static constexpr std::string_view kFreeForm[] = {"cstype", "deg",  "bmat",  "step", "curv", "curv2",
                                                     "surf",   "parm", "trim",  "hole", "scrv", "sp",
                                                     "end",    "con",  "stech", "ctech"};
    if (std::find(std::begin(kFreeForm), std::end(kFreeForm), keyword) != std::end(kFreeForm)) {
      out_.remarks.add_once("free-form", in_.statement, "free-form geometry ignored");
      return;
    }
    const std::string name = printable(keyword, 40);
    const char* why = keyword == "call" || keyword == "csh" ? " is never executed" : " ignored";
    out_.remarks.add_once("keyword " + name, in_.statement, "unknown statement \"" + name + "\"" + why);
  }

  ObjChunk& out_;
  StatementScanner in_;
  VertexStatements vertices_;
  ElementStatements elements_;
};

} // namespace

const char* parse_obj_chunk(ObjChunk& chunk, uint32_t find_face) {
  return ChunkParser(chunk, find_face).parse();
}

} // namespace softgl::cli
