#include "obj/material_library.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <strings.h>
#include <unordered_set>

#include "common/program_error.h"
#include "common/utf16_text.h"
#include "obj/file_search.h"
#include "obj/number_parser.h"
#include "obj/texture_option_parser.h"

namespace softgl::cli {
namespace {

constexpr int kMostMissingPictures = 1000; // each costs a look into the folder
constexpr size_t kMostLibraries = 256;     // of one model that are looked for; lines and names in them
constexpr size_t kLargestLibrary = size_t(256) << 20;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && ends_token(text.front()) && text.front() != '#' && text.front() != '\\')
    text.remove_prefix(1);
  while (!text.empty() && ends_token(text.back()) && text.back() != '#' && text.back() != '\\')
    text.remove_suffix(1);
  return text;
}

bool is_key(std::string_view word) {
  return !word.empty() && word.size() <= 32 && std::all_of(word.begin(), word.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == '-';
  });
}

// One MTL file: statements in order, values of the material that the last newmtl began.
class LibraryReader {
public:
  LibraryReader(const SourceText& text, const ModelFiles& files, const std::string& folder, bool strict)
      : text_(text), files_(files), folder_(folder), strict_(strict) {}

  void read() {
    const char* p = text_.begin();
    if (text_.size() >= 3 && std::string_view(p, 3) == "\xef\xbb\xbf") p += 3;
    std::string joined;
    while (p < text_.end()) {
      statement_ = p;
      std::string_view line = take_line(p);
      if (!line.empty() && line.back() == '\\' &&
          trimmed(line).substr(0, 1) != "#") { // a Windows folder ends so too
        joined.assign(line.substr(0, line.size() - 1));
        while (p < text_.end()) {
          std::string_view more = take_line(p);
          const bool continued = !more.empty() && more.back() == '\\';
          if (continued) more.remove_suffix(1);
          joined += ' ';
          joined += more;
          if (!continued) break;
        }
        line = joined;
      }
      line = trimmed(line);
      if (line.empty()) continue;
      if (line.front() != '#')
        read_statement(line);
      else
        of_blender_ |= line.find("Blender") != line.npos && line.find("MTL File") != line.npos;
    }
    finish_material();
  }

  std::vector<Material> found;
  RemarkList remarks, notes;

private:
  std::string_view take_line(const char*& p) const {
    const char* first = p;
    while (p < text_.end() && *p != '\n' && *p != '\r') ++p;
    const std::string_view line(first, size_t(p - first));
    if (p < text_.end()) p += *p == '\r' && p[1] == '\n' ? 2 : 1;
    return line;
  }

  void read_statement(std::string_view line) {
    size_t length = 0;
    while (length < line.size() && !ends_token(line[length])) ++length;
    key_ = line.substr(0, length);
    arguments_ = trimmed(line.substr(length));
    if (is("newmtl")) {
      finish_material();
      current_.emplace();
      current_->name = std::string(arguments_);
      has_ambient_ = has_picture_ = false;
      dissolve_.reset();
      transparency_.reset();
      illumination_ = 2;
      if (arguments_.empty()) remarks.add("newmtl without a name", statement_, "newmtl needs a name");
      return;
    }
    if (!current_) {
      before_first.add_once("statement before newmtl", statement_,
                            "statements before the first newmtl are ignored");
      return;
    }
    if (is("Ka"))
      has_ambient_ |= color(current_->ambient);
    else if (is("Kd"))
      color(current_->diffuse);
    else if (is("Ks"))
      color(current_->specular);
    else if (is("Ke"))
      color(current_->emission);
    else if (is("Ns"))
      shininess();
    else if (is("d"))
      opacity(dissolve_);
    else if (is("Tr"))
      opacity(transparency_);
    else if (is("illum"))
      illumination_model();
    else if (is("map_Kd"))
      has_picture_ = true, map(current_->diffuse_map);
    else if (is("map_d") || is("map_opacity"))
      map(current_->opacity_map);
    else
      ignored();
  }

  bool is(const char* name) const {
    return key_.size() == std::string_view(name).size() && ::strncasecmp(key_.data(), name, key_.size()) == 0;
  }

  std::string quoted_key() const { return "\"" + printable(key_, 32) + "\""; }

  // Up to three numbers; the count, or -1 if something else stands there.
  int numbers(float* values, int limit) const {
    const std::string copy(arguments_); // ends with a zero byte
    const char* p = copy.c_str();
    int count = 0;
    while (count < limit) {
      while (*p == ' ' || *p == '\t') ++p;
      if (*p == '\0' || *p == '#') break;
      if (!read_number(p, values[count]) || !std::isfinite(values[count])) return -1;
      ++count;
    }
    return count;
  }

  bool any_decimal_comma() const {
    const std::string copy(arguments_); // ends with a zero byte
    return has_decimal_comma(copy.c_str());
  }

  bool color(float* target) {
    float values[3];
    const int count = numbers(values, 3);
    if (count < 1) {
      const bool spectral = arguments_.substr(0, 8) == "spectral" || arguments_.substr(0, 3) == "xyz";
      remarks.add("color that is not r g b: ignored", statement_,
                  quoted_key() +
                      (spectral ? " is given as spectral or XYZ color, which is not supported; ignored"
                       : any_decimal_comma() ? " has a decimal comma; it needs a point (0.5); ignored"
                                             : " needs one or three numbers; ignored"));
      return false;
    }
    if (count < 3) values[1] = values[2] = values[0]; // one number is a gray
    for (int i = 0; i < 3; ++i) {
      if (values[i] < 0 || values[i] > 1) {
        const char* kind = "color outside 0..1: clamped";
        if (remarks.count(kind))
          remarks.describe(kind, statement_, quoted_key() + " is outside 0..1; clamped");
        break;
      }
    }
    for (int i = 0; i < 3; ++i) target[i] = std::clamp(values[i], 0.0f, 1.0f);
    return true;
  }

  void shininess() {
    float value;
    if (numbers(&value, 1) < 1) {
      remarks.add("Ns without a number: ignored", statement_, "\"Ns\" needs a number; ignored");
      return;
    }
    current_->shininess = std::clamp(value, 0.0f, 128.0f); // the range of GL_SHININESS
  }

  void opacity(std::optional<float>& target) {
    if (arguments_.substr(0, 5) == "-halo") arguments_ = trimmed(arguments_.substr(5));
    float value;
    if (numbers(&value, 1) < 1)
      remarks.add("opacity without a number: ignored", statement_, quoted_key() + " needs a number; ignored");
    else
      target = std::clamp(value, 0.0f, 1.0f);
  }

  void illumination_model() {
    float value;
    if (numbers(&value, 1) < 1) {
      remarks.add("illum without a number: ignored", statement_, "\"illum\" needs a number; ignored");
      return;
    }
    if (value < 0 || value > 10) {
      notes.add("unknown illumination model", statement_, "unknown illumination model; 2 is used");
      value = 2;
    }
    illumination_ = int(value);
  }

  void map(TextureReference& target) {
    if (missing_pictures_ >= kMostMissingPictures) return;
    const MapStatement map_statement = parse_map_statement(arguments_, files_, folder_);
    target = map_statement.texture;
    missing_pictures_ += target.file.empty();
    if (target.file.empty())
      remarks.add("picture file not found", statement_,
                  map_statement.wanted.empty()
                      ? quoted_key() + " names no file"
                      : files_.not_found("picture \"" + printable(map_statement.wanted) + "\""));
  }

  void ignored() {
    // Quiet: what has no meaning for the fixed-function pipeline but is common and correct.
    static constexpr const char* kQuiet[] = {
        "Ni",      "Tf",    "sharpness", "Pr",        "Pm",         "Ps",      "Pc",
        "Pcr",     "aniso", "anisor",    "map_Pr",    "map_Pm",     "map_Ps",  "map_Pc",
        "map_Pcr", "norm",  "map_aat",   "map_aniso", "map_anisor", "map_RMA", "map_ORM"};
    static constexpr const char* kNoted[] = {"map_Ka",   "map_Ks", "map_Ke",    "map_Ns", "map_Bump",
                                             "bump",     "disp",   "map_disp",  "decal",  "refl",
                                             "map_refl", "map_Tr", "map_normal"};
    for (const char* name : kQuiet)
      if (is(name)) return;
    for (const char* name : kNoted)
      if (is(name)) {
        notes.add_once("map " + std::string(name), statement_,
                       quoted_key() + " has no place in the fixed-function pipeline; ignored");
        return;
      }
    const std::string shown = is_key(key_) ? quoted_key() : "statement";
    remarks.add_once("key " + shown, statement_, "unknown " + shown + " ignored");
  }

  void finish_material() {
    if (!current_) return;
    Material& material = *current_;
    const float* diffuse = material.diffuse;
    if (!strict_ && has_picture_ && diffuse[0] + diffuse[1] + diffuse[2] == 0) {
      // Exporters that write a picture leave the color at 0, and mean the picture. Where that is missing a
      // black model would show nothing.
      std::fill_n(material.diffuse, 3, 1.0f);
      if (material.ambient[0] + material.ambient[1] + material.ambient[2] == 0) has_ambient_ = false;
      if (notes.count("black under a picture"))
        notes.describe("black under a picture", nullptr,
                       "material \"" + printable(material.name) +
                           "\" has a picture and Kd 0 0 0; drawn as Kd 1 1 1 (--strict-mtl keeps it black)");
    }
    if (!has_ambient_) std::copy_n(material.diffuse, 3, material.ambient);
    // MTL knows opacity from d, Tr and map_d alone, and Blender writes map_d. Others mean the alpha of
    // map_Kd.
    if (strict_ || of_blender_)
      material.diffuse_map.alpha = material.opacity_map.file == material.diffuse_map.file;
    // d is the opacity, Tr = 1 - d. A lone `Tr 1` is what some exporters write for opaque.
    if (dissolve_)
      material.opacity = *dissolve_;
    else if (transparency_)
      material.opacity = *transparency_ == 1.0f ? 1.0f : 1.0f - *transparency_;
    if (illumination_ == 0) material.lit = false;
    if (illumination_ < 2 || material.shininess == 0) std::fill_n(material.specular, 3, 0.0f);
    found.push_back(std::move(material));
    current_.reset();
  }

  const SourceText& text_;
  const ModelFiles& files_;
  const std::string& folder_;
  const bool strict_;
  bool of_blender_ = false; // who wrote the library
  const char* statement_ = nullptr;
  std::string_view key_, arguments_;
  std::optional<Material> current_;
  bool has_ambient_ = false, has_picture_ = false; // which may be missing
  std::optional<float> dissolve_, transparency_;
  int illumination_ = 2;
  int missing_pictures_ = 0;

public:
  RemarkList before_first;
};

// The files a mtllib statement names: the whole line if there is such a file, else its parts. Names may hold
// spaces.
std::vector<std::string> library_names(std::string_view line, const ModelFiles& files) {
  if (!files.find(files.folder(), line).empty()) return {std::string(line)};
  std::vector<std::string> names;
  std::string_view rest = line;
  while (!(rest = trimmed(rest)).empty() && names.size() < 64) {
    // Up to the next ".mtl" before a blank, or the next word.
    size_t length = 0;
    for (size_t i = 4; i <= rest.size() && length == 0; ++i)
      if ((i == rest.size() || rest[i] == ' ' || rest[i] == '\t') &&
          ::strncasecmp(&rest[i - 4], ".mtl", 4) == 0)
        length = i;
    const size_t word = std::min(rest.find_first_of(" \t"), rest.size());
    if (length == 0 || (length > word && files.find(files.folder(), rest.substr(0, length)).empty()))
      length = word;
    names.emplace_back(rest.substr(0, length));
    rest.remove_prefix(length);
  }
  return names;
}

} // namespace

void MaterialLibrary::read(const SourceText& text, const ModelFiles& files, const std::string& folder,
                           Warnings& warnings, Warnings& notes) {
  LibraryReader reader(text, files, folder, strict_);
  reader.read();
  if (reader.found.empty()) { // not a library: say nothing of what stands in it
    warnings.add(text.name(), "this file has no materials; ignored");
    return;
  }
  reader.remarks.append(reader.before_first);
  for (Material& material : reader.found) {
    const auto known = by_name_.find(material.name);
    if (known != by_name_.end()) {
      const std::string kind = "material defined again: the later one is used";
      if (reader.remarks.count(kind))
        reader.remarks.describe(kind, nullptr,
                                "material \"" + printable(material.name) +
                                    "\" is defined again; the later one is used");
      materials_[known->second] = std::move(material);
    } else {
      by_name_.emplace(material.name, uint32_t(materials_.size()));
      materials_.push_back(std::move(material));
    }
  }
  warnings.add(reader.remarks, text);
  notes.add(reader.notes, text);
}

uint32_t MaterialLibrary::find(std::string_view name) const {
  auto found = by_name_.find(std::string(name));
  if (found == by_name_.end()) { // perhaps a comment behind the name
    const size_t comment = name.find(" #");
    if (comment != std::string_view::npos)
      found = by_name_.find(std::string(trimmed(name.substr(0, comment))));
  }
  return found == by_name_.end() ? 0 : found->second;
}

void MaterialLibrary::load_for(const ObjModel& model, const ModelFiles& files, RemarkList& model_remarks,
                               Warnings& warnings, Warnings& notes) {
  std::unordered_set<std::string> seen, tried;
  size_t looked_for = 0;
  for (const ObjChunk& chunk : model.chunks) {
    for (const StateChange& change : chunk.changes) {
      if (change.kind != StateChange::kLibrary) continue;
      if (seen.size() >= kMostLibraries || looked_for >= kMostLibraries ||
          !seen.insert(std::string(change.name)).second)
        continue;
      for (const std::string& name : library_names(change.name, files)) {
        ++looked_for;
        const std::string path = files.find(files.folder(), name);
        if (path.empty()) {
          model_remarks.add("material library not found", change.name.data(),
                            files.not_found("material library \"" + printable(name) + "\""));
          continue;
        }
        if (!tried.insert(path).second) continue;
        files_.push_back(path);
        try {
          SourceText file = SourceText::open_named(path);
          if (file.size() > kLargestLibrary)
            throw ProgramError(kCannotRead, path + ": too large for a material library");
          read(as_utf8(std::move(file)), files, folder_of(path), warnings, notes);
        } catch (const ProgramError& error) { warnings.add_sentence(error.what()); }
      }
    }
  }
}

} // namespace softgl::cli
