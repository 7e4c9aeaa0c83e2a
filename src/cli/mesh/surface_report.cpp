#include "mesh/surface_report.h"

#include <cmath>

#include "mesh/edge_table.h"

namespace softgl::cli {

SurfaceReport report_surface(const Mesh& mesh, const ModelFrame& frame) {
  SurfaceReport report;
  for (const MeshEdge& edge : mesh_edges(mesh)) {
    ++report.edges;
    report.open_edges += edge.faces == 1;
    report.crowded_edges += edge.faces > 2;
  }
  for (const Batch& batch : mesh.triangle_batches) {
    MaterialPart part{batch.material, batch.count / 3, 0};
    for (uint32_t i = batch.first; i + 2 < batch.first + batch.count; i += 3) {
      const float* p[3];
      for (size_t k = 0; k < 3; ++k) p[k] = &mesh.positions[3 * size_t(mesh.triangles[i + k])];
      double a[3], b[3];
      for (int axis = 0; axis < 3; ++axis) {
        a[axis] = double(p[1][axis]) - p[0][axis];
        b[axis] = double(p[2][axis]) - p[0][axis];
      }
      const double n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
      part.area += std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
      report.volume += (n[0] * p[0][0] + n[1] * p[0][1] + n[2] * p[0][2]) / 6;
    }
    part.area /= frame.scale * frame.scale;
    report.parts.push_back(part);
  }
  report.volume /= frame.scale * frame.scale * frame.scale;
  return report;
}

} // namespace softgl::cli
