#include "image/picture_reader.h"

#include <algorithm>
#include <memory>
#include <string_view>

#include "common/program_error.h"
#include "common/source_text.h"
#include "image/netpbm_reader.h"
#include "image/picture_decoder.h"

#include "image/stb_image_functions.h"

namespace softgl::cli {
namespace {

struct FreeImage {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

template <class Sample> void take(const Sample* samples, float divisor, PictureSamples& picture) {
  const size_t count = 4 * size_t(picture.width) * size_t(picture.height);
  float* out = picture.values.extend(count);
  for (size_t i = 0; i < count; ++i) out[i] = float(samples[i]) / divisor;
  for (size_t i = 3; i < count && !picture.alpha; i += 4) picture.alpha = out[i] < 255;
}

PictureSamples read_jpeg(const std::string& path, const SourceText& bytes) {
  DecodedPicture decoded;
  const std::string problem = decode_picture(bytes, decoded);
  if (!problem.empty()) throw ProgramError(kCannotRead, path + ": the picture " + problem);
  if (decoded.width != decoded.file_width || decoded.height != decoded.file_height)
    throw ProgramError(kCannotRead, path + ": the picture has too many pixels");
  PictureSamples picture;
  picture.width = decoded.width;
  picture.height = decoded.height;
  take(decoded.rgba.data(), 1, picture);
  return picture;
}

} // namespace

PictureSamples read_picture(const std::string& path) {
  const SourceText bytes = SourceText::open(path);
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.begin());
  const int size = int(std::min<size_t>(bytes.size(), 0x7fffffff));
  PictureSamples picture;
  if (read_netpbm({bytes.begin(), bytes.size()}, picture)) return picture;
  if (std::string_view(bytes.begin(), bytes.size()).starts_with("\xff\xd8\xff"))
    return read_jpeg(path, bytes);
  int channels = 0;
  if (!stbi_info_from_memory(data, size, &picture.width, &picture.height, &channels))
    throw ProgramError(kCannotRead,
                       path + ": no picture that can be read (PNG, JPEG, BMP, TGA, PPM, PGM, PFM)");
  if (count_texels(picture.width, picture.height) > kMostPixels)
    throw ProgramError(kCannotRead, path + ": the picture has too many pixels");
  std::unique_ptr<void, FreeImage> pixels;
  if (stbi_is_16_bit_from_memory(data, size)) {
    pixels.reset(stbi_load_16_from_memory(data, size, &picture.width, &picture.height, &channels, 4));
    if (pixels) take(static_cast<const uint16_t*>(pixels.get()), 257, picture);
  } else {
    pixels.reset(stbi_load_from_memory(data, size, &picture.width, &picture.height, &channels, 4));
    if (pixels) take(static_cast<const uint8_t*>(pixels.get()), 1, picture);
  }
  if (!pixels) throw ProgramError(kCannotRead, path + ": the picture is damaged: " + stbi_failure_reason());
  return picture;
}

bool is_readable_picture(const std::string& path) {
  static constexpr const char* kEnds[] = {".png", ".jpg", ".jpeg", ".bmp", ".tga", ".ppm", ".pgm", ".pfm"};
  std::string name = path;
  for (char& c : name) c = char(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return std::any_of(std::begin(kEnds), std::end(kEnds),
                     [&](const char* end) { return name.ends_with(end); });
}

} // namespace softgl::cli
