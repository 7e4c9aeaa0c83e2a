#include <cstdlib>
#include <new>
#include <string_view>

#include "image/picture_formats.h"

namespace softgl::cli {
namespace {

constexpr int64_t kMostTgaTexelsPerByte = 64;

bool out_of_memory = false; // stb_image has asked in vain: its own messages do not always say so

void* noticed(void* memory) {
  if (!memory) out_of_memory = true;
  return memory;
}

} // namespace
} // namespace softgl::cli

#define STBI_MALLOC(size) softgl::cli::noticed(std::malloc(size))
#define STBI_REALLOC(memory, size) softgl::cli::noticed(std::realloc(memory, size))
#define STBI_FREE(memory) std::free(memory)
#include "image/stb_image_functions.h"

namespace softgl::cli {

std::string decode_with_stb(const SourceText& bytes, DecodedPicture& picture) {
  out_of_memory = false;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.begin());
  const int size = int(bytes.size());
  int channels = 0;
  if (!stbi_info_from_memory(data, size, &picture.width, &picture.height, &channels))
    return "is of no kind of picture that can be read";
  const int64_t texels = count_texels(picture.width, picture.height);
  if (texels > kMostTexels) return kTooManyTexels; // it reads all at once
  // TGA packs 128 texels into two bytes at best, and what is cut off would be read as zeros.
  const bool png = std::string_view(bytes.begin(), bytes.size()).starts_with("\x89PNG");
  if (!png && texels > kMostTgaTexelsPerByte * size) return kTooManyTexels;
  stbi_uc* pixels = stbi_load_from_memory(data, size, &picture.width, &picture.height, &channels, 4);
  if (out_of_memory) {
    stbi_image_free(pixels);
    throw std::bad_alloc();
  }
  if (!pixels) return std::string("cannot be decoded (") + stbi_failure_reason() + ")";
  picture.file_width = picture.width;
  picture.file_height = picture.height;
  picture.rgba =
      GrowingArray<uint8_t>::adopt(pixels, size_t(4) * size_t(picture.width) * size_t(picture.height));
  return {};
}

} // namespace softgl::cli
