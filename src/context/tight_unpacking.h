// How display lists keep images: in tight rows, alignment 1, no skips, host byte order, most significant bit
// first.
#pragma once

#include "context/context.h"

namespace softgl {

/// While alive, the unpacking state is the one of keep_image (commands/vertices).
class TightUnpacking {
public:
  explicit TightUnpacking(Context& c) : c_(c), saved_(c.client.pixel_store.unpack) {
    c.client.pixel_store.unpack = PixelStore{};
    c.client.pixel_store.unpack.alignment = 1;
  }
  ~TightUnpacking() { c_.client.pixel_store.unpack = saved_; }

private:
  Context& c_;
  PixelStore saved_;
};

} // namespace softgl
