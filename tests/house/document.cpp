#include "house/document.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "test_paths.h"

namespace softgl::test {
namespace {

bool starts_with(const std::string& text, const char* beginning) { return text.rfind(beginning, 0) == 0; }

/// The blocks of a document: a line that begins a row, an item or a heading begins one, an empty line ends
/// one. What stands between two fences of three backquotes is no text.
std::vector<DocumentBlock> cut_into_blocks(const std::string& text) {
  std::vector<DocumentBlock> blocks;
  std::istringstream lines(text);
  std::string line;
  bool open = false, fenced = false;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (starts_with(line, "```")) fenced = !fenced, open = false;
    const bool table = starts_with(line, "|"), rule = starts_with(line, "|---");
    if (fenced || line.empty() || starts_with(line, "```") || starts_with(line, "    ")) {
      open = open && starts_with(line, "    "); // an item may go on, indented
      if (!open) continue;
    }
    static const std::regex item("^ *([-*]|[0-9]+\\.) .*");
    if (rule && !blocks.empty()) {
      blocks.back().row = false; // the head
      continue;
    }
    if (!open || table || starts_with(line, "#") || std::regex_match(line, item))
      blocks.push_back({number, "", {}, {}, {}, {}, {}, {}, table});
    blocks.back().text += line + "\n";
    open = !table;
  }
  return blocks;
}

void take_names(DocumentBlock& block) {
  static const std::regex code("`([^`]+)`"), path("[A-Za-z0-9_.-]*(/[A-Za-z0-9_.-]*)+"),
      function("([A-Za-z_][A-Za-z0-9_]*(::~?[A-Za-z_][A-Za-z0-9_]*)*)\\(\\)"),
      word("[A-Za-z_][A-Za-z0-9_]*(::[A-Za-z_][A-Za-z0-9_]*)*"), scene("\\[([a-z0-9_]+)\\]"),
      link("\\]\\(([^)#]+)[^)]*\\)"), test_case("^,\\s+\"([^\"]+)\"");
  const std::string& text = block.text;
  for (std::sregex_iterator i(text.begin(), text.end(), code), end; i != end; ++i) {
    const std::string name = (*i)[1];
    std::smatch m;
    if (std::regex_match(name, m, function))
      block.functions.push_back(m[1]);
    else if (std::regex_match(name, m, scene))
      block.scenes.push_back(m[1]);
    else if (std::regex_match(name, word))
      block.words.push_back(name);
    else if (std::regex_match(name, path)) {
      block.paths.push_back(name);
      std::string rest = text.substr(size_t(i->position() + i->length()));
      for (; std::regex_search(rest, m, test_case); rest = m.suffix()) {
        std::string quoted = m[1];
        std::replace(quoted.begin(), quoted.end(), '\n', ' '); // where the document breaks the line
        block.test_cases.push_back({name, quoted});
      }
    }
  }
  for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i)
    if (!starts_with((*i)[1], "http")) block.links.push_back((*i)[1]);
}

} // namespace

std::vector<DocumentBlock> read_document(const std::string& text) {
  std::vector<DocumentBlock> blocks = cut_into_blocks(text);
  for (DocumentBlock& block : blocks) take_names(block);
  return blocks;
}

std::string read_repository_file(const std::string& path) {
  const std::filesystem::path whole = std::filesystem::path(SOFTGL_TEST_SOURCE_DIR) / path;
  if (!std::filesystem::is_regular_file(whole)) return {};
  std::ifstream file(whole, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace softgl::test
