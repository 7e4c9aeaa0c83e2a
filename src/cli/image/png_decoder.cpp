#include <csetjmp>
#include <cstring>
#include <new>

#include <png.h>

#include "image/picture_formats.h"
#include "image/picture_rows.h"

namespace softgl::cli {
namespace {

class PngReader {
public:
  PngReader(const SourceText& bytes, DecodedPicture& picture)
      : picture_(picture), at_(bytes.begin()), end_(bytes.end()), most_texels_(most_texels(bytes, false)) {}
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  std::string read() {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, say_nothing);
    if (!png_ || !(info_ = png_create_info_struct(png_))) throw std::bad_alloc();
    if (!start()) return problem();
    const int64_t width = png_get_image_width(png_, info_), height = png_get_image_height(png_, info_);
    const bool interlaced = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
    if (width * height > (interlaced ? kMostTexels : most_texels_))
      return interlaced ? "is interlaced and has too many pixels" : kTooManyTexels;
    if (height * int64_t(png_get_rowbytes(png_, info_)) > 4 * most_texels_) return kTooManyTexels;
    picture_.file_width = int(width);
    picture_.file_height = int(height);
    if (!begin_rows()) return problem();
    if (interlaced) return read_passes(size_t(width), size_t(height)) ? std::string() : problem();
    PictureRows rows(picture_, int(width), int(height));
    for (int64_t y = 0; y < height; ++y) {
      if (!read_row(rows.next_row())) return problem();
      rows.add_written();
    }
    return {};
  }

private:
  // Each of these holds nothing that a destructor would have to free: fail() jumps out of them.

  bool start() {
    if (setjmp(escape_)) return false;
    png_set_user_limits(png_, 1 << 24, 1 << 24);
    png_set_chunk_malloc_max(png_, 1 << 24);
    png_set_crc_action(png_, PNG_CRC_QUIET_USE, PNG_CRC_QUIET_USE); // a picture with a wrong sum is still one
    png_set_read_fn(png_, this, take);
    png_read_info(png_, info_);
    return true;
  }

  bool begin_rows() {
    if (setjmp(escape_)) return false;
    png_set_expand(png_);
    png_set_strip_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_filler(png_, 255, PNG_FILLER_AFTER);
    passes_ = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return png_get_rowbytes(png_, info_) == size_t(4) * png_get_image_width(png_, info_);
  }

  bool read_row(uint8_t* row) {
    if (setjmp(escape_)) return false;
    png_read_row(png_, row, nullptr);
    return true;
  }

  bool read_passes(size_t width, size_t height) {
    picture_.width = int(width);
    picture_.height = int(height);
    uint8_t* texels = picture_.rgba.extend(4 * width * height);
    for (int pass = 0; pass < passes_; ++pass)
      for (size_t y = 0; y < height; ++y)
        if (!read_row(texels + 4 * width * y)) return false;
    return true;
  }

  static void take(png_structp png, png_bytep out, size_t count) {
    auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
    if (size_t(reader->end_ - reader->at_) < count) png_error(png, "the file ends too early");
    std::memcpy(out, reader->at_, count);
    reader->at_ += count;
  }

  [[noreturn]] static void fail(png_structp png, png_const_charp message) {
    auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
    std::strncpy(reader->message_, message, sizeof reader->message_ - 1);
    std::longjmp(reader->escape_, 1);
  }
  static void say_nothing(png_structp, png_const_charp) {}

  std::string problem() const {
    if (std::strstr(message_, "memory")) throw std::bad_alloc();
    return std::string("cannot be decoded (") + message_ + ")";
  }

  DecodedPicture& picture_;
  const char* at_;
  const char* const end_;
  const int64_t most_texels_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  int passes_ = 1;
  std::jmp_buf escape_;
  char message_[128] = {};
};

} // namespace

std::string decode_png(const SourceText& bytes, DecodedPicture& picture) {
  return PngReader(bytes, picture).read();
}

} // namespace softgl::cli
