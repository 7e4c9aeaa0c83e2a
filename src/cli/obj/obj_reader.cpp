#include "obj/obj_reader.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <system_error>
#include <thread>

#include "common/program_error.h"
#include "obj/number_parser.h"

namespace softgl::cli {
namespace {

constexpr size_t kChunkBytes = size_t(2)
                               << 20; // small enough to balance two threads, large enough to forget the seams

bool starts_with(const SourceText& text, std::string_view prefix) {
  return std::string_view(text.begin(), text.size()).substr(0, prefix.size()) == prefix;
}

// With a mark at its beginning it was made UTF-8 when the file was opened.
void refuse_utf16(const SourceText& text) {
  const char* p = text.begin();
  if (text.size() >= 8 && ((!p[0] && p[1] && !p[2] && p[3] && !p[4] && p[5]) ||
                           (p[0] && !p[1] && p[2] && !p[3] && p[4] && !p[5])))
    throw ProgramError(kCannotRead, text.name() + ": this is UTF-16 text without the mark of its order of "
                                                  "bytes; save it as UTF-8 (or ASCII) and try again");
}

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

template <class T>
void merge(std::vector<ObjChunk>& chunks, GrowingArray<T> ObjChunk::*part, GrowingArray<T>& all) {
  if (chunks.size() == 1) {
    all = std::move(chunks[0].*part);
    return;
  }
  size_t total = 0;
  for (const ObjChunk& chunk : chunks) total += (chunk.*part).size();
  all.room(total);
  for (ObjChunk& chunk : chunks) {
    all.append((chunk.*part).data(), (chunk.*part).size());
    (chunk.*part).release();
  }
}

void merge_colors(std::vector<ObjChunk>& chunks, ObjModel& model) {
  bool any = false;
  for (const ObjChunk& chunk : chunks) any = any || !chunk.colors.empty();
  if (!any) return;
  for (ObjChunk& chunk : chunks)
    if (chunk.colors.empty())
      chunk.colors.fill(chunk.positions.size(), std::numeric_limits<float>::quiet_NaN());
  merge(chunks, &ObjChunk::colors, model.colors);
  // Some programs write 0..255.
  float largest = 0;
  for (const float value : model.colors) largest = value > largest ? value : largest;
  const float scale = largest > 1.0f ? (largest <= 255.0f ? 1.0f / 255.0f : 1.0f / largest) : 1.0f;
  for (float& value : model.colors) value = value < 0 ? 0 : value * scale;
}

// ZBrush lists the colors of all vertices in comments, in the order of the vertices.
void merge_painted(std::vector<ObjChunk>& chunks, ObjModel& model) {
  GrowingArray<float> painted;
  merge(chunks, &ObjChunk::painted, painted);
  if (painted.empty() || !model.colors.empty()) return;
  painted.truncate(std::min(painted.size(), 3 * size_t(model.position_count)));
  painted.fill(3 * size_t(model.position_count) - painted.size(), std::numeric_limits<float>::quiet_NaN());
  model.colors = std::move(painted);
}

void add_base(IndexList& list, uint64_t base) {
  for (const uint32_t place : list.relative) {
    int32_t& index = list.values[place];
    const int64_t absolute = int64_t(index) + int64_t(base);
    index = absolute >= 0 && absolute < kNowhere ? int32_t(absolute) : kNowhere;
  }
  list.relative.release();
}

class IndexChecker {
public:
  IndexChecker(ObjModel& model, RemarkList& remarks) : model_(model), remarks_(remarks) {
    for (const ObjChunk& chunk : model.chunks) has_unusable_position_ |= chunk.has_unusable_position;
  }

  void check(ObjChunk& chunk) {
    check_attribute(chunk, chunk.corner_texcoords.values, model_.texcoord_count, "texture coordinate",
                    "texture coordinate that does not exist: left out", "left out");
    check_attribute(chunk, chunk.corner_normals.values, model_.normal_count, "normal",
                    "normal that does not exist: generated", "generated");
    forget_zero_normals(chunk);
    if (!all_usable(chunk.corner_vertices.values)) drop_faces(chunk);
    if (!all_usable(chunk.line_vertices.values)) drop_elements(chunk, chunk.line_vertices.values, 2);
    if (!all_usable(chunk.point_vertices.values)) drop_elements(chunk, chunk.point_vertices.values, 1);
  }

private:
  bool usable(int32_t vertex) const {
    return uint32_t(vertex) < model_.position_count &&
           !(has_unusable_position_ && std::isnan(model_.positions[3 * size_t(vertex)]));
  }

  bool all_usable(const GrowingArray<int32_t>& vertices) const {
    const auto count = uint32_t(model_.position_count);
    uint32_t outside = 0;
    for (const int32_t vertex : vertices) outside |= uint32_t(vertex) >= count;
    if (outside) return false;
    if (has_unusable_position_)
      for (const int32_t vertex : vertices)
        if (!usable(vertex)) return false;
    return true;
  }

  // Reading the chunk once more finds the statement of a face; only done for the few remarks that are shown.
  static const char* place_of_face(const ObjChunk& chunk, uint32_t face) {
    ObjChunk again;
    again.begin = chunk.begin;
    again.end = chunk.end;
    return parse_obj_chunk(again, face);
  }

  static uint32_t face_of_corner(const ObjChunk& chunk, size_t corner) {
    if (chunk.face_sizes.empty()) return uint32_t(corner / 3);
    uint32_t face = 0;
    for (size_t first = chunk.face_sizes[0]; first <= corner; first += chunk.face_sizes[++face]) {}
    return face;
  }

  void check_attribute(const ObjChunk& chunk, GrowingArray<int32_t>& indices, uint64_t count,
                       const char* what, const char* kind, const char* consequence) {
    const auto limit = uint32_t(count);
    uint32_t wrong = 0;
    for (const int32_t index : indices) wrong |= (uint32_t(index) >= limit) & (index != kAbsent);
    if (!wrong) return;
    for (size_t corner = 0; corner < indices.size(); ++corner) {
      const int32_t index = indices[corner];
      if (uint32_t(index) < limit || index == kAbsent) continue;
      indices[corner] = kAbsent;
      if (remarks_.count(kind))
        remarks_.describe(kind, place_of_face(chunk, face_of_corner(chunk, corner)),
                          std::string("a corner names a ") + what + " that does not exist (the file has " +
                              std::to_string(count) + "); " + consequence);
    }
  }

  void forget_zero_normals(ObjChunk& chunk) {
    for (int32_t& index : chunk.corner_normals.values) {
      if (index == kAbsent) continue;
      const float* n = &model_.normals[3 * size_t(index)];
      if (n[0] == 0 && n[1] == 0 && n[2] == 0) index = kAbsent;
    }
  }

  void remark_face(const ObjChunk& chunk, uint32_t face, const int32_t* corners, uint32_t size) {
    bool missing = false;
    for (uint32_t i = 0; i < size; ++i) missing |= uint32_t(corners[i]) >= model_.position_count;
    const char* kind =
        missing ? "face skipped: a vertex does not exist" : "face skipped: a vertex is not finite";
    if (!remarks_.count(kind)) return;
    remarks_.describe(kind, place_of_face(chunk, face),
                      missing ? "a corner names a vertex that does not exist (the file has " +
                                    std::to_string(model_.position_count) + "); face skipped"
                              : "a corner names a vertex that is not a finite place; face skipped");
  }

  void drop_faces(ObjChunk& chunk) {
    GrowingArray<int32_t>* const lists[] = {&chunk.corner_vertices.values, &chunk.corner_texcoords.values,
                                            &chunk.corner_normals.values};
    const uint32_t face_count = chunk.face_count;
    size_t from = 0, to = 0, change = 0;
    uint32_t kept = 0;
    for (uint32_t face = 0; face < face_count; ++face) {
      while (change < chunk.changes.size() && chunk.changes[change].face <= face)
        chunk.changes[change++].face = kept;
      const uint32_t size = chunk.face_sizes.empty() ? 3 : chunk.face_sizes[face];
      const int32_t* corners = chunk.corner_vertices.values.data() + from;
      if (std::all_of(corners, corners + size, [&](int32_t vertex) { return usable(vertex); })) {
        for (GrowingArray<int32_t>* list : lists)
          if (!list->empty()) std::memmove(list->data() + to, list->data() + from, size * sizeof(int32_t));
        if (!chunk.face_sizes.empty()) chunk.face_sizes[kept] = size;
        to += size;
        ++kept;
      } else {
        remark_face(chunk, face, corners, size);
      }
      from += size;
    }
    while (change < chunk.changes.size()) chunk.changes[change++].face = kept;
    for (GrowingArray<int32_t>* list : lists)
      if (!list->empty()) list->truncate(to);
    if (!chunk.face_sizes.empty()) chunk.face_sizes.truncate(kept);
    chunk.face_count = kept;
  }

  void drop_elements(ObjChunk& chunk, GrowingArray<int32_t>& vertices, size_t size) {
    size_t to = 0, change = 0;
    const auto element_of = [&](StateChange& c) -> uint32_t& { return size == 2 ? c.line : c.point; };
    for (size_t from = 0; from < vertices.size(); from += size) {
      while (change < chunk.changes.size() && element_of(chunk.changes[change]) * size <= from)
        element_of(chunk.changes[change++]) = uint32_t(to / size);
      bool good = true;
      for (size_t i = 0; i < size; ++i) good = good && usable(vertices[from + i]);
      if (!good) {
        const char* kind = size == 2 ? "line segment skipped: a vertex does not exist or is not finite"
                                     : "point skipped: its vertex does not exist or is not finite";
        remarks_.add(kind, nullptr, kind);
        continue;
      }
      for (size_t i = 0; i < size; ++i) vertices[to + i] = vertices[from + i];
      to += size;
    }
    while (change < chunk.changes.size()) element_of(chunk.changes[change++]) = uint32_t(to / size);
    vertices.truncate(to);
  }

  ObjModel& model_;
  RemarkList& remarks_;
  bool has_unusable_position_ = false;
};

} // namespace

ObjModel read_obj(const SourceText& text, unsigned threads, RemarkList& remarks) {
  refuse_utf16(text);
  const char* begin = text.begin() + (starts_with(text, "\xef\xbb\xbf") ? 3 : 0);
  ObjModel model;
  model.chunks = cut(begin, text.end());
  parse_all(text, model.chunks, threads);

  uint64_t corner_count = 0;
  for (const ObjChunk& chunk : model.chunks) {
    corner_count += chunk.corner_vertices.values.size();
    model.position_count += chunk.positions.size() / 3;
  }
  if (model.position_count >= 0x7ffffff0 || corner_count >= 0x7ffffff0)
    throw ProgramError(kCannotRead, text.name() + ": more than two thousand million vertices or corners");

  model.position_count = 0;
  for (ObjChunk& chunk : model.chunks) {
    remarks.append(chunk.remarks);
    add_base(chunk.corner_vertices, model.position_count);
    add_base(chunk.line_vertices, model.position_count);
    add_base(chunk.point_vertices, model.position_count);
    add_base(chunk.corner_texcoords, model.texcoord_count);
    add_base(chunk.corner_normals, model.normal_count);
    model.position_count += chunk.positions.size() / 3;
    model.texcoord_count += chunk.texcoords.size() / 2;
    model.normal_count += chunk.normals.size() / 3;
    for (const StateChange& change : chunk.changes) {
      model.object_count += change.kind == StateChange::kObject;
      model.group_count += change.kind == StateChange::kGroup;
      model.has_smoothing_groups |= change.kind == StateChange::kSmoothingGroup;
    }
  }
  merge_colors(model.chunks, model);
  merge_painted(model.chunks, model);
  merge(model.chunks, &ObjChunk::positions, model.positions);
  merge(model.chunks, &ObjChunk::texcoords, model.texcoords);
  merge(model.chunks, &ObjChunk::normals, model.normals);

  IndexChecker checker(model, remarks);
  for (ObjChunk& chunk : model.chunks) {
    checker.check(chunk);
    model.face_count += chunk.face_count;
    model.segment_count += chunk.line_vertices.values.size() / 2;
    model.point_count += chunk.point_vertices.values.size();
  }
  return model;
}

namespace {

// What a file is that is no text, by its first bytes; null if they say nothing.
const char* known_binary_kind(std::string_view start) {
  static constexpr struct {
    std::string_view bytes;
    const char* kind;
  } kKinds[] = {{"\xfd"
                 "7zXZ",
                 "compressed with xz"},
                {"BZh", "compressed with bzip2"},
                {"PK\x03\x04", "a ZIP archive"},
                {"7z\xbc\xaf", "a 7z archive"},
                {"glTF", "a glTF model, not OBJ"},
                {"Kaydara FBX", "an FBX model, not OBJ"},
                {"BLENDER", "a Blender file, not OBJ"},
                {"\x89PNG", "a PNG picture"},
                {"\xff\xd8\xff", "a JPEG picture"},
                {"GIF8", "a GIF picture"},
                {"%PDF", "a PDF document"},
                {"\x7f"
                 "ELF",
                 "a program"}};
  for (const auto& known : kKinds)
    if (start.substr(0, known.bytes.size()) == known.bytes) return known.kind;
  return nullptr;
}

bool any_decimal_comma(std::string_view text) {
  for (size_t i = 0; i < text.size(); ++i)
    if (text[i] == ',' && i > 0) {
      size_t first = i;
      while (first > 0 && !ends_token(text[first - 1])) --first;
      if (has_decimal_comma(&text[first])) return true;
    }
  return false;
}

} // namespace

std::string explain_missing_geometry(const SourceText& text) {
  const std::string no_geometry = text.name() + ": no geometry";
  if (text.size() == 0) return no_geometry + "; the file is empty";
  if (const char* kind = known_binary_kind({text.begin(), text.size()}))
    return no_geometry + "; file is " + kind;
  const std::string_view all(text.begin(), text.size());
  const size_t first = std::min(all.find_first_not_of(" \t\r\n\xef\xbb\xbf"), all.size());
  const std::string_view start = all.substr(first, 4096);
  if (start.substr(0, 1) == "<") return no_geometry + "; file looks like HTML or XML";
  if (start.find("version https://git-lfs") == 0) return no_geometry + "; file is a Git LFS pointer";
  size_t strange = 0;
  for (const char c : start) {
    const auto byte = uint8_t(c);
    strange += (byte < 32 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 127;
  }
  if (strange * 20 > start.size()) return no_geometry + "; file is binary, not OBJ text";
  if (any_decimal_comma(start))
    return no_geometry + "; its numbers have decimal commas (1,5), and OBJ needs points (1.5)";
  return no_geometry + "; the file has no face, line or point that can be drawn";
}

} // namespace softgl::cli
