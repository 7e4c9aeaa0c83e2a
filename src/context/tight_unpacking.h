// How display lists keep images: in tight rows, alignment 1, no skips, host byte order, most significant bit
// first.
#pragma once

#include <utility>

#include "context/context.h"

namespace softgl {

/// While alive, the unpacking state is the one of keep_image (commands/vertices), and images come from
/// memory, not from a buffer.
class TightUnpacking {
public:
  explicit TightUnpacking(Context& c)
      : c_(c), saved_(c.client.pixel_store.unpack),
        saved_buffer_(std::move(c.client.pixel_store.unpack_buffer)) {
    c.client.pixel_store.unpack = PixelStore{};
    c.client.pixel_store.unpack.alignment = 1;
    c.client.pixel_store.unpack_buffer = BufferBinding{};
  }
  ~TightUnpacking() {
    c_.client.pixel_store.unpack = saved_;
    c_.client.pixel_store.unpack_buffer = std::move(saved_buffer_);
  }
  TightUnpacking(const TightUnpacking&) = delete;
  TightUnpacking& operator=(const TightUnpacking&) = delete;

private:
  Context& c_;
  PixelStore saved_;
  BufferBinding saved_buffer_;
};

} // namespace softgl
