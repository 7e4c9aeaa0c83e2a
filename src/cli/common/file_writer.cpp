#include "common/file_writer.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <map>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/program_error.h"
#include "common/time_limit.h"

namespace softgl::cli {
namespace {

constexpr const char* kUnfinished = ".tmp";

[[noreturn]] void cannot_write(const std::string& name, int problem) {
  throw ProgramError(kCannotWrite, name + ": cannot write: " + std::strerror(problem));
}

// 0, or what went wrong.
int write_all(int file, const GrowingArray<uint8_t>& bytes) {
  size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t count = ::write(file, bytes.data() + written, bytes.size() - written);
    if (count >= 0)
      written += size_t(count);
    else if (errno != EINTR)
      return errno;
  }
  return 0;
}

// The file that a symbolic link names in the end: the link stays.
std::string real_path(const std::string& path) {
  char* real = ::realpath(path.c_str(), nullptr);
  std::string result = real ? real : path;
  std::free(real);
  return result;
}

// "picture.png.4711-3.tmp" is of "picture.png", else empty.
std::string finished_name(const std::string& name) {
  const std::string end = kUnfinished;
  if (!name.ends_with(end)) return {};
  const size_t stop = name.size() - end.size(), dot = name.rfind('.', stop - 1);
  if (stop == 0 || dot == std::string::npos) return {};
  const std::string number = name.substr(dot + 1, stop - dot - 1);
  const size_t dash = number.find('-');
  const bool numbers = number.find_first_not_of("0123456789-") == std::string::npos;
  if (!numbers || dash == std::string::npos || dash == 0 || dash + 1 == number.size()) return {};
  return name.substr(0, dot);
}

bool is_same_file(const std::string& path, int file) {
  struct stat by_name {
  }, by_number{};
  return ::lstat(path.c_str(), &by_name) == 0 && ::fstat(file, &by_number) == 0 &&
         by_name.st_dev == by_number.st_dev && by_name.st_ino == by_number.st_ino;
}

// Whoever can lock it is alone with it. Where there are no locks, nothing is removed.
void remove_abandoned(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return;
  struct stat status {};
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && ::flock(file, LOCK_EX | LOCK_NB) == 0 &&
      is_same_file(path, file))
    ::unlink(path.c_str());
  ::close(file);
}

void remove_empty(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_size == 0)
    ::unlink(path.c_str());
}

// 0, or what went wrong. ENOENT: another process took the file for one that was left.
int replace_file(const std::string& target, const GrowingArray<uint8_t>& bytes, const struct stat* old) {
  static std::atomic<unsigned> number{0};
  const std::string temporary =
      target + "." + std::to_string(::getpid()) + "-" + std::to_string(number++) + kUnfinished;
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  const UnfinishedFile unfinished(temporary);
  const bool locked = ::flock(file, LOCK_EX) == 0; // file systems without locks do without
  int problem = locked && !is_same_file(temporary, file) ? ENOENT : 0;
  if (old) ::fchmod(file, old->st_mode & 07777);
  if (problem == 0) problem = write_all(file, bytes);
  if (problem == 0 && ::close(::dup(file)) != 0)
    problem = errno; // what a file system over a network says late
  if (problem == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) problem = errno;
  if (problem != 0 && problem != ENOENT) ::unlink(temporary.c_str());
  ::close(file);
  return problem;
}

int overwrite_file(const std::string& target, const GrowingArray<uint8_t>& bytes) {
  const int file = ::open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  const int problem = write_all(file, bytes);
  return ::close(file) != 0 && problem == 0 ? errno : problem;
}

} // namespace

void write_file(const std::string& path, const GrowingArray<uint8_t>& bytes) {
  if (path == "-") {
    if (const int problem = write_all(STDOUT_FILENO, bytes)) cannot_write("standard output", problem);
    return;
  }
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  const std::string target = exists ? real_path(path) : path;
  // A device or a pipe is written to; a file is replaced at once, so that nobody sees half of it.
  // An empty file may be held open by who made it and waits for the picture, as tumbler does.
  const bool replaced = !exists || (S_ISREG(status.st_mode) && status.st_size > 0);
  int problem =
      replaced ? replace_file(target, bytes, exists ? &status : nullptr) : overwrite_file(target, bytes);
  // A process with this number on another machine has that name, or locks do not reach this far.
  for (int i = 0; i < 3 && replaced && (problem == EEXIST || problem == ENOENT); ++i)
    problem = replace_file(target, bytes, exists ? &status : nullptr);
  if (problem != 0) cannot_write(path, problem);
}

void remove_unfinished(const std::vector<std::string>& files) {
  namespace fs = std::filesystem;
  std::map<std::string, std::set<std::string>> folders;
  for (const std::string& file : files) {
    const fs::path path = real_path(file);
    folders[path.parent_path().string()].insert(path.filename().string());
  }
  for (const auto& [folder, names] : folders) {
    std::error_code problem;
    std::vector<std::string> abandoned;
    for (fs::directory_iterator i(folder.empty() ? "." : folder, problem), end; !problem && i != end;
         i.increment(problem))
      if (names.count(finished_name(i->path().filename().string()))) abandoned.push_back(i->path().string());
    for (const std::string& path : abandoned) remove_abandoned(path);
    for (const std::string& name : names) remove_empty((fs::path(folder) / name).string());
  }
}

} // namespace softgl::cli
