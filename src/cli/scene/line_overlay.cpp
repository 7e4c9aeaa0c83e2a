#include "scene/line_overlay.h"

namespace softgl::cli {
namespace {

void disable_light() {
  glDisable(GL_LIGHTING);
  glDisable(GL_TEXTURE_2D);
  glDisable(GL_BLEND);
  for (const GLenum array : {GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
    glDisableClientState(array);
}

} // namespace

void draw_depth_only(const Mesh& mesh, const UploadedMesh& uploaded) {
  if (mesh.triangles.empty()) return;
  uploaded.use_vertices();
  disable_light();
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  uploaded.draw_triangles();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void draw_lines(const Mesh& mesh, const UploadedMesh& uploaded, const LineOptions& options,
                const std::array<float, 3>& color, float scale) {
  uploaded.use_vertices();
  disable_light();
  glColor4f(color[0], color[1], color[2], 1);
  if (options.hidden) glDisable(GL_DEPTH_TEST);
  if (options.style == LineOptions::kPoints) {
    glPointSize(options.point_size * scale);
    glDrawArrays(GL_POINTS, 0, GLsizei(mesh.positions.size() / 3));
  } else if (!mesh.edge_positions.empty()) {
    glVertexPointer(3, GL_FLOAT, 0, mesh.edge_positions.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    glLineWidth(options.width * scale);
    glDrawArrays(GL_LINES, 0, GLsizei(mesh.edge_positions.size() / 3));
  }
  glEnable(GL_DEPTH_TEST);
}

} // namespace softgl::cli
