#include "obj/file_search.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <dirent.h>
#include <memory>
#include <new>
#include <strings.h>

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

std::string ModelFiles::ignoring_case(const std::string& folder, const std::string& file) const {
  const std::unique_ptr<DIR, CloseFolder> listing(::opendir(folder.c_str()));
  if (!listing && errno == ENOMEM) throw std::bad_alloc();
  if (!listing) return {};
  std::string best; // the alphabetically first, so that the answer does not depend on the file system
  while (const dirent* entry = ::readdir(listing.get()))
    if (::strcasecmp(entry->d_name, file.c_str()) == 0 && (best.empty() || best > entry->d_name))
      best = entry->d_name;
  if (best.empty() || !may_read(folder + "/" + best)) return {};
  return folder + "/" + best;
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
