#include "scene/mesh_drawing.h"

#include <algorithm>

namespace softgl::cli {

bool MeshDrawing::draw_opaque() const {
  uploaded_.use_vertices();
  bool all = true;
  for (const Batch& batch : mesh_.triangle_batches)
    if (uploaded_.blended(batch.material))
      all = false;
    else
      draw_used_triangles(batch);
  return all;
}

void MeshDrawing::draw_triangles(const Batch& batch) const {
  uploaded_.use_vertices();
  draw_used_triangles(batch);
}

void MeshDrawing::draw_used_triangles(const Batch& batch) const {
  use_material(batch.material);
  uploaded_.draw_triangles(batch.first, batch.count);
}

void MeshDrawing::use_material(uint32_t number) const {
  uploaded_.use_material(number);
  if (!unlit_black_ || materials_[number].lit) return;
  glDisableClientState(GL_COLOR_ARRAY);
  glColor4f(0, 0, 0, materials_[number].opacity);
}

void MeshDrawing::set_sizes() const {
  const LineSizes sizes;
  glLineWidth(sizes.segment * scale_);
  glPointSize(sizes.point * scale_);
}

void MeshDrawing::draw_segments_and_points() const {
  if (!mesh_.segment_positions.empty()) start_elements(mesh_.segment_positions, mesh_.segment_colors);
  for (const Batch& batch : mesh_.segment_batches) draw_elements(GL_LINES, batch);
  if (!mesh_.point_positions.empty()) start_elements(mesh_.point_positions, mesh_.point_colors);
  for (const Batch& batch : mesh_.point_batches) draw_elements(GL_POINTS, batch);
}

void MeshDrawing::draw_segments(const Batch& batch) const {
  start_elements(mesh_.segment_positions, mesh_.segment_colors);
  draw_elements(GL_LINES, batch);
}

void MeshDrawing::draw_points(const Batch& batch) const {
  start_elements(mesh_.point_positions, mesh_.point_colors);
  draw_elements(GL_POINTS, batch);
}

// Segments and points: the plain diffuse color, since they have no normals.
void MeshDrawing::start_elements(const GrowingArray<float>& positions,
                                 const GrowingArray<float>& colors) const {
  glDisable(GL_LIGHTING);
  glDisable(GL_TEXTURE_2D);
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, positions.data());
  if (!colors.empty() && !unlit_black_) {
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(4, GL_FLOAT, 0, colors.data());
  } else {
    glDisableClientState(GL_COLOR_ARRAY);
  }
  set_sizes();
}

void MeshDrawing::draw_elements(GLenum mode, const Batch& batch) const {
  const float* color = materials_[batch.material].diffuse;
  if (unlit_black_)
    glColor4f(0, 0, 0, 1);
  else
    glColor4f(color[0], color[1], color[2], 1);
  glDrawArrays(mode, GLint(batch.first), GLsizei(batch.count));
}

// Blended triangles of all materials from the far end to the near one.
std::vector<MeshDrawing::BlendedTriangle> MeshDrawing::sort_blended() const {
  std::vector<BlendedTriangle> sorted;
  const float eye[3] = {float(camera_.eye[0]), float(camera_.eye[1]), float(camera_.eye[2])};
  for (const Batch& batch : mesh_.triangle_batches) {
    if (!uploaded_.blended(batch.material)) continue;
    for (uint32_t i = batch.first; i < batch.first + batch.count; i += 3) {
      float depth = 0;
      for (uint32_t k = 0; k < 3; ++k) {
        const float* p = &mesh_.positions[3 * size_t(mesh_.triangles[i + k])];
        depth += p[0] * eye[0] + p[1] * eye[1] + p[2] * eye[2];
      }
      sorted.push_back({depth, i, batch.material});
    }
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const BlendedTriangle& a, const BlendedTriangle& b) { return a.depth < b.depth; });
  return sorted;
}

void MeshDrawing::draw_blended() const {
  const std::vector<BlendedTriangle> sorted = sort_blended();
  uploaded_.use_vertices();
  glEnable(GL_BLEND);
  glEnable(GL_ALPHA_TEST);
  GrowingArray<uint32_t> run;
  for (size_t i = 0; i < sorted.size();) {
    run.truncate(0);
    size_t j = i;
    for (; j < sorted.size() && sorted[j].material == sorted[i].material; ++j)
      run.append(&mesh_.triangles[sorted[j].first], 3);
    use_material(sorted[i].material);
    // Textures with holes are mostly opaque: they write depth; glass does not.
    glDepthMask(materials_[sorted[i].material].opacity == 1 ? GL_TRUE : GL_FALSE);
    glDrawElements(GL_TRIANGLES, GLsizei(run.size()), GL_UNSIGNED_INT, run.data());
    i = j;
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_ALPHA_TEST);
}

void MeshDrawing::draw_silhouette() const {
  uploaded_.use_vertices();
  set_plain_state();
  uploaded_.draw_triangles();
}

void MeshDrawing::set_plain_state() const {
  glDisable(GL_LIGHTING);
  glDisable(GL_TEXTURE_2D);
  glDisable(GL_BLEND);
  glDisableClientState(GL_COLOR_ARRAY);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glColor4f(materials_[0].diffuse[0], materials_[0].diffuse[1], materials_[0].diffuse[2], 1);
}

void MeshDrawing::draw_bare_edges() const {
  GrowingArray<uint32_t> edges;
  edges.room(2 * mesh_.triangles.size());
  for (size_t i = 0; i + 2 < mesh_.triangles.size(); i += 3)
    for (size_t k = 0; k < 3; ++k) {
      edges.append(mesh_.triangles[i + k]);
      edges.append(mesh_.triangles[i + (k + 1) % 3]);
    }
  uploaded_.use_vertices();
  set_plain_state();
  set_sizes();
  glDrawElements(GL_LINES, GLsizei(edges.size()), GL_UNSIGNED_INT, edges.data());
  glDrawElements(GL_POINTS, GLsizei(edges.size()), GL_UNSIGNED_INT, edges.data());
}

} // namespace softgl::cli
