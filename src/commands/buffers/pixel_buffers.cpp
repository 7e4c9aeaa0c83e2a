#include "commands/buffers/pixel_buffers.h"

#include <algorithm>

#include "commands/buffers/buffer_contents.h"
#include "context/context.h"

namespace softgl {
namespace {

/// Whether the bytes of the span from `offset` on lie in the buffer; else the error is set.
bool holds(Context& c, const BufferObject& buffer, size_t offset, PixelSpan span) {
  if (!buffer.mapped && offset % span.element == 0 && offset <= buffer.size() &&
      span.bytes <= buffer.size() - offset)
    return true;
  set_error(c, GL_INVALID_OPERATION);
  return false;
}

} // namespace

PixelSpan image_span(const PixelStore& store, const ImageLayout& layout, int height, int depth,
                     const PixelFormat& format) {
  const size_t element = std::max<size_t>(format.element_bytes, 1);
  // The layout's numbers wrap around where the skipped pixels are more than there is memory.
  const double rows = double(store.skip_rows) + height,
               images = (double(store.skip_images) + depth) * std::max(store.image_height, height);
  if (double(layout.row_stride) * (rows + images) > double(size_t(1) << 60)) return {SIZE_MAX, element};
  return {layout.offset + size_t(depth - 1) * layout.image_stride + size_t(height - 1) * layout.row_stride +
              layout.row_bytes,
          element};
}

bool find_unpack_memory(Context& c, const void*& pixels, PixelSpan span) {
  const BufferObject* buffer = c.client.pixel_store.unpack_buffer.object.get();
  if (!buffer) return true;
  const size_t offset = reinterpret_cast<size_t>(pixels);
  if (!holds(c, *buffer, offset, span)) return false;
  pixels = buffer->storage ? buffer->storage->bytes + offset : nullptr;
  return true;
}

bool find_pack_memory(Context& c, void*& pixels, PixelSpan span) {
  BufferObject* buffer = c.client.pixel_store.pack_buffer.object.get();
  if (!buffer) return true;
  const size_t offset = reinterpret_cast<size_t>(pixels);
  if (!holds(c, *buffer, offset, span)) return false;
  make_writable(c, *buffer);
  pixels = buffer->storage ? buffer->storage->bytes + offset : nullptr;
  return true;
}

} // namespace softgl
