#include "command/figure.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "common/program_error.h"
#include "mesh/tessellation.h"
#include "scene/sheet.h"

namespace softgl::cli {
namespace {

constexpr int kLevels = 5;
constexpr size_t kMostTriangles = 2000000; // of the finest tessellation of a model: about 0.3 s a picture
constexpr int kAmplification = 4;          // of difference pictures

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

// |a - b|, amplified.
SheetEntry difference(const Picture& a, const Picture& b) {
  SheetEntry entry;
  entry.picture.width = a.width;
  entry.picture.height = a.height;
  entry.picture.channels = 3;
  int largest = 0;
  double sum = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    const int d = std::abs(a.pixels[i] - b.pixels[i]);
    entry.picture.pixels.append(uint8_t(std::min(255, kAmplification * d)));
    largest = std::max(largest, d);
    sum += d;
  }
  entry.label = "difference x" + std::to_string(kAmplification) + "\nlargest " + std::to_string(largest) +
                " of 255, " + format("mean %.2f", a.pixels.empty() ? 0 : sum / double(a.pixels.size()));
  return entry;
}

class FigureDrawer {
public:
  FigureDrawer(const FigureSubject& subject, const RenderOptions& options, Warnings& warnings)
      : subject_(subject), options_(options), warnings_(warnings), finest_(subject.levels.back().mesh),
        materials_(subject.materials) {
    this->options_.lighting.shading = Shading::kPhong;
    this->options_.lighting.terms = kAllTerms;
  }

  std::vector<SheetRow> rows() {
    std::vector<SheetRow> all;
    all.push_back(terms());
    all.push_back(exponents());
    shading(all);
    all.push_back(vectors());
    return all;
  }

private:
  Picture draw(const Mesh& mesh) {
    Warnings repeated; // what is said about textures was said with the first picture
    MeshRenderer renderer(mesh, materials_, subject_.frame);
    RenderResult result = renderer.draw(subject_.camera, options_, first_ ? warnings_ : repeated);
    if (first_ && !result.visible)
      throw ProgramError(kCannotRead,
                         subject_.name + ": nothing is visible in this view; no picture written");
    first_ = false;
    return std::move(result.picture);
  }

  const char* specular_formula() const {
    return options_.lighting.reflection_vector ? "ks (v.r)^n" : "ks (n.h)^n";
  }

  // The exponent of the part in which a figure speaks of one.
  float exponent() const {
    float largest = 0;
    for (const Material& material : materials_) largest = std::max(largest, material.shininess);
    return largest;
  }

  void set_exponent(float value) {
    for (Material& material : materials_) material.shininess = value;
  }

  SheetRow terms() {
    SheetRow row{"Terms: light = ambient + diffuse + specular", {}};
    const bool emits = std::any_of(materials_.begin(), materials_.end(), [](const Material& material) {
      return material.emission[0] > 0 || material.emission[1] > 0 || material.emission[2] > 0;
    });
    const struct {
      unsigned term;
      std::string label;
    } parts[] = {{kAmbient, "ambient\nka LA"},
                 {kDiffuse, "diffuse\nkd (n.s)"},
                 {kSpecular, std::string("specular\n") + specular_formula()},
                 {kEmission, "emission"},
                 {kAllTerms, "the sum"}};
    for (const auto& part : parts) {
      if (part.term == kEmission && !emits) continue;
      options_.lighting.terms = part.term;
      row.entries.push_back({draw(finest_), part.label});
    }
    if (emits) row.title += " + emission";
    return row;
  }

  SheetRow exponents() {
    SheetRow row{std::string("Exponent n of the specular term ") + specular_formula(), {}};
    const std::vector<Material> kept = materials_;
    for (const float value : {1.0f, 4.0f, 16.0f, 64.0f, 128.0f}) {
      set_exponent(value);
      row.entries.push_back({draw(finest_), format("n = %g", value)});
    }
    materials_ = kept;
    return row;
  }

  void shading(std::vector<SheetRow>& all) {
    SheetRow gouraud{"Gouraud shading: lit at the vertices, colors interpolated", {}};
    SheetRow phong{"Phong shading: normals interpolated, lit at every pixel", {}};
    SheetRow differences{"Gouraud against Phong", {}};
    for (const auto& [mesh, name] : subject_.levels) {
      const std::string label = name + "\n" + std::to_string(mesh.triangles.size() / 3) + " triangles";
      options_.lighting.shading = Shading::kGouraud;
      gouraud.entries.push_back({draw(mesh), label});
      options_.lighting.shading = Shading::kPhong;
      phong.entries.push_back({draw(mesh), label});
      differences.entries.push_back(difference(gouraud.entries.back().picture, phong.entries.back().picture));
    }
    for (SheetRow* row : {&gouraud, &phong, &differences}) all.push_back(std::move(*row));
  }

  SheetRow vectors() {
    SheetRow row{"Reflection vector (v.r)^n against half vector (n.h)^n", {}};
    const std::vector<Material> kept = materials_;
    const bool kept_vector = options_.lighting.reflection_vector;
    const float n = std::clamp(exponent(), 1.0f, 32.0f); // GL's exponents end at 128 = 4 * 32
    set_exponent(n);
    options_.lighting.reflection_vector = true;
    Picture reflection = draw(finest_);
    options_.lighting.reflection_vector = false;
    Picture half = draw(finest_);
    // The angle between n and h is about half of that between v and r, so four times the exponent gives about
    // the same.
    set_exponent(4 * n);
    Picture sharper = draw(finest_);
    SheetEntry far = difference(reflection, half), near = difference(reflection, sharper);
    row.entries.push_back({std::move(reflection), "reflection vector\n" + format("(v.r)^%g", n)});
    row.entries.push_back({std::move(half), "half vector\n" + format("(n.h)^%g", n)});
    row.entries.push_back(std::move(far));
    row.entries.push_back({std::move(sharper), "half vector, four times n\n" + format("(n.h)^%g", 4 * n)});
    row.entries.push_back(std::move(near));
    materials_ = kept;
    options_.lighting.reflection_vector = kept_vector;
    return row;
  }

  const FigureSubject& subject_;
  RenderOptions options_;
  Warnings& warnings_;
  const Mesh& finest_;
  std::vector<Material> materials_;
  bool first_ = true;
};

} // namespace

FigureSubject sphere_subject(const CameraOptions& camera) {
  FigureSubject subject;
  subject.name = "sphere";
  Material clay;
  clay.name = "clay";
  const float ambient[3] = {0.35f, 0.14f, 0.1f}, diffuse[3] = {0.7f, 0.28f, 0.2f};
  for (size_t i = 0; i < 3; ++i) {
    clay.ambient[i] = ambient[i];
    clay.diffuse[i] = diffuse[i];
    clay.specular[i] = 0.6f;
  }
  clay.shininess = 20;
  subject.materials.push_back(clay);
  for (int slices = 8, level = 0; level < kLevels; slices *= 2, ++level)
    subject.levels.push_back({sphere_mesh(slices), std::to_string(slices) + " slices"});
  subject.camera = fit_camera(subject.levels.back().mesh, camera);
  return subject;
}

FigureSubject model_subject(std::string name, Mesh mesh, std::vector<Material> materials, ModelFrame frame,
                            const Camera& camera) {
  if (mesh.triangles.empty())
    throw ProgramError(kCannotRead, name + ": no faces; a figure about light needs some");
  FigureSubject subject;
  subject.name = std::move(name);
  subject.materials = std::move(materials);
  subject.frame = std::move(frame);
  subject.camera = camera;
  const auto dull = [](const Material& material) {
    return *std::max_element(material.specular, material.specular + 3) == 0;
  };
  if (std::all_of(subject.materials.begin(), subject.materials.end(), dull))
    for (Material& material : subject.materials) { // nothing would shine on the whole sheet
      std::fill(material.specular, material.specular + 3, 0.5f);
      material.shininess = 20;
    }
  subject.levels.push_back({std::move(mesh), "the model's triangles"});
  for (int level = 1; level < kLevels; ++level) {
    const Mesh& coarse = subject.levels.back().mesh;
    if (coarse.triangles.size() / 3 * 4 > kMostTriangles) break;
    subject.levels.push_back({subdivide(coarse), "each cut into " + std::to_string(1 << (2 * level))});
  }
  return subject;
}

Picture draw_figure(const FigureSubject& subject, const RenderOptions& options, Warnings& warnings) {
  const std::string file = subject.name.substr(subject.name.find_last_of('/') + 1);
  return compose_sheet("The Phong illumination model and Phong shading: " + file,
                       FigureDrawer(subject, options, warnings).rows());
}

} // namespace softgl::cli
