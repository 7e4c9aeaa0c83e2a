// The statements f, l and p of an OBJ file. The scanner stands behind the keyword.
#pragma once

#include "obj/obj_chunk.h"
#include "obj/statement_scanner.h"

namespace softgl::cli {

class ElementStatements {
public:
  ElementStatements(StatementScanner& scanner, ObjChunk& chunk, uint32_t wanted_face)
      : in_(scanner), out_(chunk), wanted_(wanted_face) {}
  // True if this is the face looked for.
  bool face();
  void line() { segments_or_points(false); }
  void point() { segments_or_points(true); }

private:
  bool quick_face();
  bool corner();
  void forget_corners(size_t size);
  void segments_or_points(bool points);

  StatementScanner& in_;
  ObjChunk& out_;
  const uint32_t wanted_;
  bool with_slashes_ = false; // some corner before had one
};

} // namespace softgl::cli
