#include "image/gif_encoder.h"

#include <algorithm>
#include <memory>
#include <new>

#include "common/program_error.h"

#ifdef SOFTGL_HAVE_GIF
#include <gif_lib.h>
#endif

namespace softgl::cli {

#ifdef SOFTGL_HAVE_GIF
namespace {

constexpr int kColors = 256, kTransparent = 255;
constexpr int kStep = 8; // giflib's quantization takes 5 bits of a color

struct FreeMap {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using ColorMap = std::unique_ptr<ColorMapObject, FreeMap>;

ColorMap make_map(int count, const GifColorType* colors) {
  ColorMap map(GifMakeMapObject(count, colors));
  if (!map) throw std::bad_alloc();
  return map;
}

// Bayer's pattern, from 0 to 15: soft shades become dots instead of bands.
int threshold(int x, int y) {
  static constexpr uint8_t kPattern[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
  return kPattern[y & 3][x & 3];
}

int append(GifFileType* file, const GifByteType* bytes, int count) {
  static_cast<GrowingArray<uint8_t>*>(file->UserData)->append(bytes, size_t(count));
  return count;
}

[[noreturn]] void fail() { throw ProgramError(kCannotWrite, "giflib cannot write this animation"); }

void append_frame(GifFileType* gif, const GifFrame& frame, int hundredths) {
  GraphicsControlBlock control{};
  control.DisposalMode = frame.transparent ? DISPOSE_BACKGROUND : DISPOSE_DO_NOT;
  control.DelayTime = hundredths;
  control.TransparentColor = frame.transparent ? kTransparent : NO_TRANSPARENT_COLOR;
  GifByteType bytes[4];
  EGifGCBToExtension(&control, bytes);
  const ColorMap map =
      make_map(kColors, reinterpret_cast<const GifColorType*>(frame.palette.data())); // three bytes each
  if (EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, sizeof bytes, bytes) == GIF_ERROR ||
      EGifPutImageDesc(gif, 0, 0, frame.width, frame.height, false, map.get()) == GIF_ERROR)
    fail();
  GrowingArray<uint8_t> row; // giflib writes into what it is given
  row.extend(size_t(frame.width));
  for (int y = 0; y < frame.height; ++y) {
    std::copy_n(&frame.indices[size_t(y) * size_t(frame.width)], frame.width, row.data());
    if (EGifPutLine(gif, row.data(), frame.width) == GIF_ERROR) fail();
  }
}

} // namespace

bool can_write_gif() { return true; }

GifFrame encode_gif_frame(const Picture& picture) {
  GifFrame frame;
  frame.width = picture.width;
  frame.height = picture.height;
  frame.transparent = picture.channels == 4;
  const size_t count = size_t(picture.width) * size_t(picture.height), channels = size_t(picture.channels);
  GrowingArray<uint8_t> planes[3];
  for (GrowingArray<uint8_t>& plane : planes) plane.extend(count);
  for (size_t i = 0; i < count; ++i) {
    const int x = int(i % size_t(picture.width)), y = int(i / size_t(picture.width));
    const int up = threshold(x, y) * kStep / 16 - kStep / 2;
    for (size_t c = 0; c < 3; ++c)
      planes[c][i] = uint8_t(std::clamp(picture.pixels[channels * i + c] + up, 0, 255));
  }
  int colors = frame.transparent ? kColors - 1 : kColors;
  GifColorType map[kColors] = {};
  frame.indices.extend(count);
  if (GifQuantizeBuffer(unsigned(picture.width), unsigned(picture.height), &colors, planes[0].data(),
                        planes[1].data(), planes[2].data(), frame.indices.data(), map) == GIF_ERROR)
    throw std::bad_alloc(); // it fails for no other reason
  for (const GifColorType& color : map)
    for (const uint8_t value : {color.Red, color.Green, color.Blue}) frame.palette.append(value);
  if (frame.transparent)
    for (size_t i = 0; i < count; ++i)
      if (picture.pixels[4 * i + 3] < 128) frame.indices[i] = kTransparent;
  return frame;
}

GrowingArray<uint8_t> assemble_gif(const std::vector<GifFrame>& frames, int frames_per_second) {
  GrowingArray<uint8_t> out;
  int error = 0;
  GifFileType* gif = EGifOpen(&out, append, &error);
  if (!gif) throw std::bad_alloc();
  struct Closer {
    GifFileType* gif;
    ~Closer() {
      int ignored;
      if (gif) EGifCloseFile(gif, &ignored);
    }
  } closer{gif};
  EGifSetGifVersion(gif, true);
  const GifFrame& first = frames.front();
  // Played for ever: Netscape's extension.
  const GifByteType again[3] = {1, 0, 0};
  if (EGifPutScreenDesc(gif, first.width, first.height, 8, 0, nullptr) == GIF_ERROR ||
      EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE) == GIF_ERROR ||
      EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0") == GIF_ERROR ||
      EGifPutExtensionBlock(gif, sizeof again, again) == GIF_ERROR ||
      EGifPutExtensionTrailer(gif) == GIF_ERROR)
    fail();
  const auto time_of = [&](size_t frame) { // in hundredths of a second
    return int((200 * frame + size_t(frames_per_second)) / (2 * size_t(frames_per_second)));
  };
  for (size_t i = 0; i < frames.size(); ++i) append_frame(gif, frames[i], time_of(i + 1) - time_of(i));
  closer.gif = nullptr;
  if (EGifCloseFile(gif, &error) == GIF_ERROR) fail();
  return out;
}

#else

bool can_write_gif() { return false; }

GifFrame encode_gif_frame(const Picture&) { return {}; }

GrowingArray<uint8_t> assemble_gif(const std::vector<GifFrame>&, int) {
  throw ProgramError(kUsageError, "this softgl was built without giflib and writes no GIF");
}

#endif

} // namespace softgl::cli
