#include "scene/renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "common/program_error.h"
#include "image/sample_average.h"
#include "image/texture_loader.h"
#include "scene/gl_functions.h"
#include "scene/lighting_setup.h"

namespace softgl::cli {
namespace {

constexpr float kSegmentWidth = 1.5f, kPointSize = 4.0f; // in pixels of the finished picture

struct DestroyContext {
  void operator()(osmesa_context* context) const { OSMesaDestroyContext(context); }
};

struct GlMaterial {
  GLuint texture = 0;
  bool blended = false;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class Renderer {
public:
  Renderer(const Mesh& mesh, const std::vector<Material>& materials, const ModelFrame& frame,
           const Camera& camera, const RenderOptions& options, Warnings& warnings)
      : mesh_(mesh), materials_(materials), frame_(frame), camera_(camera), options_(options),
        warnings_(warnings) {}

  RenderResult run() {
    RenderResult result;
    const auto start = std::chrono::steady_clock::now();
    create_context();
    upload();
    result.upload_seconds = seconds_since(start);

    const auto draw_start = std::chrono::steady_clock::now();
    draw();
    result.visible = anything_drawn();
    if (!result.visible && !mesh_.triangles.empty()) {
      draw_edges();
      result.as_wireframe = result.visible = anything_drawn();
    }
    result.draw_seconds = seconds_since(draw_start);
    const GLenum error = glGetError();
    if (error == GL_OUT_OF_MEMORY) throw ProgramError(kCannotRead, "out of memory while drawing");
    if (error != GL_NO_ERROR)
      throw ProgramError(kCannotRead, "GL error " + std::to_string(error) + " while drawing");

    const auto resolve_start = std::chrono::steady_clock::now();
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    context_.reset(); // nobody writes to the buffer any more
    result.picture = resolve(std::move(buffer_), options_.width, options_.height, options_.samples_per_side,
                             options_.background.transparent);
    result.resolve_seconds = seconds_since(resolve_start);
    return result;
  }

private:
  void create_context() {
    width_ = options_.width * options_.samples_per_side;
    height_ = options_.height * options_.samples_per_side;
    context_.reset(OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr));
    if (!context_) throw ProgramError(kCannotRead, "cannot create a GL context");
    const size_t bytes = size_t(4) * size_t(width_) * size_t(height_);
    buffer_.extend(bytes);
    if (!OSMesaMakeCurrent(context_.get(), buffer_.data(), GL_UNSIGNED_BYTE, width_, height_))
      throw ProgramError(kUsageError, "GL cannot draw a picture of " + std::to_string(width_) + "x" +
                                          std::to_string(height_) + " samples");
    OSMesaPixelStore(OSMESA_Y_UP, 0);
  }

  static GLuint buffer_of(GLenum target, const void* data, size_t bytes) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, GLsizeiptr(bytes), data, GL_STATIC_DRAW);
    return name;
  }

  void upload() {
    gl_materials_.resize(materials_.size());
    for (const Batch& batch : mesh_.triangle_batches) prepare_material(batch.material);
    if (mesh_.triangles.empty()) return;
    // One buffer: positions, normals, texture coordinates, colors one after the other.
    const auto bytes = [](const GrowingArray<float>& part) { return part.size() * sizeof(float); };
    const GrowingArray<float>* parts[] = {&mesh_.positions, &mesh_.normals, &mesh_.texcoords, &mesh_.colors};
    size_t total = 0;
    for (const auto* part : parts) total += bytes(*part);
    glGenBuffers(1, &vertex_buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(total), nullptr, GL_STATIC_DRAW);
    size_t offset = 0;
    for (size_t i = 0; i < 4; ++i) {
      offsets_[i] = offset;
      if (bytes(*parts[i]))
        glBufferSubData(GL_ARRAY_BUFFER, GLintptr(offset), GLsizeiptr(bytes(*parts[i])), parts[i]->data());
      offset += bytes(*parts[i]);
    }
    index_buffer_ =
        buffer_of(GL_ELEMENT_ARRAY_BUFFER, mesh_.triangles.data(), mesh_.triangles.size() * sizeof(uint32_t));
  }

  void prepare_material(uint32_t number) {
    const Material& material = materials_[number];
    GlMaterial& prepared = gl_materials_[number];
    prepared.blended = material.opacity < 1;
    if (material.diffuse_map.file.empty() || mesh_.texcoords.empty()) return;
    TextureImage image;
    std::string problem;
    if (!load_texture(material, image, problem)) {
      warnings_.add(material.diffuse_map.file, "this picture " + problem);
      return;
    }
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    const bool any_size = (version && version[0] >= '2') || has_extension("GL_ARB_texture_non_power_of_two");
    fit_texture(image, std::max(largest, 64), !any_size);
    prepared.blended |= image.channels == 4;
    glGenTextures(1, &prepared.texture);
    glBindTexture(GL_TEXTURE_2D, prepared.texture);
    const GLint wrap = material.diffuse_map.clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const GLenum format = image.channels == 4 ? GL_RGBA : GL_RGB;
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(format), image.width, image.height, 0, format, GL_UNSIGNED_BYTE,
                 image.texels.data());
  }

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

  void bind_vertices() {
    const auto at = [this](size_t part) { return reinterpret_cast<const void*>(offsets_[part]); };
    glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
    glVertexPointer(3, GL_FLOAT, 0, at(0));
    glEnableClientState(GL_VERTEX_ARRAY);
    glNormalPointer(GL_FLOAT, 0, at(1));
    glEnableClientState(GL_NORMAL_ARRAY);
    if (!mesh_.texcoords.empty()) glTexCoordPointer(2, GL_FLOAT, 0, at(2));
    if (!mesh_.colors.empty()) glColorPointer(3, GL_FLOAT, 0, at(3));
  }

  void use_material(uint32_t number) {
    const Material& material = materials_[number];
    const GlMaterial& prepared = gl_materials_[number];
    const auto set = [&](GLenum name, const float* rgb) {
      const float rgba[4] = {rgb[0], rgb[1], rgb[2], material.opacity};
      glMaterialfv(GL_FRONT_AND_BACK, name, rgba);
    };
    const bool colored = !mesh_.colors.empty() && material.opacity == 1; // the array has no alpha
    glDisable(GL_COLOR_MATERIAL);
    set(GL_AMBIENT, material.ambient);
    set(GL_DIFFUSE, material.diffuse);
    set(GL_SPECULAR, material.specular);
    set(GL_EMISSION, material.emission);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, material.shininess);
    const bool shiny = material.specular[0] > 0 || material.specular[1] > 0 || material.specular[2] > 0;
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                  shiny && prepared.texture ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    if (colored) {
      glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
      glEnable(GL_COLOR_MATERIAL);
      glEnableClientState(GL_COLOR_ARRAY);
    } else {
      glDisableClientState(GL_COLOR_ARRAY);
      glColor4f(material.diffuse[0], material.diffuse[1], material.diffuse[2], material.opacity);
    }
    if (material.lit)
      glEnable(GL_LIGHTING);
    else
      glDisable(GL_LIGHTING);
    if (prepared.texture) {
      glEnable(GL_TEXTURE_2D);
      glBindTexture(GL_TEXTURE_2D, prepared.texture);
      glEnableClientState(GL_TEXTURE_COORD_ARRAY);
      const TextureReference& map = material.diffuse_map;
      glMatrixMode(GL_TEXTURE);
      glLoadIdentity();
      glTranslatef(map.offset[0], map.offset[1], 0);
      glScalef(map.scale[0], map.scale[1], 1);
      glMatrixMode(GL_MODELVIEW);
    } else {
      glDisable(GL_TEXTURE_2D);
      glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    }
  }

  void draw() {
    set_state();
    if (!mesh_.triangles.empty()) {
      bind_vertices();
      glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
      bool any_blended = false;
      for (const Batch& batch : mesh_.triangle_batches) {
        if (gl_materials_[batch.material].blended) {
          any_blended = true;
          continue;
        }
        use_material(batch.material);
        glDrawElements(GL_TRIANGLES, GLsizei(batch.count), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(batch.first * sizeof(uint32_t)));
      }
      draw_elements(GL_LINES, mesh_.segment_positions, mesh_.segment_colors, mesh_.segment_batches);
      draw_elements(GL_POINTS, mesh_.point_positions, mesh_.point_colors, mesh_.point_batches);
      if (any_blended) draw_blended();
    } else {
      draw_elements(GL_LINES, mesh_.segment_positions, mesh_.segment_colors, mesh_.segment_batches);
      draw_elements(GL_POINTS, mesh_.point_positions, mesh_.point_colors, mesh_.point_batches);
    }
    glFinish();
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
      glColorPointer(3, GL_FLOAT, 0, colors.data());
    } else {
      glDisableClientState(GL_COLOR_ARRAY);
    }
    glLineWidth(kSegmentWidth * float(options_.samples_per_side));
    glPointSize(kPointSize * float(options_.samples_per_side));
    for (const Batch& batch : batches) {
      glColor4f(materials_[batch.material].diffuse[0], materials_[batch.material].diffuse[1],
                materials_[batch.material].diffuse[2], 1);
      glDrawArrays(mode, GLint(batch.first), GLsizei(batch.count));
    }
  }

  // Blended triangles of all materials from the far end to the near one.
  void draw_blended() {
    struct Entry {
      float depth;
      uint32_t first, material;
    };
    std::vector<Entry> entries;
    const float eye[3] = {float(camera_.eye[0]), float(camera_.eye[1]), float(camera_.eye[2])};
    for (const Batch& batch : mesh_.triangle_batches) {
      if (!gl_materials_[batch.material].blended) continue;
      for (uint32_t i = batch.first; i < batch.first + batch.count; i += 3) {
        float depth = 0;
        for (uint32_t k = 0; k < 3; ++k) {
          const float* p = &mesh_.positions[3 * size_t(mesh_.triangles[i + k])];
          depth += p[0] * eye[0] + p[1] * eye[1] + p[2] * eye[2];
        }
        entries.push_back({depth, i, batch.material});
      }
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.depth < b.depth; });
    bind_vertices();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glEnable(GL_BLEND);
    glEnable(GL_ALPHA_TEST);
    GrowingArray<uint32_t> run;
    for (size_t i = 0; i < entries.size();) {
      run.truncate(0);
      size_t j = i;
      for (; j < entries.size() && entries[j].material == entries[i].material; ++j)
        run.append(&mesh_.triangles[entries[j].first], 3);
      use_material(entries[i].material);
      // Textures with holes are mostly opaque: they write depth; glass does not.
      glDepthMask(materials_[entries[i].material].opacity == 1 ? GL_TRUE : GL_FALSE);
      glDrawElements(GL_TRIANGLES, GLsizei(run.size()), GL_UNSIGNED_INT, run.data());
      i = j;
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_ALPHA_TEST);
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
    bind_vertices();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glDisable(GL_LIGHTING);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_BLEND);
    glDisableClientState(GL_COLOR_ARRAY);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glColor4f(materials_[0].diffuse[0], materials_[0].diffuse[1], materials_[0].diffuse[2], 1);
    glLineWidth(kSegmentWidth * float(options_.samples_per_side));
    glPointSize(kPointSize * float(options_.samples_per_side));
    glDrawElements(GL_LINES, GLsizei(edges.size()), GL_UNSIGNED_INT, edges.data());
    glDrawElements(GL_POINTS, GLsizei(edges.size()), GL_UNSIGNED_INT, edges.data());
    glFinish();
  }

  bool anything_drawn() const {
    const size_t count = size_t(width_) * size_t(height_);
    const uint8_t* pixels = buffer_.data();
    for (size_t i = 0; i < count; ++i)
      if (pixels[4 * i + 3]) return true;
    return false;
  }

  const Mesh& mesh_;
  const std::vector<Material>& materials_;
  const ModelFrame& frame_;
  const Camera& camera_;
  const RenderOptions& options_;
  Warnings& warnings_;
  int width_ = 0, height_ = 0;
  GrowingArray<uint8_t> buffer_; // outlives the context, which writes to it
  std::unique_ptr<osmesa_context, DestroyContext> context_;
  std::vector<GlMaterial> gl_materials_;
  GLuint vertex_buffer_ = 0, index_buffer_ = 0;
  size_t offsets_[4] = {0, 0, 0, 0};
};

} // namespace

RenderResult render(const Mesh& mesh, const std::vector<Material>& materials, const ModelFrame& frame,
                    const Camera& camera, const RenderOptions& options, Warnings& warnings) {
  return Renderer(mesh, materials, frame, camera, options, warnings).run();
}

} // namespace softgl::cli
