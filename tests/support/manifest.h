// What a library drew, kept as hashes: conformance to OSMesa can be checked where there is no OSMesa.
#pragma once

#include <string>
#include <vector>

#include "support/scene.h"

namespace softgl::test {

/// Pictures of seeds [first, first + count) of a family, or a named scene: one hash of all of them.
struct ManifestRow {
  std::string scene;
  uint64_t first = 0, count = 1, hash = 0;
};

struct Manifest {
  std::string library; // GL_VERSION and GL_RENDERER of what drew it
  std::vector<ManifestRow> rows;
};

/// "GL_VERSION, GL_RENDERER" of a library.
std::string library_text(const Gl& gl);
uint64_t draw_hash(const Gl& gl, const Scene& scene, uint64_t first, uint64_t count);
/// Draws every named scene, and of every family sixty seeds, ten for a row.
Manifest capture(const Gl& gl);
/// Throws std::runtime_error, also for a scene that does not exist.
Manifest read_manifest(const std::string& path);
void write_manifest(const std::string& path, const Manifest& manifest);

} // namespace softgl::test
