#include <algorithm>
#include <cstring>
#include <memory>

#include <dlfcn.h>
#include <tiffio.h>

#include "image/picture_formats.h"

namespace softgl::cli {
namespace {

struct Source {
  const char *begin, *end, *at;
};

tmsize_t take(thandle_t handle, void* out, tmsize_t count) {
  auto* source = static_cast<Source*>(handle);
  const auto taken = std::min<tmsize_t>(count, source->end - source->at);
  std::memcpy(out, source->at, size_t(taken));
  source->at += taken;
  return taken;
}

tmsize_t write_nothing(thandle_t, void*, tmsize_t) { return -1; }

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  auto* source = static_cast<Source*>(handle);
  const auto size = toff_t(source->end - source->begin);
  const toff_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? toff_t(source->at - source->begin) : size;
  const toff_t place = from + offset;
  if (place > size) return toff_t(-1);
  source->at = source->begin + place;
  return place;
}

int close_nothing(thandle_t) { return 0; }

toff_t size_of(thandle_t handle) {
  const auto* source = static_cast<Source*>(handle);
  return toff_t(source->end - source->begin);
}

// The functions of libtiff that are called. The library is loaded with the first TIFF picture.
struct Library {
  decltype(&TIFFClientOpen) open = nullptr;
  decltype(&TIFFClose) close = nullptr;
  decltype(&TIFFGetField) get_field = nullptr;
  decltype(&TIFFReadRGBAImageOriented) read = nullptr;
  bool complete = false;

  Library() {
    void* library = nullptr;
    for (const char* name : {"libtiff.so.6", "libtiff.so.5"})
      if (!library) library = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (!library) return;
    decltype(&TIFFSetErrorHandler) set_error_handler = nullptr;
    decltype(&TIFFSetWarningHandler) set_warning_handler = nullptr;
    complete = find(library, "TIFFClientOpen", open) && find(library, "TIFFClose", close) &&
               find(library, "TIFFGetField", get_field) && find(library, "TIFFReadRGBAImageOriented", read) &&
               find(library, "TIFFSetErrorHandler", set_error_handler) &&
               find(library, "TIFFSetWarningHandler", set_warning_handler);
    if (!complete) return;
    set_error_handler(nullptr); // else it writes to standard error
    set_warning_handler(nullptr);
  }

  template <class Function> static bool find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(::dlsym(library, name));
    return function != nullptr;
  }
};

struct CloseTiff {
  decltype(&TIFFClose) close;
  void operator()(TIFF* tiff) const { close(tiff); }
};

} // namespace

std::string decode_tiff(const SourceText& bytes, DecodedPicture& picture) {
  static const Library library;
  if (!library.complete) return "is of kind TIFF, and there is no libtiff.so.6 to read it";
  Source source{bytes.begin(), bytes.end(), bytes.begin()};
  // "m": the file is not mapped into memory, where it is already.
  const std::unique_ptr<TIFF, CloseTiff> tiff(library.open("picture", "rm", &source, take, write_nothing,
                                                           seek, close_nothing, size_of, nullptr, nullptr),
                                              CloseTiff{library.close});
  uint32_t width = 0, height = 0;
  if (!tiff || !library.get_field(tiff.get(), TIFFTAG_IMAGEWIDTH, &width) ||
      !library.get_field(tiff.get(), TIFFTAG_IMAGELENGTH, &height) || width == 0 || height == 0)
    return "cannot be decoded (no TIFF image in it)";
  if (width > 0xffffff || height > 0xffffff || int64_t(width) * height > kMostTexels) return kTooManyTexels;
  uint16_t samples = 1, bits = 1;
  library.get_field(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
  library.get_field(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
  if (samples > 8 || bits > 16) return "cannot be decoded (of an unusual kind)"; // strips are in memory whole
  picture.width = picture.file_width = int(width);
  picture.height = picture.file_height = int(height);
  const size_t count = size_t(width) * height;
  uint8_t* texels = picture.rgba.extend(4 * count);
  // ABGR from the highest byte of a 32-bit word: RGBA in memory, color multiplied by alpha.
  if (!library.read(tiff.get(), width, height, reinterpret_cast<uint32_t*>(texels), ORIENTATION_TOPLEFT, 1))
    return "cannot be decoded (damaged, or of an unusual kind)";
  for (uint8_t* p = texels; p < texels + 4 * count; p += 4)
    if (p[3] != 0 && p[3] != 255)
      for (int c = 0; c < 3; ++c) p[c] = uint8_t(std::min(255, (p[c] * 255 + p[3] / 2) / p[3]));
  return {};
}

} // namespace softgl::cli
