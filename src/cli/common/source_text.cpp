#include "common/source_text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/magic.h>
#include <new>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>
#include <utility>

#include "common/program_error.h"

namespace softgl::cli {
namespace {

[[noreturn]] void refuse_source(const std::string& name, const char* what) {
  const int reason = errno;
  if (reason == ENOMEM) throw std::bad_alloc();
  throw ProgramError(kCannotRead, name + ": cannot " + what + ": " + std::strerror(reason));
}

[[noreturn]] void refuse_size(const std::string& name, uint64_t most) {
  throw ProgramError(kCannotRead, name + ": more than " + std::to_string(most >> 20) +
                                      " MiB; --max-input MIB allows more");
}

std::string read_everything(int descriptor, const std::string& name, uint64_t most) {
  std::string text;
  size_t used = 0;
  for (;;) {
    if (used > most) refuse_size(name, most);
    if (text.size() - used < 65536) text.resize(std::min<size_t>(text.size() * 2, most) + (1 << 20));
    const ssize_t count = ::read(descriptor, text.data() + used, text.size() - used);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse_source(name, "read");
    if (count == 0) break;
    used += size_t(count);
  }
  text.resize(used);
  return text;
}

struct Descriptor {
  int value;
  ~Descriptor() {
    if (value > STDIN_FILENO) ::close(value);
  }
};

} // namespace

SourceText SourceText::from_string(std::string text, std::string name) {
  SourceText source;
  source.name_ = std::move(name);
  source.owned_ = std::move(text);
  source.begin_ = source.owned_.c_str();
  source.size_ = source.owned_.size();
  return source;
}

SourceText SourceText::open(const std::string& path, uint64_t most) {
  const uint64_t most_piped = most ? most : kMostPiped;
  if (path == "-")
    return from_string(read_everything(STDIN_FILENO, "standard input", most_piped), "standard input");
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.value < 0) refuse_source(path, "open");
  struct stat status {};
  if (::fstat(file.value, &status) != 0) refuse_source(path, "read");
  if (S_ISDIR(status.st_mode)) throw ProgramError(kCannotRead, path + ": this is a folder, not a model");
  const auto size = size_t(status.st_size);
  if (!S_ISREG(status.st_mode) || size == 0)
    return from_string(read_everything(file.value, path, most_piped), path);
  if (most && size > most) refuse_size(path, most);
  return read_or_map(file.value, size, path);
}

SourceText SourceText::open_named(const std::string& path) {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
  if (file.value < 0) refuse_source(path, "open");
  struct stat status {};
  if (::fstat(file.value, &status) != 0) refuse_source(path, "read");
  if (!S_ISREG(status.st_mode)) throw ProgramError(kCannotRead, path + ": this is not a file");
  if (status.st_size == 0) return from_string({}, path);
  return read_or_map(file.value, size_t(status.st_size), path);
}

SourceText SourceText::read_or_map(int descriptor, size_t size, const std::string& path) {
  // A page of zeros after the file, so that a scanner stops without looking at the end.
  const size_t page = size_t(::sysconf(_SC_PAGESIZE));
  const size_t mapping_size = (size / page + 2) * page;
  void* mapping =
      ::mmap(nullptr, mapping_size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (mapping == MAP_FAILED) refuse_source(path, "map");
  if (::mmap(mapping, size, PROT_READ, MAP_PRIVATE | MAP_FIXED, descriptor, 0) == MAP_FAILED) {
    ::munmap(mapping, mapping_size);
    return from_string(read_everything(descriptor, path, size), path);
  }
  ::madvise(mapping, size, MADV_SEQUENTIAL);
  SourceText source;
  source.name_ = path;
  source.begin_ = static_cast<const char*>(mapping);
  source.size_ = size;
  source.mapping_ = mapping;
  source.mapping_size_ = mapping_size;
  return source;
}

SourceText::SourceText(SourceText&& other) noexcept
    : name_(std::move(other.name_)), owned_(std::move(other.owned_)), size_(other.size_),
      mapping_(std::exchange(other.mapping_, nullptr)), mapping_size_(other.mapping_size_) {
  begin_ = mapping_ ? other.begin_ : owned_.c_str(); // a short string moves its bytes
}

void SourceText::forget(const char* first, const char* last) const {
  constexpr size_t kWorthIt = size_t(32) << 20;
  if (!mapping_ || size_ < kWorthIt) return;
  const auto page = size_t(::sysconf(_SC_PAGESIZE));
  const size_t begin = (size_t(first - begin_) + page - 1) / page * page;
  const size_t end = size_t(last - begin_) / page * page;
  if (begin < end) ::madvise(static_cast<char*>(mapping_) + begin, end - begin, MADV_DONTNEED);
}

SourceText::~SourceText() {
  if (mapping_) ::munmap(mapping_, mapping_size_);
}

std::vector<uint64_t> line_numbers(const SourceText& text, const std::vector<const char*>& rising_positions) {
  std::vector<uint64_t> lines;
  uint64_t line = 1;
  const char* p = text.begin();
  for (const char* position : rising_positions) {
    for (; p < position; ++p) line += *p == '\n' || (*p == '\r' && p[1] != '\n');
    lines.push_back(line);
  }
  return lines;
}

bool is_readable_file(const std::string& path) {
  struct stat status {};
  struct statfs system {};
  return ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && ::access(path.c_str(), R_OK) == 0 &&
         ::statfs(path.c_str(), &system) == 0 && system.f_type != PROC_SUPER_MAGIC &&
         system.f_type != SYSFS_MAGIC;
}

} // namespace softgl::cli
