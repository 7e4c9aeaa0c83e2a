// softgl_report: draws every lighting scene with softgl and with what it is compared with, and writes one
// HTML page.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include "report/report.h"
#include "support/environment.h"
#include "support/manifest.h"
#include "support/raycast_comparison.h"
#include "support/shader_twins.h"
#include "test_paths.h"

using namespace softgl::test;

namespace {

constexpr const char* kUsage = "usage: softgl_report [-o REPORT.html] [--seeds N]\n"
                               "  -o REPORT.html  the page to write [report.html]\n"
                               "  --seeds N       pictures of each family of random lighting states [12]\n"
                               "Exit codes: 0 all pictures within what is allowed, 1 not all, 2 wrong usage, "
                               "3 a library cannot be loaded,\n"
                               "4 the page cannot be written.\n";

class ReportMaker {
public:
  explicit ReportMaker(uint64_t seeds) : seeds(seeds), shaders(shader_library(Twins::PhongAndGouraud)) {
    report.versions = {"softgl: " + library_text(softgl_library()),
                       "OSMesa: " + library_text(osmesa_library()),
                       "softgl's extensions (lighting per pixel, reflection vectors, single terms) are "
                       "compared with shaders/glsl, run by that OSMesa."};
  }

  Report make() {
    for (const Scene& scene : named_scenes())
      add("fixed function: softgl and OSMesa", scene, 0, osmesa_library(), 0);
    for (const char* family : {"lit", "materials", "normals", "lighting"})
      for (uint64_t seed = 0; seed < seeds; ++seed)
        add("lighting per vertex: softgl and OSMesa", *find_scene(family), seed, osmesa_library(), 0);
    for (const char* family : {"illumination", "gouraud_twin"})
      for (uint64_t seed = 0; seed < seeds; ++seed)
        add("reflection vectors and terms per vertex: softgl and its GLSL twin on OSMesa",
            *find_scene(family), seed, shaders, 1);
    constexpr const char* kPixels = "lighting per pixel: softgl and its GLSL twin on OSMesa";
    for (const Scene& scene : extension_scenes())
      if (!scene.random) add(kPixels, scene, 0, shaders, 1);
    for (const char* family : {"phong", "phong_twin"})
      for (uint64_t seed = 0; seed < seeds; ++seed) add(kPixels, *find_scene(family), seed, shaders, 1);
    for (const bool reflection : {false, true})
      for (const char* shape : {"sphere", "plane", "box"}) add_curves(shape, reflection);
    return std::move(report);
  }

private:
  // The mean over all set-ups of lights and material.
  void add_curves(const std::string& shape, bool reflection) {
    const std::string plot = std::string("Mean difference from ray casting, of 255, by slices: ") +
                             (reflection ? "reflection vector" : "half vector");
    std::map<int, std::pair<double, double>> errors; // Phong's and Gouraud's by slices
    for (const ConvergencePoint& point : compare_with_raycast(shape, reflection, {8, 16, 32, 64, 128})) {
      errors[point.slices].first += point.phong_mean / raycast_setups();
      errors[point.slices].second += point.gouraud_mean / raycast_setups();
    }
    ReportCurve phong{plot, shape + ", Phong shading", {}}, gouraud{plot, shape + ", Gouraud shading", {}};
    for (const auto& [slices, error] : errors) {
      phong.points.emplace_back(slices, error.first);
      gouraud.points.emplace_back(slices, error.second);
    }
    report.curves.push_back(std::move(phong));
    report.curves.push_back(std::move(gouraud));
  }

  void add(const char* group, const Scene& scene, uint64_t seed, const Gl& other, int allowed) {
    ReportRow row;
    row.group = group;
    row.name = scene.random ? scene.name + " " + std::to_string(seed) : scene.name;
    row.again =
        "softgl_conformance --family " + scene.name + " --seed " + std::to_string(seed) + " --count 1";
    row.ours = draw(softgl_library(), scene, seed);
    row.theirs = draw(other, scene, seed);
    row.allowed = allowed;
    row.same_depths = !(scene.extension && scene.clipped);
    report.rows.push_back(std::move(row));
  }

  const uint64_t seeds;
  const Gl shaders;
  Report report;
};

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

} // namespace

int main(int argc, char** argv) {
  std::string output = "report.html";
  uint64_t seeds = 12;
  for (int i = 1; i < argc; ++i) {
    const bool more = i + 1 < argc;
    if (!std::strcmp(argv[i], "--help")) return std::fputs(kUsage, stdout), 0;
    if (more && !std::strcmp(argv[i], "-o"))
      output = argv[++i];
    else if (more && !std::strcmp(argv[i], "--seeds"))
      seeds = std::strtoull(argv[++i], nullptr, 10);
    else
      return std::fputs(kUsage, stderr), 2;
  }
  fix_environment();
  try {
    const Report report = ReportMaker(seeds).make();
    const std::string page = report_page(read(SOFTGL_TEST_SOURCE_DIR "/tests/report/page.html"), report);
    std::ofstream file(output, std::ios::binary);
    if (!(file << page) || !file.flush())
      return std::fprintf(stderr, "softgl_report: cannot write %s\n", output.c_str()), 4;
    const bool passed = std::all_of(report.rows.begin(), report.rows.end(), passes);
    std::printf("%s: %zu pictures, %zu bytes\n", output.c_str(), report.rows.size(), page.size());
    return passed ? 0 : 1;
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "softgl_report: %s\n", error.what()), 3;
  }
}
