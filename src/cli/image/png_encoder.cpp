// PNG by libdeflate. Measured on rendered 1024x1024 pictures (milliseconds of CPU / KB): stb_image_write
// 45-55 / 237-428, libpng with its defaults 51-62 / 182-302. Lit surfaces change slowly downwards: three
// pictures, on a busy machine, libdeflate level 6 without filter 21-34 / 208-335, level 3 with UP 18-22 /
// 186-246, level 1 with UP 13-17 / 217-256.
#include "image/png_encoder.h"

#include <cstdlib>
#include <libdeflate.h>
#include <memory>

#include "common/program_error.h"

namespace softgl::cli {
namespace {

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

void append_number(GrowingArray<uint8_t>& out, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.append(uint8_t(value >> shift));
}

void append_chunk(GrowingArray<uint8_t>& out, const char* type, const uint8_t* data, size_t size) {
  append_number(out, uint32_t(size));
  const size_t start = out.size();
  out.append(reinterpret_cast<const uint8_t*>(type), 4);
  out.append(data, size);
  append_number(out, libdeflate_crc32(0, out.data() + start, size + 4));
}

enum Filter : uint8_t { kNone, kSub, kUp, kAverage, kPaeth };

uint8_t predict(Filter filter, int left, int above, int above_left) {
  switch (filter) {
  case kNone: return 0;
  case kSub: return uint8_t(left);
  case kUp: return uint8_t(above);
  case kAverage: return uint8_t((left + above) / 2);
  default: {
    const int p = left + above - above_left;
    const int pa = std::abs(p - left), pb = std::abs(p - above), pc = std::abs(p - above_left);
    return uint8_t(pa <= pb && pa <= pc ? left : pb <= pc ? above : above_left);
  }
  }
}

// Writes the filtered row and returns the sum of its differences' sizes: smaller compresses better.
uint64_t filter_row(const uint8_t* row, const uint8_t* above, size_t size, size_t bytes, Filter filter,
                    uint8_t* out) {
  uint64_t sum = 0;
  for (size_t i = 0; i < size; ++i) {
    const int left = i >= bytes ? row[i - bytes] : 0;
    const int up = above ? above[i] : 0;
    const int corner = above && i >= bytes ? above[i - bytes] : 0;
    out[i] = uint8_t(row[i] - predict(filter, left, up, corner));
    sum += uint64_t(std::abs(int8_t(out[i])));
  }
  return sum;
}

GrowingArray<uint8_t> filtered(const Picture& picture, PngEffort effort) {
  const auto bytes = size_t(picture.channels) * size_t(picture.bits / 8);
  const size_t row_size = size_t(picture.width) * bytes;
  GrowingArray<uint8_t> rows, candidate;
  rows.room((row_size + 1) * size_t(picture.height));
  candidate.extend(row_size);
  for (int y = 0; y < picture.height; ++y) {
    const uint8_t* row = picture.pixels.data() + size_t(y) * row_size;
    const uint8_t* above = y ? row - row_size : nullptr;
    uint8_t* out = rows.extend(row_size + 1);
    if (effort != PngEffort::kSmall && !above) {
      out[0] = kNone;
      std::memcpy(out + 1, row, row_size);
    } else if (effort != PngEffort::kSmall) {
      out[0] = kUp;
      for (size_t i = 0; i < row_size; ++i) out[1 + i] = uint8_t(row[i] - above[i]);
    } else {
      uint64_t best = UINT64_MAX;
      for (const Filter filter : {kNone, kSub, kUp, kAverage, kPaeth}) {
        const uint64_t sum = filter_row(row, above, row_size, bytes, filter, candidate.data());
        if (sum >= best) continue;
        best = sum;
        out[0] = filter;
        std::memcpy(out + 1, candidate.data(), row_size);
      }
    }
  }
  return rows;
}

void append_start(GrowingArray<uint8_t>& out, const Picture& picture) {
  static constexpr uint8_t kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  out.append(kSignature, sizeof kSignature);
  GrowingArray<uint8_t> header;
  append_number(header, uint32_t(picture.width));
  append_number(header, uint32_t(picture.height));
  const uint8_t color = picture.channels == 4 ? 6 : picture.channels == 1 ? 0 : 2;
  const uint8_t kind[] = {uint8_t(picture.bits), color, 0, 0, 0};
  header.append(kind, sizeof kind);
  append_chunk(out, "IHDR", header.data(), header.size());
  for (const PictureNote& note : picture.notes) {
    const std::string text = note.name + '\0' + note.text;
    append_chunk(out, "tEXt", reinterpret_cast<const uint8_t*>(text.data()), text.size());
  }
}

GrowingArray<uint8_t> compressed(const Picture& picture, PngEffort effort) {
  const GrowingArray<uint8_t> rows = filtered(picture, effort);
  const int level = effort == PngEffort::kFast ? 1 : effort == PngEffort::kDefault ? 3 : 12;
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(libdeflate_alloc_compressor(level));
  if (!compressor) throw std::bad_alloc();
  GrowingArray<uint8_t> packed;
  const size_t bound = libdeflate_zlib_compress_bound(compressor.get(), rows.size());
  packed.room(bound);
  const size_t size =
      libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(), packed.data(), bound);
  if (size == 0 || size > 0x7ffffff0)
    throw ProgramError(kCannotWrite, "the picture is too large for a PNG file");
  packed.commit(size);
  return packed;
}

} // namespace

GrowingArray<uint8_t> encode_png(const Picture& picture, PngEffort effort) {
  const GrowingArray<uint8_t> packed = compressed(picture, effort);
  GrowingArray<uint8_t> out;
  out.room(packed.size() + 64);
  append_start(out, picture);
  append_chunk(out, "IDAT", packed.data(), packed.size());
  append_chunk(out, "IEND", nullptr, 0);
  return out;
}

PngFrame encode_png_frame(const Picture& picture, PngEffort effort) {
  PngFrame frame;
  append_start(frame.start, picture);
  frame.width = uint32_t(picture.width);
  frame.height = uint32_t(picture.height);
  frame.packed = compressed(picture, effort);
  return frame;
}

// The Animated PNG specification of Mozilla, now in PNG's third edition: the first frame is an ordinary
// picture, the others are fdAT chunks; both counted by one sequence of numbers.
GrowingArray<uint8_t> assemble_apng(const std::vector<PngFrame>& frames, int frames_per_second) {
  GrowingArray<uint8_t> out, chunk;
  out.append(frames.front().start.data(), frames.front().start.size());
  append_number(chunk, uint32_t(frames.size()));
  append_number(chunk, 0); // played for ever
  append_chunk(out, "acTL", chunk.data(), chunk.size());
  uint32_t sequence = 0;
  for (const PngFrame& frame : frames) {
    chunk.truncate(0);
    for (const uint32_t value : {sequence++, frame.width, frame.height, 0u, 0u}) append_number(chunk, value);
    append_number(chunk, 1u << 16 | uint32_t(frames_per_second)); // a delay of 1 / frames_per_second
    chunk.fill(2, 0);                                             // replaces what was there
    append_chunk(out, "fcTL", chunk.data(), chunk.size());
    if (sequence == 1) {
      append_chunk(out, "IDAT", frame.packed.data(), frame.packed.size());
      continue;
    }
    chunk.truncate(0);
    append_number(chunk, sequence++);
    chunk.append(frame.packed.data(), frame.packed.size());
    append_chunk(out, "fdAT", chunk.data(), chunk.size());
  }
  append_chunk(out, "IEND", nullptr, 0);
  return out;
}

} // namespace softgl::cli
