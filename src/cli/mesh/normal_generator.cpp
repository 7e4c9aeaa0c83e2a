#include "mesh/normal_generator.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "common/trigonometry.h"

namespace softgl::cli {
namespace {

constexpr int32_t kNoGroup = -1; // before the first `s`
constexpr size_t kLanes = 64;

// Normals and corner angles of up to 64 triangles, as arrays the compiler vectorizes.
struct TriangleBlock {
  float x[3][kLanes], y[3][kLanes], z[3][kLanes];
  float nx[kLanes], ny[kLanes], nz[kLanes]; // unit, or 0 for a triangle without area
  float angle[3][kLanes];

  void load(const float* positions, const int32_t* vertices, size_t count) {
    for (size_t i = 0; i < count; ++i)
      for (size_t k = 0; k < 3; ++k) {
        const float* p = positions + 3 * size_t(vertices[3 * i + k]);
        x[k][i] = p[0];
        y[k][i] = p[1];
        z[k][i] = p[2];
      }
    for (size_t i = count; i < kLanes; ++i)
      for (size_t k = 0; k < 3; ++k) x[k][i] = y[k][i] = z[k][i] = 0;
  }

  void compute_normals() {
    for (size_t i = 0; i < kLanes; ++i) {
      const float ax = x[1][i] - x[0][i], ay = y[1][i] - y[0][i], az = z[1][i] - z[0][i];
      const float bx = x[2][i] - x[0][i], by = y[2][i] - y[0][i], bz = z[2][i] - z[0][i];
      const float cx = ay * bz - az * by, cy = az * bx - ax * bz, cz = ax * by - ay * bx;
      // Scaled up first: the square of a small triangle's area would be no number any more.
      const float largest = std::max(std::max(std::fabs(cx), std::fabs(cy)), std::fabs(cz));
      const float scale = largest > 1e-36f ? 1 / largest : 0;
      const float sx = cx * scale, sy = cy * scale, sz = cz * scale;
      const float length = std::sqrt(sx * sx + sy * sy + sz * sz);
      const float inverse = length > 0 ? 1 / length : 0;
      nx[i] = sx * inverse;
      ny[i] = sy * inverse;
      nz[i] = sz * inverse;
    }
  }

  // acos by a polynomial (Abramowitz and Stegun 4.4.45, error 7e-5): weights need no more, and no two C
  // libraries differ.
  void compute_angles() {
    for (size_t k = 0; k < 3; ++k) {
      const size_t l = (k + 1) % 3, m = (k + 2) % 3;
      for (size_t i = 0; i < kLanes; ++i) {
        const float ax = x[l][i] - x[k][i], ay = y[l][i] - y[k][i], az = z[l][i] - z[k][i];
        const float bx = x[m][i] - x[k][i], by = y[m][i] - y[k][i], bz = z[m][i] - z[k][i];
        const float lengths = (ax * ax + ay * ay + az * az) * (bx * bx + by * by + bz * bz);
        const float inverse = 1 / std::sqrt(lengths > 1e-36f ? lengths : 1e-36f);
        float cosine = (ax * bx + ay * by + az * bz) * inverse;
        cosine = std::min(std::max(cosine, -1.0f), 1.0f);
        const float c = std::fabs(cosine);
        const float half =
            std::sqrt(1 - c) * (1.5707288f + c * (-0.2121144f + c * (0.0742610f + c * -0.0187293f)));
        angle[k][i] = cosine < 0 ? 3.14159265f - half : half;
      }
    }
  }
};

struct Incidence { // a corner at a position whose faces are not all smooth
  float n[3];
  float angle;
  int32_t group;
  int32_t* normal; // where the corner's normal index goes; null: the file gives one
};

class NormalGenerator {
public:
  NormalGenerator(ObjModel& model, const ModelFrame& frame, const NormalOptions& options)
      : model_(model), positions_(frame.positions.data()), use_groups_(!options.ignore_groups) {
    const double crease = std::clamp(options.crease_angle, 0.0, 180.0);
    cos_crease_ = float(cosine(crease)) - 1e-6f; // an angle just as large is smooth
    // Faces within half the angle of the mean are within the angle of each other.
    cos_half_crease_ = float(cosine(crease / 2)) + 1e-6f;
  }

  uint64_t run() {
    const uint64_t missing = prepare_corners();
    if (missing == 0) return 0;
    const size_t count = model_.position_count;
    find_places();
    sums_.fill(3 * count, 0.0f);
    sharp_.fill(count, 0);
    if (use_groups_ && model_.has_smoothing_groups) groups_.fill(count, kUnseen);
    accumulate();
    normalize_sums();
    mark_creases();
    write_smooth_normals();
    split_sharp_positions();
    return missing;
  }

private:
  static constexpr int32_t kUnseen = -2;

  // Vertices at one place, of exactly the same coordinates, are one for the normals.
  void find_places() {
    const size_t count = model_.position_count;
    size_t slots = 64;
    while (slots < 2 * count) slots *= 2;
    GrowingArray<int32_t> table;
    table.fill(slots, -1);
    bool any = false;
    places_.extend(count);
    for (size_t i = 0; i < count; ++i) {
      places_[i] = int32_t(i);
      const float* p = positions_ + 3 * i;
      uint32_t bits[3];
      for (size_t axis = 0; axis < 3; ++axis) bits[axis] = std::bit_cast<uint32_t>(p[axis] + 0.0f); // no -0
      uint64_t hash = (bits[0] | uint64_t(bits[1]) << 32) * 0x9e3779b97f4a7c15u;
      hash = (hash ^ (hash >> 29) ^ bits[2]) * 0xbf58476d1ce4e5b9u;
      size_t slot = (hash >> 32) & (slots - 1);
      for (int probes = 0; probes < 64; ++probes, slot = (slot + 1) & (slots - 1)) {
        int32_t& entry = table[slot];
        if (entry < 0) {
          entry = int32_t(i);
          break;
        }
        const float* q = positions_ + 3 * size_t(entry);
        if (p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) {
          places_[i] = entry;
          any = true;
          break;
        }
      }
    }
    if (!any) places_.release();
  }

  size_t place_of(int32_t vertex) const { return size_t(places_.empty() ? vertex : places_[size_t(vertex)]); }

  uint64_t prepare_corners() {
    uint64_t missing = 0;
    for (ObjChunk& chunk : model_.chunks) {
      GrowingArray<int32_t>& normals = chunk.corner_normals.values;
      if (normals.empty()) normals.fill(chunk.corner_vertices.values.size(), kAbsent);
      uint64_t absent = 0;
      for (const int32_t normal : normals) absent += normal == kAbsent;
      missing += absent;
    }
    return missing;
  }

  // Calls visit(chunk, first triangle, count <= 64, group) over all triangles in file order.
  template <class Visit> void for_each_block(const Visit& visit) {
    int32_t group = kNoGroup;
    for (ObjChunk& chunk : model_.chunks) {
      const size_t total = chunk.corner_vertices.values.size() / 3;
      size_t change = 0;
      for (size_t first = 0; first < total;) {
        while (change < chunk.changes.size() && chunk.changes[change].face <= first) {
          const StateChange& c = chunk.changes[change++];
          if (use_groups_ && c.kind == StateChange::kSmoothingGroup) group = c.group;
        }
        size_t last = std::min(total, first + kLanes);
        for (size_t next = change; next < chunk.changes.size() && chunk.changes[next].face < last; ++next)
          if (chunk.changes[next].kind == StateChange::kSmoothingGroup && chunk.changes[next].face > first)
            last = chunk.changes[next].face;
        visit(chunk, first, last - first, group);
        first = last;
      }
      for (; change < chunk.changes.size(); ++change)
        if (use_groups_ && chunk.changes[change].kind == StateChange::kSmoothingGroup)
          group = chunk.changes[change].group;
    }
  }

  void accumulate() {
    for_each_block([&](ObjChunk& chunk, size_t first, size_t count, int32_t group) {
      const int32_t* vertices = chunk.corner_vertices.values.data() + 3 * first;
      block_.load(positions_, vertices, count);
      block_.compute_normals();
      block_.compute_angles();
      for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < 3; ++k) {
          float* sum = &sums_[3 * place_of(vertices[3 * i + k])];
          const float weight = block_.angle[k][i];
          sum[0] += weight * block_.nx[i];
          sum[1] += weight * block_.ny[i];
          sum[2] += weight * block_.nz[i];
        }
      if (groups_.empty()) return;
      for (size_t i = 0; i < 3 * count; ++i) {
        const size_t vertex = place_of(vertices[i]);
        if (groups_[vertex] == kUnseen) groups_[vertex] = group;
        if (groups_[vertex] != group || group == 0) sharp_[vertex] = 1;
      }
    });
  }

  static bool normalize(float* n) {
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(length > 1e-12f)) return false;
    for (int axis = 0; axis < 3; ++axis) n[axis] /= length;
    return true;
  }

  void normalize_sums() {
    for (size_t i = 0; i < sums_.size(); i += 3)
      if (!normalize(&sums_[i])) { // no face with area, or faces that cancel each other
        sums_[i] = sums_[i + 1] = 0;
        sums_[i + 2] = 1;
        sharp_[i / 3] = 1;
      }
  }

  void mark_creases() {
    for_each_block([&](ObjChunk& chunk, size_t first, size_t count, int32_t group) {
      if (group > 0) return; // a smoothing group needs no angle
      const int32_t* vertices = chunk.corner_vertices.values.data() + 3 * first;
      block_.load(positions_, vertices, count);
      block_.compute_normals();
      for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < 3; ++k) {
          const size_t vertex = place_of(vertices[3 * i + k]);
          const float* mean = &sums_[3 * vertex];
          const float towards = mean[0] * block_.nx[i] + mean[1] * block_.ny[i] + mean[2] * block_.nz[i];
          const bool flat = block_.nx[i] == 0 && block_.ny[i] == 0 && block_.nz[i] == 0;
          sharp_[vertex] |= uint8_t(!(towards >= cos_half_crease_) & !flat);
        }
    });
  }

  void write_smooth_normals() {
    base_ = int32_t(model_.normals.size() / 3);
    model_.normals.append(sums_.data(), sums_.size());
    for (ObjChunk& chunk : model_.chunks)
      for (size_t i = 0; i < chunk.corner_normals.values.size(); ++i) {
        int32_t& normal = chunk.corner_normals.values[i];
        if (normal == kAbsent) normal = base_ + int32_t(place_of(chunk.corner_vertices.values[i]));
      }
  }

  // Positions with more than one normal: every corner's own mean over the faces that belong to its face.
  void split_sharp_positions() {
    GrowingArray<uint32_t> start; // of each sharp position's incidences
    size_t total = 0;
    for (const ObjChunk& chunk : model_.chunks)
      for (const int32_t vertex : chunk.corner_vertices.values) total += sharp_[place_of(vertex)];
    if (total == 0) return;
    start.fill(model_.position_count + 1, 0);
    for (const ObjChunk& chunk : model_.chunks)
      for (const int32_t vertex : chunk.corner_vertices.values)
        start[place_of(vertex) + 1] += sharp_[place_of(vertex)];
    for (size_t i = 0; i < model_.position_count; ++i) start[i + 1] += start[i];
    GrowingArray<Incidence> incidences;
    incidences.extend(total);
    for_each_block([&](ObjChunk& chunk, size_t first, size_t count, int32_t group) {
      const int32_t* vertices = chunk.corner_vertices.values.data() + 3 * first;
      int32_t* normals = chunk.corner_normals.values.data() + 3 * first;
      bool any = false;
      for (size_t i = 0; i < 3 * count; ++i) any |= sharp_[place_of(vertices[i])] != 0;
      if (!any) return;
      block_.load(positions_, vertices, count);
      block_.compute_normals();
      block_.compute_angles();
      for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < 3; ++k) {
          const size_t vertex = place_of(vertices[3 * i + k]);
          if (!sharp_[vertex]) continue;
          int32_t* normal = normals + 3 * i + k;
          incidences[start[vertex]++] = {{block_.nx[i], block_.ny[i], block_.nz[i]},
                                         block_.angle[k][i],
                                         group,
                                         *normal >= base_ ? normal : nullptr};
        }
    });
    size_t begin = 0;
    for (size_t vertex = 0; vertex < model_.position_count; ++vertex) {
      const size_t end = start[vertex];
      if (end > begin) split(incidences.data() + begin, end - begin);
      begin = std::max(begin, end);
    }
  }

  bool belong_together(const Incidence& a, const Incidence& b) const {
    if (a.group != b.group || a.group == 0) return false;
    if (a.group > 0) return true;
    return a.n[0] * b.n[0] + a.n[1] * b.n[1] + a.n[2] * b.n[2] >= cos_crease_;
  }

  int32_t add_normal(const float* n, size_t first_of_position) {
    const size_t count = model_.normals.size() / 3;
    for (size_t i = first_of_position; i < count && i < first_of_position + 16; ++i)
      if (std::equal(n, n + 3, &model_.normals[3 * i])) return int32_t(i);
    model_.normals.append(n, 3);
    return int32_t(count);
  }

  void split(const Incidence* around, size_t count) {
    const size_t first_of_position = model_.normals.size() / 3;
    if (count > 128) {
      split_hub(around, count, first_of_position);
      return;
    }
    for (size_t i = 0; i < count; ++i) {
      if (!around[i].normal) continue;
      float sum[3] = {0, 0, 0};
      for (size_t j = 0; j < count; ++j) {
        if (j != i && !belong_together(around[i], around[j])) continue;
        for (int axis = 0; axis < 3; ++axis) sum[axis] += around[j].angle * around[j].n[axis];
      }
      if (!normalize(sum)) std::copy_n(around[i].n, 3, sum);
      set_normal(around[i], sum, first_of_position);
    }
  }

  void set_normal(const Incidence& corner, float* n, size_t first_of_position) {
    if (n[0] == 0 && n[1] == 0 && n[2] == 0) return; // a face without area keeps the mean
    *corner.normal = add_normal(n, first_of_position);
  }

  // The hub of a large fan: comparing all pairs would be quadratic, so faces join the first of a few bundles.
  void split_hub(const Incidence* around, size_t count, size_t first_of_position) {
    struct Bundle {
      const Incidence* first;
      float sum[3];
    };
    std::vector<Bundle> bundles;
    std::vector<size_t> bundle_of(count);
    for (size_t i = 0; i < count; ++i) {
      size_t b = 0;
      while (b < bundles.size() && !belong_together(*bundles[b].first, around[i])) ++b;
      if (b == bundles.size()) {
        if (bundles.size() < 64 && around[i].group != 0)
          bundles.push_back({&around[i], {0, 0, 0}});
        else
          b = SIZE_MAX;
      }
      bundle_of[i] = b;
      if (b != SIZE_MAX)
        for (int axis = 0; axis < 3; ++axis) bundles[b].sum[axis] += around[i].angle * around[i].n[axis];
    }
    for (Bundle& bundle : bundles)
      if (!normalize(bundle.sum)) std::copy_n(bundle.first->n, 3, bundle.sum);
    for (size_t i = 0; i < count; ++i) {
      if (!around[i].normal) continue;
      float n[3];
      std::copy_n(bundle_of[i] == SIZE_MAX ? around[i].n : bundles[bundle_of[i]].sum, 3, n);
      set_normal(around[i], n, first_of_position);
    }
  }

  ObjModel& model_;
  const float* positions_;
  const bool use_groups_;
  float cos_crease_, cos_half_crease_;
  TriangleBlock block_;
  GrowingArray<int32_t> places_; // per vertex, the first one at its place; empty if no two share one
  GrowingArray<float> sums_;
  GrowingArray<uint8_t> sharp_;
  GrowingArray<int32_t> groups_; // the first face's group at each position; empty without smoothing groups
  int32_t base_ = 0;
};

} // namespace

uint64_t generate_normals(ObjModel& model, const ModelFrame& frame, const NormalOptions& options) {
  return NormalGenerator(model, frame, options).run();
}

} // namespace softgl::cli
