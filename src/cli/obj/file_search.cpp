#include "obj/file_search.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <dirent.h>
#include <memory>
#include <new>

#include "common/source_text.h"

namespace softgl::cli {

std::string folder_of(const std::string& path) {
  const size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

namespace {

struct CloseFolder {
  void operator()(DIR* folder) const { ::closedir(folder); }
};

constexpr size_t kMostListings = 16;

std::string in_small_letters(std::string text) {
  for (char& c : text) c = char(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return text;
}

std::string without_links(const std::string& path) {
  char resolved[PATH_MAX];
  return ::realpath(path.c_str(), resolved) ? resolved : "";
}

} // namespace

ModelFiles::ModelFiles(const std::string& model_path, bool anywhere)
    : folder_(folder_of(model_path)), anywhere_(anywhere), root_(without_links(folder_)) {
  if (!root_.empty() && root_.back() != '/') root_ += '/';
}

bool ModelFiles::may_read(const std::string& path) const {
  if (anywhere_) return is_readable_file(path);
  const std::string place = without_links(path);
  return !root_.empty() && place.compare(0, root_.size(), root_) == 0 && is_readable_file(place);
}

std::string ModelFiles::not_found(const std::string& what) const {
  return what + (anywhere_ ? " not found"
                           : " not found in the model's folder (--allow-any-path looks elsewhere, too)");
}

// A folder is read once, whatever a model names: it may have a hundred thousand files.
const ModelFiles::Listing& ModelFiles::listing_of(const std::string& folder) const {
  const auto known = listings_.find(folder);
  if (known != listings_.end()) return known->second;
  if (listings_.size() >= kMostListings) listings_.clear();
  const std::unique_ptr<DIR, CloseFolder> stream(::opendir(folder.c_str()));
  if (!stream && errno == ENOMEM) throw std::bad_alloc();
  Listing& listing = listings_[folder];
  if (!stream) return listing;
  while (const dirent* entry = ::readdir(stream.get())) {
    // The alphabetically first, so that the answer does not depend on the file system.
    const auto [place, is_new] = listing.emplace(in_small_letters(entry->d_name), entry->d_name);
    if (!is_new && place->second > entry->d_name) place->second = entry->d_name;
  }
  return listing;
}

std::string ModelFiles::ignoring_case(const std::string& folder, const std::string& file) const {
  const Listing& listing = listing_of(folder);
  const auto found = listing.find(in_small_letters(file));
  if (found == listing.end() || !may_read(folder + "/" + found->second)) return {};
  return folder + "/" + found->second;
}

std::string ModelFiles::find(const std::string& folder, std::string_view name, bool any_case) const {
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  if (name.empty() || name.size() > 4096 || name.find('\0') != std::string_view::npos) return {};
  std::string path(name);
  std::replace(path.begin(), path.end(), '\\', '/');
  const bool drive = path.size() > 2 && path[1] == ':' && path[2] == '/';
  const bool absolute = path[0] == '/' || drive;
  std::string joined = absolute ? path : folder + "/" + path;
  if (!drive && may_read(joined)) return joined;
  if (std::string exact = folder + "/" + std::string(name); !absolute && may_read(exact)) return exact;
  const std::string last = path.substr(path.rfind('/') + 1); // npos + 1 = 0
  if (last.empty() || last == "." || last == "..") return {};
  if (!absolute && any_case)
    if (std::string found = ignoring_case(folder_of(joined), last); !found.empty()) return found;
  if (may_read(folder + "/" + last)) return folder + "/" + last;
  return any_case ? ignoring_case(folder, last) : std::string();
}

} // namespace softgl::cli
