#include "common/compressed_text.h"

#include <algorithm>
#include <memory>
#include <new>
#include <string_view>

#ifdef SOFTGL_HAVE_ZLIB
#include <zlib.h>
#endif
#ifdef SOFTGL_HAVE_ZSTD
#include <zstd.h>
#endif

#include "common/program_error.h"
#include "common/utf16_text.h"

namespace softgl::cli {
namespace {

constexpr size_t kStep = size_t(1) << 20;

[[noreturn]] void refuse_damage(const std::string& name) {
  throw ProgramError(kCannotRead, name + ": cannot be decompressed; the file is damaged or cut off");
}

// What has been decompressed. Room for a step more, as long as the limit allows.
class Output {
public:
  Output(const std::string& name, uint64_t most) : name_(name), most_(most) {}

  char* room() {
    if (used_ > most_)
      throw ProgramError(kCannotRead, name_ + ": more than " + std::to_string(most_ >> 20) +
                                          " MiB when decompressed; --max-input MIB allows more");
    if (text_.size() - used_ < kStep) text_.resize(std::max(2 * text_.size(), used_ + kStep));
    return text_.data() + used_;
  }
  void add(size_t count) { used_ += count; }
  std::string take() {
    text_.resize(used_);
    return std::move(text_);
  }

private:
  const std::string& name_;
  const uint64_t most_;
  std::string text_;
  size_t used_ = 0;
};

#ifdef SOFTGL_HAVE_ZLIB
struct EndInflate {
  void operator()(z_stream* stream) const { ::inflateEnd(stream); }
};

std::string inflated(const SourceText& file, uint64_t most) {
  z_stream stream{};
  if (::inflateInit2(&stream, 15 + 16) != Z_OK) throw std::bad_alloc(); // 16: a gzip header
  const std::unique_ptr<z_stream, EndInflate> owner(&stream);
  Output output(file.name(), most);
  const char* at = file.begin();
  for (;;) {
    const auto given = uInt(std::min<size_t>(size_t(file.end() - at), size_t(1) << 30));
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(at));
    stream.avail_in = given;
    stream.next_out = reinterpret_cast<Bytef*>(output.room());
    stream.avail_out = uInt(kStep);
    const int status = ::inflate(&stream, Z_NO_FLUSH);
    at += given - stream.avail_in;
    output.add(kStep - stream.avail_out);
    if (status == Z_STREAM_END) {
      if (file.end() - at < 2 || at[0] != '\x1f' || at[1] != '\x8b') return output.take();
      ::inflateReset(&stream); // one member of the file after another
    } else if (status == Z_MEM_ERROR) {
      throw std::bad_alloc();
    } else if (status != Z_OK) {
      refuse_damage(file.name());
    }
  }
}
#endif

#ifdef SOFTGL_HAVE_ZSTD
struct FreeZstd {
  void operator()(ZSTD_DStream* stream) const { ::ZSTD_freeDStream(stream); }
};

std::string unpacked(const SourceText& file, uint64_t most) {
  const std::unique_ptr<ZSTD_DStream, FreeZstd> stream(::ZSTD_createDStream());
  if (!stream) throw std::bad_alloc();
  Output output(file.name(), most);
  ZSTD_inBuffer in{file.begin(), file.size(), 0};
  for (;;) {
    ZSTD_outBuffer out{output.room(), kStep, 0};
    const size_t before = in.pos;
    const size_t status = ::ZSTD_decompressStream(stream.get(), &out, &in);
    if (::ZSTD_isError(status)) refuse_damage(file.name());
    output.add(out.pos);
    if (status == 0 && in.pos == in.size) return output.take();
    if (in.pos == before && out.pos == 0) refuse_damage(file.name());
  }
}
#endif

bool starts_with(const SourceText& file, std::string_view bytes) {
  return std::string_view(file.begin(), file.size()).substr(0, bytes.size()) == bytes;
}

[[maybe_unused]] [[noreturn]] void refuse_kind(const std::string& name, const char* kind) {
  throw ProgramError(kCannotRead,
                     name + ": file is compressed with " + kind + ", which this program was built without");
}

} // namespace

SourceText open_text(const std::string& path, uint64_t most) {
  return as_utf8(decompressed(SourceText::open(path, most), most));
}

SourceText decompressed(SourceText file, uint64_t most) {
  [[maybe_unused]] const uint64_t limit = most ? most : std::max<uint64_t>(64 * file.size(), 16 << 20);
  if (starts_with(file, "\x1f\x8b")) {
#ifdef SOFTGL_HAVE_ZLIB
    return SourceText::from_string(inflated(file, limit), file.name());
#else
    refuse_kind(file.name(), "gzip");
#endif
  }
  if (starts_with(file, "\x28\xb5\x2f\xfd")) {
#ifdef SOFTGL_HAVE_ZSTD
    return SourceText::from_string(unpacked(file, limit), file.name());
#else
    refuse_kind(file.name(), "zstd");
#endif
  }
  return file;
}

} // namespace softgl::cli
