// Light that falls on a surface, and how the surface sends it on.
#include <cmath>
#include <numbers>

#include "common/trigonometry.h"
#include "figure/figure_list.h"
#include "figure/plot.h"
#include "figure/textbook.h"

namespace softgl::cli {
namespace {

// A beam of constant width meets a surface; the surface's normal is `angle` degrees from it.
void add_beam(Drawing& drawing, const Lecture& lecture, double center, double angle) {
  constexpr double kSurface = 262, kLength = 190, kWidth = 64;
  const Vec3 s = direction_at(-angle);
  const double n_dot_s = spec::clamped_dot(kNormal, s), covered = kWidth / n_dot_s;
  const Point foot{center, kSurface}, top{center + kLength * s.x, kSurface - kLength * s.y};
  const Point across{s.y * kWidth / 2, -s.x * kWidth / 2}; // at right angles to s; y downwards
  const auto at = [&](double along, double side) {
    return Point{foot.x + along * (top.x - foot.x) + side * across.x,
                 foot.y + along * (top.y - foot.y) - side * across.y};
  };
  const Point left{center - covered / 2, kSurface}, right{center + covered / 2, kSurface};
  drawing.polygon({left, right, at(1, 1), at(1, -1)}, kYellow, 0.3);
  for (const double side : {-0.6, 0.0, 0.6}) drawing.arrow(at(1, side), at(0.72, side), kOrange, 2);
  drawing.line({center, kSurface}, {center, kSurface - 215}, kGray, 1.5, true);
  drawing.words({center + 6, kSurface - 206}, "n", 15, Words::kStart, kGray);
  drawing.line({center - 110, kSurface}, {center + 110, kSurface}, kInk, 2);
  drawing.line(at(0.6, -1), at(0.6, 1), kBlue, 3);
  const Point name = at(0.6, 1);
  drawing.words({name.x + 7, name.y + 4}, "dA", 15, Words::kStart, kBlue);
  drawing.line(left, right, kRed, 5);
  const std::string degrees = lecture.number(angle, 0) + "°";
  drawing.words({center, kSurface + 28}, "dA / cos " + degrees + " = " + lecture.number(1 / n_dot_s) + " dA",
                14, Words::kMiddle, kRed);
  drawing.formula({center, kSurface + 52},
                  "E = E_0 cos " + degrees + " = " + lecture.number(n_dot_s) + " E_0", 14, Words::kMiddle);
}

} // namespace

Page cosine_figure(const Lecture& lecture) {
  Page page;
  page.drawing.height = 330;
  double center = 112;
  for (const double angle : {0.0, 30.0, 60.0}) {
    add_beam(page.drawing, lecture, center, angle);
    center += 226;
  }
  Plot plot(page.drawing, {728, 40, 250, 222}, {-120, 120, 60, "θ", 0}, {0, 1, 0.25, "E / E_0", 2},
            lecture.language());
  plot.curve(
      "cosine", 120, [](double angle) { return spec::clamped_dot(kNormal, direction_at(angle)); }, kRed);
  page.formulas = {"E = E_0 cos θ = E_0 (n·s)"};
  page.sentences = {
      lecture.say({"A beam has the cross section dA.", "Ein Lichtbündel hat den Querschnitt dA."}),
      lecture.say({"Where it meets the surface aslant, it covers dA / cos θ.",
                   "Trifft es schräg auf die Fläche, bedeckt es dA / cos θ."}),
      lecture.say({"The same light on a larger area is less light at each point.",
                   "Dasselbe Licht auf mehr Fläche ist weniger Licht an jedem Punkt."}),
      lecture.say({"So the irradiance E falls with the cosine of the angle between n and s.",
                   "Die Bestrahlungsstärke E fällt also mit dem Kosinus des Winkels zwischen n und s."}),
      lecture.say({"For unit vectors the cosine is the dot product n·s.",
                   "Für Einheitsvektoren ist der Kosinus das Skalarprodukt n·s."}),
      lecture.say({"Beyond 90° the light is behind the surface and adds nothing.",
                   "Jenseits von 90° steht das Licht hinter der Fläche und trägt nichts bei."})};
  return page;
}

Page diffuse_figure(const Lecture& lecture) {
  Page page;
  page.drawing.height = 330;
  Drawing& drawing = page.drawing;
  const auto diffuse = [](double angle) {
    return reflected_light({0, 1, 0, 1}, kNormal, direction_at(angle), kNormal);
  };
  PolarPlot falling(drawing, {235, 280}, 200, lecture.language());
  falling.lobe("diffuse", -90, 90, 180, diffuse, kBlue, 0.12);
  falling.vector(-40, diffuse(-40), "s", kOrange);
  falling.vector(0, 1.1, "n", kGray);
  drawing.formula({235, 322},
                  lecture.say({"k_d (n·s) for each direction s of the light",
                               "k_d (n·s) für jede Richtung s des Lichts"}),
                  14, Words::kMiddle);
  PolarPlot leaving(drawing, {740, 280}, 200, lecture.language());
  const Color colors[] = {kBlue, kGreen, kRed};
  for (int i = 0; i < 3; ++i) {
    const double angle = 30 * i;
    const auto sent = [&](double to) {
      return reflected_light({0, 1, 0, 1}, kNormal, direction_at(-angle), direction_at(to));
    };
    const Color& color = colors[i];
    const std::string degrees = lecture.number(angle, 0);
    leaving.lobe("diffuse-" + degrees, -89, 89, 178, sent, color);
    leaving.vector(-angle, 1.1, "s", color);
    drawing.formula({895, 60.0 + 22 * i}, degrees + "°: " + lecture.number(sent(0)), 14, Words::kStart,
                    color);
  }
  drawing.formula({740, 322},
                  lecture.say({"the same light for every viewer v", "dasselbe Licht für jeden Betrachter v"}),
                  14, Words::kMiddle);
  page.formulas = {"L_d = k_d Σ L_j (n·s_j)"};
  page.sentences = {
      lecture.say({"A matt surface sends light to all sides alike.",
                   "Eine matte Fläche streut Licht nach allen Seiten gleich."}),
      lecture.say({"So the diffuse term depends on the light's direction s, and not on the viewer.",
                   "Der diffuse Term hängt also von der Richtung s des Lichts ab und nicht vom Betrachter."}),
      lecture.say({"Drawn over s, the cosine is a circle that touches the surface.",
                   "Über s aufgetragen ist der Kosinus ein Kreis, der die Fläche berührt."}),
      lecture.say({"k_d says which part of the light is sent on.",
                   "k_d sagt, welcher Teil des Lichts weitergegeben wird."})};
  return page;
}

Page reflection_figure(const Lecture& lecture) {
  Page page;
  page.drawing.height = 350;
  Drawing& drawing = page.drawing;
  constexpr double kLight = -50, kViewer = 28;
  const Vec3 s = direction_at(kLight), v = direction_at(kViewer), r = spec::reflection_vector(s, kNormal),
             h = spec::half_vector(s, v);
  PolarPlot plot(drawing, {300, 310}, 270, lecture.language());
  const auto degrees_of = [](Vec3 a) { return std::atan2(a.x, a.y) * 180 / std::numbers::pi; };
  const double n_dot_s = spec::dot(kNormal, s);
  const Point foot = plot.place(0, n_dot_s);
  drawing.line(plot.place(kLight, 1), foot, kOrange, 1.5, true);
  drawing.line(foot, plot.place(degrees_of(r), 1), kRed, 1.5, true);
  drawing.formula({foot.x + 8, foot.y - 8}, "(n·s) n", 14, Words::kStart, kGray);
  plot.vector(0, 1, "n", kInk);
  plot.vector(kLight, 1, "s", kOrange);
  plot.vector(degrees_of(r), 1, "r", kRed);
  plot.vector(kViewer, 1, "v", kBlue);
  plot.vector(degrees_of(h), 1, "h", kGreen);
  const auto vector = [&](const char* name, Vec3 a) {
    return std::string(name) + " = (" + lecture.number(a.x) +
           (lecture.language() == Language::kGerman ? "; " : ", ") + lecture.number(a.y) + ")";
  };
  const std::pair<std::string, Color> lines[] = {
      {vector("n", kNormal), kInk},
      {vector("s", s), kOrange},
      {"n·s = cos " + lecture.number(-kLight, 0) + "° = " + lecture.number(n_dot_s), kGray},
      {vector("r = 2 (n·s) n − s", r), kRed},
      {vector("v", v), kBlue},
      {"v·r = cos " + lecture.number(degrees_of(r) - kViewer, 0) + "° = " + lecture.number(spec::dot(v, r)),
       kInk},
      {vector("h = (s + v) / |s + v|", h), kGreen},
      {"n·h = cos " + lecture.number(std::abs(degrees_of(h)), 0) +
           "° = " + lecture.number(spec::dot(kNormal, h)),
       kInk}};
  double y = 90;
  for (const auto& [text, color] : lines) {
    drawing.formula({650, y}, text, 16, Words::kStart, color);
    y += 29;
  }
  page.formulas = {"r = 2 (n·s) n − s"};
  page.sentences = {
      lecture.say({"A mirror sends the light to r.", "Ein Spiegel wirft das Licht nach r."}),
      lecture.say({"The part of s along the normal is (n·s) n.",
                   "Der Anteil von s entlang der Normalen ist (n·s) n."}),
      lecture.say({"Twice this part minus s gives r.", "Zweimal dieser Anteil minus s ergibt r."}),
      lecture.say({"The nearer the viewer v is to r, the brighter the highlight is.",
                   "Je näher der Betrachter v an r liegt, desto heller ist das Glanzlicht."}),
      lecture.say({"OpenGL takes the half vector h instead: where h is n, v is r.",
                   "OpenGL nimmt stattdessen den Halbvektor h: Wo h gleich n ist, ist v gleich r."})};
  return page;
}

Page specular_figure(const Lecture& lecture) {
  Page page;
  page.drawing.height = 350;
  Drawing& drawing = page.drawing;
  constexpr double kLight = -40;
  constexpr int kExponents[] = {1, 4, 16, 64, 128};
  const Color colors[] = {kGray, kBlue, kGreen, kOrange, kRed};
  PolarPlot polar(drawing, {240, 290}, 210, lecture.language());
  Plot plot(drawing, {590, 40, 270, 250}, {-90, 90, 30, "φ", 0}, {0, 1, 0.25, "(v·r)^a", 2},
            lecture.language());
  const Vec3 s = direction_at(kLight);
  for (size_t i = 0; i < std::size(kExponents); ++i) {
    const int a = kExponents[i];
    const auto lobe = [&](double viewer) {
      return reflected_light({0, 0, 1, double(a)}, kNormal, s, direction_at(viewer));
    };
    polar.lobe("specular-" + std::to_string(a), -90, 90, 720, lobe, colors[i]);
    // Light along the normal: the viewer's angle is the one to r.
    plot.curve(
        "power-" + std::to_string(a), 360,
        [&](double angle) {
          return reflected_light({0, 0, 1, double(a)}, kNormal, kNormal, direction_at(angle));
        },
        colors[i]);
    const double half = std::acos(std::pow(0.5, 1.0 / a)) * 180 / std::numbers::pi;
    plot.legend("a = " + std::to_string(a) + ": " + lecture.number(half, 1) + "°", colors[i]);
  }
  drawing.words({874, 180}, lecture.say({"half as bright", "halb so hell"}), 13);
  drawing.words({874, 198}, lecture.say({"at this angle", "bei diesem Winkel"}), 13);
  polar.vector(kLight, 1.1, "s", kOrange);
  polar.vector(-kLight, 1.1, "r", kInk);
  page.formulas = {"L_s = k_s Σ L_j (v·r_j)^a"};
  page.sentences = {
      lecture.say({"A glossy surface sends most of the light near r.",
                   "Eine glänzende Fläche wirft das meiste Licht in die Nähe von r."}),
      lecture.say({"φ is the angle between the viewer v and r, and v·r = cos φ.",
                   "φ ist der Winkel zwischen Betrachter v und r, und v·r = cos φ."}),
      lecture.say({"The power a makes the lobe narrow.", "Die Potenz a macht die Keule schmal."}),
      lecture.say({"The exponent has no physical unit: it is chosen by eye.",
                   "Der Exponent hat keine physikalische Einheit: Man wählt ihn nach Augenmaß."})};
  return page;
}

} // namespace softgl::cli
