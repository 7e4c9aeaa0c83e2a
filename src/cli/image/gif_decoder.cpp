#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include <gif_lib.h>

#include "image/picture_formats.h"

namespace softgl::cli {
namespace {

struct Source {
  const char *at, *end;
};

int take(GifFileType* gif, GifByteType* out, int count) {
  auto* source = static_cast<Source*>(gif->UserData);
  const auto taken = std::min<ptrdiff_t>(count, source->end - source->at);
  std::memcpy(out, source->at, size_t(taken));
  source->at += taken;
  return int(taken);
}

struct CloseGif {
  void operator()(GifFileType* gif) const { DGifCloseFile(gif, nullptr); }
};
using Gif = std::unique_ptr<GifFileType, CloseGif>;

std::string problem(int code) {
  const char* text = GifErrorString(code);
  return std::string("cannot be decoded (") + (text ? text : "damaged") + ")";
}

// Moves to the first image; the transparent color in front of it, or -1. False: there is no image.
bool find_image(GifFileType* gif, int& transparent) {
  GifRecordType record;
  while (DGifGetRecordType(gif, &record) == GIF_OK && record != TERMINATE_RECORD_TYPE) {
    if (record == IMAGE_DESC_RECORD_TYPE) return DGifGetImageDesc(gif) == GIF_OK;
    if (record != EXTENSION_RECORD_TYPE) continue;
    int code = 0;
    GifByteType* block = nullptr; // its length comes first
    if (DGifGetExtension(gif, &code, &block) != GIF_OK) return false;
    while (block) {
      if (code == GRAPHICS_EXT_FUNC_CODE && block[0] >= 4)
        transparent = block[1] & 1 ? block[4] : NO_TRANSPARENT_COLOR;
      if (DGifGetExtensionNext(gif, &block) != GIF_OK) return false;
    }
  }
  return false;
}

} // namespace

// The first image of the file.
std::string decode_gif(const SourceText& bytes, DecodedPicture& picture) {
  Source source{bytes.begin(), bytes.end()};
  int error = 0;
  const Gif gif(DGifOpen(&source, take, &error));
  if (!gif) return problem(error);
  int transparent = NO_TRANSPARENT_COLOR;
  if (!find_image(gif.get(), transparent)) return problem(gif->Error);
  const GifImageDesc& image = gif->Image;
  const ColorMapObject* colors = image.ColorMap ? image.ColorMap : gif->SColorMap;
  if (!colors) return "has no colors";
  if (image.Width < 1 || image.Height < 1) return "is empty";
  if (int64_t(image.Width) * image.Height > kMostTexels) return kTooManyTexels;
  const auto width = size_t(image.Width), height = size_t(image.Height);
  picture.width = picture.file_width = image.Width;
  picture.height = picture.file_height = image.Height;
  uint8_t* texels = picture.rgba.extend(4 * width * height);
  std::vector<GifPixelType> line(width);
  static constexpr struct {
    size_t first, step;
  } kPasses[] = {{0, 8}, {4, 8}, {2, 4}, {1, 2}}, kOnePass = {0, 1};
  for (int pass = 0; pass < (image.Interlace ? 4 : 1); ++pass) {
    const auto [first, step] = image.Interlace ? kPasses[pass] : kOnePass;
    for (size_t y = first; y < height; y += step) {
      if (DGifGetLine(gif.get(), line.data(), image.Width) != GIF_OK) return problem(gif->Error);
      uint8_t* out = texels + 4 * width * y;
      for (const GifPixelType index : line) {
        const GifColorType color = index < colors->ColorCount ? colors->Colors[index] : GifColorType{};
        *out++ = color.Red;
        *out++ = color.Green;
        *out++ = color.Blue;
        *out++ = int(index) == transparent ? 0 : 255;
      }
    }
  }
  return {};
}

} // namespace softgl::cli
