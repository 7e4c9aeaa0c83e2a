#include "scene/data_pass.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "common/program_error.h"
#include "scene/float_target.h"
#include "scene/gl_context.h"
#include "scene/mesh_drawing.h"

namespace softgl::cli {
namespace {

std::string text_of(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

// Colors far apart for numbers that follow each other: hues by the golden angle.
void color_of(unsigned number, float* rgb) {
  const double hue = 6 * std::fmod(number * 0.6180339887498949, 1.0);
  const double value = number % 3 == 1 ? 1 : number % 3 == 2 ? 0.75 : 0.5;
  const double offsets[3] = {0, 4, 2};
  for (int c = 0; c < 3; ++c) {
    const double distance = std::fabs(std::fmod(hue + offsets[c], 6.0) - 3);
    const double full = std::fmin(std::fmax(distance - 1, 0), 1);
    rgb[c] = float(std::round(255 * value * (0.25 + 0.75 * full)) / 255);
  }
}

std::string printable_ascii(const std::string& text) {
  std::string result;
  for (const char c : text) result += c >= ' ' && c <= '~' ? c : '?';
  return result;
}

class DataDrawing {
public:
  DataDrawing(Pass pass, const Mesh& mesh, const std::vector<Material>& materials, const ModelFrame& frame,
              const UploadedMesh& uploaded, const Camera& camera, int width, int height)
      : pass_(pass), mesh_(mesh), materials_(materials), frame_(frame), uploaded_(uploaded), camera_(camera),
        width_(width), height_(height) {}

  DataPicture draw(bool whole) {
    const FloatTarget target(width_, height_, false);
    set_state();
    draw_triangles();
    draw_elements(GL_LINES, mesh_.segment_positions, mesh_.segment_batches);
    draw_elements(GL_POINTS, mesh_.point_positions, mesh_.point_batches);
    GlContext::finish();
    colors_ = target.colors();
    if (pass_ == Pass::kDepth) depths_ = target.depths();
    DataPicture result;
    for (size_t i = 3; i < colors_.size() && !result.visible; i += 4) result.visible = colors_[i] > 0;
    FloatPicture& picture = result.picture;
    picture.width = width_;
    picture.height = height_;
    picture.channels = pass_ == Pass::kDepth || (pass_ == Pass::kId && !whole) ? 1 : 3;
    const size_t count = size_t(width_) * size_t(height_), channels = size_t(picture.channels);
    float* out = picture.values.extend(count * channels);
    for (size_t i = 0; i < count; ++i, out += channels) {
      std::fill_n(out, channels, 0.0f);
      store(i, whole, out);
    }
    note(whole, picture);
    return result;
  }

private:
  void set_state() const {
    glViewport(0, 0, width_, height_);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(camera_.projection);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(camera_.view);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GEQUAL, 0.5f);
    // The number is the primary color's, the alpha the texture's.
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_PRIMARY_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA, GL_TEXTURE);
    if (!mesh_.segment_positions.empty() && !mesh_.triangles.empty()) {
      glEnable(GL_POLYGON_OFFSET_FILL); // as in the picture of colors
      glPolygonOffset(1, 1);
    }
  }

  // Three floats of each vertex.
  const float* vertex_numbers() {
    if (pass_ == Pass::kNormal) return mesh_.normals.data();
    if (pass_ != Pass::kUv || mesh_.texcoords.empty()) return nullptr;
    numbers_.truncate(0);
    for (size_t i = 0; i + 1 < mesh_.texcoords.size(); i += 2)
      for (const float value : {mesh_.texcoords[i], mesh_.texcoords[i + 1], 0.0f}) numbers_.append(value);
    return numbers_.data();
  }

  void draw_triangles() {
    if (mesh_.triangles.empty()) return;
    uploaded_.use_vertices();
    glDisableClientState(GL_NORMAL_ARRAY);
    const float* numbers = vertex_numbers();
    for (const Batch& batch : mesh_.triangle_batches) {
      uploaded_.use_texture(batch.material);
      glDisableClientState(GL_COLOR_ARRAY);
      glColor4f(number_of(batch), 0, 0, 1);
      if (numbers) {
        glColorPointer(3, GL_FLOAT, 0, numbers);
        glEnableClientState(GL_COLOR_ARRAY);
      }
      uploaded_.draw_triangles(batch.first, batch.count);
    }
  }

  float number_of(const Batch& batch) const { return pass_ == Pass::kId ? float(batch.material + 1) : 0; }

  void draw_elements(GLenum mode, const GrowingArray<float>& positions,
                     const std::vector<Batch>& batches) const {
    if (positions.empty()) return;
    glDisable(GL_TEXTURE_2D);
    for (const GLenum array : {GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY})
      glDisableClientState(array);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, positions.data());
    const LineSizes sizes;
    glLineWidth(sizes.segment);
    glPointSize(sizes.point);
    for (const Batch& batch : batches) {
      glColor4f(number_of(batch), 0, 0, 1);
      glDrawArrays(mode, GLint(batch.first), GLsizei(batch.count));
    }
  }

  void store(size_t i, bool whole, float* out) const {
    const float* color = &colors_[4 * i];
    const bool covered = color[3] > 0;
    switch (pass_) {
    case Pass::kDepth: {
      const double distance = camera_.distance_of(double(depths_[i]));
      const double near = camera_.distance_of(0), far = camera_.distance_of(1);
      if (whole)
        *out = covered ? float((distance - near) / (far - near)) : 1;
      else
        *out = covered ? float(distance / frame_.scale) : std::numeric_limits<float>::infinity();
      return;
    }
    case Pass::kNormal: {
      const double length =
          std::sqrt(double(color[0]) * color[0] + double(color[1]) * color[1] + double(color[2]) * color[2]);
      if (!(length > 0)) return;
      for (int c = 0; c < 3; ++c) out[c] = float(whole ? (color[c] / length + 1) / 2 : color[c] / length);
      return;
    }
    case Pass::kUv:
      for (int c = 0; c < 2; ++c) out[c] = whole ? color[c] - std::floor(color[c]) : color[c];
      return;
    default:
      if (!covered) return;
      if (whole)
        color_of(unsigned(color[0] + 0.5f), out);
      else
        *out = color[0];
    }
  }

  void note(bool whole, FloatPicture& picture) const {
    picture.notes.push_back({"softgl pass", name_of(pass_)});
    if (pass_ == Pass::kDepth) {
      picture.notes.push_back({"softgl near", text_of(camera_.distance_of(0) / frame_.scale)});
      picture.notes.push_back({"softgl far", text_of(camera_.distance_of(1) / frame_.scale)});
    }
    if (pass_ != Pass::kId) return;
    for (const std::vector<Batch>* batches :
         {&mesh_.triangle_batches, &mesh_.segment_batches, &mesh_.point_batches})
      for (const Batch& batch : *batches) {
        std::string number = std::to_string(batch.material + 1);
        if (whole) {
          float rgb[3];
          char hex[8];
          color_of(batch.material + 1, rgb);
          std::snprintf(hex, sizeof hex, "#%02x%02x%02x", unsigned(rgb[0] * 255 + 0.5f),
                        unsigned(rgb[1] * 255 + 0.5f), unsigned(rgb[2] * 255 + 0.5f));
          number = hex;
        }
        picture.notes.push_back({"softgl id " + number, printable_ascii(materials_[batch.material].name)});
      }
  }

  Pass pass_;
  const Mesh& mesh_;
  const std::vector<Material>& materials_;
  const ModelFrame& frame_;
  const UploadedMesh& uploaded_;
  const Camera& camera_;
  int width_, height_;
  GrowingArray<float> numbers_, colors_, depths_;
};

constexpr struct {
  const char* name;
  Pass pass;
} kPasses[] = {{"color", Pass::kColor},
               {"colour", Pass::kColor},
               {"depth", Pass::kDepth},
               {"normal", Pass::kNormal},
               {"uv", Pass::kUv},
               {"id", Pass::kId},
               {"ambient", Pass::kAmbient},
               {"diffuse", Pass::kDiffuse},
               {"specular", Pass::kSpecular},
               {"emission", Pass::kEmission},
               {"coverage", Pass::kCoverage}};

} // namespace

std::vector<std::string> pass_names() {
  std::vector<std::string> names;
  for (const auto& known : kPasses)
    if (known.name == std::string(name_of(known.pass))) names.emplace_back(known.name);
  return names;
}

bool named_pass(const std::string& name, Pass& pass) {
  for (const auto& known : kPasses)
    if (name == known.name) {
      pass = known.pass;
      return true;
    }
  return false;
}

const char* name_of(Pass pass) {
  for (const auto& known : kPasses)
    if (pass == known.pass) return known.name;
  return "";
}

DataPicture draw_data(Pass pass, const Mesh& mesh, const std::vector<Material>& materials,
                      const ModelFrame& frame, const UploadedMesh& uploaded, const Camera& camera, int width,
                      int height, bool whole) {
  return DataDrawing(pass, mesh, materials, frame, uploaded, camera, width, height).draw(whole);
}

} // namespace softgl::cli
