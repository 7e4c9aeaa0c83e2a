#include "image/picture_decoder.h"

#include <string_view>

#include "image/picture_formats.h"

namespace softgl::cli {
namespace {

using Decoder = std::string (*)(const SourceText&, DecodedPicture&);

// What the build has no library for goes to stb_image where that can read it, else nowhere.
#ifdef SOFTGL_HAVE_PNG
constexpr Decoder kPng = decode_png;
#else
constexpr Decoder kPng = decode_with_stb;
#endif
#ifdef SOFTGL_HAVE_JPEG
constexpr Decoder kJpeg = decode_jpeg;
#else
constexpr Decoder kJpeg = nullptr;
#endif
#ifdef SOFTGL_HAVE_GIF
constexpr Decoder kGif = decode_gif;
#else
constexpr Decoder kGif = nullptr;
#endif
#ifdef SOFTGL_HAVE_TIFF
constexpr Decoder kTiff = decode_tiff;
#else
constexpr Decoder kTiff = nullptr;
#endif
#ifdef SOFTGL_HAVE_WEBP
constexpr Decoder kWebp = decode_webp;
#else
constexpr Decoder kWebp = nullptr;
#endif

struct Format {
  std::string_view start;
  const char* name;
  Decoder decoder;
};

constexpr Format kFormats[] = {
    {"\x89PNG", "PNG", kPng},
    {"\xff\xd8\xff", "JPEG", kJpeg},
    {"GIF8", "GIF", kGif},
    {std::string_view("II*\0", 4), "TIFF", kTiff},
    {std::string_view("MM\0*", 4), "TIFF", kTiff},
    {"RIFF", "WebP", kWebp},
    {"BM", "BMP", decode_with_stb},
    {"DDS ", "DDS", nullptr},
    {"\x76\x2f\x31\x01", "OpenEXR", nullptr},
    {"#?RADIANCE", "Radiance HDR", nullptr},
    {"8BPS", "Photoshop", nullptr},
    {"\xabKTX", "KTX", nullptr},
};

} // namespace

std::string decode_picture(const SourceText& bytes, DecodedPicture& picture) {
  if (bytes.size() == 0) return "is empty";
  if (bytes.size() > 0x7fffffff) return "is too large";
  const std::string_view all(bytes.begin(), bytes.size());
  for (const Format& format : kFormats)
    if (all.substr(0, format.start.size()) == format.start) {
      if (!format.decoder)
        return std::string("is of kind ") + format.name + ", which this program cannot read";
      return format.decoder(bytes, picture);
    }
  return decode_with_stb(bytes, picture); // TGA has no mark at its start
}

} // namespace softgl::cli
