#include "obj/obj_reader.h"

#include <algorithm>
#include <cmath>

#include "common/program_error.h"
#include "obj/index_check.h"
#include "obj/number_parser.h"

namespace softgl::cli {
namespace {

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
  float largest = 0;
  for (const float value : model.colors) largest = value > largest ? value : largest;
  const float scale = color_scale(largest);
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

} // namespace

ObjModel read_obj(const SourceText& text, unsigned threads, RemarkList& remarks) {
  refuse_utf16(text);
  const char* begin = text.begin() + (starts_with(text, "\xef\xbb\xbf") ? 3 : 0);
  ObjModel model;
  model.chunks = parse_obj_range(text, begin, text.end(), threads);

  uint64_t corner_count = 0;
  for (const ObjChunk& chunk : model.chunks) {
    corner_count += chunk.corner_vertices.values.size();
    model.position_count += chunk.positions.size() / 3;
  }
  if (model.position_count >= 0x7ffffff0 || corner_count >= 0x7ffffff0)
    throw ProgramError(kCannotRead, text.name() + ": more than two thousand million vertices or corners");

  ElementCounts before;
  for (ObjChunk& chunk : model.chunks) {
    remarks.append(chunk.remarks);
    const ElementCounts own = element_counts(chunk);
    resolve_indices(chunk, before);
    before.positions += own.positions;
    before.texcoords += own.texcoords;
    before.normals += own.normals;
    for (const StateChange& change : chunk.changes) {
      model.object_count += change.kind == StateChange::kObject;
      model.group_count += change.kind == StateChange::kGroup;
      model.has_smoothing_groups |= change.kind == StateChange::kSmoothingGroup;
    }
  }
  model.texcoord_count = before.texcoords;
  model.normal_count = before.normals;
  merge_colors(model.chunks, model);
  merge_painted(model.chunks, model);
  merge(model.chunks, &ObjChunk::positions, model.positions);
  merge(model.chunks, &ObjChunk::texcoords, model.texcoords);
  merge(model.chunks, &ObjChunk::normals, model.normals);

  check_indices(model, before, remarks);
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
