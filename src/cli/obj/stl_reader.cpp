#include "obj/stl_reader.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "obj/model_assembly.h"
#include "obj/number_parser.h"

namespace softgl::cli {
namespace {

constexpr size_t kHeader = 84, kFacet = 50; // bytes: a comment and the number of facets; each facet

uint32_t claimed_facets(const SourceText& text) {
  uint32_t count;
  std::memcpy(&count, text.begin() + kHeader - 4, 4); // little-endian, as we are
  return count;
}

bool is_text(const SourceText& text) {
  const std::string_view start(text.begin(), std::min<size_t>(text.size(), 1024));
  return start.substr(0, 5) == "solid" && start.find("facet") != start.npos && start.find('\0') == start.npos;
}

// The numbers of places that were seen before: a hash table with open addresses.
class Places {
public:
  explicit Places(ModelAssembly& assembly) : assembly_(assembly), slots_(1024, kFree) {}

  int64_t number_of(const float* xyz) {
    Place place;
    for (int i = 0; i < 3; ++i)
      place.bits[i] = std::bit_cast<uint32_t>(xyz[i] == 0 ? 0.0f : xyz[i]); // -0 is 0
    if (2 * places_.size() >= slots_.size()) grow();
    uint32_t& slot = slots_[find(place)];
    if (slot == kFree) {
      slot = uint32_t(places_.size());
      places_.append(place);
      const double values[3] = {xyz[0], xyz[1], xyz[2]};
      assembly_.add_vertex(values);
    }
    return slot;
  }

private:
  static constexpr uint32_t kFree = 0xffffffff;
  struct Place {
    uint32_t bits[3];
  };

  size_t find(const Place& place) const {
    uint64_t hash = 0;
    for (const uint32_t bits : place.bits) hash = (hash ^ bits) * 0x9e3779b97f4a7c15u, hash ^= hash >> 29;
    for (size_t at = hash & (slots_.size() - 1);; at = (at + 1) & (slots_.size() - 1))
      if (slots_[at] == kFree || std::equal(place.bits, place.bits + 3, places_[slots_[at]].bits)) return at;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    for (uint32_t i = 0; i < places_.size(); ++i) slots_[find(places_[i])] = i;
  }

  ModelAssembly& assembly_;
  GrowingArray<Place> places_;
  std::vector<uint32_t> slots_;
};

void read_binary(const SourceText& text, ModelAssembly& assembly, Places& places, RemarkList& remarks) {
  const size_t there = (text.size() - kHeader) / kFacet, claimed = claimed_facets(text);
  if (there < claimed)
    remarks.add("cut off", nullptr,
                "the file is cut off: it has " + std::to_string(there) + " of " + std::to_string(claimed) +
                    " triangles");
  const char* facet = text.begin() + kHeader;
  for (size_t i = 0; i < std::min(there, claimed); ++i, facet += kFacet) {
    int64_t corners[3];
    for (size_t k = 0; k < 3; ++k) {
      float xyz[3];
      std::memcpy(xyz, facet + 12 * (k + 1), sizeof xyz); // the normal comes first
      corners[k] = places.number_of(xyz);
    }
    assembly.add_face(corners, 3);
  }
}

class TextReader {
public:
  TextReader(const SourceText& text, ModelAssembly& assembly, Places& places, RemarkList& remarks)
      : p_(text.begin()), end_(text.end()), assembly_(assembly), places_(places), remarks_(remarks) {}

  void read() {
    for (std::string_view word; !(word = next_word()).empty();) {
      if (word == "vertex")
        vertex();
      else if (word == "endloop" || word == "endfacet")
        close();
    }
    if (!corners_.empty()) remarks_.add("cut off", nullptr, "the file ends within a facet");
  }

private:
  std::string_view next_word() {
    while (p_ < end_ && uint8_t(*p_) <= ' ') ++p_;
    const char* first = p_;
    while (p_ < end_ && uint8_t(*p_) > ' ') ++p_;
    return {first, size_t(p_ - first)};
  }

  void vertex() {
    const char* statement = p_;
    float xyz[3] = {0, 0, 0};
    for (float& value : xyz) {
      while (*p_ == ' ' || *p_ == '\t') ++p_;
      const char* token = p_;
      if (read_number(p_, value) && p_ > token) continue;
      remarks_.add("facet with a vertex that is not three numbers: skipped", statement,
                   "a vertex needs three numbers; its facet is skipped");
      good_ = false;
      break;
    }
    corners_.push_back(good_ ? places_.number_of(xyz) : -1);
  }

  void close() {
    if (good_ && !corners_.empty()) assembly_.add_face(corners_.data(), corners_.size());
    corners_.clear();
    good_ = true;
  }

  const char* p_;
  const char* const end_;
  ModelAssembly& assembly_;
  Places& places_;
  RemarkList& remarks_;
  std::vector<int64_t> corners_;
  bool good_ = true;
};

} // namespace

bool is_stl(const SourceText& text) {
  if (is_text(text)) return true;
  if (text.size() < kHeader) return false;
  const uint64_t wanted = kHeader + uint64_t(kFacet) * claimed_facets(text);
  if (text.size() == wanted && claimed_facets(text) > 0) return true;
  // By its name, if it is not as long as it says.
  std::string name = text.name();
  for (char& c : name) c = char(c >= 'A' && c <= 'Z' ? c + 32 : c);
  const std::string_view start(text.begin(), kHeader);
  return name.find(".stl") != name.npos && start.find('\0') != start.npos;
}

ObjModel read_stl(const SourceText& text, RemarkList& remarks) {
  ModelAssembly assembly(remarks, false, false);
  Places places(assembly);
  if (is_text(text))
    TextReader(text, assembly, places, remarks).read();
  else
    read_binary(text, assembly, places, remarks);
  return assembly.take(text);
}

} // namespace softgl::cli
