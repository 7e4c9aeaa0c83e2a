#include "mpi/ghost_faces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <unordered_map>

namespace softgl::cli {
namespace {

constexpr size_t kPlacesAtOnce = size_t(1) << 19; // that a rank sends: 6 MB
constexpr size_t kFaceWords = 10;                 // three places and a smoothing group
constexpr int32_t kNoGroup = -1;                  // before the first `s`

using Place = std::array<uint32_t, 3>;

// Zeros have no sign: the normals of places that are equal numbers are one.
Place place_of(const float* position) {
  Place place;
  for (size_t axis = 0; axis < 3; ++axis) place[axis] = std::bit_cast<uint32_t>(position[axis] + 0.0f);
  return place;
}

uint64_t hash_of(const Place& place) {
  uint64_t hash = (place[0] | uint64_t(place[1]) << 32) * 0x9e3779b97f4a7c15u;
  hash = (hash ^ (hash >> 29) ^ place[2]) * 0xbf58476d1ce4e5b9u;
  return hash ^ hash >> 32;
}

// Each place has a rank that keeps the list of those who use it, chosen by its hash. Ranks tell it their
// places, and learn who has the same.
class SharedPlaces {
public:
  SharedPlaces(const ObjModel& model, const ModelFrame& frame, const Ranks& ranks)
      : frame_(frame), ranks_(ranks), used_(model.position_count) {
    for (const ObjChunk& chunk : model.chunks)
      for (const int32_t vertex : chunk.corner_vertices.values) used_[size_t(vertex)] = true;
    const uint64_t count = ranks.largest(uint64_t(std::count(used_.begin(), used_.end(), true)));
    const uint64_t rounds = count / kPlacesAtOnce + 1;
    for (uint64_t round = 0; round < rounds; ++round) run_round(round, rounds);
  }

  // Other ranks at the vertex's place; null if there are none.
  const std::vector<int>* others(int32_t vertex) const {
    const auto found = others_.find(vertex);
    return found == others_.end() ? nullptr : &found->second;
  }
  bool empty() const { return others_.empty(); }

private:
  struct Entry {
    Place place;
    uint32_t rank, number; // of the sender, and in its message
    bool operator<(const Entry& other) const { return place < other.place; }
  };

  void run_round(uint64_t round, uint64_t rounds) {
    const auto count = size_t(ranks_.count());
    std::vector<std::vector<uint32_t>> places(count);
    std::vector<std::vector<int32_t>> vertices(count);
    for (size_t vertex = 0; vertex < used_.size(); ++vertex) {
      if (!used_[vertex]) continue;
      const Place place = place_of(&frame_.positions[3 * vertex]);
      const uint64_t hash = hash_of(place);
      if (hash % rounds != round) continue;
      const size_t keeper = size_t(hash / rounds % count);
      places[keeper].insert(places[keeper].end(), place.begin(), place.end());
      vertices[keeper].push_back(int32_t(vertex));
    }
    const auto answers = ranks_.swap(match(ranks_.swap(std::move(places))));
    for (size_t keeper = 0; keeper < count; ++keeper) {
      const std::vector<uint32_t>& words = answers[keeper];
      for (size_t i = 0; i < words.size(); i += 2 + words[i + 1])
        others_[vertices[keeper][words[i]]].assign(&words[i + 2], &words[i + 2] + words[i + 1]);
    }
  }

  // For each place that several ranks have: its number in the message, how many others, and which.
  static std::vector<std::vector<uint32_t>> match(std::vector<std::vector<uint32_t>> places) {
    std::vector<Entry> entries;
    for (size_t rank = 0; rank < places.size(); ++rank) {
      for (size_t i = 0; i < places[rank].size(); i += 3)
        entries.push_back(
            {{places[rank][i], places[rank][i + 1], places[rank][i + 2]}, uint32_t(rank), uint32_t(i / 3)});
      places[rank].clear();
    }
    std::stable_sort(entries.begin(), entries.end());
    for (size_t first = 0, last = 0; first < entries.size(); first = last) {
      std::vector<uint32_t> users;
      for (; last < entries.size() && entries[last].place == entries[first].place; ++last)
        if (users.empty() || users.back() != entries[last].rank) users.push_back(entries[last].rank);
      if (users.size() < 2) continue;
      for (size_t i = first; i < last; ++i) {
        std::vector<uint32_t>& answer = places[entries[i].rank];
        answer.push_back(entries[i].number);
        answer.push_back(uint32_t(users.size() - 1));
        for (const uint32_t user : users)
          if (user != entries[i].rank) answer.push_back(user);
      }
    }
    return places;
  }

  const ModelFrame& frame_;
  const Ranks& ranks_;
  std::vector<bool> used_;
  std::unordered_map<int32_t, std::vector<int>> others_;
};

// Calls visit(chunk, triangle, smoothing group) in the order of the file.
template <class Visit> void for_each_triangle(const ObjModel& model, const Visit& visit) {
  int32_t group = kNoGroup;
  for (const ObjChunk& chunk : model.chunks) {
    const size_t total = chunk.corner_vertices.values.size() / 3;
    size_t change = 0;
    for (size_t triangle = 0; triangle <= total; ++triangle) {
      for (; change < chunk.changes.size() && chunk.changes[change].face <= triangle; ++change)
        if (chunk.changes[change].kind == StateChange::kSmoothingGroup) group = chunk.changes[change].group;
      if (triangle < total) visit(chunk, triangle, group);
    }
  }
}

std::vector<std::vector<uint32_t>> pack_faces(const ObjModel& model, const ModelFrame& frame,
                                              const SharedPlaces& shared, const Ranks& ranks) {
  std::vector<std::vector<uint32_t>> packed(size_t(ranks.count()));
  if (shared.empty()) return packed;
  std::vector<int> takers;
  for_each_triangle(model, [&](const ObjChunk& chunk, size_t triangle, int32_t group) {
    const int32_t* corners = &chunk.corner_vertices.values[3 * triangle];
    takers.clear();
    for (size_t k = 0; k < 3; ++k)
      if (const std::vector<int>* others = shared.others(corners[k]))
        takers.insert(takers.end(), others->begin(), others->end());
    if (takers.empty()) return;
    uint32_t words[kFaceWords];
    for (size_t k = 0; k < 3; ++k) std::memcpy(words + 3 * k, &frame.positions[3 * size_t(corners[k])], 12);
    words[9] = uint32_t(group);
    std::sort(takers.begin(), takers.end());
    takers.erase(std::unique(takers.begin(), takers.end()), takers.end());
    for (const int taker : takers) {
      std::vector<uint32_t>& message = packed[size_t(taker)];
      message.insert(message.end(), words, words + kFaceWords);
    }
  });
  return packed;
}

ObjChunk unpack_faces(const std::vector<uint32_t>& words, ObjModel& model, ModelFrame& frame) {
  ObjChunk chunk;
  int32_t group = kNoGroup;
  for (size_t i = 0; i < words.size(); i += kFaceWords) {
    const auto own_group = int32_t(words[i + 9]);
    if (own_group != group) {
      group = own_group;
      chunk.changes.push_back({StateChange::kSmoothingGroup, group, {}, chunk.face_count, 0, 0});
    }
    for (size_t k = 0; k < 3; ++k) {
      std::memcpy(frame.positions.extend(3), &words[i + 3 * k], 12);
      chunk.corner_vertices.values.append(int32_t(model.position_count++));
    }
    ++chunk.face_count;
  }
  return chunk;
}

} // namespace

size_t add_ghost_faces(ObjModel& model, ModelFrame& frame, const Ranks& ranks) {
  std::vector<std::vector<uint32_t>> faces;
  {
    const SharedPlaces shared(model, frame, ranks);
    faces = ranks.swap(pack_faces(model, frame, shared, ranks));
  }
  std::vector<ObjChunk> before, behind;
  for (size_t rank = 0; rank < faces.size(); ++rank) {
    if (faces[rank].empty()) continue;
    (rank < size_t(ranks.rank()) ? before : behind).push_back(unpack_faces(faces[rank], model, frame));
    faces[rank] = {};
  }
  const size_t count = before.size();
  for (std::vector<ObjChunk>* chunks : {&model.chunks, &behind})
    for (ObjChunk& chunk : *chunks) before.push_back(std::move(chunk));
  model.chunks = std::move(before);
  return count;
}

void drop_ghost_faces(ObjModel& model, size_t first, size_t count) {
  model.chunks.erase(model.chunks.begin() + long(first + count), model.chunks.end());
  model.chunks.erase(model.chunks.begin(), model.chunks.begin() + long(first));
}

} // namespace softgl::cli
