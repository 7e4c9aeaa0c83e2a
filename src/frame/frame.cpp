#include "frame/frame.h"

namespace softgl {

void Frame::flush(const Surface&) {
  items_.clear();
  retained_.clear();
  arena_.reset();
}

} // namespace softgl
