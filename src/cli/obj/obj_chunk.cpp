#include "obj/obj_chunk.h"

#include "obj/element_statements.h"
#include "obj/vertex_statements.h"

#include <algorithm>

namespace softgl::cli {
namespace {

class ChunkParser {
public:
  ChunkParser(ObjChunk& chunk, uint32_t find_face)
      : out(chunk), in{chunk.begin, chunk.end}, vertices(in, chunk), elements(in, chunk, find_face) {}

  const char* parse() {
    while (in.p < in.end) {
      in.skip_blanks();
      if (in.p >= in.end) break;
      in.statement = in.p;
      switch (*in.p) {
      case 'v': vertex_statement(); break;
      case 'f':
        if (StatementScanner::is_blank(in.p[1])) {
          in.p += 1;
          if (elements.face()) return in.statement;
        } else if (in.p[1] == 'o' &&
                   StatementScanner::is_blank(in.p[2])) { // `fo`: the name of `f` in old files
          in.p += 2;
          if (elements.face()) return in.statement;
        } else {
          other_statement();
        }
        break;
      case '#': in.finish_line(); continue;
      case '\n':
      case '\r': break;
      default: other_statement();
      }
      in.end_statement();
    }
    return nullptr;
  }

private:
  void vertex_statement() {
    if (StatementScanner::is_blank(in.p[1])) {
      in.p += 1;
      vertices.position();
    } else if (in.p[1] == 't' && StatementScanner::is_blank(in.p[2])) {
      in.p += 2;
      vertices.texture_coordinate();
    } else if (in.p[1] == 'n' && StatementScanner::is_blank(in.p[2])) {
      in.p += 2;
      vertices.normal();
    } else if (in.p[1] == 'p' && StatementScanner::is_blank(in.p[2])) {
      in.skip_rest(); // parameter-space points belong to free-form geometry
    } else if (ends_token(in.p[1])) {
      in.p += 1;
      vertices.position(); // `v` alone still counts as a vertex
    } else {
      other_statement();
    }
  }

  void change(StateChange::Kind kind, std::string_view name, int32_t group = 0) {
    out.changes.push_back({kind, group, name, out.face_count,
                           static_cast<uint32_t>(out.line_vertices.values.size() / 2),
                           static_cast<uint32_t>(out.point_vertices.values.size())});
  }

  void smoothing_group() {
    const std::string_view value = in.rest_of_line();
    int32_t group = 0;
    for (const char c : value) {
      if (c < '0' || c > '9') break;
      group = group > 100000000 ? 100000000 : group * 10 + (c - '0');
    }
    if (value.substr(0, 2) == "on") group = 1;
    change(StateChange::kSmoothingGroup, {}, group);
  }

  void other_statement() {
    const char* first = in.p;
    while (!ends_token(*in.p)) ++in.p;
    if (in.p == first) ++in.p; // a lone backslash
    const std::string_view keyword(first, static_cast<size_t>(in.p - first));
    if (keyword == "usemtl")
      change(StateChange::kMaterial, in.rest_of_line());
    else if (keyword == "mtllib")
      change(StateChange::kLibrary, in.rest_of_line());
    else if (keyword == "s")
      smoothing_group();
    else if (keyword == "o")
      change(StateChange::kObject, in.rest_of_line());
    else if (keyword == "g")
      change(StateChange::kGroup, in.rest_of_line());
    else if (keyword == "l")
      elements.line();
    else if (keyword == "p")
      elements.point();
    else {
      ignored_statement(keyword);
      in.skip_rest();
    }
  }

  void ignored_statement(std::string_view keyword) {
    static constexpr std::string_view kFreeForm[] = {"cstype", "deg",  "bmat",  "step", "curv", "curv2",
                                                     "surf",   "parm", "trim",  "hole", "scrv", "sp",
                                                     "end",    "con",  "stech", "ctech"};
    if (std::find(std::begin(kFreeForm), std::end(kFreeForm), keyword) != std::end(kFreeForm)) {
      out.remarks.add_once("free-form", in.statement, "free-form geometry ignored");
      return;
    }
    const std::string name = StatementScanner::printable(keyword.data(), keyword.data() + keyword.size());
    const char* why = keyword == "call" || keyword == "csh" ? " is never executed" : " ignored";
    out.remarks.add_once("keyword " + name, in.statement, "unknown statement \"" + name + "\"" + why);
  }

  ObjChunk& out;
  StatementScanner in;
  VertexStatements vertices;
  ElementStatements elements;
};

} // namespace

const char* parse_obj_chunk(ObjChunk& chunk, uint32_t find_face) {
  return ChunkParser(chunk, find_face).parse();
}

} // namespace softgl::cli
