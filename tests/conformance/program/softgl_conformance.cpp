// softgl_conformance: draws random scenes with softgl and OSMesa and reports every byte that differs.
//   softgl_conformance --family lit --seed 0 --count 1000000
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "support/environment.h"
#include "support/minimize.h"
#include "support/runner.h"
#include "support/shader_twins.h"
#include "test_paths.h"

using namespace softgl::test;

namespace {

const char kUsage[] =
    "usage: softgl_conformance [options]\n"
    "  --list            names of all families and scenes\n"
    "  --family NAME     a family or a scene; may be given several times; all when absent\n"
    "  --seed A          the first seed (0)\n"
    "  --count N         how many seeds (100)\n"
    "  --library L       compare (default: softgl with OSMesa), softgl or osmesa: one library alone\n"
    "  --hash            print a hash for each scene instead of comparing\n"
    "  --minimize        cut each failing scene down to the calls that matter and print them\n"
    "  --trace           print the calls of each scene\n"
    "  --floats          draw all scenes to buffers of floats\n"
    "  --framebuffer-object  draw all scenes to renderbuffers\n"
    "  --sheet FILE      write the pictures of one library as one PNG\n"
    "  --stop N          stop a family after N failures (5)\n"
    "  --expect-isa I    fail unless softgl computes with this instruction set (SOFTGL_ISA)\n";

struct Options {
  std::vector<std::string> families;
  uint64_t seed = 0, count = 100;
  std::string library = "compare", sheet;
  bool hash = false, minimize = false, trace = false, floats = false, framebuffer_object = false;
  int stop = 5;
};

// libsoftgl.so beside the drop-in library picks its instruction set by the same rule.
bool computes_with(const std::string& isa) {
  void* library = dlopen(
      (std::filesystem::path(SOFTGL_TEST_LIBRARY).parent_path().parent_path() / "libsoftgl.so.0").c_str(),
      RTLD_NOW | RTLD_LOCAL);
  auto name = library ? reinterpret_cast<const char* (*)()>(dlsym(library, "softgl_isa")) : nullptr;
  if (name && name() == isa) return true;
  std::fprintf(stderr, "softgl computes with %s, not %s\n", name ? name() : "(no softgl_isa)", isa.c_str());
  return false;
}

int usage() { return std::fputs(kUsage, stderr), 2; }

// Pictures of equal cells, side by side.
struct Sheet {
  static constexpr int kCell = 160, kColumns = 10;
  int count = 0;
  std::vector<uint8_t> rgba;
  void add(const Picture& p) {
    const int row = count / kColumns, column = count % kColumns;
    count++;
    std::vector<uint8_t>& out = rgba;
    if (column == 0) out.resize(size_t(row + 1) * kCell * kColumns * kCell * 4, 40);
    for (int y = 0; y < std::min(p.height, kCell - 4); y++)
      for (int x = 0; x < std::min(p.width, kCell - 4); x++)
        std::memcpy(&out[(size_t(row * kCell + y) * kColumns * kCell + column * kCell + x) * 4],
                    &p.color[(size_t(p.height - 1 - y) * p.width + x) * 4], 4);
  }
  void write(const std::string& path) {
    const int rows = (count + kColumns - 1) / kColumns, width = kColumns * kCell;
    std::vector<uint8_t> flipped(rgba.size());
    for (int y = 0; y < rows * kCell; y++)
      std::memcpy(&flipped[size_t(y) * width * 4], &rgba[size_t(rows * kCell - 1 - y) * width * 4],
                  size_t(width) * 4);
    write_png(std::filesystem::absolute(path).string(), width, rows * kCell, flipped);
  }
};

int run(const Options& o) {
  std::vector<Scene> scenes;
  if (o.families.empty()) {
    scenes = families();
    if (o.hash) {
      for (const Scene& s : named_scenes()) scenes.push_back(s);
      if (o.library == "softgl")
        for (const Scene& s : extension_scenes()) scenes.push_back(s);
    }
  } else {
    for (const std::string& name : o.families) {
      const Scene* scene = find_scene(name);
      if (!scene) return std::fprintf(stderr, "no family or scene is called %s\n", name.c_str()), 2;
      scenes.push_back(*scene);
    }
  }
  for (Scene& scene : scenes) {
    scene.floats |= o.floats;
    scene.framebuffer_object |= o.framebuffer_object;
  }
  const bool alone = o.library != "compare";
  const Gl& gl = o.library == "osmesa" ? osmesa_library() : softgl_library();
  const Gl shaders =
      alone || o.hash
          ? Gl{}
          : shader_library(Twins::PhongAndGouraud); // OSMesa, which one library alone must not need
  Sheet sheet;
  bool failed = false;
  for (const Scene& scene : scenes) {
    int failures = 0;
    uint64_t done = 0, count = scene.random ? o.count : 1, black = 0;
    const auto begin = std::chrono::steady_clock::now();
    for (uint64_t seed = o.seed; seed < o.seed + count; seed++) {
      if (o.trace) {
        std::printf("// %s, seed %llu\n", scene.name.c_str(), static_cast<unsigned long long>(seed));
        print_calls(gl, scene, seed, {});
      }
      const Picture first = draw(gl, scene, seed);
      done++;
      if (!o.sheet.empty()) sheet.add(first);
      if (o.hash) {
        std::printf("%s %llu %016llx\n", scene.name.c_str(), static_cast<unsigned long long>(seed),
                    static_cast<unsigned long long>(first.hash()));
        continue;
      }
      // Nothing but one color: such a scene tests little.
      bool uniform = true;
      for (size_t i = 4; i < first.color.size(); i++) uniform &= first.color[i] == first.color[i - 4];
      black += uniform;
      if (alone) {
        // One library: the same bytes twice, and no error that was not meant.
        const Picture second = draw(gl, scene, seed);
        const Difference d = compare(first, second);
        if (d.any())
          std::printf("%s %llu is not repeatable: %s\n", scene.name.c_str(),
                      static_cast<unsigned long long>(seed), d.text.c_str()),
              failures++;
        if (!first.errors.empty()) {
          std::printf("%s %llu raises GL error %04x\n", scene.name.c_str(),
                      static_cast<unsigned long long>(seed), first.errors[0]);
          failures++;
        }
      } else {
        const Gl& oracle = scene.extension ? shaders : osmesa_library();
        const Picture theirs = draw(oracle, scene, seed);
        const Difference d = compare(first, theirs);
        if (scene.extension ? (d.depth_values && !scene.clipped) || d.max_color > 1 : d.any()) {
          failures++;
          std::printf("%s %llu: %s\n", scene.name.c_str(), static_cast<unsigned long long>(seed),
                      d.text.c_str());
          if (o.minimize) {
            print_calls(gl, scene, seed, minimize(gl, oracle, scene, seed, scene.extension ? 1 : 0));
          }
          write_difference(std::string(SOFTGL_TEST_OUTPUT) + "/" + scene.name + "-" + std::to_string(seed),
                           first, theirs);
        }
      }
      std::fflush(stdout);
      if (failures >= o.stop) break;
    }
    failed |= failures > 0;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (!o.hash)
      std::printf("%-24s %llu scenes, %d failures, %llu of one color, %.1f s\n", scene.name.c_str(),
                  static_cast<unsigned long long>(done), failures, static_cast<unsigned long long>(black),
                  seconds);
    std::fflush(stdout);
  }
  if (!o.sheet.empty()) sheet.write(o.sheet);
  return failed ? 1 : 0;
}

} // namespace

int main(int argc, char** argv) {
  fix_environment();
  Options o;
  for (int i = 1; i < argc; i++) {
    const std::string option = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : nullptr;
    if (option == "--list") {
      for (const Scene& s : families()) std::printf("%s\n", s.name.c_str());
      for (const Scene& s : named_scenes()) std::printf("%s\n", s.name.c_str());
      for (const Scene& s : extension_scenes()) std::printf("%s (softgl only)\n", s.name.c_str());
      return 0;
    } else if (option == "--hash")
      o.hash = true;
    else if (option == "--minimize")
      o.minimize = true;
    else if (option == "--trace")
      o.trace = true;
    else if (option == "--floats")
      o.floats = true;
    else if (option == "--framebuffer-object")
      o.framebuffer_object = true;
    else if (!value)
      return usage();
    else if (option == "--family")
      o.families.push_back(argv[++i]);
    else if (option == "--seed")
      o.seed = std::strtoull(argv[++i], nullptr, 10);
    else if (option == "--count")
      o.count = std::strtoull(argv[++i], nullptr, 10);
    else if (option == "--library")
      o.library = argv[++i];
    else if (option == "--sheet")
      o.sheet = argv[++i];
    else if (option == "--expect-isa") {
      if (!computes_with(argv[++i])) return 4;
    } else if (option == "--stop")
      o.stop = std::atoi(argv[++i]);
    else
      return usage();
  }
  if (o.library != "compare" && o.library != "softgl" && o.library != "osmesa") return usage();
  try {
    return run(o);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "softgl_conformance: %s\n", e.what());
    return 3;
  }
}
