#include "scene/renderer.h"

#include <algorithm>
#include <chrono>

#include "image/sample_average.h"
#include "scene/gl_context.h"
#include "scene/lighting_setup.h"
#include "scene/uploaded_mesh.h"

namespace softgl::cli {
namespace {

constexpr float kSegmentWidth = 1.5f, kPointSize = 4.0f; // in pixels of the finished picture

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

struct MeshRenderer::Resources {
  Resources(uint8_t* pixels, int width, int height, const MeshRenderer& renderer, Warnings& warnings)
      : context(pixels, width, height, 24), uploaded(renderer.mesh_, renderer.materials_, warnings) {}

  GlContext context;
  UploadedMesh uploaded;
};

// One picture.
class MeshRenderer::Drawing {
public:
  Drawing(const MeshRenderer& renderer, const Camera& camera, const RenderOptions& options)
      : mesh_(renderer.mesh_), materials_(renderer.materials_), frame_(renderer.frame_), camera_(camera),
        options_(options), width_(options.width * options.samples_per_side),
        height_(options.height * options.samples_per_side) {
    samples_.extend(size_t(4) * size_t(width_) * size_t(height_));
  }

  // The renderer's context and objects, made if there are none yet.
  void prepare(MeshRenderer& renderer, Warnings& warnings) {
    if (renderer.resources_)
      renderer.resources_->context.attach(samples_.data());
    else
      renderer.resources_ = std::make_unique<Resources>(samples_.data(), width_, height_, renderer, warnings);
    uploaded_ = &renderer.resources_->uploaded;
  }

  void draw_all(RenderResult& result) {
    const auto start = std::chrono::steady_clock::now();
    glPushAttrib(GL_ALL_ATTRIB_BITS); // the next picture begins with the same state
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    draw();
    result.visible = anything_drawn();
    if (!result.visible && !mesh_.triangles.empty()) {
      draw_silhouette();
      result.transparent = anything_drawn();
      clear();
      draw_edges();
      result.as_wireframe = result.visible = anything_drawn();
    }
    glPopClientAttrib();
    glPopAttrib();
    result.draw_seconds = seconds_since(start);
  }

  // Nobody writes to the samples any more.
  void average(RenderResult& result) {
    const auto start = std::chrono::steady_clock::now();
    result.picture = average_samples(std::move(samples_), options_.width, options_.height,
                                     options_.samples_per_side, options_.background.transparent);
    result.average_seconds = seconds_since(start);
  }

private:
  void clear() {
    // Alpha counts what is drawn: the background has none, whatever its color.
    const uint8_t* color = options_.background.color;
    if (options_.background.transparent)
      glClearColor(0, 0, 0, 0);
    else
      glClearColor(float(color[0]) / 255, float(color[1]) / 255, float(color[2]) / 255, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }

  void set_state() {
    glViewport(0, 0, width_, height_);
    clear();
    apply_lighting(options_.lighting, camera_, frame_);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(camera_.projection);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(camera_.view);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glAlphaFunc(GL_GREATER, 0);
    if (!mesh_.segment_positions.empty() && !mesh_.triangles.empty()) {
      glEnable(GL_POLYGON_OFFSET_FILL); // lines on a surface are to be seen
      glPolygonOffset(1, 1);
    }
  }

  void draw() {
    set_state();
    const bool any_blended = !mesh_.triangles.empty() && !draw_opaque();
    draw_elements(GL_LINES, mesh_.segment_positions, mesh_.segment_colors, mesh_.segment_batches);
    draw_elements(GL_POINTS, mesh_.point_positions, mesh_.point_colors, mesh_.point_batches);
    if (any_blended) draw_blended();
    GlContext::finish();
  }

  // Triangles of all materials but the blended ones. False: some are left.
  bool draw_opaque() {
    uploaded_->bind_vertices();
    uploaded_->bind_triangles();
    bool all = true;
    for (const Batch& batch : mesh_.triangle_batches) {
      if (uploaded_->blended(batch.material)) {
        all = false;
        continue;
      }
      uploaded_->use_material(batch.material);
      glDrawElements(GL_TRIANGLES, GLsizei(batch.count), GL_UNSIGNED_INT,
                     reinterpret_cast<const void*>(batch.first * sizeof(uint32_t)));
    }
    return all;
  }

  void set_sizes() const {
    glLineWidth(kSegmentWidth * float(options_.samples_per_side));
    glPointSize(kPointSize * float(options_.samples_per_side));
  }

  // Segments and points: the plain diffuse color, since they have no normals.
  void draw_elements(GLenum mode, const GrowingArray<float>& positions, const GrowingArray<float>& colors,
                     const std::vector<Batch>& batches) {
    if (positions.empty()) return;
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDisable(GL_LIGHTING);
    glDisable(GL_TEXTURE_2D);
    glDisableClientState(GL_NORMAL_ARRAY);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, positions.data());
    if (!colors.empty()) {
      glEnableClientState(GL_COLOR_ARRAY);
      glColorPointer(4, GL_FLOAT, 0, colors.data());
    } else {
      glDisableClientState(GL_COLOR_ARRAY);
    }
    set_sizes();
    for (const Batch& batch : batches) {
      glColor4f(materials_[batch.material].diffuse[0], materials_[batch.material].diffuse[1],
                materials_[batch.material].diffuse[2], 1);
      glDrawArrays(mode, GLint(batch.first), GLsizei(batch.count));
    }
  }

  struct BlendedTriangle {
    float depth;
    uint32_t first, material;
  };

  // Blended triangles of all materials from the far end to the near one.
  std::vector<BlendedTriangle> sort_blended() const {
    std::vector<BlendedTriangle> sorted;
    const float eye[3] = {float(camera_.eye[0]), float(camera_.eye[1]), float(camera_.eye[2])};
    for (const Batch& batch : mesh_.triangle_batches) {
      if (!uploaded_->blended(batch.material)) continue;
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

  void draw_blended() {
    const std::vector<BlendedTriangle> sorted = sort_blended();
    uploaded_->bind_vertices();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glEnable(GL_BLEND);
    glEnable(GL_ALPHA_TEST);
    GrowingArray<uint32_t> run;
    for (size_t i = 0; i < sorted.size();) {
      run.truncate(0);
      size_t j = i;
      for (; j < sorted.size() && sorted[j].material == sorted[i].material; ++j)
        run.append(&mesh_.triangles[sorted[j].first], 3);
      uploaded_->use_material(sorted[i].material);
      // Textures with holes are mostly opaque: they write depth; glass does not.
      glDepthMask(materials_[sorted[i].material].opacity == 1 ? GL_TRUE : GL_FALSE);
      glDrawElements(GL_TRIANGLES, GLsizei(run.size()), GL_UNSIGNED_INT, run.data());
      i = j;
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_ALPHA_TEST);
  }

  // All surfaces without materials.
  void draw_silhouette() {
    uploaded_->bind_vertices();
    uploaded_->bind_triangles();
    set_plain_state();
    glDrawElements(GL_TRIANGLES, GLsizei(mesh_.triangles.size()), GL_UNSIGNED_INT, nullptr);
    GlContext::finish();
  }

  void set_plain_state() {
    glDisable(GL_LIGHTING);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_BLEND);
    glDisableClientState(GL_COLOR_ARRAY);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glColor4f(materials_[0].diffuse[0], materials_[0].diffuse[1], materials_[0].diffuse[2], 1);
  }

  // What has no area to be seen, a plane from its edge or a single place, is shown by its edges and corners.
  void draw_edges() {
    GrowingArray<uint32_t> edges;
    edges.room(2 * mesh_.triangles.size());
    for (size_t i = 0; i + 2 < mesh_.triangles.size(); i += 3)
      for (size_t k = 0; k < 3; ++k) {
        edges.append(mesh_.triangles[i + k]);
        edges.append(mesh_.triangles[i + (k + 1) % 3]);
      }
    uploaded_->bind_vertices();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    set_plain_state();
    set_sizes();
    glDrawElements(GL_LINES, GLsizei(edges.size()), GL_UNSIGNED_INT, edges.data());
    glDrawElements(GL_POINTS, GLsizei(edges.size()), GL_UNSIGNED_INT, edges.data());
    GlContext::finish();
  }

  bool anything_drawn() const {
    const size_t count = size_t(width_) * size_t(height_);
    const uint8_t* pixels = samples_.data();
    for (size_t i = 0; i < count; ++i)
      if (pixels[4 * i + 3]) return true;
    return false;
  }

  const Mesh& mesh_;
  const std::vector<Material>& materials_;
  const ModelFrame& frame_;
  const Camera& camera_;
  const RenderOptions& options_;
  int width_, height_;
  GrowingArray<uint8_t> samples_; // RGBA rows from the top
  const UploadedMesh* uploaded_ = nullptr;
};

MeshRenderer::MeshRenderer(const Mesh& mesh, const std::vector<Material>& materials, const ModelFrame& frame)
    : mesh_(mesh), materials_(materials), frame_(frame) {}

MeshRenderer::~MeshRenderer() = default;

RenderResult MeshRenderer::draw(const Camera& camera, const RenderOptions& options, Warnings& warnings) {
  RenderResult result;
  const auto start = std::chrono::steady_clock::now();
  Drawing drawing(*this, camera, options);
  drawing.prepare(*this, warnings);
  result.upload_seconds = seconds_since(start);
  drawing.draw_all(result);
  drawing.average(result);
  return result;
}

} // namespace softgl::cli
