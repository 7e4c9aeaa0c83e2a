// What goes wrong without a test, a small constant, unit vectors, or a limit.
#include <algorithm>
#include <cmath>

#include "figure/figure_list.h"
#include "figure/plot.h"
#include "figure/textbook.h"

namespace softgl::cli {
namespace {

raycast::Scene scene(const Lecture& lecture, const std::string& text) {
  raycast::Scene scene = scene_of(lecture.options().width, lecture.options().height, text);
  const uint8_t* color = lecture.options().background.color;
  scene.background = {color[0] / 255.0, color[1] / 255.0, color[2] / 255.0};
  return scene;
}

// Where a ray hits nothing, the background.
template <class Shade> Picture shaded(const raycast::Scene& scene, Shade shade) {
  std::vector<Vec3> colors;
  const raycast::Camera& camera = scene.camera;
  for (int row = camera.height - 1; row >= 0; --row)
    for (int column = 0; column < camera.width; ++column) {
      const raycast::Ray ray = camera.ray(column + 0.5, row + 0.5);
      const auto hit = scene.nearest(ray);
      colors.push_back(hit ? shade(*hit, -ray.direction) : scene.background);
    }
  return picture_of(camera.width, camera.height, colors);
}

std::string percent(const Lecture& lecture, double part) { return lecture.number(100 * part, 1) + " %"; }

// The part of the pixels that differ.
double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  size_t count = 0;
  for (size_t i = 0; i < a.size(); ++i) count += spec::length(a[i] - b[i]) > 1e-3;
  return double(count) / double(a.size());
}

std::string shadow_scene(double epsilon) {
  char start[40];
  std::snprintf(start, sizeof start, "%.3e", epsilon);
  return "camera perspective 38\nambient 0.25 0.25 0.25\n"
         "light -4 6 1 1   0.8 0.8 0.8\n"
         "material ambient 0.8 0.8 0.75  diffuse 0.7 0.7 0.65\n"
         "plane 0 -0.9 -5  0 0.9 0.35\n"
         "material ambient 0.8 0.3 0.2  diffuse 0.8 0.3 0.2  specular 0.5 0.5 0.5  exponent 30\n"
         "sphere 0 -0.05 -5  0.75\n"
         "shadows " +
         std::string(start) + "\n";
}

} // namespace

Page behind_figure(const Lecture& lecture) {
  Page page;
  const std::string text =
      "camera orthographic 1.1\nambient 0.25 0.25 0.25\n"
      "light 0.85 0.2 -0.5 0   0.9 0.9 0.9\n"
      "material ambient 0.8 0.35 0.2  diffuse 0.8 0.35 0.2  specular 0.8 0.8 0.8  exponent 4\n"
      "sphere 0 0 -5 1\n";
  const raycast::Scene tested = scene(lecture, text);
  Picture with = ray_cast_picture(tested),
          without = ray_cast_picture(scene(lecture, text + "without_test\n"));
  // A mistake that is often made: max(n·s, 0) in the diffuse term, and no test of the specular one.
  Picture half = shaded(tested, [&](const raycast::Hit& hit, Vec3 v) {
    const spec::Light& light = tested.illumination.lights.front();
    const raycast::Material& material = *hit.material;
    const Vec3 s = spec::unit(light.position.xyz());
    const double specular =
        std::pow(spec::clamped_dot(v, spec::reflection_vector(s, hit.normal)), material.phongExponent);
    return material.kAmbient * tested.illumination.model.ambient +
           light.diffuse *
               (spec::clamped_dot(hit.normal, s) * material.kDiffuse + specular * material.kSpecular);
  });
  PageEntry apart = difference_of(lecture, "difference", with, half);
  std::vector<PageEntry> entries;
  entries.push_back(
      {std::move(with), "tested", lecture.say({"with the test", "mit der Abfrage"}), "n·s > 0"});
  entries.push_back({std::move(without), "untested", lecture.say({"without a test", "ohne Abfrage"}), ""});
  entries.push_back({std::move(half), "diffuse-tested",
                     lecture.say({"for the diffuse term alone", "nur für den diffusen Term"}),
                     "max(n·s, 0)"});
  apart.formula = lecture.say({"of the first and the third", "des ersten und dritten"});
  entries.push_back(std::move(apart));
  append_pictures(page.drawing, std::move(entries), 4);
  Drawing& drawing = page.drawing;
  Plot plot(drawing, {60, drawing.height + 40, 640, 220},
            {-90, 90, 30,
             lecture.say({"angle from v to n, light at 120°", "Winkel von v zu n, Licht bei 120°"}), 0},
            {-0.4, 1, 0.2, "L", 1}, lecture.language());
  const Reflectances surface = {0.2, 0.5, 0.5, 4};
  const Vec3 v = direction_at(0), s = direction_at(120);
  for (const bool tested : {true, false})
    plot.curve(
        tested ? "tested" : "untested", 360,
        [&](double angle) { return reflected_light(surface, direction_at(angle), s, v, tested); },
        tested ? kBlue : kRed, 2.5, !tested);
  plot.legend(lecture.say({"with the test", "mit der Abfrage"}), kBlue);
  plot.legend(lecture.say({"without it", "ohne sie"}), kRed);
  drawing.height += 310;
  page.formulas = {lecture.say({"n·s_j ≤ 0:  light j adds nothing", "n·s_j ≤ 0:  Licht j trägt nichts bei"})};
  page.sentences = {
      lecture.say({"Where n·s is negative, the light is behind the surface.",
                   "Wo n·s negativ ist, steht das Licht hinter der Fläche."}),
      lecture.say({"Without a test the diffuse term is negative there and takes ambient light away.",
                   "Ohne Abfrage ist der diffuse Term dort negativ und nimmt vom ambienten Licht weg."}),
      lecture.say({"The specular term does not notice: v·r can be positive on the dark side, too.",
                   "Der spekulare Term merkt nichts: v·r kann auch auf der dunklen Seite positiv sein."}),
      lecture.say({"So one test, n·s > 0, has to guard both terms.",
                   "Also muss eine Abfrage, n·s > 0, beide Terme schützen."})};
  return page;
}

Page epsilon_figure(const Lecture& lecture) {
  Page page;
  const struct {
    double epsilon;
    const char* name;
    Wording label;
    const char* value;
  } choices[] = {{0, "zero", {"no constant", "ohne Konstante"}, "ε = 0"},
                 {1e-9, "small", {"small", "klein"}, "ε = 10^{−9}"},
                 {1.6, "large", {"too large", "zu groß"}, "ε = 1.6"}};
  std::vector<PageEntry> entries;
  for (const auto& choice : choices) {
    std::string value = choice.value;
    if (lecture.language() == Language::kGerman) std::replace(value.begin(), value.end(), '.', ',');
    entries.push_back({ray_cast_picture(scene(lecture, shadow_scene(choice.epsilon))), choice.name,
                       lecture.say(choice.label), value});
  }
  append_pictures(page.drawing, std::move(entries), 3);
  Drawing& drawing = page.drawing;
  constexpr int kSide = 48; // of the pictures that are counted
  const auto colors = [](double epsilon) {
    return ray_cast_colors(scene_of(kSide, kSide, shadow_scene(epsilon)));
  };
  const std::vector<Vec3> right = colors(raycast::kNearestDistance);
  std::vector<Point> wrong;
  for (int power = -18; power <= 1; ++power)
    wrong.push_back({double(power), 100 * difference(colors(std::pow(10.0, power)), right)});
  Plot plot(drawing, {60, drawing.height + 40, 640, 200}, {-18, 2, 2, "log_{10} ε", 0},
            {0, 40, 10, lecture.say({"wrong pixels in %", "falsche Pixel in %"}), 0}, lecture.language());
  plot.curve("wrong", wrong, kRed);
  drawing.height += 290;
  page.formulas = {lecture.say({"shadow ray:  p + t s,  t > ε", "Schattenstrahl:  p + t s,  t > ε"})};
  page.sentences = {
      lecture.say({"A ray from the point p to the light tells whether p is in shadow.",
                   "Ein Strahl vom Punkt p zum Licht sagt, ob p im Schatten liegt."}),
      lecture.say({"Rounding puts p a little before or behind its own surface.",
                   "Durch Rundung liegt p ein wenig vor oder hinter seiner eigenen Fläche."}),
      lecture.say(
          {"With ε = 0 the ray meets the surface that it starts on: the picture is full of dots.",
           "Mit ε = 0 trifft der Strahl die Fläche, auf der er beginnt: Das Bild ist voller Punkte."}),
      lecture.say({"With a large ε the ray starts behind what casts the shadow: light leaks in.",
                   "Mit großem ε beginnt der Strahl hinter dem, was Schatten wirft: Licht sickert ein."}),
      lecture.say({"Between rounding and the smallest detail any ε is right.",
                   "Zwischen der Rundung und dem kleinsten Detail ist jedes ε richtig."})};
  return page;
}

Page unit_figure(const Lecture& lecture) {
  Page page;
  const raycast::Scene shapes = scene(lecture, "camera orthographic 1.1\nsphere 0 0 -5 1\n");
  const Vec3 light{-3, 3, -1};
  const auto with_lengths = [&](double n_length, bool unit_s, double v_length) {
    return shaded(shapes, [&](const raycast::Hit& hit, Vec3 towards_viewer) {
      const Vec3 to_light = light - hit.point, s = unit_s ? spec::unit(to_light) : to_light;
      const Vec3 n = n_length * hit.normal, v = v_length * towards_viewer;
      const double diffuse = spec::clamped_dot(n, s),
                   specular = spec::highlight(spec::Highlight::ReflectionVector, n, s, v, 12);
      return (0.15 + 0.55 * diffuse) * Vec3{0.9, 0.4, 0.25} + 0.4 * specular * Vec3{1, 1, 1};
    });
  };
  const auto short_length = lecture.number(0.8, 1);
  std::vector<PageEntry> entries;
  entries.push_back({with_lengths(1, true, 1), "unit", lecture.say({"all of length 1", "alle der Länge 1"}),
                     "|n| = |s| = |v| = 1"});
  entries.push_back({with_lengths(0.8, true, 1), "normal", lecture.say({"short normal", "kurze Normale"}),
                     "|n| = " + short_length});
  entries.push_back({with_lengths(1, false, 1), "light", lecture.say({"s not divided", "s nicht geteilt"}),
                     lecture.say({"s = light − p", "s = Licht − p"})});
  entries.push_back(
      {with_lengths(1, true, 0.8), "viewer", lecture.say({"short v", "kurzes v"}), "|v| = " + short_length});
  append_pictures(page.drawing, std::move(entries), 4);
  Drawing& drawing = page.drawing;
  // Along an edge between two vertices, whose normals are 70 degrees apart.
  const Vec3 a = direction_at(-35), b = direction_at(35), s = direction_at(10);
  const auto interpolated = [&](double t) { return (1 - t) * a + t * b; };
  Plot plot(drawing, {60, drawing.height + 40, 640, 220},
            {0, 1, 0.25, lecture.say({"from one vertex to the next", "von einer Ecke zur nächsten"}), 2},
            {0, 1, 0.25, "", 2}, lecture.language());
  const auto highlight = [&](Vec3 n) { return spec::highlight(spec::Highlight::HalfVector, n, s, s, 20); };
  plot.curve(
      "length", 200, [&](double t) { return spec::length(interpolated(t)); }, kGray);
  plot.curve(
      "normalized", 200, [&](double t) { return highlight(spec::unit(interpolated(t))); }, kBlue);
  plot.curve(
      "interpolated", 200, [&](double t) { return highlight(interpolated(t)); }, kRed, 2.5, true);
  plot.legend(lecture.say({"|n|, interpolated", "|n|, interpoliert"}), kGray);
  plot.legend(lecture.say({"(n·h)^{20}, |n| = 1", "(n·h)^{20}, |n| = 1"}), kBlue);
  plot.legend(lecture.say({"(n·h)^{20}, n as it is", "(n·h)^{20}, n wie es ist"}), kRed);
  drawing.height += 320;
  page.formulas = {"n·s = |n| |s| cos θ"};
  page.sentences = {
      lecture.say({"The dot product is the cosine only for vectors of length 1.",
                   "Das Skalarprodukt ist nur für Vektoren der Länge 1 der Kosinus."}),
      lecture.say({"A short normal makes the surface dark, and its highlight even more so.",
                   "Eine kurze Normale macht die Fläche dunkel, und das Glanzlicht noch mehr."}),
      lecture.say(
          {"The difference light − p is as long as the light is far: it has to be divided by its length.",
           "Die Differenz Licht − p ist so lang, wie das Licht entfernt ist: Man muss sie durch ihre Länge "
           "teilen."}),
      lecture.say({"Interpolated normals are shorter than 1 between the vertices, so Phong shading "
                   "normalizes at each pixel.",
                   "Interpolierte Normalen sind zwischen den Ecken kürzer als 1, darum normiert "
                   "Phong-Shading an jedem Pixel."})};
  return page;
}

Page energy_figure(const Lecture& lecture) {
  Page page;
  const std::string head = "camera orthographic 1.1\nambient 1 1 1\nlight -1 1 2 0  1 1 1\n";
  const raycast::Scene fit = scene(lecture, head + "material ambient 0.1 0.08 0.05  diffuse 0.55 0.45 0.25  "
                                                   "specular 0.35 0.35 0.35  exponent 12\nsphere 0 0 -5 1\n");
  const raycast::Scene over = scene(lecture, head + "material ambient 0.2 0.16 0.1  diffuse 1 0.8 0.5  "
                                                    "specular 0.9 0.9 0.9  exponent 12\nsphere 0 0 -5 1\n");
  const int width = over.camera.width, height = over.camera.height;
  std::vector<Vec3> colors = ray_cast_colors(over), marked = colors;
  size_t beyond = 0, hits = 0;
  double largest = 0;
  for (size_t i = 0; i < colors.size(); ++i) {
    const double most = std::max({colors[i].x, colors[i].y, colors[i].z});
    hits += colors[i].x != over.background.x || colors[i].y != over.background.y;
    largest = std::max(largest, most);
    if (most <= 1) continue;
    ++beyond;
    marked[i] = {0.85, 0, 0.55};
  }
  std::vector<PageEntry> entries;
  entries.push_back(
      {ray_cast_picture(fit), "fit", lecture.say({"ka + kd + ks = 1", "ka + kd + ks = 1"}), ""});
  entries.push_back(
      {picture_of(width, height, colors), "over",
       lecture.say({"ka + kd + ks = 2.1, cut off at 1", "ka + kd + ks = 2,1, bei 1 abgeschnitten"}),
       lecture.say({"largest L = ", "größtes L = "}) + lecture.number(largest)});
  entries.push_back({picture_of(width, height, marked), "marked",
                     lecture.say({"above 1: marked", "über 1: markiert"}),
                     percent(lecture, double(beyond) / double(std::max<size_t>(1, hits))) +
                         lecture.say({" of the sphere", " der Kugel"})});
  append_pictures(page.drawing, std::move(entries), 3);
  Drawing& drawing = page.drawing;
  Plot plot(
      drawing, {60, drawing.height + 40, 640, 220},
      {-90, 90, 30,
       lecture.say({"angle from s to n, viewer at the light", "Winkel von s zu n, Betrachter beim Licht"}),
       0},
      {0, 2.5, 0.5, "L", 1}, lecture.language());
  const auto light = [](const Reflectances& surface) {
    return
        [surface](double angle) { return reflected_light(surface, direction_at(angle), kNormal, kNormal); };
  };
  const auto too_much = light({0.2, 1, 0.9, 12});
  plot.curve("fit", 360, light({0.1, 0.55, 0.35, 12}), kBlue);
  plot.curve("over", 360, too_much, kRed, 2.5, true);
  plot.curve(
      "clamped", 360, [&](double angle) { return std::min(1.0, too_much(angle)); }, kOrange);
  plot.legend("k_a + k_d + k_s = 1", kBlue);
  plot.legend("k_a + k_d + k_s = " + lecture.number(2.1, 1), kRed);
  plot.legend(lecture.say({"what the screen shows", "was der Bildschirm zeigt"}), kOrange);
  drawing.height += 310;
  page.formulas = {"k_a + k_d + k_s ≤ 1"};
  page.sentences = {
      lecture.say({"A surface cannot send on more light than it gets.",
                   "Eine Fläche kann nicht mehr Licht weitergeben, als sie bekommt."}),
      lecture.say({"Phong's equation does not know that: its terms are simply added.",
                   "Die Phongsche Gleichung weiß das nicht: Ihre Terme werden einfach addiert."}),
      lecture.say({"The screen cuts off at 1, each of red, green and blue alone.",
                   "Der Bildschirm schneidet bei 1 ab, und zwar Rot, Grün und Blau einzeln."}),
      lecture.say({"So the bright part gets flat, with a hard edge, and its hue changes.",
                   "Darum wird der helle Teil flach, bekommt einen harten Rand und ändert seinen Farbton."}),
      lecture.say({"Several lights add up, too: the sum of all of them counts.",
                   "Auch mehrere Lichter addieren sich: Es zählt die Summe aller."})};
  return page;
}

} // namespace softgl::cli
