#include "view/file_watch.h"

#include <algorithm>
#include <sys/stat.h>

namespace softgl::cli {

FileWatch::Stamp FileWatch::stamp_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return {status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_size, status.st_ino};
}

void FileWatch::add(const std::string& path) {
  const bool known =
      std::any_of(files_.begin(), files_.end(), [&path](const File& file) { return file.path == path; });
  if (known) return;
  const Stamp stamp = stamp_of(path);
  files_.push_back({path, stamp, stamp});
}

bool FileWatch::look() {
  bool changed = false, settled = true;
  for (File& file : files_) {
    const Stamp now = stamp_of(file.path);
    settled &= now == file.last;
    file.last = now;
    changed |= now != file.known;
  }
  if (!changed || !settled) return false;
  for (File& file : files_) file.known = file.last;
  return true;
}

} // namespace softgl::cli
