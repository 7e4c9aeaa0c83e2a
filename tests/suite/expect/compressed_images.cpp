// Images of compressed texels (3.8.3, GL_EXT_texture_compression_s3tc).
#include <algorithm>
#include <array>

#include "expect/calls.h"

namespace softgl::suite {
namespace {

constexpr int kBlock = 4; // texels along each side

using Color = std::array<Interval, 4>;

// An integer of `bytes` bytes, the least one first.
uint64_t integer(const std::vector<double>& memory, size_t at, int bytes) {
  uint64_t value = 0;
  for (int i = 0; i < bytes; i++) value |= uint64_t(memory.at(at + size_t(i))) << (8 * i);
  return value;
}

// A part of `a` and the rest of `b`. A GL may have rounded both to bytes, and the result.
Interval mixed(double a, double b, double part) {
  const double off = part == 1 ? 0.6 : 1.6;
  return spec::clamped(spec::widened(part * a + (1 - part) * b, off / 255), 0, 1);
}

// The colors of the 16 texels of a block. Only GL_COMPRESSED_*_DXT1 have the mode of three colors.
void block_colors(const std::vector<double>& memory, size_t at, GLenum format, Color texels[16]) {
  const uint64_t color[2] = {integer(memory, at, 2), integer(memory, at + 2, 2)},
                 codes = integer(memory, at + 4, 4);
  const bool dxt1 = format == GL_COMPRESSED_RGB_S3TC_DXT1_EXT || format == GL_COMPRESSED_RGBA_S3TC_DXT1_EXT;
  const bool three = dxt1 && color[0] <= color[1];
  const auto component = [&](int i, int c) {
    return c == 0   ? double(color[i] >> 11) / 31
           : c == 1 ? double(color[i] >> 5 & 63) / 63
                    : double(color[i] & 31) / 31;
  };
  for (int i = 0; i < 16; i++) {
    const uint64_t code = codes >> (2 * i) & 3;
    const bool black = three && code == 3;
    const double part = code == 0 ? 1 : code == 1 ? 0 : three ? 0.5 : code == 2 ? 2.0 / 3 : 1.0 / 3;
    for (int c = 0; c < 3; c++)
      texels[i][size_t(c)] = black       ? Interval(0)
                             : code == 1 ? mixed(component(1, c), 0, 1)
                                         : mixed(component(0, c), component(1, c), part);
    texels[i][3] = black && format == GL_COMPRESSED_RGBA_S3TC_DXT1_EXT ? 0 : 1;
  }
}

void block_alphas(const std::vector<double>& memory, size_t at, GLenum format, Color texels[16]) {
  if (format == GL_COMPRESSED_RGBA_S3TC_DXT3_EXT) {
    for (int i = 0; i < 16; i++)
      texels[i][3] = mixed(double(integer(memory, at, 8) >> (4 * i) & 15) / 15, 0, 1);
    return;
  }
  const double alpha[2] = {memory.at(at) / 255, memory.at(at + 1) / 255};
  const uint64_t codes = integer(memory, at + 2, 6);
  for (int i = 0; i < 16; i++) {
    const int code = int(codes >> (3 * i) & 7), steps = alpha[0] > alpha[1] ? 7 : 5;
    Interval& a = texels[i][3];
    if (code < 2)
      a = mixed(alpha[code], 0, 1);
    else if (steps == 5 && code >= 6)
      a = code - 6;
    else
      a = mixed(alpha[0], alpha[1], double(steps + 1 - code) / steps);
  }
}

} // namespace

bool Machine::play_compressed_images(const Call& call) {
  const bool whole = call.command == Command::CompressedTexImage2D;
  if (!whole && call.command != Command::CompressedTexSubImage2D) return false;
  const auto n = [&](size_t i) { return int(call.n(i)); };
  int face = 0;
  TextureObject& texture = state_.texture.bound(state_.texture.active, texture_target(call.e(0), &face));
  TextureImage& image = texture.images[face][n(1)];
  const int left = whole ? 0 : n(2), bottom = whole ? 0 : n(3), width = whole ? n(3) : n(4),
            height = whole ? n(4) : n(5);
  const GLenum format = whole ? call.e(2) : call.e(6);
  if (whole) {
    image = {};
    image.width = width, image.height = height, image.depth = 1;
    image.internal_format = format, image.base = base_format(format),
    image.texels.resize(size_t(width * height));
  }
  const bool alphas =
      format == GL_COMPRESSED_RGBA_S3TC_DXT3_EXT || format == GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;
  const std::vector<double>& memory = call.v(whole ? 7 : 8);
  size_t at = 0;
  for (int y = 0; y < height; y += kBlock)
    for (int x = 0; x < width; x += kBlock) {
      Color texels[kBlock * kBlock];
      block_colors(memory, at + (alphas ? 8 : 0), format, texels);
      if (alphas) block_alphas(memory, at, format, texels);
      at += alphas ? 16 : 8;
      for (int j = 0; j < std::min(kBlock, height - y); j++)
        for (int i = 0; i < std::min(kBlock, width - x); i++)
          std::copy_n(texels[kBlock * j + i].begin(), 4, image.at(left + x + i, bottom + y + j, 0).c);
    }
  return true;
}

} // namespace softgl::suite
