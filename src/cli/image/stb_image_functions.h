// stb_image with the kinds of pictures that it reads here, its functions of the including file alone: files
// choose their own STBI_MALLOC before. Not JPEG: its decoder of 2022 writes behind a table where a file says
// so (CVE-2022-28042 and the like); libjpeg reads those.
#pragma once

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace softgl::cli {

// What stbi_info says of a size. A BMP file whose first row is the upper one has a height below 0 there.
inline int64_t count_texels(int width, int height) {
  const int64_t count = int64_t(width) * height;
  return count < 0 ? -count : count;
}

} // namespace softgl::cli
