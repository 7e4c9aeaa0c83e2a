#include "support/manifest.h"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "support/runner.h"

namespace softgl::test {
namespace {

constexpr int kSeedsPerRow = 10, kRowsPerFamily = 6;
const char kLibraryLine[] = "# drawn by ";

} // namespace

std::string library_text(const Gl& gl) {
  uint32_t pixel = 0;
  void* context = gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, nullptr);
  if (!context || !gl.OSMesaMakeCurrent(context, &pixel, GL_UNSIGNED_BYTE, 1, 1))
    throw std::runtime_error(gl.name + " makes no context");
  auto text = [&](GLenum name) { return std::string(reinterpret_cast<const char*>(gl.GetString(name))); };
  const std::string result = text(GL_VERSION) + ", " + text(GL_RENDERER);
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(context);
  return result;
}

uint64_t draw_hash(const Gl& gl, const Scene& scene, uint64_t first, uint64_t count) {
  uint64_t h = 0xcbf29ce484222325u;
  for (uint64_t seed = first; seed < first + count; seed++) {
    const uint64_t picture = draw(gl, scene, seed).hash();
    for (int shift = 0; shift < 64; shift += 8) h = (h ^ (picture >> shift & 255)) * 0x100000001b3u;
  }
  return h;
}

Manifest capture(const Gl& gl) {
  Manifest manifest{library_text(gl), {}};
  auto add = [&](const Scene& scene, uint64_t first, uint64_t count) {
    manifest.rows.push_back({scene.name, first, count, draw_hash(gl, scene, first, count)});
  };
  for (const Scene& scene : named_scenes()) add(scene, 0, 1);
  for (const Scene& family : families())
    for (int i = 0; i < kRowsPerFamily; i++) add(family, uint64_t(i) * kSeedsPerRow, kSeedsPerRow);
  return manifest;
}

Manifest read_manifest(const std::string& path) {
  std::ifstream file(path);
  Manifest manifest;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(kLibraryLine, 0) == 0) manifest.library = line.substr(sizeof kLibraryLine - 1);
    if (line.empty() || line[0] == '#') continue;
    char name[64];
    ManifestRow row;
    if (std::sscanf(line.c_str(), "%63s %" SCNu64 " %" SCNu64 " %" SCNx64, name, &row.first, &row.count,
                    &row.hash) != 4 ||
        !find_scene(name))
      throw std::runtime_error(path + ": cannot use the line \"" + line + "\"");
    row.scene = name;
    manifest.rows.push_back(row);
  }
  if (manifest.rows.empty()) throw std::runtime_error(path + " cannot be read, or holds no row");
  return manifest;
}

void write_manifest(const std::string& path, const Manifest& manifest) {
  std::ofstream file(path);
  file << kLibraryLine << manifest.library
       << "\n# scene, first seed, number of seeds, hash of their colors, depths, stencils and errors\n";
  for (const ManifestRow& row : manifest.rows) {
    char line[128];
    std::snprintf(line, sizeof line, "%s %" PRIu64 " %" PRIu64 " %016" PRIx64 "\n", row.scene.c_str(),
                  row.first, row.count, row.hash);
    file << line;
  }
  if (!file.flush()) throw std::runtime_error(path + " cannot be written");
}

} // namespace softgl::test
