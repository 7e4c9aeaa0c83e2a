// The statements v, vt and vn of an OBJ file. The scanner stands behind the keyword.
#pragma once

#include "obj/obj_chunk.h"
#include "obj/statement_scanner.h"

namespace softgl::cli {

class VertexStatements {
public:
  VertexStatements(StatementScanner& scanner, ObjChunk& chunk) : in_(scanner), out_(chunk) {}
  void position();
  void texture_coordinate();
  void normal();

private:
  bool quick_position();

  StatementScanner& in_;
  ObjChunk& out_;
};

} // namespace softgl::cli
