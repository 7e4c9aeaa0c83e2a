// softgl_capture: keeps what the system's libOSMesa draws, as hashes or as pictures, and checks a library
// against them.
//   softgl_capture --write reference/osmesa/manifest.txt
//   softgl_capture --check reference/osmesa/manifest.txt --library softgl
#include <cstdio>
#include <exception>
#include <string>

#include "support/environment.h"
#include "support/manifest.h"
#include "support/runner.h"

using namespace softgl::test;

namespace {

const char kUsage[] =
    "usage: softgl_capture [--library softgl|osmesa] --write FILE | --check FILE | --pictures FOLDER\n"
    "  --library L        what draws (osmesa)\n"
    "  --write FILE       writes a manifest: a hash for every named scene, and six for 60 seeds of "
    "every family (8 minutes)\n"
    "  --check FILE       draws what a manifest lists and names the rows that differ\n"
    "  --pictures FOLDER  writes the named scenes, and the first ten of every family, as PNG files\n";

int check(const Gl& gl, const std::string& path) {
  const Manifest manifest = read_manifest(path);
  size_t differing = 0;
  for (const ManifestRow& row : manifest.rows) {
    if (draw_hash(gl, *find_scene(row.scene), row.first, row.count) == row.hash) continue;
    differing++;
    std::printf("%s %llu to %llu: another picture than that of %s\n", row.scene.c_str(),
                static_cast<unsigned long long>(row.first),
                static_cast<unsigned long long>(row.first + row.count - 1), manifest.library.c_str());
  }
  std::printf("%zu rows, %zu differing\n", manifest.rows.size(), differing);
  return differing ? 1 : 0;
}

int write_pictures(const Gl& gl, const std::string& folder) {
  auto write = [&](const Scene& scene, uint64_t seed, const std::string& name) {
    const Picture p = draw(gl, scene, seed);
    write_png(folder + "/" + name + ".png", p.width, p.height, p.color);
  };
  for (const Scene& scene : named_scenes()) write(scene, 0, scene.name);
  for (const Scene& family : families())
    for (uint64_t seed = 0; seed < 10; seed++) write(family, seed, family.name + "-" + std::to_string(seed));
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  fix_environment();
  std::string library = "osmesa", action, path;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--library")
      library = argv[i + 1];
    else
      action = option, path = argv[i + 1];
  }
  if (argc % 2 == 0 || (library != "softgl" && library != "osmesa")) return std::fputs(kUsage, stderr), 2;
  try {
    const Gl& gl = library == "softgl" ? softgl_library() : osmesa_library();
    if (action == "--check") return check(gl, path);
    if (action == "--pictures") return write_pictures(gl, path);
    if (action == "--write") return write_manifest(path, capture(gl)), 0;
  } catch (const std::exception& e) { return std::fprintf(stderr, "softgl_capture: %s\n", e.what()), 3; }
  return std::fputs(kUsage, stderr), 2;
}
