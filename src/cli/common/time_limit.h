// An end of the run after some time, whatever it is doing.
#pragma once

#include <string>

namespace softgl::cli {

// After so many seconds, counted from now (0: no more), the program says so and ends with kCannotRead. A file
// that is being written is removed.
void start_time_limit(double seconds);

// While one exists, the file of that name is incomplete.
class UnfinishedFile {
public:
  explicit UnfinishedFile(const std::string& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

private:
  const std::string path_;
};

} // namespace softgl::cli
