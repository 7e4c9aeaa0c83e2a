#include "mesh/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>

namespace softgl::cli {
namespace {

// Which material each element has, in file order.
struct MaterialRun {
  uint32_t chunk;
  uint32_t material;
  uint32_t first, last; // elements of the chunk
};

class MaterialResolver {
public:
  MaterialResolver(const ObjModel& model, const MaterialLibrary& library, bool any, RemarkList& remarks)
      : model_(model), library_(library), remarks_(remarks) {
    for (const ObjChunk& chunk : model.chunks)
      for (const StateChange& change : chunk.changes) any |= change.kind == StateChange::kMaterial;
    // A library of one material that nobody names is meant for the whole model.
    if (!any && library.materials().size() == 2) start_ = 1;
  }

  std::vector<MaterialRun> runs(uint32_t StateChange::*element, uint32_t (*count_of)(const ObjChunk&)) {
    std::vector<MaterialRun> result;
    uint32_t material = start_;
    for (uint32_t c = 0; c < model_.chunks.size(); ++c) {
      const ObjChunk& chunk = model_.chunks[c];
      const uint32_t total = count_of(chunk);
      uint32_t first = 0;
      const auto close = [&](uint32_t last) {
        if (last <= first) return;
        if (!result.empty() && result.back().chunk == c && result.back().material == material)
          result.back().last = last;
        else
          result.push_back({c, material, first, last});
        first = last;
      };
      for (const StateChange& change : chunk.changes) {
        if (change.kind != StateChange::kMaterial) continue;
        close(change.*element);
        material = resolve(change.name);
      }
      close(total);
    }
    return result;
  }

private:
  // What Blender writes before faces that have none.
  static bool is_no_material(std::string_view name) { return name == "None" || name == "(null)"; }

  uint32_t resolve(std::string_view name) {
    if (name.empty()) return 0;
    if (is_no_material(name) && library_.find(name) == 0) return 0;
    const auto known = resolved_.find(name);
    if (known != resolved_.end()) return known->second;
    const uint32_t material = library_.find(name);
    resolved_.emplace(name, material);
    if (material == 0) {
      const char* kind = "unknown material: the default one is used";
      if (remarks_.count(kind))
        remarks_.describe(kind, name.data(),
                          "material \"" + std::string(name.substr(0, 80)) +
                              "\" is unknown; the default one is used");
    }
    return material;
  }

  const ObjModel& model_;
  const MaterialLibrary& library_;
  RemarkList& remarks_;
  uint32_t start_ = 0;
  std::unordered_map<std::string_view, uint32_t> resolved_;
};

class MeshBuilder {
public:
  MeshBuilder(ObjModel& model, const ModelFrame& frame, const std::vector<Material>& materials,
              const MeshOptions& options)
      : model_(model), frame_(frame), materials_(materials), options_(options) {}

  Mesh build(MaterialResolver& resolver) {
    const auto triangle_runs = resolver.runs(
        &StateChange::face, [](const ObjChunk& c) { return uint32_t(c.corner_vertices.values.size() / 3); });
    const auto segment_runs = resolver.runs(
        &StateChange::line, [](const ObjChunk& c) { return uint32_t(c.line_vertices.values.size() / 2); });
    const auto point_runs = resolver.runs(
        &StateChange::point, [](const ObjChunk& c) { return uint32_t(c.point_vertices.values.size()); });
    add_triangles(triangle_runs);
    add_elements(segment_runs, &ObjChunk::line_vertices, 2, mesh_.segment_positions, mesh_.segment_colors,
                 mesh_.segment_batches);
    add_elements(point_runs, &ObjChunk::point_vertices, 1, mesh_.point_positions, mesh_.point_colors,
                 mesh_.point_batches);
    return std::move(mesh_);
  }

private:
  // A batch per material in order of first use, and for each run the place in the batch.
  static std::vector<Batch> lay_out(const std::vector<MaterialRun>& runs, uint32_t per_element,
                                    std::vector<uint32_t>& places) {
    std::vector<Batch> batches;
    std::unordered_map<uint32_t, size_t> batch_of;
    for (const MaterialRun& run : runs) {
      const auto [found, added] = batch_of.emplace(run.material, batches.size());
      if (added) batches.push_back({run.material, 0, 0});
      batches[found->second].count += (run.last - run.first) * per_element;
    }
    uint32_t next = 0;
    for (Batch& batch : batches) {
      batch.first = next;
      next += batch.count;
    }
    std::vector<uint32_t> filled(batches.size(), 0);
    for (const MaterialRun& run : runs) {
      const size_t b = batch_of[run.material];
      places.push_back(batches[b].first + filled[b]);
      filled[b] += (run.last - run.first) * per_element;
    }
    return batches;
  }

  void add_triangles(const std::vector<MaterialRun>& runs) {
    std::vector<uint32_t> places;
    mesh_.triangle_batches = lay_out(runs, 3, places);
    size_t total = 0;
    for (const MaterialRun& run : runs) total += size_t(3) * (run.last - run.first);
    if (total == 0) return;
    mesh_.triangles.extend(total);
    with_texcoords_ = false;
    for (const ObjChunk& chunk : model_.chunks) with_texcoords_ |= !chunk.corner_texcoords.values.empty();
    with_texcoords_ = options_.has_texcoords.value_or(with_texcoords_ && model_.texcoord_count > 0) &&
                      options_.with_texcoords;
    if (options_.flat)
      mesh_.positions.room(3 * total);
    else
      head_.fill(model_.position_count, kNone);
    for (size_t r = 0; r < runs.size(); ++r) {
      const MaterialRun& run = runs[r];
      ObjChunk& chunk = model_.chunks[run.chunk];
      uint32_t* out = mesh_.triangles.data() + places[r];
      opacity_ = materials_[run.material].opacity;
      if (options_.flat)
        add_flat_run(chunk, run, out);
      else if (with_texcoords_ && !chunk.corner_texcoords.values.empty())
        add_run<true>(chunk, run, out);
      else
        add_run<false>(chunk, run, out);
      if (r + 1 < runs.size() && runs[r + 1].chunk == run.chunk) continue;
      for (IndexList* list : {&chunk.corner_vertices, &chunk.corner_texcoords, &chunk.corner_normals})
        list->values
            .release(); // while the mesh grows: both at once would be a sixth of the program's memory more
    }
  }

  static constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

  uint32_t add_vertex(int32_t vertex, int32_t texcoord) {
    const auto index = uint32_t(mesh_.positions.size() / 3);
    mesh_.positions.append(&frame_.positions[3 * size_t(vertex)], 3);
    if (with_texcoords_) {
      static constexpr float kZero[2] = {0, 0};
      mesh_.texcoords.append(texcoord == kAbsent ? kZero : &model_.texcoords[2 * size_t(texcoord)], 2);
    }
    if (!model_.colors.empty()) add_color(mesh_.colors, vertex, opacity_);
    return index;
  }

  // Where some vertex has a color, those without are white, as they are for most readers.
  void add_color(GrowingArray<float>& colors, int32_t vertex, float opacity) {
    const float* rgb = &model_.colors[3 * size_t(vertex)];
    for (int i = 0; i < 3; ++i) colors.append(std::isnan(rgb[i]) ? 1.0f : rgb[i]);
    colors.append(opacity);
  }

  // Vertex colors hold the opacity, so materials of different ones share no vertices.
  bool has_opacity(uint32_t index) const {
    return mesh_.colors.empty() || mesh_.colors[4 * size_t(index) + 3] == opacity_;
  }

  void add_normal(const float* n) {
    // Scaled first: the squares of a very short or long normal would leave the range of float.
    const float largest = std::max({std::fabs(n[0]), std::fabs(n[1]), std::fabs(n[2])});
    const float x = n[0] / largest, y = n[1] / largest, z = n[2] / largest;
    const float length = std::sqrt(x * x + y * y + z * z);
    float* out = mesh_.normals.extend(3);
    out[0] = x / length;
    out[1] = y / length;
    out[2] = z / length;
  }

  // Vertices with the same position, texture coordinate, normal and color are one; those of a position form a
  // list.
  template <bool kTexcoords> void add_run(const ObjChunk& chunk, const MaterialRun& run, uint32_t* out) {
    const int32_t* vertices = chunk.corner_vertices.values.data();
    const int32_t* texcoords = chunk.corner_texcoords.values.data();
    const int32_t* normals = chunk.corner_normals.values.data();
    for (size_t i = size_t(3) * run.first; i < size_t(3) * run.last; ++i) {
      const int32_t vertex = vertices[i], normal = normals[i];
      const int32_t texcoord = kTexcoords ? texcoords[i] : kAbsent;
      uint32_t* link = &head_[size_t(vertex)];
      uint32_t index = *link;
      // A position with very many variants: stop looking, a copy more does no harm.
      for (int steps = 0; index != kNone && steps < 32; ++steps) {
        const Variant& variant = variants_[index];
        if (variant.normal == normal && variant.texcoord == texcoord && has_opacity(index)) break;
        index = steps < 31 ? variant.next : kNone;
      }
      if (index == kNone) {
        index = add_vertex(vertex, texcoord);
        add_normal(&model_.normals[3 * size_t(normal)]);
        variants_.append({texcoord, normal, *link});
        *link = index;
      }
      *out++ = index;
    }
  }

  void add_flat_run(const ObjChunk& chunk, const MaterialRun& run, uint32_t* out) {
    const int32_t* vertices = chunk.corner_vertices.values.data();
    const bool textured = with_texcoords_ && !chunk.corner_texcoords.values.empty();
    for (size_t i = size_t(3) * run.first; i < size_t(3) * run.last; i += 3) {
      const float* p[3];
      for (size_t k = 0; k < 3; ++k) {
        p[k] = &frame_.positions[3 * size_t(vertices[i + k])];
        *out++ = add_vertex(vertices[i + k], textured ? chunk.corner_texcoords.values[i + k] : kAbsent);
      }
      const double ax = double(p[1][0]) - p[0][0], ay = double(p[1][1]) - p[0][1],
                   az = double(p[1][2]) - p[0][2];
      const double bx = double(p[2][0]) - p[0][0], by = double(p[2][1]) - p[0][1],
                   bz = double(p[2][2]) - p[0][2];
      const double n[3] = {ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx};
      const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis)
          mesh_.normals.append(length > 0 ? float(n[axis] / length) : axis == 2 ? 1.0f : 0.0f);
    }
  }

  void add_elements(const std::vector<MaterialRun>& runs, IndexList ObjChunk::*list, uint32_t per_element,
                    GrowingArray<float>& positions, GrowingArray<float>& colors,
                    std::vector<Batch>& batches) {
    std::vector<uint32_t> places;
    batches = lay_out(runs, per_element, places);
    // By material, in file order within each.
    std::vector<size_t> order(runs.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return places[a] < places[b]; });
    for (const size_t number : order) {
      const MaterialRun& run = runs[number];
      const GrowingArray<int32_t>& vertices = (model_.chunks[run.chunk].*list).values;
      for (size_t i = size_t(run.first) * per_element; i < size_t(run.last) * per_element; ++i) {
        positions.append(&frame_.positions[3 * size_t(vertices[i])], 3);
        if (!model_.colors.empty()) add_color(colors, vertices[i], 1);
      }
    }
  }

  struct Variant {
    int32_t texcoord, normal;
    uint32_t next;
  };

  ObjModel& model_;
  const ModelFrame& frame_;
  const std::vector<Material>& materials_;
  const MeshOptions& options_;
  float opacity_ = 1; // of the current run's material
  Mesh mesh_;
  bool with_texcoords_ = false;
  GrowingArray<uint32_t> head_; // per position, the vertex added last
  GrowingArray<Variant> variants_;
};

} // namespace

Mesh build_mesh(ObjModel& model, const ModelFrame& frame, const MaterialLibrary& library,
                const MeshOptions& options, RemarkList& remarks) {
  MaterialResolver materials(model, library, options.names_materials, remarks);
  return MeshBuilder(model, frame, library.materials(), options).build(materials);
}

} // namespace softgl::cli
