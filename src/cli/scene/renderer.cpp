#include "scene/renderer.h"

#include <algorithm>
#include <optional>

#include "common/elapsed_time.h"
#include "image/sample_average.h"
#include "image/srgb.h"
#include "scene/data_pass.h"
#include "scene/float_target.h"
#include "scene/gl_context.h"
#include "scene/ground.h"
#include "scene/line_overlay.h"
#include "scene/mesh_drawing.h"
#include "scene/picture_state.h"
#include "scene/uploaded_mesh.h"

namespace softgl::cli {
namespace {

// Alpha alone.
template <class Colors> FloatPicture coverage_of(const Colors& picture, float largest) {
  FloatPicture result;
  result.width = picture.width;
  result.height = picture.height;
  result.channels = 1;
  const auto& values = [&]() -> const auto& {
    if constexpr (std::is_same_v<Colors, Picture>)
      return picture.pixels;
    else
      return picture.values;
  }
  ();
  float* out = result.values.extend(values.size() / 4);
  for (size_t i = 3; i < values.size(); i += 4) *out++ = float(values[i]) / largest;
  return result;
}

} // namespace

struct MeshRenderer::Resources {
  Resources(uint8_t* pixels, int width, int height, const MeshRenderer& renderer, Warnings& warnings)
      : context(pixels, width, height, 24),
        uploaded(renderer.mesh_, renderer.materials_, renderer.linear_, warnings) {}

  GlContext context;
  UploadedMesh uploaded;
};

// One picture.
class MeshRenderer::Drawing {
public:
  Drawing(const MeshRenderer& renderer, const Camera& camera, const RenderOptions& options)
      : mesh_(renderer.mesh_), materials_(renderer.materials_), frame_(renderer.frame_), camera_(camera),
        options_(settle_for_pass(options)), width_(options.width * options.samples_per_side),
        height_(options.height * options.samples_per_side) {
    samples_.extend(size_t(4) * size_t(width_) * size_t(height_));
  }

  // The renderer's context and objects, made if there are none yet.
  void prepare(MeshRenderer& renderer, Warnings& warnings) {
    if (renderer.resources_)
      renderer.resources_->context.attach(samples_.data(), width_, height_);
    else
      renderer.resources_ = std::make_unique<Resources>(samples_.data(), width_, height_, renderer, warnings);
    uploaded_ = &renderer.resources_->uploaded;
  }

  void run(RenderResult& result) {
    const auto start = Clock::now();
    glPushAttrib(GL_ALL_ATTRIB_BITS); // the next picture begins with the same state
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    if (is_data(options_.pass)) {
      DataPicture data = draw_data(options_.pass, mesh_, materials_, frame_, *uploaded_, camera_,
                                   options_.width, options_.height, options_.values != Values::kFloats);
      result.visible = data.visible;
      deliver(std::move(data.picture), result);
    } else {
      draw_colors(result);
    }
    glPopClientAttrib();
    glPopAttrib();
    result.draw_seconds = seconds_since(start) - result.average_seconds;
  }

private:
  void draw_colors(RenderResult& result) {
    std::optional<FloatTarget> target;
    // Many faint shadows, and light that is encoded in the end, need more than bytes.
    if (options_.values != Values::kBytes || options_.ground || options_.srgb)
      target.emplace(width_, height_, options_.values != Values::kFloats);
    MeshDrawing drawing(mesh_, materials_, *uploaded_, camera_, float(options_.samples_per_side));
    if (is_term(options_.pass) && options_.pass != Pass::kEmission) drawing.blacken_unlit();
    set_state();
    draw(drawing);
    result.visible = anything_drawn(target);
    if (result.visible && options_.ground) {
      draw_ground_shadow(mesh_, *uploaded_, camera_, options_.up);
      draw_rest(drawing);
      anything_drawn(target);
    }
    if (!result.visible && !mesh_.triangles.empty()) {
      drawing.draw_silhouette();
      GlContext::finish();
      result.transparent = anything_drawn(target);
      clear_picture(options_, width_, height_);
      drawing.draw_bare_edges();
      GlContext::finish();
      result.as_wireframe = result.visible = anything_drawn(target);
    }
    const auto start = Clock::now();
    average(target.has_value(), result); // nobody writes to the samples any more
    result.average_seconds = seconds_since(start);
  }

  void average(bool in_floats, RenderResult& result) {
    const bool transparent = options_.background.transparent, coverage = options_.pass == Pass::kCoverage;
    const int side = options_.samples_per_side;
    if (in_floats) {
      FloatPicture picture =
          average_float_samples(float_samples_, options_.width, options_.height, side, transparent);
      if (options_.srgb && !coverage && options_.values != Values::kFloats) encode(picture);
      deliver(coverage ? coverage_of(picture, 1) : std::move(picture), result);
    } else {
      result.picture =
          average_samples(std::move(samples_), options_.width, options_.height, side, transparent);
      if (coverage) result.picture = quantize(coverage_of(result.picture, 255), 8);
    }
  }

  static void encode(FloatPicture& picture) {
    const auto channels = size_t(picture.channels);
    for (size_t i = 0; i < picture.values.size(); ++i)
      if (i % channels < 3) picture.values[i] = to_srgb(picture.values[i]);
  }

  void deliver(FloatPicture picture, RenderResult& result) const {
    if (options_.values == Values::kFloats)
      result.floats = std::move(picture);
    else
      result.picture = quantize(picture, options_.values == Values::kWords ? 16 : 8);
  }

  void set_state() const {
    const LineOptions& lines = options_.lines;
    const bool any_lines = !mesh_.segment_positions.empty() || lines.edges != Edges::kNone ||
                           lines.style != LineOptions::kSurface;
    start_picture(options_, camera_, frame_, width_, height_, any_lines && !mesh_.triangles.empty());
  }

  void draw(const MeshDrawing& drawing) {
    const LineOptions& lines = options_.lines;
    if (lines.style == LineOptions::kSurface)
      any_blended_ = !mesh_.triangles.empty() && !drawing.draw_opaque();
    else if (!lines.hidden)
      draw_depth_only(mesh_, *uploaded_);
    draw_rest(drawing);
  }

  // Again after the ground, which is behind it.
  void draw_rest(const MeshDrawing& drawing) const {
    const LineOptions& lines = options_.lines;
    drawing.draw_segments_and_points();
    if (any_blended_) drawing.draw_blended();
    if (lines.style != LineOptions::kSurface || lines.edges != Edges::kNone)
      draw_lines(mesh_, *uploaded_, lines, line_color(), float(options_.samples_per_side));
    GlContext::finish();
  }

  // Seen on the surface, or on the background where there is none.
  std::array<float, 3> line_color() const {
    std::array<float, 3> color = options_.lines.color.value_or(std::array<float, 3>{0.1f, 0.1f, 0.1f});
    const uint8_t* behind = options_.background.color;
    const bool dark = 0.299 * behind[0] + 0.587 * behind[1] + 0.114 * behind[2] < 128;
    if (!options_.lines.color && options_.lines.style != LineOptions::kSurface && dark) color.fill(0.85f);
    if (options_.srgb)
      for (float& value : color) value = from_srgb(value);
    return color;
  }

  bool anything_drawn(const std::optional<FloatTarget>& target) {
    const size_t count = 4 * size_t(width_) * size_t(height_);
    if (target) float_samples_ = target->colors();
    for (size_t i = 3; i < count; i += 4)
      if (target ? float_samples_[i] > 0 : samples_[i] > 0) return true;
    return false;
  }

  const Mesh& mesh_;
  const std::vector<Material>& materials_;
  const ModelFrame& frame_;
  const Camera& camera_;
  RenderOptions options_;
  int width_, height_;
  GrowingArray<uint8_t> samples_; // RGBA rows from the top
  GrowingArray<float> float_samples_;
  const UploadedMesh* uploaded_ = nullptr;
  bool any_blended_ = false;
};

MeshRenderer::MeshRenderer(const Mesh& mesh, const std::vector<Material>& materials, const ModelFrame& frame,
                           bool linear)
    : mesh_(mesh), materials_(materials), frame_(frame), linear_(linear) {}

MeshRenderer::~MeshRenderer() = default;

RenderResult MeshRenderer::draw(const Camera& camera, const RenderOptions& options, Warnings& warnings) {
  RenderResult result;
  const auto start = Clock::now();
  Drawing drawing(*this, camera, options);
  drawing.prepare(*this, warnings);
  result.upload_seconds = seconds_since(start);
  drawing.run(result);
  return result;
}

} // namespace softgl::cli
