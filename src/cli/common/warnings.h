// What is worth saying about the input files: a few examples of each kind, and how many there were.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/source_text.h"

namespace softgl::cli {

// A remark while its place is still a position in the text. `kind` groups remarks: of each kind the first few
// are shown one by one, the rest as a number.
class RemarkList {
public:
  static constexpr size_t kShownPerKind = 3;
  static constexpr size_t kMaxKinds = 100;

  // Counts a remark; true if the caller should add its text with `describe` (so that a million bad lines cost
  // no text).
  bool count(std::string_view kind);
  void describe(std::string_view kind, const char* at, std::string text);
  void add(std::string_view kind, const char* at, std::string text) {
    if (count(kind)) describe(kind, at, std::move(text));
  }
  // A kind of which only the first is shown, with the number of times: unknown keywords.
  void add_once(std::string_view kind, const char* at, std::string_view text);
  void append(const RemarkList& later);
  bool empty() const { return kinds_.empty(); }

private:
  friend class Warnings;
  struct Example {
    const char* at;
    std::string text;
  };
  struct Kind {
    uint64_t count = 0;
    bool once = false;
    std::vector<Example> examples;
  };
  std::map<std::string, Kind, std::less<>> kinds_;
};

// Text of a file, fit for a message: no control characters, and not too long.
std::string printable(std::string_view text, size_t limit = 80);

class Warnings {
public:
  // Gives every remark its line; `at` null means the file as a whole.
  void add(const RemarkList& remarks, const SourceText& text);
  void add(const std::string& file, const std::string& text);
  // A sentence that names its file already.
  void add_sentence(const std::string& sentence);
  // What was done that nobody asked for, and that is no fault of the input: told, but not counted.
  void add_notice(const std::string& file, const std::string& text);

  // Those of another picture of the same model, without what has been said before.
  void add_new(const Warnings& others);

  uint64_t count() const { return count_; }
  const std::vector<std::string>& notices() const { return notices_; }
  const std::vector<std::string>& sentences() const { return sentences_; } // "model.obj:12: ..."

private:
  std::vector<std::string> sentences_, notices_;
  uint64_t count_ = 0;
};

} // namespace softgl::cli
