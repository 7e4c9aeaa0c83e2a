// The equation: its terms, its exponent, its two vectors.
#include "figure/figure_list.h"
#include "figure/plot.h"
#include "figure/subject_pictures.h"
#include "figure/textbook.h"

namespace softgl::cli {
namespace {

constexpr const char* kEquation = "L = k_a L_A + k_d Σ L_j (n·s_j) + k_s Σ L_j (v·r_j)^a";

} // namespace

Page terms_figure(const Lecture& lecture) {
  Page page;
  append_pictures(page.drawing, term_pictures(lecture), kPageColumns);
  Drawing& drawing = page.drawing;
  constexpr double kLight = -40, kUnit = 220;
  const double ground = drawing.height + 260;
  const Reflectances all = {0.2, 0.4, 0.4, 20};
  PolarPlot plot(drawing, {300, ground}, kUnit, lecture.language());
  const auto lobe = [&](const Reflectances& part) {
    return [part](double viewer) {
      return reflected_light(part, kNormal, direction_at(kLight), direction_at(viewer));
    };
  };
  plot.lobe("sum", -90, 90, 720, lobe(all), kRed, 0.1);
  plot.lobe("ambient-diffuse", -90, 90, 180, lobe({all.ambient, all.diffuse, 0, 1}), kBlue, 0.15);
  plot.lobe("ambient", -90, 90, 180, lobe({all.ambient, 0, 0, 1}), kGreen, 0.25);
  plot.vector(kLight, 1.05, "s", kOrange);
  plot.vector(-kLight, 1.05, "r", kInk);
  const double mirrored = -kLight;
  const auto value = [&](const Reflectances& part) { return lecture.number(lobe(part)(mirrored)); };
  const std::pair<std::string, Color> lines[] = {
      {lecture.say({"seen from r:", "von r aus gesehen:"}), kInk},
      {"k_a L_A = " + value({all.ambient, 0, 0, 1}), kGreen},
      {"k_d L_j (n·s_j) = " + value({0, all.diffuse, 0, 1}), kBlue},
      {"k_s L_j (v·r_j)^a = " + value({0, 0, all.specular, all.exponent}), kRed},
      {"L = " + value(all), kInk}};
  double y = ground - 170;
  for (const auto& [text, color] : lines) {
    drawing.formula({600, y}, text, 16, Words::kStart, color);
    y += 30;
  }
  drawing.height = ground + 24;
  page.formulas = {kEquation};
  page.sentences = {
      lecture.say({"The ambient term is a constant for the light that comes from everywhere.",
                   "Der ambiente Term ist eine Konstante für das Licht, das von überall kommt."}),
      lecture.say({"The diffuse term depends on n and s.", "Der diffuse Term hängt von n und s ab."}),
      lecture.say({"The specular term depends on v, too.", "Der spekulare Term hängt auch von v ab."}),
      lecture.say({"The sum runs over all lights j that are in front of the surface.",
                   "Die Summe läuft über alle Lichter j, die vor der Fläche stehen."})};
  return page;
}

Page exponents_figure(const Lecture& lecture) {
  Page page;
  append_pictures(page.drawing, exponent_pictures(lecture), kPageColumns);
  page.formulas = {"L_s = " + specular_formula(lecture)};
  page.sentences = {
      lecture.say({"The higher the exponent a, the smaller the highlight.",
                   "Je höher der Exponent a, desto kleiner das Glanzlicht."}),
      lecture.say(
          {"In its middle the highlight keeps its brightness, so a higher exponent gives less light in all.",
           "In der Mitte bleibt das Glanzlicht gleich hell, insgesamt ist es bei höherem Exponenten also "
           "weniger Licht."})};
  return page;
}

Page vectors_figure(const Lecture& lecture) {
  Page page;
  append_pictures(page.drawing, vector_pictures(lecture), kPageColumns);
  Drawing& drawing = page.drawing;
  constexpr double kExponent = 16, kLight = -30;
  const Vec3 s = direction_at(kLight);
  Plot plot(drawing, {60, drawing.height + 50, 640, 230},
            {-60, 90, 30, lecture.say({"angle from n to v", "Winkel von n zu v"}), 0},
            {0, 1, 0.25, lecture.say({"highlight", "Glanzlicht"}), 2}, lecture.language());
  const auto add = [&](const char* name, spec::Highlight kind, double exponent, const char* legend,
                       const Color& color, bool dashed) {
    plot.curve(
        name, 300,
        [&](double viewer) { return spec::highlight(kind, kNormal, s, direction_at(viewer), exponent); },
        color, 2.5, dashed);
    plot.legend(legend, color);
  };
  add("reflection", spec::Highlight::ReflectionVector, kExponent, "(v·r)^{16}", kRed, false);
  add("half", spec::Highlight::HalfVector, kExponent, "(n·h)^{16}", kGreen, false);
  add("half-sharper", spec::Highlight::HalfVector, 4 * kExponent, "(n·h)^{64}", kBlue, true);
  drawing.formula({714, drawing.height + 160},
                  lecture.say({"light at −30°, r at 30°", "Licht bei −30°, r bei 30°"}), 13);
  drawing.height += 330;
  page.formulas = {"r = 2 (n·s) n − s,   h = (s + v) / |s + v|", "(v·r)^a ≈ (n·h)^{4a}"};
  page.sentences = {
      lecture.say({"Phong takes the angle between v and r.", "Phong nimmt den Winkel zwischen v und r."}),
      lecture.say({"Blinn, and OpenGL after him, take the angle between n and h.",
                   "Blinn und nach ihm OpenGL nehmen den Winkel zwischen n und h."}),
      lecture.say({"In one plane with n, the second angle is half of the first one.",
                   "In einer Ebene mit n ist der zweite Winkel halb so groß wie der erste."}),
      lecture.say(
          {"So the same exponent gives a wider highlight, and four times the exponent nearly the same one.",
           "Derselbe Exponent gibt also ein breiteres Glanzlicht, der vierfache beinahe dasselbe."})};
  return page;
}

} // namespace softgl::cli
