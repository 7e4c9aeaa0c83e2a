// The bytes of a text file, memory-mapped where possible and always followed by a zero byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace softgl::cli {

class SourceText {
public:
  // Maps or reads `path`; "-" is standard input. Throws ProgramError (kCannotRead), also if there are more
  // than `most` bytes, or std::bad_alloc if memory ends. 0: files have no limit, pipes and devices
  // kMostPiped.
  static SourceText open(const std::string& path, uint64_t most = 0);
  static constexpr uint64_t kMostPiped = uint64_t(256) << 20;
  // The same for a name that a model gives: only regular files.
  static SourceText open_named(const std::string& path);
  static SourceText from_string(std::string text, std::string name);

  SourceText(SourceText&& other) noexcept;
  SourceText& operator=(SourceText&&) = delete;
  ~SourceText();

  const std::string& name() const { return name_; }
  const char* begin() const { return begin_; }
  const char* end() const { return begin_ + size_; }
  size_t size() const { return size_; }
  // A large file need not stay in memory once it is parsed; it is read again where a message needs it.
  void forget(const char* first, const char* last) const;

private:
  SourceText() = default;
  static SourceText read_or_map(int descriptor, size_t size, const std::string& path);

  std::string name_;
  std::string owned_;
  const char* begin_ = nullptr;
  size_t size_ = 0;
  void* mapping_ = nullptr;
  size_t mapping_size_ = 0;
};

// Line numbers (from 1) of positions in the text that rise; LF, CR LF and CR end a line.
std::vector<uint64_t> line_numbers(const SourceText& text, const std::vector<const char*>& rising_positions);

// True if `path` names a regular file that can be opened, and not one that the kernel makes up (/proc, /sys).
bool is_readable_file(const std::string& path);

} // namespace softgl::cli
