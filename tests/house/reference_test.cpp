// What the documents name exists: a file that moves or a test that gets another name takes its documents
// along.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>

#include "house/document.h"
#include "support/scene.h"
#include "test_paths.h"

namespace softgl::test {
namespace {

namespace fs = std::filesystem;

const fs::path kTop = SOFTGL_TEST_SOURCE_DIR;

bool is_word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Every word of the sources. This folder is left out: its tests name what does not exist.
const std::set<std::string>& words_of_sources() {
  static const std::set<std::string> words = [] {
    std::set<std::string> found;
    for (const char* folder : {"src", "shaders", "include", "tests"})
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kTop / folder)) {
        static const std::set<std::string> kinds = {".cpp", ".c", ".h", ".inl", ".inc", ".txt", ".py"};
        const std::string path = fs::relative(entry.path(), kTop).string();
        if (!kinds.count(entry.path().extension().string()) || path.rfind("tests/house/", 0) == 0) continue;
        const std::string text = read_repository_file(path);
        for (auto i = text.begin(); i != text.end();) {
          const auto end = std::find_if_not(i, text.end(), is_word_character);
          if (end != i) found.emplace(i, end);
          i = std::find_if(end, text.end(), is_word_character);
        }
      }
    return found;
  }();
  return words;
}

bool is_called_in(const std::string& text, const std::string& function) {
  for (size_t at = 0; (at = text.find(function + "(", at)) != std::string::npos; ++at)
    if (at == 0 || !is_word_character(text[at - 1])) return true;
  return false;
}

/// The parts of a::b::c.
std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts;
  for (size_t at = 0, end; at <= name.size(); at = end + 2) {
    end = std::min(name.find("::", at), name.size());
    parts.push_back(name.substr(at, end - at));
  }
  return parts;
}

/// True if the file has the test case, whose name may stand on a line of its own, or on two.
bool has_test_case(const std::string& path, const std::string& name) {
  static const std::regex cut("\"\\s+\""), begin("TEST_CASE\\(\\s+");
  const std::string whole = std::regex_replace(read_repository_file(path), cut, "");
  return std::regex_replace(whole, begin, "TEST_CASE(").find("TEST_CASE(\"" + name + "\"") !=
         std::string::npos;
}

/// What a block names and nobody has; one a line. `folder`: of the document, where links begin.
std::string what_is_missing(const DocumentBlock& block, const std::string& folder) {
  std::string missing;
  auto report = [&](const std::string& what) {
    missing += "line " + std::to_string(block.line) + ": " + what + "\n";
  };
  for (const std::string& path : block.paths)
    if (!fs::exists(kTop / path) && !fs::exists(kTop / folder / path)) report("there is no " + path);
  for (const std::string& link : block.links)
    if (!fs::exists(kTop / folder / link)) report("the link to " + link + " leads nowhere");
  for (const std::string& function : block.functions)
    if (std::none_of(block.paths.begin(), block.paths.end(), [&](const std::string& path) {
          return is_called_in(read_repository_file(path), function);
        }))
      report("no file named here has " + function + "()");
  for (const std::string& word : block.words)
    for (const std::string& part : parts_of(word))
      if (!words_of_sources().count(part)) report("no source has " + part);
  for (const std::string& scene : block.scenes)
    if (!find_scene(scene)) report("there is no scene and no family " + scene);
  for (const auto& test : block.test_cases)
    if (!has_test_case(test.path, test.name)) report(test.path + " has no test case \"" + test.name + "\"");
  return missing;
}

std::string what_is_missing(const std::string& text, const std::string& folder) {
  std::string missing;
  for (const DocumentBlock& block : read_document(text)) missing += what_is_missing(block, folder);
  return missing;
}

bool is_code(const std::string& path) { return path.rfind("src/", 0) == 0 || path.rfind("shaders/", 0) == 0; }
bool has_test(const DocumentBlock& b) { return !b.test_cases.empty() || !b.scenes.empty(); }

} // namespace

TEST_CASE("what the documents name exists", "[house]") {
  for (const char* document : {"reference/ARCHITECTURE.md", "reference/CHANGES.md", "reference/DEVIATIONS.md",
                               "reference/FIDELITY.md", "reference/NOTES.md", ".github/CONTRIBUTING.md",
                               "tests/examples/NOTES.md"}) {
    const std::string text = read_repository_file(document);
    INFO(document);
    CHECK(!text.empty());
    CHECK(what_is_missing(text, fs::path(document).parent_path().string()) == "");
  }
  for (const DocumentBlock& block : read_document(read_repository_file("README.md")))
    for (const std::string& link : block.links) {
      INFO("README.md: " << link);
      CHECK(fs::exists(kTop / link));
    }
}

TEST_CASE("every row of DEVIATIONS.md names its test, every row of FIDELITY.md its code and its test",
          "[house]") {
  for (const DocumentBlock& block : read_document(read_repository_file("reference/DEVIATIONS.md"))) {
    INFO("DEVIATIONS.md, line " << block.line);
    if (block.row) CHECK(has_test(block));
  }
  for (const DocumentBlock& block : read_document(read_repository_file("reference/FIDELITY.md"))) {
    INFO("FIDELITY.md, line " << block.line);
    if (!block.row) continue;
    CHECK(has_test(block));
    CHECK(std::any_of(block.paths.begin(), block.paths.end(), is_code));
    CHECK(!(block.functions.empty() && block.words.empty()));
  }
}

TEST_CASE("a document that names what is not there is refused", "[house]") {
  auto missing = [](const char* text) { return what_is_missing(text, "reference"); };
  CHECK(missing("| case | `src/cli/command/main.cpp`, `main()` | `tests/catch_main.cpp`, "
                "`CATCH_CONFIG_RUNNER` |\n") == "");
  CHECK(missing("See `src/cli/maim.cpp`.\n") == "line 1: there is no src/cli/maim.cpp\n");
  CHECK(missing("`src/cli/command/main.cpp` has `mean()`\n") == "line 1: no file named here has mean()\n");
  // The file is named in another row.
  CHECK(missing("| `src/cli/command/main.cpp` |\n| `main()` |\n") ==
        "line 2: no file named here has main()\n");
  CHECK(missing("a word\nand `DrawnRecord`\n") == "line 1: no source has DrawnRecord\n");
  CHECK(missing("| `[lit]`, `[teapot]` and `[unlit]` |\n") ==
        "line 1: there is no scene and no family unlit\n");
  CHECK(missing("* `tests/spec/clear_test.cpp`, \"no such case\"\n") ==
        "line 1: tests/spec/clear_test.cpp has no test case \"no such case\"\n");
  CHECK(missing("# Title\n\n[here](NOTES.md) and [there](NOTHING.md)\n") ==
        "line 3: the link to NOTHING.md leads nowhere\n");
}

} // namespace softgl::test
