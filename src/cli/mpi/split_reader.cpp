#include "mpi/split_reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <unordered_set>

#include "common/compressed_text.h"
#include "mesh/face_triangulation.h"
#include "mesh/normal_generator.h"
#include "mpi/chunk_exchange.h"
#include "mpi/element_exchange.h"
#include "mpi/ghost_faces.h"
#include "obj/index_check.h"
#include "obj/ply_reader.h"
#include "obj/stl_reader.h"

namespace softgl::cli {
namespace {

// Names are told by their place in the file, which all ranks can see.
struct FileName {
  uint64_t offset = 0, size = 0;
};

template <class T> std::string as_bytes(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}
template <class T> std::vector<T> values_from(const std::string& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

// What holds at the end of a stretch, if something in it says so.
struct State {
  FileName material;
  int64_t group = 0;
  bool has_material = false, has_group = false;
};

class SplitReader {
public:
  SplitReader(const std::string& path, const ProgramOptions& options, unsigned threads, const Ranks& ranks)
      : path_(path), options_(options), threads_(threads), ranks_(ranks) {
    rank_.messages.push_back({size_t(ranks.rank()), {}, {}});
  }

  RankModel read() {
    ranks_.together([this] {
      text_.push_back(open_text(path_, options_.limits.input_bytes));
      parse();
    });
    resolve();
    draw_vertices_without_elements();
    take_vertices();
    balance_chunks(model_.chunks, text(), ranks_);
    carry_states();
    load_materials();
    fetch();
    ranks_.together([this] { check(); });
    refuse_size_and_emptiness();
    ranks_.together([this] {
      triangulate_faces(model_);
      paint_over(options_.materials, loaded_);
    });
    prepare();
    order_steps();
    return std::move(rank_);
  }

private:
  const SourceText& text() const { return text_.front(); }
  Warnings& warnings() { return rank_.messages.front().warnings; }

  FileName name_of(std::string_view name) const {
    return {uint64_t(name.data() - text().begin()), name.size()};
  }
  std::string_view view_of(FileName name) const { return {text().begin() + name.offset, name.size}; }

  // Where the stretch of a rank begins.
  const char* border(int rank) const {
    if (rank >= ranks_.count()) return text().end();
    const bool mark = text().size() >= 3 && std::memcmp(text().begin(), "\xef\xbb\xbf", 3) == 0;
    if (rank == 0) return text().begin() + (mark ? 3 : 0);
    const double share = double(rank) / ranks_.count();
    return statement_border(text().begin() + uint64_t(double(text().size()) * share), text().end());
  }

  void parse() {
    const char* begin = border(ranks_.rank());
    model_.chunks = parse_obj_range(text(), begin, std::max(begin, border(ranks_.rank() + 1)), threads_);
    for (ObjChunk& chunk : model_.chunks) {
      remarks_.append(chunk.remarks);
      if (!chunk.painted.empty())
        throw ProgramError(kCannotRead,
                           path_ + ": colors in #MRGB comments are not read by several processes");
      for (const StateChange& change : chunk.changes)
        model_.has_smoothing_groups |= change.kind == StateChange::kSmoothingGroup;
    }
  }

  // The first number of each rank, and in the end how many there are.
  std::vector<uint64_t> firsts_of(uint64_t count) const {
    std::vector<uint64_t> firsts = {0};
    for (const std::string& bytes : ranks_.gather_everywhere(as_bytes(std::vector<uint64_t>{count})))
      firsts.push_back(firsts.back() + values_from<uint64_t>(bytes).front());
    return firsts;
  }

  void resolve() {
    ElementCounts own;
    const auto add = [](ElementCounts& sum, const ElementCounts& more) {
      sum.positions += more.positions;
      sum.texcoords += more.texcoords;
      sum.normals += more.normals;
    };
    for (const ObjChunk& chunk : model_.chunks) add(own, element_counts(chunk));
    positions_ = firsts_of(own.positions);
    texcoords_ = firsts_of(own.texcoords);
    normals_ = firsts_of(own.normals);
    of_file_ = {positions_.back(), texcoords_.back(), normals_.back()};
    if (std::max({of_file_.positions, of_file_.texcoords, of_file_.normals}) >= 0x7ffffff0)
      throw SharedError(kCannotRead, path_ + ": more than two thousand million vertices");
    const auto rank = size_t(ranks_.rank());
    ElementCounts before{positions_[rank], texcoords_[rank], normals_[rank]};
    for (ObjChunk& chunk : model_.chunks) {
      resolve_indices(chunk, before);
      add(before, element_counts(chunk));
    }
    model_.has_smoothing_groups = ranks_.any(model_.has_smoothing_groups);
  }

  static uint64_t elements_of(const ObjModel& model) {
    uint64_t count = 0;
    for (const ObjChunk& chunk : model.chunks)
      count += chunk.corner_vertices.values.size() + chunk.line_vertices.values.size() +
               chunk.point_vertices.values.size();
    return count;
  }

  // A file of nothing but vertices is a point cloud.
  void draw_vertices_without_elements() {
    const bool remarks = ranks_.any(!remarks_.empty());
    if (ranks_.any(elements_of(model_) > 0) || remarks || of_file_.positions == 0) return;
    uint64_t number = positions_[size_t(ranks_.rank())];
    for (ObjChunk& chunk : model_.chunks)
      for (size_t i = 0; i < chunk.positions.size(); i += 3, ++number)
        if (!std::isnan(chunk.positions[i])) chunk.point_vertices.values.append(int32_t(number));
    if (ranks_.is_first())
      remarks_.add("no elements", nullptr, "no faces, lines or points; the vertices are drawn as points");
  }

  // What lower ranks' chunks say holds for those of this one, too.
  void carry_states() {
    State own;
    for (const ObjChunk& chunk : model_.chunks)
      for (const StateChange& change : chunk.changes) {
        if (change.kind == StateChange::kMaterial)
          own.material = name_of(change.name), own.has_material = true;
        if (change.kind == StateChange::kSmoothingGroup) own.group = change.group, own.has_group = true;
      }
    State before;
    const std::vector<std::string> states = ranks_.gather_everywhere(as_bytes(std::vector<State>{own}));
    for (size_t rank = 0; rank < states.size(); ++rank) {
      const State state = values_from<State>(states[rank]).front();
      names_materials_ |= state.has_material;
      if (rank >= size_t(ranks_.rank())) continue;
      if (state.has_material) before.material = state.material, before.has_material = true;
      if (state.has_group) before.group = state.group, before.has_group = true;
    }
    std::vector<StateChange>& changes = model_.chunks.front().changes;
    if (before.has_material)
      changes.insert(changes.begin(), {StateChange::kMaterial, 0, view_of(before.material), 0, 0, 0});
    if (before.has_group)
      changes.insert(changes.begin(), {StateChange::kSmoothingGroup, int32_t(before.group), {}, 0, 0, 0});
  }

  // All ranks read all libraries; the first one says what there is to say.
  void load_materials() {
    std::vector<FileName> own;
    std::unordered_set<std::string_view> seen;
    for (const ObjChunk& chunk : model_.chunks)
      for (const StateChange& change : chunk.changes)
        if (change.kind == StateChange::kLibrary && seen.insert(change.name).second)
          own.push_back(name_of(change.name));
    ObjModel naming;
    naming.chunks.emplace_back();
    for (const std::string& names : ranks_.gather_everywhere(as_bytes(own)))
      for (const FileName& name : values_from<FileName>(names))
        naming.chunks[0].changes.push_back({StateChange::kLibrary, 0, view_of(name), 0, 0, 0});
    ranks_.together([&] {
      RemarkList unsaid;
      Warnings unsaid_warnings, unsaid_notes;
      const bool first = ranks_.is_first();
      loaded_.library = MaterialLibrary(options_.limits.load.strict_materials);
      loaded_.library.load_for(naming, ModelFiles(text().name(), options_.limits.load.any_path),
                               first ? remarks_ : unsaid, first ? warnings() : unsaid_warnings,
                               first ? rank_.messages.front().notes : unsaid_notes);
    });
    for (const Material& material : loaded_.library.materials())
      loaded_.report.textures += !material.diffuse_map.file.empty() || !material.opacity_map.file.empty();
  }

  template <class T> GrowingArray<T> take(GrowingArray<T> ObjChunk::*part) {
    GrowingArray<T> all;
    for (ObjChunk& chunk : model_.chunks) {
      all.append((chunk.*part).data(), (chunk.*part).size());
      (chunk.*part).release();
    }
    return all;
  }

  // The elements that the lists name, with the lists renumbered.
  std::vector<uint32_t> choose(uint64_t count, std::initializer_list<IndexList ObjChunk::*> lists) {
    IndexSet set(count);
    for (const ObjChunk& chunk : model_.chunks)
      for (const auto list : lists) set.measure(chunk.*list);
    for (const ObjChunk& chunk : model_.chunks)
      for (const auto list : lists) set.add(chunk.*list);
    std::vector<uint32_t> numbers = set.numbers();
    for (ObjChunk& chunk : model_.chunks)
      for (const auto list : lists) set.renumber(chunk.*list);
    return numbers;
  }

  // What this rank has read, for whoever needs it.
  void take_vertices() {
    bool colors = false;
    for (const ObjChunk& chunk : model_.chunks) colors |= !chunk.colors.empty();
    has_colors_ = ranks_.any(colors);
    for (ObjChunk& chunk : model_.chunks)
      if (has_colors_ && chunk.colors.empty())
        chunk.colors.fill(chunk.positions.size(), std::numeric_limits<float>::quiet_NaN());
    read_.positions = take(&ObjChunk::positions);
    read_.colors = take(&ObjChunk::colors);
    read_.texcoords = take(&ObjChunk::texcoords);
    read_.normals = take(&ObjChunk::normals);
  }

  void fetch() {
    const std::vector<uint32_t> vertices =
        choose(of_file_.positions,
               {&ObjChunk::corner_vertices, &ObjChunk::line_vertices, &ObjChunk::point_vertices});
    model_.positions = fetch_elements(vertices, std::move(read_.positions), 3, positions_, ranks_);
    model_.position_count = vertices.size();
    bool unusable = false; // other ranks' positions may be
    for (size_t i = 0; i < model_.positions.size(); i += 3) unusable |= std::isnan(model_.positions[i]);
    for (ObjChunk& chunk : model_.chunks) chunk.has_unusable_position = unusable;
    if (has_colors_) {
      double largest = 0;
      for (const float value : read_.colors) largest = value > largest ? double(value) : largest;
      ranks_.largest(&largest, 1);
      model_.colors = fetch_elements(vertices, std::move(read_.colors), 3, positions_, ranks_);
      for (float& value : model_.colors) value = value < 0 ? 0 : value * color_scale(float(largest));
    }
    const std::vector<uint32_t> texcoords = choose(of_file_.texcoords, {&ObjChunk::corner_texcoords});
    model_.texcoords = fetch_elements(texcoords, std::move(read_.texcoords), 2, texcoords_, ranks_);
    model_.texcoord_count = texcoords.size();
    const std::vector<uint32_t> normals = choose(of_file_.normals, {&ObjChunk::corner_normals});
    model_.normals = fetch_elements(normals, std::move(read_.normals), 3, normals_, ranks_);
    model_.normal_count = normals.size();
  }

  void check() {
    bool texcoords = false;
    for (const ObjChunk& chunk : model_.chunks) texcoords |= !chunk.corner_texcoords.values.empty();
    has_texcoords_ = texcoords && of_file_.texcoords > 0;
    check_indices(model_, of_file_, remarks_);
  }

  void refuse_size_and_emptiness() {
    has_texcoords_ = ranks_.any(has_texcoords_);
    const uint64_t count = ranks_.sum(elements_of(model_));
    if (count == 0) throw SharedError(kCannotRead, explain_missing_geometry(text()));
    uint64_t triangles = 0;
    for (const ObjChunk& chunk : model_.chunks)
      triangles += chunk.corner_vertices.values.size() - 2 * uint64_t(chunk.face_count);
    triangles = ranks_.sum(triangles);
    const uint64_t most = options_.limits.load.triangles;
    if (most && triangles > most)
      throw SharedError(kCannotRead, path_ + ": about " + std::to_string(triangles) +
                                         " triangles, more than --max-triangles allows");
  }

  bool lacks_normals() const {
    for (const ObjChunk& chunk : model_.chunks) {
      const GrowingArray<int32_t>& normals = chunk.corner_normals.values;
      if (normals.empty() && !chunk.corner_vertices.values.empty()) return true;
      if (std::find(normals.begin(), normals.end(), kAbsent) != normals.end()) return true;
    }
    return false;
  }

  void prepare() {
    const ModelBounds bounds = bounds_of_all(bounds_of(model_), ranks_);
    rank_.frame = frame_model(ObjModel(), bounds);
    rank_.models.emplace_back();
    PreparedModel& prepared = rank_.models.front();
    const bool flat = options_.render.lighting.shading == Shading::kFlat;
    ranks_.together([&] { prepared.frame = frame_model(model_, bounds); });
    if (!flat && ranks_.any(lacks_normals())) {
      const size_t count = model_.chunks.size();
      const size_t first = add_ghost_faces(model_, prepared.frame, ranks_);
      ranks_.together([&] { generate_normals(model_, prepared.frame, options_.normals); });
      drop_ghost_faces(model_, first, count);
    }
    ranks_.together([&] {
      MeshOptions mesh_options = mesh_options_for(options_, loaded_.report);
      mesh_options.has_texcoords = has_texcoords_;
      mesh_options.names_materials = names_materials_;
      prepared.mesh = build_mesh(model_, prepared.frame, loaded_.library, mesh_options, remarks_);
      warnings().add(remarks_, text());
      if (ranks_.is_first()) rank_.exporter = exporter_evidence(first_lines(text(), "OBJ"));
      prepared.frame.positions.release();
    });
    prepared.name = text().name();
    prepared.up = options_.views.front().camera.up;
    prepared.materials = std::move(loaded_.library.materials());
    model_ = ObjModel();
    text_.clear();
  }

  // Batches of one kind, all ranks' of one material together, materials by their first use in the file.
  void add_steps(PartStep::Kind kind, const std::vector<Batch>& batches, uint32_t& next) {
    std::map<uint32_t, size_t> own;
    for (size_t i = 0; i < batches.size(); ++i) own.emplace(batches[i].material, i);
    const std::vector<std::string> all = ranks_.gather_everywhere(as_bytes(batches));
    std::vector<uint32_t> order;
    std::map<uint32_t, uint64_t> before; // elements of the lower ranks
    for (size_t rank = 0; rank < all.size(); ++rank)
      for (const Batch& batch : values_from<Batch>(all[rank])) {
        const auto [known, is_new] = before.emplace(batch.material, 0);
        if (is_new) order.push_back(batch.material);
        if (rank < size_t(ranks_.rank())) known->second += batch.count / 3;
      }
    for (const uint32_t material : order) {
      const auto batch = own.find(material);
      if (batch != own.end()) rank_.steps.push_back({kind, 0, batch->second, next + uint32_t(ranks_.rank())});
      next += uint32_t(ranks_.count());
    }
    if (kind == PartStep::kTriangles)
      for (const Batch& batch : batches) rank_.triangles_before.push_back(before[batch.material]);
  }

  void order_steps() {
    const Mesh& mesh = rank_.models.front().mesh;
    uint32_t next = 1;
    add_steps(PartStep::kTriangles, mesh.triangle_batches, next);
    add_steps(PartStep::kSegments, mesh.segment_batches, next);
    add_steps(PartStep::kPoints, mesh.point_batches, next);
  }

  const std::string& path_;
  const ProgramOptions& options_;
  const unsigned threads_;
  const Ranks& ranks_;
  RankModel rank_;
  std::vector<SourceText> text_; // one, once it is open
  RemarkList remarks_;
  LoadedModel loaded_; // without its model:
  ObjModel& model_ = loaded_.model;
  std::vector<uint64_t> positions_, texcoords_, normals_; // see firsts_of()
  ElementCounts of_file_;
  struct {
    GrowingArray<double> positions;
    GrowingArray<float> colors, texcoords, normals;
  } read_; // by this rank
  bool has_colors_ = false, has_texcoords_ = false, names_materials_ = false;
};

} // namespace

bool can_split(const std::string& path) {
  unsigned char start[4] = {0, 0, 0, 0};
  std::ifstream(path, std::ios::binary).read(reinterpret_cast<char*>(start), 4);
  const bool compressed =
      (start[0] == 0x1f && start[1] == 0x8b) || std::memcmp(start, "\x28\xb5\x2f\xfd", 4) == 0;
  const bool wide = (start[0] == 0xff && start[1] == 0xfe) || (start[0] == 0xfe && start[1] == 0xff) ||
                    start[0] == 0 || start[1] == 0;
  if (compressed || wide) return false;
  const SourceText text = SourceText::open(path);
  return !is_ply(text) && !is_stl(text);
}

RankModel read_split(const std::string& path, const ProgramOptions& options, unsigned threads,
                     const Ranks& ranks) {
  return SplitReader(path, options, threads, ranks).read();
}

} // namespace softgl::cli
