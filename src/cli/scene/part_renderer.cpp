#include "scene/part_renderer.h"

#include <algorithm>

#include "image/sample_average.h"
#include "scene/gl_context.h"
#include "scene/mesh_drawing.h"
#include "scene/picture_state.h"
#include "scene/uploaded_mesh.h"

namespace softgl::cli {
namespace {

PartSamples room_for(const RenderOptions& options) {
  PartSamples samples;
  samples.width = options.width * options.samples_per_side;
  samples.height = options.height * options.samples_per_side;
  samples.colors.extend(4 * size_t(samples.width) * size_t(samples.height));
  return samples;
}

// GL's rows begin at the bottom.
template <class T> void turn_rows(GrowingArray<T>& values, int width) {
  const auto columns = size_t(width);
  for (size_t low = 0, high = values.size(); low + columns < high; low += columns) {
    high -= columns;
    std::swap_ranges(&values[low], &values[low] + columns, &values[high]);
  }
}

template <class T> GrowingArray<T> read_rows(const PartSamples& samples, GLenum format, GLenum type) {
  GrowingArray<T> values;
  values.extend(size_t(samples.width) * size_t(samples.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, samples.width, samples.height, format, type, values.data());
  turn_rows(values, samples.width);
  return values;
}

// Which step each sample was drawn last by, with the help of the stencil: it counts steps of an order of
// their own.
class StencilOrders {
public:
  explicit StencilOrders(PartSamples& samples) : samples_(samples) {
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    start();
  }

  void begin_step(uint32_t order) {
    if (order == orders_.back()) return;
    if (orders_.size() == 256) collect();
    orders_.push_back(order);
    glStencilFunc(GL_ALWAYS, GLint(orders_.size() - 1), 255);
  }

  void collect() {
    const auto values = read_rows<uint8_t>(samples_, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
    for (size_t i = 0; i < values.size(); ++i)
      if (values[i]) samples_.orders[i] = orders_[values[i]];
    start();
  }

private:
  void start() {
    orders_.assign(1, 0);
    glClear(GL_STENCIL_BUFFER_BIT);
  }

  PartSamples& samples_;
  std::vector<uint32_t> orders_; // by value of the stencil
};

} // namespace

struct PartRenderer::Resources {
  Resources(const PartRenderer& renderer, std::vector<Warnings>& warnings)
      : samples(room_for(renderer.options_)),
        context(samples.colors.data(), samples.width, samples.height, 24, renderer.interleaved_ ? 8 : 0) {
    for (size_t i = 0; i < renderer.meshes_.size(); ++i)
      uploaded.push_back(std::make_unique<UploadedMesh>(*renderer.meshes_[i].mesh,
                                                        *renderer.meshes_[i].materials, false, warnings[i]));
  }

  // Those of the first picture are there since the context was made.
  PartSamples take_samples(const RenderOptions& options) {
    if (samples.colors.empty()) {
      samples = room_for(options);
      context.attach(samples.colors.data(), samples.width, samples.height);
    }
    return std::move(samples);
  }

  PartSamples samples;
  GlContext context;
  std::vector<std::unique_ptr<UploadedMesh>> uploaded;
};

// One picture.
class PartRenderer::Drawing {
public:
  Drawing(PartRenderer& renderer, const Camera& camera, bool lines_on_surfaces)
      : renderer_(renderer), samples_(renderer.resources_->take_samples(renderer.options_)) {
    const RenderOptions& options = renderer.options_;
    start_picture(options, camera, renderer.frame_, samples_.width, samples_.height, lines_on_surfaces);
    for (size_t i = 0; i < renderer.meshes_.size(); ++i) {
      drawings_.emplace_back(*renderer.meshes_[i].mesh, *renderer.meshes_[i].materials,
                             *renderer.resources_->uploaded[i], camera, float(options.samples_per_side));
      if (is_term(options.pass) && options.pass != Pass::kEmission) drawings_.back().blacken_unlit();
    }
    samples_.orders.fill(size_t(samples_.width) * size_t(samples_.height), 0);
  }

  void draw(const std::vector<PartStep>& steps) {
    if (renderer_.interleaved_) {
      StencilOrders orders(samples_);
      for (const PartStep& step : steps) {
        orders.begin_step(step.order);
        draw(step);
      }
      orders.collect();
      finish();
      return;
    }
    for (const PartStep& step : steps) draw(step);
    finish();
    set_orders(steps.empty() ? 0 : steps.back().order);
  }

  void draw_edges() {
    for (size_t i = 0; i < drawings_.size(); ++i)
      if (!renderer_.meshes_[i].mesh->triangles.empty()) drawings_[i].draw_bare_edges();
    finish();
    set_orders(1); // all of one color
  }

  PartSamples take() { return std::move(samples_); }

private:
  void draw(const PartStep& step) const {
    const MeshDrawing& drawing = drawings_[step.mesh];
    const Mesh& mesh = *renderer_.meshes_[step.mesh].mesh;
    switch (step.kind) {
    case PartStep::kTriangles: return drawing.draw_triangles(mesh.triangle_batches[step.batch]);
    case PartStep::kSegments: return drawing.draw_segments(mesh.segment_batches[step.batch]);
    case PartStep::kPoints: return drawing.draw_points(mesh.point_batches[step.batch]);
    }
  }

  void finish() {
    samples_.depths = read_rows<uint32_t>(samples_, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
    GlContext::finish();
  }

  // One for all that is drawn: nobody else's lies between this process's first and last.
  void set_orders(uint32_t order) {
    for (size_t i = 0; i < samples_.orders.size(); ++i)
      if (samples_.colors[4 * i + 3]) samples_.orders[i] = order; // the background has no alpha
  }

  PartRenderer& renderer_;
  PartSamples samples_;
  std::vector<MeshDrawing> drawings_;
};

PartRenderer::PartRenderer(std::vector<PartMesh> meshes, const ModelFrame& frame,
                           const RenderOptions& options, bool interleaved, std::vector<Warnings>& warnings)
    : meshes_(std::move(meshes)), frame_(frame), options_(settle_for_pass(options)),
      interleaved_(interleaved), resources_(std::make_unique<Resources>(*this, warnings)) {}

PartRenderer::~PartRenderer() = default;

const Material* PartRenderer::transparent_material() const {
  for (size_t i = 0; i < meshes_.size(); ++i)
    for (const Batch& batch : meshes_[i].mesh->triangle_batches)
      if (resources_->uploaded[i]->blended(batch.material)) return &(*meshes_[i].materials)[batch.material];
  return nullptr;
}

PartSamples PartRenderer::draw(const Camera& camera, const std::vector<PartStep>& steps,
                               bool lines_on_surfaces) {
  Drawing drawing(*this, camera, lines_on_surfaces);
  drawing.draw(steps);
  return drawing.take();
}

PartSamples PartRenderer::draw_edges(const Camera& camera) {
  Drawing drawing(*this, camera, false);
  drawing.draw_edges();
  return drawing.take();
}

Picture picture_of(PartSamples samples, const RenderOptions& options) {
  return average_samples(std::move(samples.colors), options.width, options.height, options.samples_per_side,
                         settle_for_pass(options).background.transparent);
}

} // namespace softgl::cli
