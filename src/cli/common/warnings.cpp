#include "common/warnings.h"

#include <algorithm>

namespace softgl::cli {

bool RemarkList::count(std::string_view kind) {
  auto found = kinds_.find(kind);
  if (found == kinds_.end()) {
    if (kinds_.size() >= kMaxKinds) return false; // a hostile file may invent any number of keywords
    found = kinds_.emplace(std::string(kind), Kind{}).first;
  }
  return ++found->second.count <= kShownPerKind;
}

void RemarkList::describe(std::string_view kind, const char* at, std::string text) {
  const auto found = kinds_.find(kind);
  if (found != kinds_.end()) found->second.examples.push_back({at, std::move(text)});
}

void RemarkList::add_once(std::string_view kind, const char* at, std::string_view text) {
  if (!count(kind)) return;
  Kind& entry = kinds_.find(kind)->second;
  entry.once = true;
  if (entry.examples.empty()) entry.examples.push_back({at, std::string(text)});
}

void RemarkList::append(const RemarkList& later) {
  for (const auto& [name, kind] : later.kinds_) {
    auto found = kinds_.find(name);
    if (found == kinds_.end()) {
      if (kinds_.size() >= kMaxKinds) continue;
      found = kinds_.emplace(name, Kind{}).first;
    }
    Kind& mine = found->second;
    mine.count += kind.count;
    mine.once = kind.once;
    const size_t shown = kind.once ? 1 : kShownPerKind;
    for (const Example& example : kind.examples)
      if (mine.examples.size() < shown) mine.examples.push_back(example);
  }
}

std::string printable(std::string_view text, size_t limit) {
  std::string result;
  for (const char c : text.substr(0, limit)) result += uint8_t(c) < 32 || c == 127 ? '?' : c;
  return result;
}

void Warnings::add(const RemarkList& remarks, const SourceText& text) {
  struct Line {
    const char* at;
    const std::string* text;
    uint64_t times; // 0: not counted
  };
  std::vector<Line> lines;
  for (const auto& [name, kind] : remarks.kinds_) {
    count_ += kind.count;
    for (const auto& example : kind.examples)
      lines.push_back({example.at, &example.text, kind.once && kind.count > 1 ? kind.count : 0});
  }
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.at < b.at; });
  std::vector<const char*> positions;
  for (const Line& line : lines)
    if (line.at) positions.push_back(line.at);
  const std::vector<uint64_t> numbers = line_numbers(text, positions);
  size_t next = 0;
  for (const Line& line : lines) {
    std::string where = text.name();
    if (line.at) where += ":" + std::to_string(numbers[next++]);
    std::string sentence = where + ": " + *line.text;
    if (line.times) sentence += std::string(" (") + std::to_string(line.times) + " times)";
    sentences_.push_back(std::move(sentence));
  }
  for (const auto& [name, kind] : remarks.kinds_)
    if (!kind.once && kind.count > kind.examples.size())
      sentences_.push_back(text.name() + ": " + std::to_string(kind.count - kind.examples.size()) +
                           " more times: " + name);
}

void Warnings::add(const std::string& file, const std::string& text) { add_sentence(file + ": " + text); }

void Warnings::add_sentence(const std::string& sentence) {
  ++count_;
  sentences_.push_back(sentence);
}

void Warnings::add_notice(const std::string& file, const std::string& text) {
  notices_.push_back(file + ": " + text);
}

void Warnings::add_new(const Warnings& others) {
  const auto add_to = [](std::vector<std::string>& known, const std::string& sentence) {
    if (std::find(known.begin(), known.end(), sentence) != known.end()) return false;
    known.push_back(sentence);
    return true;
  };
  for (const std::string& sentence : others.sentences_) count_ += add_to(sentences_, sentence);
  for (const std::string& sentence : others.notices_) add_to(notices_, sentence);
}

} // namespace softgl::cli
