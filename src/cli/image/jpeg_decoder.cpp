#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <new>

#include <jpeglib.h>

#include "image/picture_formats.h"
#include "image/picture_rows.h"

namespace softgl::cli {
namespace {

// A picture of many scans is kept whole as coefficients, and each scan may touch all of it.
constexpr int64_t kMostScannedTexels = int64_t(1) << 27;
constexpr int64_t kMostWork = int64_t(1) << 30; // texels times scans

struct Failure {
  jpeg_error_mgr manager;
  std::jmp_buf escape;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void fail(j_common_ptr decoder) {
  auto* failure = reinterpret_cast<Failure*>(decoder->err);
  failure->manager.format_message(decoder, failure->message);
  std::longjmp(failure->escape, 1);
}

void say_nothing(j_common_ptr, int) {}
void say_nothing(j_common_ptr) {}

void watch_scans(j_common_ptr decoder) {
  const auto* info = reinterpret_cast<j_decompress_ptr>(decoder);
  if (int64_t(info->image_width) * info->image_height * info->input_scan_number <= kMostWork) return;
  auto* failure = reinterpret_cast<Failure*>(decoder->err);
  std::strcpy(failure->message, "too many scans");
  std::longjmp(failure->escape, 1);
}

class JpegReader {
public:
  JpegReader(const SourceText& bytes, DecodedPicture& picture)
      : picture_(picture), most_rows_(most_texels(bytes, false)), most_whole_(most_texels(bytes, true)) {
    std::memset(&info_, 0, sizeof info_);
    info_.err = jpeg_std_error(&failure_.manager);
    failure_.manager.error_exit = fail;
    failure_.manager.emit_message = say_nothing;
    failure_.manager.output_message = say_nothing;
    progress_.progress_monitor = watch_scans;
    data_ = reinterpret_cast<const unsigned char*>(bytes.begin());
    size_ = bytes.size();
  }
  ~JpegReader() { jpeg_destroy_decompress(&info_); }

  std::string read() {
    if (!start()) return problem();
    const int64_t width = info_.image_width, height = info_.image_height;
    const bool whole = jpeg_has_multiple_scans(&info_);
    if (width * height > (whole ? std::min(most_whole_, kMostScannedTexels) : most_rows_))
      return kTooManyTexels;
    picture_.file_width = int(width);
    picture_.file_height = int(height);
    cmyk_ = info_.jpeg_color_space == JCS_CMYK || info_.jpeg_color_space == JCS_YCCK;
    info_.out_color_space = cmyk_ ? JCS_CMYK : JCS_EXT_RGBA;
    info_.scale_num = 1;
    info_.scale_denom = unsigned(std::min(reduction_of(width, height), 8));
    if (!begin_rows()) return problem();
    PictureRows rows(picture_, int(info_.output_width), int(info_.output_height));
    while (info_.output_scanline < info_.output_height) {
      uint8_t* row = rows.next_row();
      if (!read_row(row)) return problem();
      if (cmyk_) make_rgb(row, info_.output_width);
      rows.add_written();
    }
    return {};
  }

private:
  // Each of these holds nothing that a destructor would have to free: fail() jumps out of them.

  bool start() {
    if (setjmp(failure_.escape)) return false;
    jpeg_create_decompress(&info_);
    info_.progress = &progress_;
    jpeg_mem_src(&info_, data_, size_);
    jpeg_read_header(&info_, TRUE);
    return true;
  }

  bool begin_rows() {
    if (setjmp(failure_.escape)) return false;
    return jpeg_start_decompress(&info_);
  }

  bool read_row(uint8_t* row) {
    if (setjmp(failure_.escape)) return false;
    return jpeg_read_scanlines(&info_, &row, 1) == 1;
  }

  // Adobe's CMYK is inverted: 255 is no ink.
  static void make_rgb(uint8_t* row, size_t count) {
    for (uint8_t* p = row; p < row + 4 * count; p += 4) {
      for (int c = 0; c < 3; ++c) p[c] = uint8_t((p[c] * p[3] + 127) / 255);
      p[3] = 255;
    }
  }

  std::string problem() const {
    if (std::strncmp(failure_.message, "Insufficient memory", 19) == 0) throw std::bad_alloc();
    return std::string("cannot be decoded (") + failure_.message + ")";
  }

  DecodedPicture& picture_;
  const int64_t most_rows_, most_whole_;
  jpeg_decompress_struct info_;
  jpeg_progress_mgr progress_{};
  Failure failure_{};
  const unsigned char* data_ = nullptr;
  size_t size_ = 0;
  bool cmyk_ = false;
};

} // namespace

std::string decode_jpeg(const SourceText& bytes, DecodedPicture& picture) {
  return JpegReader(bytes, picture).read();
}

} // namespace softgl::cli
