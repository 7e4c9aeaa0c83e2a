// Buffer objects as the memory of pixel commands (GL_ARB_pixel_buffer_object): what their pointers mean.
#pragma once

#include <cstddef>

#include "base/gl_types.h"
#include "texture/pixel_formats.h"

namespace softgl {

struct Context;
struct PixelStore;

/// The bytes of client memory that a command touches, from its pointer on.
struct PixelSpan {
  size_t bytes = 0;   // up to the last one; SIZE_MAX when no memory holds them
  size_t element = 1; // the size of the data type: offsets are multiples of it
};
/// Of an image with the layout that layout_image() gave for `store`. No size is 0.
PixelSpan image_span(const PixelStore& store, const ImageLayout& layout, int height, int depth,
                     const PixelFormat& format);
/// Of `count` values, one behind the other.
inline PixelSpan array_span(size_t count, size_t element) { return {count * element, element}; }

/// Makes the argument of a command that reads pixels an address: of the bound unpack buffer, or the client's
/// own, which it is already. False, and GL_INVALID_OPERATION, when the buffer is mapped, or too small, or the
/// offset is not one of the data type.
bool find_unpack_memory(Context& c, const void*& pixels, PixelSpan span);
/// The same for a command that writes pixels, and the pack buffer, which must not wait for a frame any more.
/// Throws std::bad_alloc.
bool find_pack_memory(Context& c, void*& pixels, PixelSpan span);

} // namespace softgl
