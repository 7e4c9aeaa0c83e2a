#include "house/source_tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>

#include "test_paths.h"

namespace softgl::test {
namespace {

namespace fs = std::filesystem;

bool has_extension(const std::string& path, std::initializer_list<const char*> extensions) {
  const std::string extension = fs::path(path).extension().string();
  for (const char* one : extensions)
    if (extension == one) return true;
  return false;
}

} // namespace

bool is_source(const std::string& path) { return has_extension(path, {".h", ".cpp", ".c", ".inl", ".inc"}); }

std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }

std::string normal_path(const std::string& path) { return fs::path(path).lexically_normal().string(); }

const SourceTree& source_tree() {
  static const SourceTree tree = [] {
    SourceTree files;
    const fs::path top = SOFTGL_TEST_SOURCE_DIR;
    const auto add = [&](const fs::directory_entry& entry) {
      if (!entry.is_regular_file()) return;
      const std::string path = fs::relative(entry.path(), top).string();
      std::ifstream file(has_extension(path, {".png", ".obj"}) ? "" : entry.path(), std::ios::binary);
      files[path] = {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    };
    for (const auto& entry : fs::directory_iterator(top)) add(entry);
    for (const char* folder : {"src", "shaders", "include", "tests", "reference", ".ci", ".github"})
      if (fs::exists(top / folder))
        for (const auto& entry : fs::recursive_directory_iterator(top / folder)) add(entry);
    return files;
  }();
  return tree;
}

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  for (size_t at = 0, end; at <= text.size(); at = end + separator.size()) {
    end = std::min(text.find(separator, at), text.size());
    parts.push_back(text.substr(at, end - at));
  }
  return parts;
}

} // namespace softgl::test
