#include "image/image_writer.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "image/png_encoder.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace softgl::cli {
namespace {

constexpr const char* kWrittenFormats[] = {"png", "ppm", "pam", "jpg",  "jpeg", "bmp",
                                           "tga", "raw", "gif", "apng", "pfm",  "exr"};

void append_bytes(void* context, void* data, int size) {
  static_cast<GrowingArray<uint8_t>*>(context)->append(static_cast<const uint8_t*>(data), size_t(size));
}

} // namespace

Picture as_rgb(const Picture& picture) {
  Picture result;
  result.width = picture.width;
  result.height = picture.height;
  if (picture.channels == 3) {
    result.pixels.append(picture.pixels.data(), picture.pixels.size());
    return result;
  }
  const size_t count = size_t(picture.width) * size_t(picture.height);
  uint8_t* out = result.pixels.extend(3 * count);
  if (picture.channels == 1) {
    for (size_t i = 0; i < count; ++i) std::fill_n(out + 3 * i, 3, picture.pixels[i]);
    return result;
  }
  for (size_t i = 0; i < count; ++i) {
    const uint8_t* p = &picture.pixels[4 * i];
    for (size_t c = 0; c < 3; ++c) out[3 * i + c] = uint8_t((p[c] * p[3] + 255 * (255 - p[3]) + 127) / 255);
  }
  return result;
}

namespace {

void append_text(GrowingArray<uint8_t>& out, const std::string& text) {
  out.append(reinterpret_cast<const uint8_t*>(text.data()), text.size());
}

} // namespace

std::vector<std::string> image_formats() { return {std::begin(kWrittenFormats), std::end(kWrittenFormats)}; }

bool is_image_format(const std::string& format) {
  return std::find(std::begin(kWrittenFormats), std::end(kWrittenFormats), format) !=
         std::end(kWrittenFormats);
}

bool has_alpha(const std::string& format) {
  return format == "png" || format == "apng" || format == "gif" || format == "pam" || format == "tga" ||
         format == "raw" || format == "exr";
}
bool is_animation(const std::string& format) { return format == "gif" || format == "apng"; }

std::string image_format_of(const std::string& path) {
  const size_t dot = path.rfind('.');
  if (dot == std::string::npos || path.find('/', dot) != std::string::npos) return {};
  std::string end = path.substr(dot + 1);
  for (char& c : end) c = char(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return is_image_format(end) ? end : std::string();
}

GrowingArray<uint8_t> encode_image(const Picture& picture, const std::string& format, PngEffort effort) {
  if (format == "png") return encode_png(picture, effort);
  if (picture.channels == 1) return encode_image(as_rgb(picture), format, effort);
  if (picture.channels == 4 && !has_alpha(format)) return encode_image(as_rgb(picture), format, effort);
  GrowingArray<uint8_t> out;
  if (format == "raw") {
    out.append(picture.pixels.data(), picture.pixels.size());
    return out;
  }
  const std::string size = std::to_string(picture.width) + " " + std::to_string(picture.height);
  if (format == "ppm") {
    append_text(out, "P6\n" + size + "\n255\n");
    out.append(picture.pixels.data(), picture.pixels.size());
  } else if (format == "pam") {
    append_text(out, "P7\nWIDTH " + std::to_string(picture.width) + "\nHEIGHT " +
                         std::to_string(picture.height) + "\nDEPTH " + std::to_string(picture.channels) +
                         "\nMAXVAL 255\nTUPLTYPE " + (picture.channels == 4 ? "RGB_ALPHA" : "RGB") +
                         "\nENDHDR\n");
    out.append(picture.pixels.data(), picture.pixels.size());
  } else if (format == "bmp") {
    stbi_write_bmp_to_func(append_bytes, &out, picture.width, picture.height, picture.channels,
                           picture.pixels.data());
  } else if (format == "tga") {
    stbi_write_tga_to_func(append_bytes, &out, picture.width, picture.height, picture.channels,
                           picture.pixels.data());
  } else {
    stbi_write_jpg_to_func(append_bytes, &out, picture.width, picture.height, picture.channels,
                           picture.pixels.data(), 92);
  }
  return out;
}

} // namespace softgl::cli
