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
