// What the frame benchmark draws: each workload is a program of its own kind that uses OpenGL.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frames/mesh.h"
#include "support/gl.h"

namespace softgl::bench {

using test::Gl;

/// A running workload. `scale` in (0, 1] shrinks its geometry and its number of draws, for tests.
class Workload {
public:
  explicit Workload(const Gl& gl, int size) : gl(gl), size(size) {}
  virtual ~Workload() = default;
  /// One picture; `turn` counts them, so that no two are alike.
  virtual void frame(int turn) = 0;

  const Gl& gl;
  const int size;   // of the picture in pixels, square
  double units = 0; // work of a frame, in millions of what `unit` names
  const char* unit = "Mtriangle/s";
};

struct WorkloadKind {
  const char* name;
  const char* what;
  std::unique_ptr<Workload> (*make)(const Gl& gl, int size, double scale);
  /// Measured from loading the library to the first finished picture, and not from picture to picture.
  bool first_frame;
  /// Needs GL_PHONG_WIN.
  bool phong = false;
};
const std::vector<WorkloadKind>& workloads();
/// Those of workloads() that draw by other means than lit meshes and layers.
std::vector<WorkloadKind> program_workloads();

} // namespace softgl::bench
