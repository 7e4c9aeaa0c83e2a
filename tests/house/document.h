// A document of the repository, taken apart into what it names. NOTES.md says how names are written.
#pragma once

#include <string>
#include <vector>

namespace softgl::test {

/// A row of a table, an item of a list, or a paragraph, with what it names.
struct DocumentBlock {
  int line; // of its beginning
  std::string text;
  std::vector<std::string> paths, functions, words, scenes, links;
  struct TestCase {
    std::string path, name;
  };
  std::vector<TestCase> test_cases;

  /// A row that says something: not the head of a table, nor the line below.
  bool row = false;
};

std::vector<DocumentBlock> read_document(const std::string& text);

/// The file below the repository's top folder; empty if there is none.
std::string read_repository_file(const std::string& path);

} // namespace softgl::test
