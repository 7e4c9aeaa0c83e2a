#include <new>

#include <webp/decode.h>

#include "image/picture_formats.h"
#include "image/picture_rows.h"

namespace softgl::cli {

// Of an animation nothing is decoded; the library says that it is not supported.
std::string decode_webp(const SourceText& bytes, DecodedPicture& picture) {
  const auto* data = reinterpret_cast<const uint8_t*>(bytes.begin());
  WebPDecoderConfig config;
  if (!WebPInitDecoderConfig(&config)) return "cannot be decoded (another version of the library)";
  if (WebPGetFeatures(data, bytes.size(), &config.input) != VP8_STATUS_OK)
    return "cannot be decoded (no WebP picture)";
  if (int64_t(config.input.width) * config.input.height > most_texels(bytes, true)) return kTooManyTexels;
  picture.file_width = config.input.width;
  picture.file_height = config.input.height;
  const int factor = reduction_of(picture.file_width, picture.file_height);
  picture.width = (picture.file_width + factor - 1) / factor;
  picture.height = (picture.file_height + factor - 1) / factor;
  if (factor > 1) {
    config.options.use_scaling = 1;
    config.options.scaled_width = picture.width;
    config.options.scaled_height = picture.height;
  }
  const size_t size = size_t(4) * size_t(picture.width) * size_t(picture.height);
  config.output.colorspace = MODE_RGBA;
  config.output.is_external_memory = 1;
  config.output.u.RGBA.rgba = picture.rgba.extend(size);
  config.output.u.RGBA.stride = 4 * picture.width;
  config.output.u.RGBA.size = size;
  const VP8StatusCode status = WebPDecode(data, bytes.size(), &config);
  WebPFreeDecBuffer(&config.output);
  if (status == VP8_STATUS_OUT_OF_MEMORY) throw std::bad_alloc();
  return status == VP8_STATUS_OK                    ? std::string()
         : status == VP8_STATUS_UNSUPPORTED_FEATURE ? "cannot be decoded (an animation)"
                                                    : "cannot be decoded (damaged)";
}

} // namespace softgl::cli
