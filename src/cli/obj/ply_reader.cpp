#include "obj/ply_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "common/program_error.h"
#include "obj/model_assembly.h"
#include "obj/number_parser.h"

namespace softgl::cli {
namespace {

enum class Type { kNone, kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };
constexpr size_t kSizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};

Type type_of(std::string_view name) {
  static constexpr struct {
    std::string_view name;
    Type type;
  } kNames[] = {{"char", Type::kInt8},     {"int8", Type::kInt8},     {"uchar", Type::kUint8},
                {"uint8", Type::kUint8},   {"short", Type::kInt16},   {"int16", Type::kInt16},
                {"ushort", Type::kUint16}, {"uint16", Type::kUint16}, {"int", Type::kInt32},
                {"int32", Type::kInt32},   {"uint", Type::kUint32},   {"uint32", Type::kUint32},
                {"float", Type::kFloat},   {"float32", Type::kFloat}, {"double", Type::kDouble},
                {"float64", Type::kDouble}};
  for (const auto& known : kNames)
    if (known.name == name) return known.type;
  return Type::kNone;
}

struct Property {
  std::string name;
  Type type = Type::kNone;
  Type count_type = Type::kNone; // of a list
};

struct Element {
  std::string name;
  uint64_t count = 0;
  std::vector<Property> properties;

  int find(std::initializer_list<const char*> names) const {
    for (const char* name : names)
      for (size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == name && properties[i].count_type == Type::kNone) return int(i);
    return -1;
  }
};

class PlyReader {
public:
  PlyReader(const SourceText& text, RemarkList& remarks)
      : text_(text), remarks_(remarks), p_(text.begin()), end_(text.end()) {}

  ObjModel read() {
    read_header();
    const auto vertices = std::find_if(elements_.begin(), elements_.end(),
                                       [](const Element& element) { return element.name == "vertex"; });
    if (vertices == elements_.end() || vertices->find({"x"}) < 0 || vertices->find({"y"}) < 0 ||
        vertices->find({"z"}) < 0)
      refuse("has no vertices with x, y and z");
    find_places(*vertices);
    ModelAssembly assembly(remarks_, places_[9] >= 0 && places_[10] >= 0, has(3));
    for (const Element& element : elements_) {
      if (element.properties.empty()) continue;
      if (!read_element(element, &element == &*vertices, assembly)) {
        remarks_.add("cut off", nullptr,
                     "the file is cut off within its elements \"" + printable(element.name, 40) +
                         "\"; what is there is drawn");
        break;
      }
    }
    return assembly.take(text_);
  }

private:
  [[noreturn]] void refuse(const char* what) const {
    throw ProgramError(kCannotRead, text_.name() + ": this PLY file " + what);
  }

  std::string_view line() {
    const char* first = p_;
    while (p_ < end_ && *p_ != '\n' && *p_ != '\r') ++p_;
    const std::string_view result(first, size_t(p_ - first));
    if (p_ < end_) p_ += *p_ == '\r' && p_[1] == '\n' ? 2 : 1;
    return result;
  }

  static std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (size_t at = 0; at < line.size() && words.size() < 8;) {
      const size_t first = line.find_first_not_of(" \t", at);
      if (first == line.npos) break;
      at = std::min(line.find_first_of(" \t", first), line.size());
      words.push_back(line.substr(first, at - first));
    }
    return words;
  }

  void read_header() {
    line(); // ply
    bool has_format = false;
    for (int lines = 0; p_ < end_ && lines < 10000; ++lines) {
      const auto words = words_of(line());
      if (words.empty()) continue;
      if (words[0] == "end_header") {
        if (!has_format) refuse("does not say its format");
        return;
      }
      if (words[0] == "format" && words.size() >= 2) {
        has_format = true;
        binary_ = words[1] != "ascii";
        swapped_ = words[1] == "binary_big_endian";
        if (binary_ && !swapped_ && words[1] != "binary_little_endian") refuse("has an unknown format");
      } else if (words[0] == "element" && words.size() >= 3) {
        double count = 0;
        const std::string number(words[2]);
        const char* cursor = number.c_str();
        if (!read_number(cursor, count) || !(count >= 0 && count < 1e15))
          refuse("has a count that is no number");
        elements_.push_back({std::string(words[1]), uint64_t(count), {}});
      } else if (words[0] == "property" && words.size() >= 3 && !elements_.empty()) {
        Property property;
        const bool list = words[1] == "list" && words.size() >= 5;
        property.type = type_of(words[list ? 3 : 1]);
        if (list) property.count_type = type_of(words[2]);
        property.name = std::string(words[list ? 4 : 2]);
        if (property.type == Type::kNone || (list && property.count_type == Type::kNone))
          refuse("has a property of an unknown type");
        elements_.back().properties.push_back(property);
      }
    }
    refuse("has no end of its header");
  }

  bool number(Type type, double& value) {
    if (!binary_) {
      while (p_ < end_ && uint8_t(*p_) <= ' ') ++p_;
      if (p_ >= end_) return false;
      const char* token = p_;
      if (read_number(p_, value)) return true;
      if (p_ == token) ++p_; // '#' or '\\'
      value = std::numeric_limits<double>::quiet_NaN();
      return true;
    }
    const size_t size = kSizes[int(type)];
    if (size_t(end_ - p_) < size) return false;
    char bytes[8];
    std::memcpy(bytes, p_, size);
    p_ += size;
    if (swapped_) std::reverse(bytes, bytes + size);
    switch (type) {
    case Type::kInt8: value = as<int8_t>(bytes); break;
    case Type::kUint8: value = as<uint8_t>(bytes); break;
    case Type::kInt16: value = as<int16_t>(bytes); break;
    case Type::kUint16: value = as<uint16_t>(bytes); break;
    case Type::kInt32: value = as<int32_t>(bytes); break;
    case Type::kUint32: value = as<uint32_t>(bytes); break;
    case Type::kFloat: value = double(as<float>(bytes)); break;
    default: value = as<double>(bytes);
    }
    return true;
  }

  template <class T> static T as(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

  // Where the properties of a vertex stand: x y z, nx ny nz, red green blue, s t; -1 where there is none.
  void find_places(const Element& vertices) {
    places_ = {vertices.find({"x"}),
               vertices.find({"y"}),
               vertices.find({"z"}),
               vertices.find({"nx"}),
               vertices.find({"ny"}),
               vertices.find({"nz"}),
               vertices.find({"red", "r", "diffuse_red"}),
               vertices.find({"green", "g", "diffuse_green"}),
               vertices.find({"blue", "b", "diffuse_blue"}),
               vertices.find({"s", "u", "texture_u"}),
               vertices.find({"t", "v", "texture_v"})};
  }
  bool has(size_t first) const {
    return places_[first] >= 0 && places_[first + 1] >= 0 && places_[first + 2] >= 0;
  }

  // `vertices`: it is the element of find_places(). False: the file ends before its elements do.
  bool read_element(const Element& element, bool vertices, ModelAssembly& assembly) {
    const bool faces = element.name == "face";
    std::vector<double> values(element.properties.size());
    std::vector<int64_t> corners;
    for (uint64_t i = 0; i < element.count; ++i) {
      for (size_t k = 0; k < values.size(); ++k) {
        const Property& property = element.properties[k];
        if (property.count_type == Type::kNone) {
          if (!number(property.type, values[k])) return false;
          continue;
        }
        const bool wanted = faces && (property.name == "vertex_indices" || property.name == "vertex_index");
        if (!read_list(property, wanted ? &corners : nullptr)) return false;
      }
      if (vertices) add_vertex(element, values, assembly);
      if (faces) {
        assembly.add_face(corners.data(), corners.size());
        corners.clear();
      }
    }
    return true;
  }

  bool read_list(const Property& property, std::vector<int64_t>* corners) {
    double count;
    if (!number(property.count_type, count)) return false;
    if (!(count >= 0 && count <= double(end_ - p_))) return false; // each takes a byte at least
    for (auto left = uint64_t(count); left > 0; --left) {
      double value;
      if (!number(property.type, value)) return false;
      if (corners) corners->push_back(value >= 0 && value < 2147483647 ? int64_t(value) : -1);
    }
    return true;
  }

  void add_vertex(const Element& element, const std::vector<double>& values, ModelAssembly& assembly) {
    const auto value = [&](size_t place) { return values[size_t(places_[place])]; };
    const double xyz[3] = {value(0), value(1), value(2)};
    assembly.add_vertex(xyz);
    if (has(3)) {
      const float n[3] = {float(value(3)), float(value(4)), float(value(5))};
      assembly.add_normal(n);
    }
    if (has(6)) {
      float rgb[3];
      for (size_t i = 0; i < 3; ++i) {
        const Type type = element.properties[size_t(places_[6 + i])].type;
        const double full = type == Type::kUint16                           ? 65535
                            : type == Type::kFloat || type == Type::kDouble ? 1
                                                                            : 255;
        rgb[i] = float(value(6 + i) / full);
      }
      assembly.add_color(rgb);
    }
    if (places_[9] >= 0 && places_[10] >= 0) assembly.add_texcoord(float(value(9)), float(value(10)));
  }

  const SourceText& text_;
  RemarkList& remarks_;
  const char* p_;
  const char* const end_;
  bool binary_ = false, swapped_ = false;
  std::vector<Element> elements_;
  std::array<int, 11> places_{};
};

} // namespace

bool is_ply(const SourceText& text) {
  const std::string_view start(text.begin(), std::min<size_t>(text.size(), 4));
  return start == "ply\n" || start == "ply\r";
}

ObjModel read_ply(const SourceText& text, RemarkList& remarks) { return PlyReader(text, remarks).read(); }

} // namespace softgl::cli
