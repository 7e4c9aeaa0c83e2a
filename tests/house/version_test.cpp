// The version is written once, in CMakeLists.txt, and everything that tells it tells the same.
#include <catch2/catch.hpp>

#include <softgl/softgl.h>
#include <softgl/version.h>

#include <cstdio>
#include <filesystem>
#include <regex>
#include <sstream>

#include "house/document.h"
#include "spec/state_snapshot.h"
#include "support/gl.h"
#include "test_paths.h"

namespace softgl::test {
namespace {

namespace fs = std::filesystem;

const std::string kVersion = std::to_string(SOFTGL_VERSION_MAJOR) + "." +
                             std::to_string(SOFTGL_VERSION_MINOR) + "." +
                             std::to_string(SOFTGL_VERSION_PATCH);

/// True if the text says this version and not one that only begins or ends like it.
bool says(const std::string& text, const std::string& version) {
  const std::regex pattern("(^|[^0-9.])" + std::regex_replace(version, std::regex("\\."), "\\.") +
                           "(?![0-9]|\\.[0-9])");
  return text.find(version) != std::string::npos && std::regex_search(text, pattern);
}

std::string output_of(const std::string& command) {
  std::string output;
  if (FILE* pipe = popen((command + " 2>&1").c_str(), "r")) {
    for (char part[256]; std::fgets(part, sizeof part, pipe);) output += part;
    pclose(pipe);
  }
  return output;
}

std::string read_built_file(const std::string& name) {
  const fs::path build = fs::path(SOFTGL_TEST_BINARY_DIR).parent_path();
  return read_repository_file(fs::relative(build / name, SOFTGL_TEST_SOURCE_DIR).string());
}

/// Of the tags of a commit those that call it another version; one a line in both.
std::string wrong_tags(const std::string& tags) {
  std::istringstream lines(tags);
  std::string wrong;
  for (std::string tag; std::getline(lines, tag);)
    if (std::regex_match(tag, std::regex("v[0-9].*")) && tag != "v" + kVersion) wrong += tag + "\n";
  return wrong;
}

} // namespace

TEST_CASE("library, headers, packages and program tell the version of CMakeLists.txt", "[house]") {
  CHECK(says(read_repository_file("CMakeLists.txt"), kVersion)); // from which version.h is made
  CHECK(softgl_version() == kVersion);
  const CurrentContext context(softgl_library());
  CHECK(reinterpret_cast<const char*>(softgl_library().GetString(GL_VERSION)) == "1.5 softgl " + kVersion);
  CHECK(output_of(SOFTGL_TEST_BINARY_DIR "/softgl --version") == "softgl " + kVersion + "\n");
  CHECK(says(read_built_file("softgl.pc"), kVersion));
  CHECK(says(read_built_file("softglConfigVersion.cmake"), kVersion));
}

TEST_CASE("nobody but CMakeLists.txt and the list of changes writes the version", "[house]") {
  for (const char* folder : {"", "src", "shaders", "include", "tests", "reference", ".ci", ".github"})
    for (auto entry = fs::recursive_directory_iterator(fs::path(SOFTGL_TEST_SOURCE_DIR) / folder);
         entry != fs::recursive_directory_iterator(); ++entry) {
      if (entry->is_directory() && *folder == '\0') entry.disable_recursion_pending(); // builds, git
      const std::string path = fs::relative(entry->path(), SOFTGL_TEST_SOURCE_DIR).string();
      static const std::regex text_file(
          ".*\\.(cpp|c|h|inl|inc|in|md|txt|cmake|py|json|tsv|map|yml)|\\.ci/.*");
      if (!entry->is_regular_file() || !std::regex_match(path, text_file)) continue;
      if (path == "CMakeLists.txt" || path == "reference/CHANGES.md") continue;
      INFO(path);
      CHECK_FALSE(says(read_repository_file(path), kVersion));
    }
  CHECK(says("project(softgl VERSION " + kVersion + " LANGUAGES C)", kVersion));
  CHECK(says("This is version " + kVersion + ".", kVersion));
  CHECK_FALSE(says("1" + kVersion + " and " + kVersion + "1", kVersion));
}

TEST_CASE("the list of changes begins with what is to come or with this version", "[house]") {
  const std::string changes = read_repository_file("reference/CHANGES.md");
  std::smatch heading;
  REQUIRE(std::regex_search(changes, heading, std::regex("\n## ([^ \n]*)")));
  CHECK((heading[1] == "Unreleased" || heading[1] == kVersion));
}

TEST_CASE("a commit with a version's tag has that version", "[house]") {
  // Where there is no git or no tag there is nothing to compare.
  const std::string tags = output_of("git -C '" SOFTGL_TEST_SOURCE_DIR "' tag --points-at HEAD");
  CHECK(wrong_tags(tags) == "");
  CHECK(wrong_tags("v" + kVersion + "\nnightly\n") == "");
  CHECK(wrong_tags("v999.0.0\nv" + kVersion + "\n") == "v999.0.0\n");
  CHECK(wrong_tags("v" + kVersion + "-rc1\n") == "v" + kVersion + "-rc1\n");
}

} // namespace softgl::test
