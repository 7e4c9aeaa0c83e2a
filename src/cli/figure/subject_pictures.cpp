#include "figure/subject_pictures.h"

#include <algorithm>

namespace softgl::cli {
namespace {

const Mesh& finest(const Lecture& lecture) { return lecture.subject().levels.back().mesh; }

std::vector<Material> with_exponent(const Lecture& lecture, float value) {
  std::vector<Material> materials = lecture.subject().materials;
  for (Material& material : materials) material.shininess = value;
  return materials;
}

std::string level_name(const Lecture& lecture, const FigureSubject::Level& level) {
  if (lecture.subject().name.empty())
    return std::to_string(level.slices) + lecture.say({" slices", " Streifen"});
  if (level.slices == 1) return lecture.say({"the model's triangles", "Dreiecke des Modells"});
  return lecture.say({"each cut into ", "jedes in "}) + std::to_string(level.slices) +
         lecture.say({"", " geteilt"});
}

} // namespace

std::string specular_formula(const Lecture& lecture) {
  return lecture.options().lighting.reflection_vector ? "k_s L_j (v·r_j)^a" : "k_s L_j (n·h_j)^a";
}

std::vector<PageEntry> term_pictures(const Lecture& lecture) {
  std::vector<PageEntry> entries;
  const std::vector<Material>& materials = lecture.subject().materials;
  const bool emits = std::any_of(materials.begin(), materials.end(), [](const Material& material) {
    return material.emission[0] > 0 || material.emission[1] > 0 || material.emission[2] > 0;
  });
  const struct {
    unsigned term;
    const char* name;
    Wording label;
    std::string formula;
  } parts[] = {{kAmbient, "ambient", {"ambient", "ambient"}, "k_a L_A"},
               {kDiffuse, "diffuse", {"diffuse", "diffus"}, "k_d L_j (n·s_j)"},
               {kSpecular, "specular", {"specular", "spekular"}, specular_formula(lecture)},
               {kEmission, "emission", {"emission", "Emission"}, ""},
               {kAllTerms, "sum", {"the sum", "die Summe"}, "L"}};
  RenderOptions options = lecture.options();
  for (const auto& part : parts) {
    if (part.term == kEmission && !emits) continue;
    options.lighting.terms = part.term;
    entries.push_back({lecture.draw(finest(lecture), materials, options), part.name, lecture.say(part.label),
                       part.formula});
  }
  return entries;
}

std::vector<PageEntry> exponent_pictures(const Lecture& lecture) {
  std::vector<PageEntry> entries;
  for (const int value : {1, 4, 16, 64, 128})
    entries.push_back({lecture.draw(finest(lecture), with_exponent(lecture, float(value)), lecture.options()),
                       "exponent-" + std::to_string(value),
                       "a = " + std::to_string(value),
                       {}});
  return entries;
}

std::vector<PageEntry> vector_pictures(const Lecture& lecture) {
  float exponent = 1; // of the part in which the figure speaks of one
  for (const Material& material : lecture.subject().materials)
    exponent = std::max(exponent, material.shininess);
  const int a = int(std::min(exponent, 32.0f)); // GL's exponents end at 128 = 4 * 32
  RenderOptions options = lecture.options();
  options.lighting.reflection_vector = true;
  Picture reflection = lecture.draw(finest(lecture), with_exponent(lecture, float(a)), options);
  options.lighting.reflection_vector = false;
  Picture half = lecture.draw(finest(lecture), with_exponent(lecture, float(a)), options);
  // The angle between n and h is about half of that between v and r, so four times the exponent gives about
  // the same.
  Picture sharper = lecture.draw(finest(lecture), with_exponent(lecture, float(4 * a)), options);
  const auto power = [](const char* product, int value) {
    return std::string(product) + "^{" + std::to_string(value) + "}";
  };
  PageEntry far = difference_of(lecture, "difference", reflection, half),
            near = difference_of(lecture, "difference-sharper", reflection, sharper);
  std::vector<PageEntry> entries;
  entries.push_back({std::move(reflection), "reflection",
                     lecture.say({"reflection vector", "Reflexionsvektor"}), power("(v·r)", a)});
  entries.push_back({std::move(half), "half", lecture.say({"half vector", "Halbvektor"}), power("(n·h)", a)});
  entries.push_back(std::move(far));
  entries.push_back({std::move(sharper), "half-sharper",
                     lecture.say({"half vector, four times a", "Halbvektor, vierfaches a"}),
                     power("(n·h)", 4 * a)});
  entries.push_back(std::move(near));
  return entries;
}

ShadingPictures shading_pictures(const Lecture& lecture) {
  ShadingPictures pictures;
  RenderOptions options = lecture.options();
  for (const FigureSubject::Level& level : lecture.subject().levels) {
    const std::string number = std::to_string(level.slices), label = level_name(lecture, level),
                      triangles = std::to_string(level.mesh.triangles.size() / 3) +
                                  lecture.say({" triangles", " Dreiecke"});
    const std::vector<Material>& materials = lecture.subject().materials;
    options.lighting.shading = Shading::kGouraud;
    pictures.gouraud.push_back(
        {lecture.draw(level.mesh, materials, options), "gouraud-" + number, label, triangles});
    options.lighting.shading = Shading::kPhong;
    pictures.phong.push_back(
        {lecture.draw(level.mesh, materials, options), "phong-" + number, label, triangles});
    pictures.differences.push_back(difference_of(
        lecture, "difference-" + number, pictures.gouraud.back().picture, pictures.phong.back().picture));
  }
  return pictures;
}

} // namespace softgl::cli
