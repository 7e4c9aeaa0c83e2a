#include "image/texture_loader.h"

#include <algorithm>
#include <memory>

#include "common/program_error.h"
#include "common/source_text.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace softgl::cli {
namespace {

constexpr int64_t kMostTexels = int64_t(1) << 26; // a small file may claim any size

struct FreeImage {
  void operator()(uint8_t* pixels) const { stbi_image_free(pixels); }
};

struct Decoded {
  int width = 0, height = 0, channels = 0;
  std::unique_ptr<uint8_t, FreeImage> pixels; // RGBA, rows from the top
};

bool decode(const std::string& file, Decoded& image, std::string& problem) {
  try {
    const SourceText bytes = SourceText::open(file);
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.begin());
    if (bytes.size() > 0x7fffffff) {
      problem = "is too large";
      return false;
    }
    const int size = int(bytes.size());
    if (!stbi_info_from_memory(data, size, &image.width, &image.height, &image.channels)) {
      problem = "is no PNG, JPEG, BMP or TGA picture that can be read";
      return false;
    }
    if (int64_t(image.width) * image.height > kMostTexels) {
      problem = "has too many pixels";
      return false;
    }
    image.pixels.reset(stbi_load_from_memory(data, size, &image.width, &image.height, &image.channels, 4));
    if (!image.pixels) problem = std::string("cannot be decoded (") + stbi_failure_reason() + ")";
    return image.pixels != nullptr;
  } catch (const ProgramError& error) {
    problem = "cannot be read";
    return false;
  }
}

uint8_t adjusted(uint8_t texel, const TextureReference& map) {
  const float value = map.base + map.gain * (float(texel) / 255.0f);
  return uint8_t(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

} // namespace

bool load_texture(const Material& material, TextureImage& image, std::string& problem) {
  Decoded color, opacity;
  if (!decode(material.diffuse_map.file, color, problem)) return false;
  const auto count = size_t(color.width) * size_t(color.height);
  uint8_t* texels = color.pixels.get();
  const TextureReference& map = material.diffuse_map;
  if (map.base != 0 || map.gain != 1)
    for (size_t i = 0; i < count; ++i)
      for (size_t c = 0; c < 3; ++c) texels[4 * i + c] = adjusted(texels[4 * i + c], map);
  const std::string& opacity_file = material.opacity_map.file;
  std::string ignored;
  if (!opacity_file.empty() && opacity_file != map.file && decode(opacity_file, opacity, ignored)) {
    const bool has_alpha = opacity.channels == 2 || opacity.channels == 4;
    for (int y = 0; y < color.height; ++y)
      for (int x = 0; x < color.width; ++x) {
        const auto ox = size_t(int64_t(x) * opacity.width / color.width);
        const auto oy = size_t(int64_t(y) * opacity.height / color.height);
        const uint8_t* p = opacity.pixels.get() + 4 * (oy * size_t(opacity.width) + ox);
        texels[4 * (size_t(y) * size_t(color.width) + size_t(x)) + 3] = has_alpha ? p[3] : p[0];
      }
  }
  bool opaque = true;
  for (size_t i = 0; i < count && opaque; ++i) opaque = texels[4 * i + 3] == 255;
  image.width = color.width;
  image.height = color.height;
  image.channels = opaque ? 3 : 4;
  const auto channels = size_t(image.channels);
  const auto width = size_t(image.width), height = size_t(image.height);
  uint8_t* out = image.texels.extend(count * channels);
  for (size_t y = 0; y < height; ++y)
    for (size_t x = 0; x < width; ++x)
      for (size_t c = 0; c < channels; ++c) *out++ = texels[4 * ((height - 1 - y) * width + x) + c];
  return true;
}

void fit_texture(TextureImage& image, int largest, bool power_of_two) {
  const auto channels = size_t(image.channels);
  while (image.width > largest || image.height > largest) {
    const int width = std::max(1, image.width / 2), height = std::max(1, image.height / 2);
    GrowingArray<uint8_t> half;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (size_t c = 0; c < channels; ++c) {
          unsigned sum = 0;
          for (int i = 0; i < 4; ++i) {
            const auto sx = size_t(std::min(2 * x + i % 2, image.width - 1));
            const auto sy = size_t(std::min(2 * y + i / 2, image.height - 1));
            sum += image.texels[(sy * size_t(image.width) + sx) * channels + c];
          }
          half.append(uint8_t((sum + 2) / 4));
        }
    image.texels = std::move(half);
    image.width = width;
    image.height = height;
  }
  if (!power_of_two) return;
  int width = 1, height = 1;
  while (width < image.width) width *= 2;
  while (height < image.height) height *= 2;
  if (width > largest) width = largest;
  if (height > largest) height = largest;
  if (width == image.width && height == image.height) return;
  GrowingArray<uint8_t> stretched;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double fx = std::max(0.0, (x + 0.5) * image.width / width - 0.5),
                   fy = std::max(0.0, (y + 0.5) * image.height / height - 0.5);
      const int x0 = int(fx), y0 = int(fy);
      const int x1 = std::min(x0 + 1, image.width - 1), y1 = std::min(y0 + 1, image.height - 1);
      const double ax = fx - x0, ay = fy - y0;
      const auto texel = [&](int sx, int sy, size_t c) {
        return double(image.texels[(size_t(sy) * size_t(image.width) + size_t(sx)) * channels + c]);
      };
      for (size_t c = 0; c < channels; ++c)
        stretched.append(uint8_t((texel(x0, y0, c) * (1 - ax) + texel(x1, y0, c) * ax) * (1 - ay) +
                                 (texel(x0, y1, c) * (1 - ax) + texel(x1, y1, c) * ax) * ay + 0.5));
    }
  image.texels = std::move(stretched);
  image.width = width;
  image.height = height;
}

} // namespace softgl::cli
