// The rooms of src and shaders match the walls that their NOTES.md describe.
#include <catch2/catch.hpp>

#include "house/include_rules.h"

namespace softgl::test {
namespace {

std::string text_of(const std::vector<std::string>& faults) {
  std::string text;
  for (const std::string& fault : faults) text += fault + "\n";
  return text;
}

/// What the inspector says when one line more stands at the end of a file.
std::string faults_with(const std::string& path, const std::string& line) {
  SourceTree tree = source_tree();
  REQUIRE(tree.count(path));
  tree[path] += "\n" + line + "\n";
  return text_of(include_faults(tree));
}

/// What the inspector says when a file's text reads otherwise.
std::string faults_without(const std::string& path, const std::string& old, const std::string& text = "") {
  SourceTree tree = source_tree();
  const size_t at = tree[path].find(old);
  REQUIRE(at != std::string::npos);
  tree[path].replace(at, old.size(), text);
  return text_of(include_faults(tree));
}

} // namespace

TEST_CASE("each folder includes what its notes allow", "[house]") {
  CHECK(text_of(include_faults(source_tree())) == "");
}

TEST_CASE("a file of the back that includes the context is found", "[house]") {
  for (const std::string& folder : kBack) {
    int files = 0;
    for (const auto& [path, text] : source_tree()) {
      if (folder_of(path) != folder || !is_source(path)) continue;
      ++files;
      INFO(path);
      const std::string faults = faults_with(path, "#include \"context/context.h\"");
      using Catch::Contains;
      CHECK_THAT(faults, Contains(path + " includes src/context/context.h, and " + folder + " may not"));
      CHECK_THAT(faults, Contains("the back sees a Context: " + path + " -> src/context/context.h"));
      CHECK_THAT(faults, Contains(folder + " includes src/context, which does not stand below it"));
      if (files == 3) break; // of each folder
    }
    CHECK(files > 0);
  }
}

TEST_CASE("every other breach of the include rules is found", "[house]") {
  using Catch::Contains;
  CHECK_THAT(faults_with("src/raster/tile_binner.h", "#include \"nowhere.h\""),
             Contains("src/raster/tile_binner.h includes nowhere.h, which is not there"));
  CHECK_THAT(faults_with("src/surface/framebuffer.h", "# include \"base/thread_pool.h\""),
             Contains("src/surface/framebuffer.h includes base/thread_pool.h"));
  CHECK_THAT(faults_with("src/surface/framebuffer.h", "#include \"frame/frame.h\""),
             Contains("a cycle: ") && Contains("src/surface may not"));
  CHECK_THAT(faults_with("shaders/common/surface.h", "#include \"shaders/fragment/fragment.h\""),
             Contains("a cycle: ") || Contains("shaders/common may not") || Contains("not there"));
  CHECK_THAT(faults_without("src/frame/NOTES.md", "May include: "),
             Contains("src/frame/NOTES.md has no line \"May include:\""));
  CHECK_THAT(faults_without("src/frame/NOTES.md", "surface/, "), Contains("and src/frame may not"));
  CHECK_THAT(faults_without("src/draw/NOTES.md", "base/,", "base/, base/nowhere/,"),
             Contains("src/draw/NOTES.md allows src/base/nowhere, which is not there"));
  CHECK_THAT(faults_without("src/base/NOTES.md", "May include: ", "May include: texture/, "),
             Contains("src/base includes src/texture, which does not stand below it"));
  CHECK_THAT(faults_without("src/NOTES.md", "from the top"), Contains("src/NOTES.md states no order"));
  CHECK_THAT(faults_without("src/NOTES.md", "surface, "), Contains("src/NOTES.md gives surface no place"));
}

} // namespace softgl::test
