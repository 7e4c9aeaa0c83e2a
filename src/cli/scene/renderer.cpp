#include "scene/renderer.h"

#include "scene/gl_functions.h"
#include "scene/lighting_setup.h"
#include "common/program_error.h"
#include "image/sample_average.h"
#include "image/texture_loader.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

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
      : mesh(mesh), materials(materials), frame(frame), camera(camera), options(options), warnings(warnings) {
  }

  RenderResult run() {
    RenderResult result;
    const auto start = std::chrono::steady_clock::now();
    create_context();
    upload();
    result.upload_seconds = seconds_since(start);

    const auto draw_start = std::chrono::steady_clock::now();
    draw();
    result.visible = anything_drawn();
    if (!result.visible && !mesh.triangles.empty()) {
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
    context.reset(); // nobody writes to the buffer any more
    result.picture = resolve(std::move(buffer), options.width, options.height, options.samples_per_side,
                             options.background.transparent);
    result.resolve_seconds = seconds_since(resolve_start);
    return result;
  }

private:
  void create_context() {
    width = options.width * options.samples_per_side;
    height = options.height * options.samples_per_side;
    context.reset(OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr));
    if (!context) throw ProgramError(kCannotRead, "cannot create a GL context");
    const size_t bytes = size_t(4) * static_cast<size_t>(width) * static_cast<size_t>(height);
    buffer.extend(bytes);
    if (!OSMesaMakeCurrent(context.get(), buffer.data(), GL_UNSIGNED_BYTE, width, height))
      throw ProgramError(kUsageError, "GL cannot draw a picture of " + std::to_string(width) + "x" +
                                          std::to_string(height) + " samples");
    OSMesaPixelStore(OSMESA_Y_UP, 0);
  }

  static GLuint buffer_of(GLenum target, const void* data, size_t bytes) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    return name;
  }

  void upload() {
    gl_materials.resize(materials.size());
    for (const Batch& batch : mesh.triangle_batches) prepare_material(batch.material);
    if (mesh.triangles.empty()) return;
    // One buffer: positions, normals, texture coordinates, colours one after the other.
    const auto bytes = [](const GrowingArray<float>& part) { return part.size() * sizeof(float); };
    const GrowingArray<float>* parts[] = {&mesh.positions, &mesh.normals, &mesh.texcoords, &mesh.colours};
    size_t total = 0;
    for (const auto* part : parts) total += bytes(*part);
    glGenBuffers(1, &vertex_buffer);
    glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(total), nullptr, GL_STATIC_DRAW);
    size_t offset = 0;
    for (size_t i = 0; i < 4; ++i) {
      offsets[i] = offset;
      if (bytes(*parts[i]))
        glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(offset),
                        static_cast<GLsizeiptr>(bytes(*parts[i])), parts[i]->data());
      offset += bytes(*parts[i]);
    }
    index_buffer =
        buffer_of(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles.data(), mesh.triangles.size() * sizeof(uint32_t));
  }

  void prepare_material(uint32_t number) {
    const Material& material = materials[number];
    GlMaterial& prepared = gl_materials[number];
    prepared.blended = material.opacity < 1;
    if (material.diffuse_map.file.empty() || mesh.texcoords.empty()) return;
    TextureImage image;
    std::string problem;
    if (!load_texture(material, image, problem)) {
      warnings.add(material.diffuse_map.file, "this picture " + problem);
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
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), image.width, image.height, 0, format,
                 GL_UNSIGNED_BYTE, image.texels.data());
  }

  void clear() {
    // Alpha counts what is drawn: the background has none, whatever its colour.
    const uint8_t* colour = options.background.colour;
    if (options.background.transparent)
      glClearColor(0, 0, 0, 0);
    else
      glClearColor(static_cast<float>(colour[0]) / 255, static_cast<float>(colour[1]) / 255,
                   static_cast<float>(colour[2]) / 255, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }

  void set_state() {
    glViewport(0, 0, width, height);
    clear();
    apply_lighting(options.lighting, camera, frame);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(camera.projection);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(camera.view);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glAlphaFunc(GL_GREATER, 0);
    if (!mesh.segment_positions.empty() && !mesh.triangles.empty()) {
      glEnable(GL_POLYGON_OFFSET_FILL); // lines on a surface are to be seen
      glPolygonOffset(1, 1);
    }
  }

  void bind_vertices() {
    const auto at = [this](size_t part) { return reinterpret_cast<const void*>(offsets[part]); };
    glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer);
    glVertexPointer(3, GL_FLOAT, 0, at(0));
    glEnableClientState(GL_VERTEX_ARRAY);
    glNormalPointer(GL_FLOAT, 0, at(1));
    glEnableClientState(GL_NORMAL_ARRAY);
    if (!mesh.texcoords.empty()) glTexCoordPointer(2, GL_FLOAT, 0, at(2));
    if (!mesh.colours.empty()) glColorPointer(3, GL_FLOAT, 0, at(3));
  }

  void use_material(uint32_t number) {
    const Material& material = materials[number];
    const GlMaterial& prepared = gl_materials[number];
    const auto set = [&](GLenum name, const float* rgb) {
      const float rgba[4] = {rgb[0], rgb[1], rgb[2], material.opacity};
      glMaterialfv(GL_FRONT_AND_BACK, name, rgba);
    };
    const bool coloured = !mesh.colours.empty() && material.opacity == 1; // the array has no alpha
    glDisable(GL_COLOR_MATERIAL);
    set(GL_AMBIENT, material.ambient);
    set(GL_DIFFUSE, material.diffuse);
    set(GL_SPECULAR, material.specular);
    set(GL_EMISSION, material.emission);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, material.shininess);
    const bool shiny = material.specular[0] > 0 || material.specular[1] > 0 || material.specular[2] > 0;
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                  shiny && prepared.texture ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
    if (coloured) {
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
    if (!mesh.triangles.empty()) {
      bind_vertices();
      glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer);
      bool any_blended = false;
      for (const Batch& batch : mesh.triangle_batches) {
        if (gl_materials[batch.material].blended) {
          any_blended = true;
          continue;
        }
        use_material(batch.material);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.count), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(batch.first * sizeof(uint32_t)));
      }
      draw_elements(GL_LINES, mesh.segment_positions, mesh.segment_colours, mesh.segment_batches);
      draw_elements(GL_POINTS, mesh.point_positions, mesh.point_colours, mesh.point_batches);
      if (any_blended) draw_blended();
    } else {
      draw_elements(GL_LINES, mesh.segment_positions, mesh.segment_colours, mesh.segment_batches);
      draw_elements(GL_POINTS, mesh.point_positions, mesh.point_colours, mesh.point_batches);
    }
    glFinish();
  }

  // Segments and points: the plain diffuse colour, since they have no normals.
  void draw_elements(GLenum mode, const GrowingArray<float>& positions, const GrowingArray<float>& colours,
                     const std::vector<Batch>& batches) {
    if (positions.empty()) return;
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDisable(GL_LIGHTING);
    glDisable(GL_TEXTURE_2D);
    glDisableClientState(GL_NORMAL_ARRAY);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, positions.data());
    if (!colours.empty()) {
      glEnableClientState(GL_COLOR_ARRAY);
      glColorPointer(3, GL_FLOAT, 0, colours.data());
    } else {
      glDisableClientState(GL_COLOR_ARRAY);
    }
    glLineWidth(kSegmentWidth * static_cast<float>(options.samples_per_side));
    glPointSize(kPointSize * static_cast<float>(options.samples_per_side));
    for (const Batch& batch : batches) {
      glColor4f(materials[batch.material].diffuse[0], materials[batch.material].diffuse[1],
                materials[batch.material].diffuse[2], 1);
      glDrawArrays(mode, static_cast<GLint>(batch.first), static_cast<GLsizei>(batch.count));
    }
  }

  // Blended triangles of all materials from the far end to the near one.
  void draw_blended() {
    struct Entry {
      float depth;
      uint32_t first, material;
    };
    std::vector<Entry> entries;
    const float eye[3] = {static_cast<float>(camera.eye[0]), static_cast<float>(camera.eye[1]),
                          static_cast<float>(camera.eye[2])};
    for (const Batch& batch : mesh.triangle_batches) {
      if (!gl_materials[batch.material].blended) continue;
      for (uint32_t i = batch.first; i < batch.first + batch.count; i += 3) {
        float depth = 0;
        for (uint32_t k = 0; k < 3; ++k) {
          const float* p = &mesh.positions[3 * static_cast<size_t>(mesh.triangles[i + k])];
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
        run.append(&mesh.triangles[entries[j].first], 3);
      use_material(entries[i].material);
      // Textures with holes are mostly opaque: they write depth; glass does not.
      glDepthMask(materials[entries[i].material].opacity == 1 ? GL_TRUE : GL_FALSE);
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(run.size()), GL_UNSIGNED_INT, run.data());
      i = j;
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_ALPHA_TEST);
  }

  // What has no area to be seen, a plane from its edge or a single place, is shown by its edges and corners.
  void draw_edges() {
    GrowingArray<uint32_t> edges;
    edges.room(2 * mesh.triangles.size());
    for (size_t i = 0; i + 2 < mesh.triangles.size(); i += 3)
      for (size_t k = 0; k < 3; ++k) {
        edges.append(mesh.triangles[i + k]);
        edges.append(mesh.triangles[i + (k + 1) % 3]);
      }
    bind_vertices();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glDisable(GL_LIGHTING);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_BLEND);
    glDisableClientState(GL_COLOR_ARRAY);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glColor4f(materials[0].diffuse[0], materials[0].diffuse[1], materials[0].diffuse[2], 1);
    glLineWidth(kSegmentWidth * static_cast<float>(options.samples_per_side));
    glPointSize(kPointSize * static_cast<float>(options.samples_per_side));
    glDrawElements(GL_LINES, static_cast<GLsizei>(edges.size()), GL_UNSIGNED_INT, edges.data());
    glDrawElements(GL_POINTS, static_cast<GLsizei>(edges.size()), GL_UNSIGNED_INT, edges.data());
    glFinish();
  }

  bool anything_drawn() const {
    const size_t count = static_cast<size_t>(width) * static_cast<size_t>(height);
    const uint8_t* pixels = buffer.data();
    for (size_t i = 0; i < count; ++i)
      if (pixels[4 * i + 3]) return true;
    return false;
  }

  const Mesh& mesh;
  const std::vector<Material>& materials;
  const ModelFrame& frame;
  const Camera& camera;
  const RenderOptions& options;
  Warnings& warnings;
  int width = 0, height = 0;
  GrowingArray<uint8_t> buffer; // outlives the context, which writes to it
  std::unique_ptr<osmesa_context, DestroyContext> context;
  std::vector<GlMaterial> gl_materials;
  GLuint vertex_buffer = 0, index_buffer = 0;
  size_t offsets[4] = {0, 0, 0, 0};
};

} // namespace

RenderResult render(const Mesh& mesh, const std::vector<Material>& materials, const ModelFrame& frame,
                    const Camera& camera, const RenderOptions& options, Warnings& warnings) {
  return Renderer(mesh, materials, frame, camera, options, warnings).run();
}

} // namespace softgl::cli
