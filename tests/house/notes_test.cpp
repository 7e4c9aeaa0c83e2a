// What a NOTES.md names is there: a file that moves or gets another name takes the notes along.
#include <catch2/catch.hpp>

#include <fnmatch.h>

#include <algorithm>
#include <cctype>
#include <regex>

#include "house/source_tree.h"

namespace softgl::test {
namespace {

/// Every word of the sources. This folder is left out: its tests name what does not exist.
const std::set<std::string>& words_of_sources() {
  static const std::set<std::string> words = [] {
    std::set<std::string> found;
    const auto is_in_word = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
    for (const auto& [path, text] : source_tree()) {
      if (!is_source(path) && !path.ends_with(".py") && !path.ends_with("CMakeLists.txt")) continue;
      if (path.rfind("tests/house/", 0) == 0) continue;
      for (auto i = text.begin(); i != text.end();) {
        const auto begin = std::find_if(i, text.end(), is_in_word);
        i = std::find_if_not(begin, text.end(), is_in_word);
        if (begin != i) found.emplace(begin, i);
      }
    }
    return found;
  }();
  return words;
}

/// A file or a folder: at any depth below the notes' folder, or from src, include, the program's folder or
/// the top. A * stands for anything.
bool exists(const std::string& folder, std::string name) {
  if (name.ends_with("/")) name += "*";
  std::vector<std::string> patterns;
  for (const std::string& from :
       std::vector<std::string>{folder + "/", folder + "/*/", "src/", "include/", "src/cli/", ""})
    patterns.push_back(normal_path(from + name));
  return std::any_of(source_tree().begin(), source_tree().end(), [&](const auto& file) {
    return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
      return fnmatch(pattern.c_str(), file.first.c_str(), 0) == 0;
    });
  });
}

/// What the notes of a folder name and nobody has; one a line. A word in backquotes is a file without its
/// extension, a folder, or a word of the sources.
std::string what_is_missing(const std::string& folder, const std::string& text) {
  static const std::regex file(
      "[A-Za-z0-9_./*-]{2,}\\.(h|cpp|c|inl|inc|md|py|glsl|vert|frag|tsv|map|txt)\\b"),
      code("`([A-Za-z0-9_./*-]+)`"), word("[A-Za-z_][A-Za-z0-9_]*");
  std::string missing;
  for (std::sregex_iterator i(text.begin(), text.end(), file), end; i != end; ++i)
    if (!exists(folder, i->str())) missing += i->str() + "\n";
  for (std::sregex_iterator i(text.begin(), text.end(), code), end; i != end; ++i) {
    const std::string name = (*i)[1];
    if (std::regex_match(name, word)) {
      if (!words_of_sources().count(name) && !exists(folder, name + "/") && !exists(folder, name + ".*"))
        missing += name + "\n";
    } else if (name.find('/') != std::string::npos && !exists(folder, name) && !exists(folder, name + "/"))
      missing += name + "\n";
  }
  return missing;
}

} // namespace

TEST_CASE("what a NOTES.md names is there", "[house]") {
  int notes = 0;
  for (const auto& [path, text] : source_tree()) {
    if (!path.ends_with("NOTES.md")) continue;
    ++notes;
    INFO(path);
    CHECK(what_is_missing(folder_of(path), text) == "");
  }
  CHECK(notes > 30);
}

TEST_CASE("notes that name what is not there are refused", "[house]") {
  CHECK(what_is_missing("src/frame",
                        "frame.h, `frame.h`, base/arena.h, README.md, `shaders/glsl`, `base/`") == "");
  CHECK(what_is_missing("src/frame", "First comes fame.h, then `Frame`.") == "fame.h\n");
  CHECK(what_is_missing("src/frame", "`fame`, `geometry/`, `geography/`") == "fame\ngeography/\n");
  CHECK(what_is_missing("shaders", "the three *_kernels.cpp, no *_colonels.cpp") == "*_colonels.cpp\n");
  CHECK(what_is_missing("src/cli", "Entry: `run_program` in command/program.h; `GL/osmesa.h`") == "");
}

} // namespace softgl::test
