#include "image/texture_loader.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>

#include "common/program_error.h"
#include "common/source_text.h"

namespace softgl::cli {
namespace {

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

// Empty: it worked; else why not, as half a sentence.
std::string decode_bytes(const SourceText& bytes, Decoded& image) {
  if (bytes.size() > 0x7fffffff) return "is too large";
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.begin());
  const int size = int(bytes.size());
  if (!stbi_info_from_memory(data, size, &image.width, &image.height, &image.channels))
    return "is no PNG, JPEG, BMP or TGA picture that can be read";
  if (int64_t(image.width) * image.height > kMostTexels) return "has too many pixels";
  image.pixels.reset(stbi_load_from_memory(data, size, &image.width, &image.height, &image.channels, 4));
  return image.pixels ? std::string() : std::string("cannot be decoded (") + stbi_failure_reason() + ")";
}

bool decode(const std::string& file, Decoded& image, std::string& problem) {
  out_of_memory = false;
  try {
    problem = decode_bytes(SourceText::open(file), image);
  } catch (const ProgramError&) { problem = "cannot be read"; }
  if (out_of_memory) throw std::bad_alloc();
  return problem.empty();
}

uint8_t adjusted(uint8_t texel, const TextureReference& map) {
  const float value = map.base + map.gain * (float(texel) / 255.0f);
  return uint8_t(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

// The opacity picture's alpha, or its gray, stretched over the color picture.
void replace_alpha(Decoded& color, const Decoded& opacity) {
  const bool has_alpha = opacity.channels == 2 || opacity.channels == 4;
  uint8_t* alpha = color.pixels.get() + 3;
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x, alpha += 4) {
      const auto ox = size_t(int64_t(x) * opacity.width / color.width);
      const auto oy = size_t(int64_t(y) * opacity.height / color.height);
      const uint8_t* p = opacity.pixels.get() + 4 * (oy * size_t(opacity.width) + ox);
      *alpha = has_alpha ? p[3] : p[0];
    }
}

const uint8_t* texel_at(const TextureImage& image, int x, int y) {
  return &image.texels[(size_t(y) * size_t(image.width) + size_t(x)) * size_t(image.channels)];
}

void replace_texels(TextureImage& image, int width, int height, GrowingArray<uint8_t> texels) {
  image.texels = std::move(texels);
  image.width = width;
  image.height = height;
}

void halve(TextureImage& image) {
  const int width = std::max(1, image.width / 2), height = std::max(1, image.height / 2);
  GrowingArray<uint8_t> half;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < image.channels; ++c) {
        unsigned sum = 0;
        for (int i = 0; i < 4; ++i)
          sum += texel_at(image, std::min(2 * x + i % 2, image.width - 1),
                          std::min(2 * y + i / 2, image.height - 1))[c];
        half.append(uint8_t((sum + 2) / 4));
      }
  replace_texels(image, width, height, std::move(half));
}

void stretch(TextureImage& image, int width, int height) {
  GrowingArray<uint8_t> stretched;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double fx = std::max(0.0, (x + 0.5) * image.width / width - 0.5),
                   fy = std::max(0.0, (y + 0.5) * image.height / height - 0.5);
      const int x0 = int(fx), y0 = int(fy);
      const int x1 = std::min(x0 + 1, image.width - 1), y1 = std::min(y0 + 1, image.height - 1);
      const double ax = fx - x0, ay = fy - y0;
      const auto texel = [&](int sx, int sy, int c) { return double(texel_at(image, sx, sy)[c]); };
      for (int c = 0; c < image.channels; ++c)
        stretched.append(uint8_t((texel(x0, y0, c) * (1 - ax) + texel(x1, y0, c) * ax) * (1 - ay) +
                                 (texel(x0, y1, c) * (1 - ax) + texel(x1, y1, c) * ax) * ay + 0.5));
    }
  replace_texels(image, width, height, std::move(stretched));
}

} // namespace

bool load_texture(const Material& material, TextureImage& image, std::string& problem) {
  Decoded color, opacity;
  const TextureReference& map = material.diffuse_map;
  if (!decode(map.file, color, problem)) return false;
  const auto count = size_t(color.width) * size_t(color.height);
  uint8_t* texels = color.pixels.get();
  if (map.base != 0 || map.gain != 1)
    for (size_t i = 0; i < count; ++i)
      for (size_t c = 0; c < 3; ++c) texels[4 * i + c] = adjusted(texels[4 * i + c], map);
  const std::string& opacity_file = material.opacity_map.file;
  std::string ignored;
  if (!opacity_file.empty() && opacity_file != map.file && decode(opacity_file, opacity, ignored))
    replace_alpha(color, opacity);
  bool opaque = true;
  for (size_t i = 0; i < count && opaque; ++i) opaque = texels[4 * i + 3] == 255;
  image.width = color.width;
  image.height = color.height;
  image.channels = opaque ? 3 : 4;
  const auto channels = size_t(image.channels), width = size_t(image.width), height = size_t(image.height);
  uint8_t* out = image.texels.extend(count * channels);
  for (size_t y = 0; y < height; ++y)
    for (size_t x = 0; x < width; ++x)
      for (size_t c = 0; c < channels; ++c) *out++ = texels[4 * ((height - 1 - y) * width + x) + c];
  return true;
}

void fit_texture(TextureImage& image, int largest, bool power_of_two) {
  while (image.width > largest || image.height > largest) halve(image);
  if (!power_of_two) return;
  int width = 1, height = 1;
  while (width < image.width) width *= 2;
  while (height < image.height) height *= 2;
  width = std::min(width, largest);
  height = std::min(height, largest);
  if (width != image.width || height != image.height) stretch(image, width, height);
}

} // namespace softgl::cli
