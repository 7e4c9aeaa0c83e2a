#include "obj/obj_range.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>

namespace softgl::cli {
namespace {

constexpr size_t kChunkBytes = size_t(2)
                               << 20; // small enough to balance two threads, large enough to forget the seams

std::vector<ObjChunk> cut(const char* begin, const char* end) {
  std::vector<ObjChunk> chunks;
  do {
    const auto rest = size_t(end - begin);
    const char* border =
        rest > kChunkBytes + kChunkBytes / 2 ? statement_border(begin + kChunkBytes, end) : end;
    chunks.emplace_back();
    chunks.back().begin = begin;
    chunks.back().end = border;
    begin = border;
  } while (begin < end);
  return chunks;
}

void parse_all(const SourceText& text, std::vector<ObjChunk>& chunks, unsigned threads) {
  std::atomic<size_t> next{0};
  std::vector<std::exception_ptr> failures(std::max<size_t>(1, std::min<size_t>(threads, chunks.size())));
  const auto work = [&](size_t worker) {
    try {
      for (size_t i; (i = next.fetch_add(1)) < chunks.size();) {
        parse_obj_chunk(chunks[i]);
        text.forget(chunks[i].begin, chunks[i].end);
      }
    } catch (...) { failures[worker] = std::current_exception(); }
  };
  {
    std::vector<std::jthread> helpers; // which end before `failures` is read
    helpers.reserve(failures.size());
    try {
      for (size_t i = 1; i < failures.size(); ++i) helpers.emplace_back(work, i);
    } catch (const std::system_error&) {} // no more threads to be had: fewer do the same work
    work(0);
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

void add_base(IndexList& list, uint64_t base) {
  for (const uint32_t place : list.relative) {
    int32_t& index = list.values[place];
    const int64_t absolute = int64_t(index) + int64_t(base);
    index = absolute >= 0 && absolute < kNowhere ? int32_t(absolute) : kNowhere;
  }
  list.relative.release();
}

} // namespace

// The next place after `from` where a statement begins.
const char* statement_border(const char* from, const char* end) {
  for (const char* p = from; p < end; ++p) {
    if (*p != '\n' && (*p != '\r' || p[1] == '\n')) continue;
    const char* before = p; // a continued line is no border
    if (*p == '\n' && before > from && before[-1] == '\r') --before;
    if (before > from && before[-1] == '\\') continue;
    if (before == from) continue; // what stands before is unknown
    return p + 1;
  }
  return end;
}

std::vector<ObjChunk> parse_obj_range(const SourceText& text, const char* begin, const char* end,
                                      unsigned threads) {
  std::vector<ObjChunk> chunks = cut(begin, end);
  parse_all(text, chunks, threads);
  return chunks;
}

ElementCounts element_counts(const ObjChunk& chunk) {
  return {chunk.positions.size() / 3, chunk.texcoords.size() / 2, chunk.normals.size() / 3};
}

void resolve_indices(ObjChunk& chunk, const ElementCounts& before) {
  add_base(chunk.corner_vertices, before.positions);
  add_base(chunk.line_vertices, before.positions);
  add_base(chunk.point_vertices, before.positions);
  add_base(chunk.corner_texcoords, before.texcoords);
  add_base(chunk.corner_normals, before.normals);
}

float color_scale(float largest) {
  return largest > 1.0f ? (largest <= 255.0f ? 1.0f / 255.0f : 1.0f / largest) : 1.0f;
}

} // namespace softgl::cli
