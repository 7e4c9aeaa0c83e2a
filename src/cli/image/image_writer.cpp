#include "image/image_writer.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

#include "common/program_error.h"
#include "common/time_limit.h"
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

constexpr const char* kFormats[] = {"png", "ppm", "pam", "jpg", "jpeg", "bmp", "tga"};

void append_bytes(void* context, void* data, int size) {
  static_cast<GrowingArray<uint8_t>*>(context)->append(static_cast<const uint8_t*>(data), size_t(size));
}

Picture over_white(const Picture& picture) {
  Picture result;
  result.width = picture.width;
  result.height = picture.height;
  const size_t count = size_t(picture.width) * size_t(picture.height);
  uint8_t* out = result.pixels.extend(3 * count);
  for (size_t i = 0; i < count; ++i) {
    const uint8_t* p = &picture.pixels[4 * i];
    for (size_t c = 0; c < 3; ++c) out[3 * i + c] = uint8_t((p[c] * p[3] + 255 * (255 - p[3]) + 127) / 255);
  }
  return result;
}

void append_text(GrowingArray<uint8_t>& out, const std::string& text) {
  out.append(reinterpret_cast<const uint8_t*>(text.data()), text.size());
}

} // namespace

bool is_image_format(const std::string& format) {
  return std::find(std::begin(kFormats), std::end(kFormats), format) != std::end(kFormats);
}

bool has_alpha(const std::string& format) { return format == "png" || format == "pam" || format == "tga"; }

std::string image_format_of(const std::string& path) {
  const size_t dot = path.rfind('.');
  if (dot == std::string::npos || path.find('/', dot) != std::string::npos) return {};
  std::string end = path.substr(dot + 1);
  for (char& c : end) c = char(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return is_image_format(end) ? end : std::string();
}

GrowingArray<uint8_t> encode_image(const Picture& picture, const std::string& format, PngEffort effort) {
  if (format == "png") return encode_png(picture, effort);
  if (picture.channels == 4 && !has_alpha(format)) return encode_image(over_white(picture), format, effort);
  GrowingArray<uint8_t> out;
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

void write_file(const std::string& path, const GrowingArray<uint8_t>& bytes) {
  const bool standard_output = path == "-";
  const std::string name = standard_output ? "standard output" : path;
  const int file =
      standard_output ? STDOUT_FILENO : ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw ProgramError(kCannotWrite, name + ": cannot write: " + std::strerror(errno));
  std::optional<UnfinishedFile> unfinished;
  if (!standard_output) unfinished.emplace(path);
  size_t written = 0;
  int problem = 0;
  while (written < bytes.size() && problem == 0) {
    const ssize_t count = ::write(file, bytes.data() + written, bytes.size() - written);
    if (count >= 0)
      written += size_t(count);
    else if (errno != EINTR)
      problem = errno;
  }
  if (!standard_output && ::close(file) != 0 && problem == 0) problem = errno;
  if (problem == 0) return;
  struct stat status {};
  if (!standard_output && ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode))
    ::unlink(path.c_str());
  throw ProgramError(kCannotWrite, name + ": cannot write: " + std::strerror(problem));
}

} // namespace softgl::cli
