#include "models/picture_files.h"

#include <memory>
#include <stdexcept>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_GIF
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace softgl::test {
namespace {

struct FreeImage {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};
using Pixels = std::unique_ptr<stbi_uc, FreeImage>;

const stbi_uc* data_of(const std::string& bytes) { return reinterpret_cast<const stbi_uc*>(bytes.data()); }

uint32_t number_at(const std::string& bytes, size_t at) {
  uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i) value = value << 8 | uint8_t(bytes[at + i]);
  return value;
}

std::string number(size_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += char(value >> shift);
  return bytes;
}

} // namespace

TestPicture decode_picture(const std::string& bytes) {
  TestPicture picture;
  int channels;
  const Pixels pixels(stbi_load_from_memory(data_of(bytes), int(bytes.size()), &picture.width,
                                            &picture.height, &channels, 3));
  if (!pixels) throw std::runtime_error("no picture");
  picture.rgb.assign(pixels.get(), pixels.get() + 3 * size_t(picture.width) * size_t(picture.height));
  return picture;
}

std::vector<uint8_t> decode_alpha(const std::string& bytes) {
  int width, height, channels;
  const Pixels pixels(
      stbi_load_from_memory(data_of(bytes), int(bytes.size()), &width, &height, &channels, 4));
  if (!pixels) throw std::runtime_error("no picture");
  std::vector<uint8_t> alpha;
  for (size_t i = 0; i < size_t(width) * size_t(height); ++i) alpha.push_back(pixels.get()[4 * i + 3]);
  return alpha;
}

std::vector<TestPicture> decode_gif(const std::string& bytes) {
  int* delays = nullptr;
  int width, height, frames, channels;
  const Pixels pixels(stbi_load_gif_from_memory(data_of(bytes), int(bytes.size()), &delays, &width, &height,
                                                &frames, &channels, 4));
  if (!pixels) throw std::runtime_error("no GIF");
  stbi_image_free(delays);
  std::vector<TestPicture> pictures;
  const size_t count = size_t(width) * size_t(height);
  for (size_t frame = 0; frame < size_t(frames); ++frame) {
    pictures.push_back({width, height, {}});
    for (size_t i = 0; i < count; ++i)
      for (size_t c = 0; c < 3; ++c) pictures.back().rgb.push_back(pixels.get()[4 * (frame * count + i) + c]);
  }
  return pictures;
}

std::vector<std::string> png_chunks(const std::string& bytes, const std::string& type) {
  std::vector<std::string> found;
  for (size_t at = 8; at + 12 <= bytes.size();) {
    const size_t size = number_at(bytes, at);
    if (bytes.substr(at + 4, 4) == type) found.push_back(bytes.substr(at + 8, size));
    at += size + 12;
  }
  return found;
}

std::vector<TestPicture> decode_apng(const std::string& bytes) {
  std::vector<std::string> frames = png_chunks(bytes, "IDAT");
  for (const std::string& chunk : png_chunks(bytes, "fdAT")) frames.push_back(chunk.substr(4));
  const auto chunk = [](const std::string& type, const std::string& data) {
    return number(data.size()) + type + data + std::string(4, '\0'); // stb_image asks for no checksum
  };
  std::vector<TestPicture> pictures;
  for (const std::string& frame : frames)
    pictures.push_back(decode_picture(bytes.substr(0, 8) + chunk("IHDR", png_chunks(bytes, "IHDR").at(0)) +
                                      chunk("IDAT", frame) + chunk("IEND", "")));
  return pictures;
}

} // namespace softgl::test
