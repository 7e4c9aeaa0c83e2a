#include "image/float_formats.h"

#include <bit>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "common/program_error.h"

#ifdef SOFTGL_HAVE_TINYEXR
#include <tinyexr.h>
#endif

namespace softgl::cli {
namespace {

// http://www.pauldebevec.com/Research/HDR/PFM/: rows from the bottom; a negative scale means little-endian.
GrowingArray<uint8_t> encode_pfm(const FloatPicture& picture) {
  static_assert(std::endian::native == std::endian::little);
  GrowingArray<uint8_t> out;
  const size_t channels = size_t(picture.channels), kept = channels == 1 ? 1 : 3;
  const std::string header = std::string(kept == 1 ? "Pf" : "PF") + "\n" + std::to_string(picture.width) +
                             " " + std::to_string(picture.height) + "\n-1.0\n";
  out.append(reinterpret_cast<const uint8_t*>(header.data()), header.size());
  for (size_t y = size_t(picture.height); y-- > 0;)
    for (size_t x = 0; x < size_t(picture.width); ++x) {
      const float* p = &picture.values[(y * size_t(picture.width) + x) * channels];
      out.append(reinterpret_cast<const uint8_t*>(p), kept * sizeof(float));
    }
  return out;
}

#ifdef SOFTGL_HAVE_TINYEXR
struct Free {
  void operator()(void* memory) const { std::free(memory); }
};

GrowingArray<uint8_t> encode_exr(const FloatPicture& picture) {
  const int channels = picture.channels;
  const size_t count = size_t(picture.width) * size_t(picture.height);
  // A file's channels stand in alphabetical order: A B G R.
  GrowingArray<float> planes;
  planes.extend(count * size_t(channels));
  std::vector<float*> images;
  std::vector<EXRChannelInfo> infos(static_cast<size_t>(channels));
  std::vector<int> types(size_t(channels), TINYEXR_PIXELTYPE_FLOAT);
  for (int c = 0; c < channels; ++c) {
    const int source = channels - 1 - c;
    float* plane = planes.data() + size_t(c) * count;
    for (size_t i = 0; i < count; ++i) {
      const float* p = &picture.values[i * size_t(channels)];
      plane[i] = p[source] * (channels == 4 && source < 3 ? p[3] : 1); // OpenEXR multiplies colors by alpha
    }
    images.push_back(plane);
    infos[size_t(c)] = EXRChannelInfo{};
    infos[size_t(c)].name[0] = channels == 1 ? 'Y' : "RGBA"[source];
  }
  std::vector<EXRAttribute> attributes;
  for (const PictureNote& note : picture.notes) {
    EXRAttribute attribute{};
    std::strncpy(attribute.name, note.name.c_str(), sizeof attribute.name - 1);
    std::strcpy(attribute.type, "string");
    attribute.value = reinterpret_cast<unsigned char*>(const_cast<char*>(note.text.data()));
    attribute.size = int(note.text.size());
    attributes.push_back(attribute);
  }
  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = channels;
  header.channels = infos.data();
  header.pixel_types = types.data();
  header.requested_pixel_types = types.data();
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  header.num_custom_attributes = int(attributes.size());
  header.custom_attributes = attributes.data();
  EXRImage image;
  InitEXRImage(&image);
  image.num_channels = channels;
  image.images = reinterpret_cast<unsigned char**>(images.data());
  image.width = picture.width;
  image.height = picture.height;
  unsigned char* memory = nullptr;
  const char* problem = nullptr;
  const size_t size = SaveEXRImageToMemory(&image, &header, &memory, &problem);
  const std::unique_ptr<unsigned char, Free> owner(memory);
  if (size == 0) {
    const std::string sentence = problem ? problem : "unknown error";
    FreeEXRErrorMessage(problem);
    throw ProgramError(kCannotWrite, "tinyexr cannot write this picture: " + sentence);
  }
  GrowingArray<uint8_t> out;
  out.append(memory, size);
  return out;
}
#endif

} // namespace

bool is_float_format(const std::string& format) { return format == "pfm" || format == "exr"; }

#ifdef SOFTGL_HAVE_TINYEXR
bool can_write_exr() { return true; }
#else
bool can_write_exr() { return false; }
#endif

GrowingArray<uint8_t> encode_floats(const FloatPicture& picture, const std::string& format) {
  if (format == "pfm") return encode_pfm(picture);
#ifdef SOFTGL_HAVE_TINYEXR
  return encode_exr(picture);
#else
  throw ProgramError(kUsageError, "this softgl was built without tinyexr and writes no OpenEXR");
#endif
}

} // namespace softgl::cli
