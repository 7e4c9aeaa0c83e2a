#include "image/texture_loader.h"

#include <algorithm>

#include "common/program_error.h"
#include "common/source_text.h"
#include "image/picture_decoder.h"

namespace softgl::cli {
namespace {

constexpr int64_t kTexelsPerByte = 64;

// False: a warning says why.
bool read_picture(const std::string& file, DecodedPicture& picture, TexelBudget& budget, Warnings& warnings) {
  std::string problem;
  try {
    const SourceText bytes = SourceText::open_named(file);
    if (budget.left > 0) {
      problem = decode_picture(bytes, picture);
      const int64_t free = budget.files.insert(file).second ? kTexelsPerByte * int64_t(bytes.size()) : 0;
      budget.left -= std::max<int64_t>(0, int64_t(picture.file_width) * picture.file_height - free);
    } else {
      problem = "is left out: the pictures before it have too many pixels for the size of their files";
    }
  } catch (const ProgramError&) { problem = "cannot be read"; }
  if (!problem.empty()) {
    warnings.add(file, "this picture " + problem);
    return false;
  }
  const auto size = [](int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
  };
  if (picture.file_width != picture.width || picture.file_height != picture.height)
    warnings.add_notice(file, "this picture of " + size(picture.file_width, picture.file_height) +
                                  " pixels was reduced to " + size(picture.width, picture.height));
  return true;
}

size_t texel_count(const DecodedPicture& picture) { return size_t(picture.width) * size_t(picture.height); }

bool has_alpha(const DecodedPicture& picture) {
  const size_t count = texel_count(picture);
  for (size_t i = 0; i < count; ++i)
    if (picture.rgba[4 * i + 3] != 255) return true;
  return false;
}

uint8_t adjusted(uint8_t texel, const TextureReference& map) {
  const float value = map.base + map.gain * (float(texel) / 255.0f);
  return uint8_t(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

void adjust(DecodedPicture& picture, const TextureReference& map, size_t first, size_t last) {
  if (map.base == 0 && map.gain == 1) return;
  const size_t count = texel_count(picture);
  for (size_t i = 0; i < count; ++i)
    for (size_t c = first; c < last; ++c) picture.rgba[4 * i + c] = adjusted(picture.rgba[4 * i + c], map);
}

// The opacity of each texel becomes its alpha: that of the file where it has any, else the gray.
void make_opacity(DecodedPicture& picture, const TextureReference& map) {
  const size_t count = texel_count(picture);
  if (!has_alpha(picture))
    for (size_t i = 0; i < count; ++i) picture.rgba[4 * i + 3] = picture.rgba[4 * i];
  adjust(picture, map, 3, 4);
}

// The opacity picture is stretched over the color picture.
void replace_alpha(DecodedPicture& color, const DecodedPicture& opacity) {
  uint8_t* alpha = color.rgba.data() + 3;
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x, alpha += 4) {
      const auto ox = size_t(int64_t(x) * opacity.width / color.width);
      const auto oy = size_t(int64_t(y) * opacity.height / color.height);
      *alpha = opacity.rgba[4 * (oy * size_t(opacity.width) + ox) + 3];
    }
}

template <size_t kChannels> void copy_channels(const uint8_t* in, size_t count, uint8_t* out) {
  for (size_t i = 0; i < count; ++i, in += 4, out += kChannels)
    for (size_t c = 0; c < kChannels; ++c) out[c] = in[c];
}

// `channels` channels (1, 3 or 4) from `first` on, rows from the bottom.
void take_channels(const DecodedPicture& picture, size_t first, int channels, TextureImage& image) {
  image.width = picture.width;
  image.height = picture.height;
  image.channels = channels;
  const auto width = size_t(image.width), height = size_t(image.height);
  uint8_t* out = image.texels.extend(width * height * size_t(channels));
  const auto copy = channels == 4 ? copy_channels<4> : channels == 3 ? copy_channels<3> : copy_channels<1>;
  for (size_t y = 0; y < height; ++y, out += width * size_t(channels))
    copy(&picture.rgba[4 * (height - 1 - y) * width + first], width, out);
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

// A picture without an opaque texel would show nothing: then its alpha means something else.
bool uses_alpha(const DecodedPicture& color, const TextureReference& map, Warnings& warnings) {
  if (!map.alpha || !has_alpha(color)) return false;
  const size_t count = texel_count(color);
  for (size_t i = 0; i < count; ++i)
    if (color.rgba[4 * i + 3] != 0) return true;
  warnings.add_notice(map.file, "this picture is transparent everywhere; it is drawn without its alpha");
  return false;
}

} // namespace

bool load_texture(const Material& material, TextureImage& image, TexelBudget& budget, Warnings& warnings) {
  DecodedPicture color, opacity;
  const TextureReference &color_map = material.diffuse_map, &opacity_map = material.opacity_map;
  const bool has_color = !color_map.file.empty() && read_picture(color_map.file, color, budget, warnings);
  const bool has_opacity = !opacity_map.file.empty() && opacity_map.file != color_map.file &&
                           read_picture(opacity_map.file, opacity, budget, warnings);
  if (has_opacity) make_opacity(opacity, opacity_map);
  if (!has_color) {
    if (has_opacity) take_channels(opacity, 3, 1, image);
    return has_opacity;
  }
  adjust(color, color_map, 0, 3);
  if (has_opacity) {
    replace_alpha(color, opacity);
    opacity.rgba.release();
  }
  const bool transparent = has_opacity ? has_alpha(color) : uses_alpha(color, color_map, warnings);
  take_channels(color, 0, transparent ? 4 : 3, image);
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
