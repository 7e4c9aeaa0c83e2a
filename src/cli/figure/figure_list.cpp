#include "figure/figure_list.h"

namespace softgl::cli {
namespace {

constexpr FigureKind kKinds[] = {
    {"cosine", {"Irradiance and the cosine", "Bestrahlungsstärke und Kosinus"}, cosine_figure, false},
    {"diffuse", {"Diffuse reflection", "Diffuse Reflexion"}, diffuse_figure, false},
    {"reflection", {"The reflection vector", "Der Reflexionsvektor"}, reflection_figure, false},
    {"specular", {"The specular lobe", "Die spekulare Keule"}, specular_figure, false},
    {"terms", {"Three terms and their sum", "Drei Terme und ihre Summe"}, terms_figure, true},
    {"exponents", {"The exponent", "Der Exponent"}, exponents_figure, true},
    {"vectors",
     {"Reflection vector and half vector", "Reflexionsvektor und Halbvektor"},
     vectors_figure,
     true},
    {"behind", {"Light behind the surface", "Licht hinter der Fläche"}, behind_figure, false},
    {"epsilon", {"Where a shadow ray starts", "Wo ein Schattenstrahl beginnt"}, epsilon_figure, false},
    {"unit",
     {"Vectors that are not of unit length", "Vektoren, die nicht die Länge 1 haben"},
     unit_figure,
     false},
    {"energy", {"More light than there is", "Mehr Licht als da ist"}, energy_figure, false},
    {"gouraud",
     {"Gouraud shading and Phong shading", "Gouraud-Shading und Phong-Shading"},
     gouraud_figure,
     true},
    {"missed",
     {"The highlight that Gouraud shading misses", "Das Glanzlicht, das Gouraud-Shading verpasst"},
     missed_figure,
     false},
    {"mach", {"Mach bands", "Machsche Streifen"}, mach_figure, false},
    {"truth", {"Ray-cast shapes as the truth", "Strahlverfolgte Körper als Wahrheit"}, truth_figure, false},
};

} // namespace

std::span<const FigureKind> figure_kinds() { return kKinds; }

const FigureKind* find_figure(const std::string& name) {
  for (const FigureKind& kind : kKinds)
    if (name == kind.name) return &kind;
  return nullptr;
}

Page draw_figure(const FigureKind& kind, const Lecture& lecture) {
  Page page = kind.draw(lecture);
  page.name = kind.name;
  page.title = lecture.say(kind.title);
  return page;
}

} // namespace softgl::cli
