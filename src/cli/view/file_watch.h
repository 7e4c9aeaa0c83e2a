// Files that may change while they are shown.
#pragma once

#include <string>
#include <vector>

namespace softgl::cli {

class FileWatch {
public:
  // From now on this file is watched, too; what it is now is known.
  void add(const std::string& path);
  void clear() { files_.clear(); }

  // True once after a change, as soon as two looks in turn have found the same: who writes is done then. A
  // file that is gone, or there again, has changed.
  bool look();

private:
  struct Stamp {
    long seconds = -1, nanoseconds = 0;
    long long bytes = 0;
    unsigned long long number = 0; // of the inode: a file of the same name may be another
    bool operator==(const Stamp&) const = default;
  };
  struct File {
    std::string path;
    Stamp known, last;
  };
  static Stamp stamp_of(const std::string& path);

  std::vector<File> files_;
};

} // namespace softgl::cli
