#include "image/netpbm_reader.h"

#include <bit>
#include <cstdlib>
#include <string>

namespace softgl::cli {
namespace {

class NetpbmReader {
public:
  NetpbmReader(std::string_view bytes, PictureSamples& picture) : bytes_(bytes), picture_(picture) {}

  bool read() {
    if (bytes_.size() < 2 || bytes_[0] != 'P') return false;
    const char kind = bytes_[1];
    at_ = 2;
    const bool floats = kind == 'f' || kind == 'F';
    if (!floats && kind != '5' && kind != '6') return false;
    channels_ = kind == '6' || kind == 'F' ? 3 : 1;
    const double width = number(), height = number(), scale = number();
    ++at_; // one blank
    if (!(width >= 1 && height >= 1 && width <= 16384 && height <= 16384) || scale == 0) return false;
    picture_.width = int(width);
    picture_.height = int(height);
    if (floats)
      return take(
          4, [scale](const uint8_t* p) { return float_of(p, scale < 0) * 255; }, true);
    if (!(scale >= 1 && scale <= 65535)) return false;
    const auto most = float(scale);
    if (scale < 256)
      return take(
          1, [most](const uint8_t* p) { return float(*p) * 255 / most; }, false);
    return take(
        2, [most](const uint8_t* p) { return float(p[0] * 256 + p[1]) * 255 / most; }, false);
  }

private:
  // The next word of the header as a number, 0 if it is none.
  double number() {
    while (at_ < bytes_.size() && (is_blank(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#')
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      else
        ++at_;
    }
    std::string word;
    while (at_ < bytes_.size() && !is_blank(bytes_[at_]) && word.size() < 32) word += bytes_[at_++];
    return std::strtod(word.c_str(), nullptr);
  }

  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  static float float_of(const uint8_t* p, bool little) {
    uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits |= uint32_t(p[i]) << (little ? 8 * i : 24 - 8 * i);
    return std::bit_cast<float>(bits);
  }

  template <class Sample> bool take(size_t size, Sample sample, bool from_below) {
    const size_t columns = size_t(picture_.width), rows = size_t(picture_.height),
                 row = columns * channels_ * size;
    if (int64_t(columns * rows) > kMostPixels || at_ > bytes_.size() || (bytes_.size() - at_) / row < rows)
      return false;
    float* out = picture_.values.extend(4 * columns * rows);
    for (size_t y = 0; y < rows; ++y) {
      const auto* p =
          reinterpret_cast<const uint8_t*>(bytes_.data()) + at_ + (from_below ? rows - 1 - y : y) * row;
      for (size_t x = 0; x < columns; ++x, out += 4, p += channels_ * size) {
        for (size_t c = 0; c < 3; ++c) out[c] = sample(p + (channels_ == 3 ? c * size : 0));
        out[3] = 255;
      }
    }
    return true;
  }

  std::string_view bytes_;
  PictureSamples& picture_;
  size_t at_ = 0, channels_ = 1;
};

} // namespace

bool read_netpbm(std::string_view bytes, PictureSamples& picture) {
  return NetpbmReader(bytes, picture).read();
}

} // namespace softgl::cli
