// Triangles: where they are lit, and how far that is from the exact shape.
#include <algorithm>

#include "figure/exact_shapes.h"
#include "figure/figure_list.h"
#include "figure/figure_meshes.h"
#include "figure/plot.h"
#include "figure/subject_pictures.h"

namespace softgl::cli {
namespace {

CameraOptions front_view(const Lecture& lecture) {
  CameraOptions camera;
  camera.azimuth = camera.elevation = 0;
  camera.orthographic = true;
  camera.width = lecture.options().width;
  camera.height = lecture.options().height;
  return camera;
}

RenderOptions lit_from(const Lecture& lecture, LightOptions::Kind kind, std::array<double, 3> place,
                       Shading shading) {
  RenderOptions options = lecture.options();
  LightOptions light;
  light.kind = kind;
  std::copy(place.begin(), place.end(), light.value);
  options.lighting.lights = {light};
  options.lighting.shading = shading;
  return options;
}

Material material_of(std::array<float, 3> color, float specular, float exponent) {
  Material material;
  for (size_t i = 0; i < 3; ++i) {
    material.ambient[i] = material.diffuse[i] = color[i];
    material.specular[i] = specular;
  }
  material.shininess = exponent;
  return material;
}

RenderResult draw(const Mesh& mesh, const Material& material, const Camera& camera,
                  const RenderOptions& options) {
  const std::vector<Material> materials = {material};
  const ModelFrame frame;
  Warnings none;
  return MeshRenderer(mesh, materials, frame).draw(camera, options, none);
}

} // namespace

Page gouraud_figure(const Lecture& lecture) {
  Page page;
  ShadingPictures pictures = shading_pictures(lecture);
  append_pictures(page.drawing, std::move(pictures.gouraud), kPageColumns,
                  lecture.say({"Gouraud shading: lit at the vertices, colors interpolated",
                               "Gouraud-Shading: an den Ecken beleuchtet, Farben interpoliert"}));
  append_pictures(page.drawing, std::move(pictures.phong), kPageColumns,
                  lecture.say({"Phong shading: normals interpolated, lit at every pixel",
                               "Phong-Shading: Normalen interpoliert, an jedem Pixel beleuchtet"}));
  append_pictures(page.drawing, std::move(pictures.differences), kPageColumns,
                  lecture.say({"The difference", "Die Differenz"}));
  page.sentences = {
      lecture.say({"Gouraud shading computes the equation at the vertices and interpolates its result.",
                   "Gouraud-Shading rechnet die Gleichung an den Ecken und interpoliert das Ergebnis."}),
      lecture.say({"Phong shading interpolates the normal and computes the equation at every pixel.",
                   "Phong-Shading interpoliert die Normale und rechnet die Gleichung an jedem Pixel."}),
      lecture.say({"Small triangles make the two alike, but the outline of coarse ones shows in both.",
                   "Kleine Dreiecke machen beide gleich, aber den Umriss grober sieht man bei beiden."}),
      lecture.say(
          {"Phong's illumination model and Phong shading are two things: each goes without the other.",
           "Phongsches Beleuchtungsmodell und Phong-Shading sind zweierlei: Jedes geht ohne das andere."})};
  return page;
}

Page missed_figure(const Lecture& lecture) {
  Page page;
  const Material floor = material_of({0.25f, 0.4f, 0.6f}, 0.8f, 60);
  std::vector<PageEntry> rows[2];
  for (const int cells : {1, 2, 4, 8, 32}) {
    const Mesh mesh = square_mesh(cells);
    const Camera camera = fit_camera(mesh, front_view(lecture));
    for (const bool phong : {false, true}) {
      const RenderOptions options = lit_from(lecture, LightOptions::kModelPosition, {0.2, 0.15, 1.2},
                                             phong ? Shading::kPhong : Shading::kGouraud);
      rows[phong].push_back(
          {draw(mesh, floor, camera, options).picture,
           (phong ? "phong-" : "gouraud-") + std::to_string(cells),
           std::to_string(cells) + "×" + std::to_string(cells) + lecture.say({" squares", " Quadrate"}),
           {}});
    }
  }
  append_pictures(page.drawing, std::move(rows[0]), kPageColumns, "Gouraud");
  append_pictures(page.drawing, std::move(rows[1]), kPageColumns, "Phong");
  page.sentences = {
      lecture.say(
          {"A lamp hangs above a flat square; its highlight is in the middle of a triangle.",
           "Eine Lampe hängt über einem ebenen Quadrat; ihr Glanzlicht liegt mitten in einem Dreieck."}),
      lecture.say({"At the vertices there is no highlight, so Gouraud shading has none to interpolate.",
                   "An den Ecken ist kein Glanzlicht, also hat Gouraud-Shading keines zu interpolieren."}),
      lecture.say({"With more vertices it appears, as a star, and moves in jumps from vertex to vertex.",
                   "Mit mehr Ecken erscheint es, als Stern, und springt von Ecke zu Ecke."}),
      lecture.say({"Phong shading finds it with two triangles.",
                   "Phong-Shading findet es schon mit zwei Dreiecken."})};
  return page;
}

Page mach_figure(const Lecture& lecture) {
  Page page;
  const Material matt = material_of({0.75f, 0.75f, 0.75f}, 0, 0);
  const Mesh mesh = band_mesh(4, 60);
  const Camera camera = fit_camera(mesh, front_view(lecture));
  std::vector<PageEntry> entries;
  std::vector<Point> light[2], slope[2];
  for (const bool phong : {false, true}) {
    RenderOptions options = lit_from(lecture, LightOptions::kDirection, {-0.34, 0, 0.94},
                                     phong ? Shading::kPhong : Shading::kGouraud);
    entries.push_back({draw(mesh, matt, camera, options).picture,
                       phong ? "phong" : "gouraud",
                       phong ? "Phong" : "Gouraud",
                       {}});
    options.values = Values::kFloats; // a byte is too coarse for the slope
    const FloatPicture floats = draw(mesh, matt, camera, options).floats;
    const int row = floats.height / 2 - 1;
    const auto value = [&](int column) {
      return double(
          floats.values[size_t(floats.channels) * (size_t(row) * size_t(floats.width) + size_t(column))]);
    };
    const int first = floats.width / 16, last = floats.width - floats.width / 16;
    for (int column = first; column < last; ++column) {
      const double x = double(column) / floats.width;
      light[phong].push_back({x, value(column)});
      slope[phong].push_back({x, (value(column + 1) - value(column - 1)) / 2 * floats.width});
    }
  }
  entries.push_back(difference_of(lecture, "difference", entries[0].picture, entries[1].picture));
  append_pictures(page.drawing, std::move(entries), 3);
  Drawing& drawing = page.drawing;
  const Axis across = {0, 1, 0.25, lecture.say({"place in the middle row", "Stelle in der mittleren Zeile"}),
                       2};
  Plot above(drawing, {60, drawing.height + 40, 360, 220}, across, {0, 1, 0.25, "L", 2}, lecture.language());
  Plot below(drawing, {510, drawing.height + 40, 360, 220}, across,
             {-2, 1, 1, lecture.say({"slope of L", "Steigung von L"}), 0}, lecture.language());
  for (const bool phong : {false, true}) {
    const Color& color = phong ? kBlue : kRed;
    above.curve(phong ? "phong" : "gouraud", light[phong], color);
    below.curve(phong ? "phong-slope" : "gouraud-slope", slope[phong], color);
    below.legend(phong ? "Phong" : "Gouraud", color);
  }
  drawing.height += 310;
  page.sentences = {
      lecture.say({"Four flat strips lie side by side; their normals turn evenly from −60° to 60°.",
                   "Vier ebene Streifen liegen nebeneinander; ihre Normalen drehen sich gleichmäßig von "
                   "−60° bis 60°."}),
      lecture.say({"Interpolated colors are straight lines with a bend at each edge.",
                   "Interpolierte Farben sind Geraden mit einem Knick an jeder Kante."}),
      lecture.say({"There the slope jumps, although the color does not.",
                   "Dort springt die Steigung, obwohl die Farbe nicht springt."}),
      lecture.say({"The eye looks for edges and sees a light or dark stripe at each bend: a Mach band.",
                   "Das Auge sucht Kanten und sieht an jedem Knick einen hellen oder dunklen Streifen: einen "
                   "Machschen Streifen."}),
      lecture.say(
          {"With Phong shading the color bends smoothly.", "Mit Phong-Shading biegt sich die Farbe glatt."})};
  return page;
}

Page truth_figure(const Lecture& lecture) {
  Page page;
  const ExactShapes shapes;
  const Picture truth = shapes.ray_cast(lecture.options());
  std::vector<PageEntry> pictures, differences;
  pictures.push_back({shapes.ray_cast(lecture.options()), "ray-cast",
                      lecture.say({"one ray a pixel", "ein Strahl je Pixel"}),
                      lecture.say({"sphere, plane, box", "Kugel, Ebene, Quader"})});
  for (const int slices : {8, 16, 64}) {
    const std::string number = std::to_string(slices);
    pictures.push_back({shapes.triangles(lecture.options(), slices), "triangles-" + number,
                        lecture.say({"triangles, Phong shading", "Dreiecke, Phong-Shading"}),
                        number + lecture.say({" slices", " Streifen"})});
    differences.push_back(difference_of(lecture, "difference-" + number, truth, pictures.back().picture));
  }
  append_pictures(page.drawing, std::move(pictures), 4);
  const double indent = kPageWidth / 4; // below the pictures that they belong to
  Drawing below;
  append_pictures(below, std::move(differences), 4);
  const double height = below.height;
  page.drawing.append(std::move(below), {indent + 3.5, page.drawing.height});
  page.drawing.height += height;
  page.formulas = {"|o + t d − c|^2 = R^2,   (o + t d − p)·n = 0"};
  page.sentences = {
      lecture.say(
          {"A ray o + t d meets a sphere, a plane or a box at a point that a formula gives.",
           "Ein Strahl o + t d trifft Kugel, Ebene oder Quader in einem Punkt, den eine Formel angibt."}),
      lecture.say({"There the normal is exact, and so is the light.",
                   "Dort ist die Normale exakt und damit auch das Licht."}),
      lecture.say(
          {"Flat shapes are exact as triangles, too: plane and box differ in a pixel at an edge at most.",
           "Ebene Flächen sind auch als Dreiecke exakt: Ebene und Quader weichen höchstens in einem Pixel am "
           "Rand ab."}),
      lecture.say({"A sphere of triangles is wrong at its outline first.",
                   "Eine Kugel aus Dreiecken ist zuerst am Umriss falsch."})};
  return page;
}

} // namespace softgl::cli
