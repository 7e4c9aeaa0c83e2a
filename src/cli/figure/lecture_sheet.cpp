#include "figure/lecture_sheet.h"

#include "figure/subject_pictures.h"
#include "scene/sheet.h"

namespace softgl::cli {
namespace {

SheetRow row_of(std::string title, std::vector<PageEntry> entries) {
  SheetRow row{std::move(title), {}};
  for (PageEntry& entry : entries) {
    std::string second = plain_formula(entry.formula);
    for (const char brace : {'{', '}'}) std::erase(second, brace);
    row.entries.push_back({std::move(entry.picture), entry.label + (second.empty() ? "" : "\n" + second)});
  }
  return row;
}

} // namespace

Picture lecture_sheet(const Lecture& lecture) {
  std::vector<SheetRow> rows;
  std::vector<PageEntry> terms = term_pictures(lecture);
  std::string sum = lecture.say(
      {"Terms: light = ambient + diffuse + specular", "Terme: Licht = ambient + diffus + spekular"});
  if (terms.size() > 4) sum += lecture.say({" + emission", " + Emission"});
  rows.push_back(row_of(sum, std::move(terms)));
  rows.push_back(
      row_of(lecture.say({"Exponent a of the specular term ", "Exponent a des spekularen Terms "}) +
                 plain_formula(specular_formula(lecture)),
             exponent_pictures(lecture)));
  ShadingPictures shading = shading_pictures(lecture);
  rows.push_back(row_of(lecture.say({"Gouraud shading: lit at the vertices, colors interpolated",
                                     "Gouraud-Shading: an den Ecken beleuchtet, Farben interpoliert"}),
                        std::move(shading.gouraud)));
  rows.push_back(row_of(lecture.say({"Phong shading: normals interpolated, lit at every pixel",
                                     "Phong-Shading: Normalen interpoliert, an jedem Pixel beleuchtet"}),
                        std::move(shading.phong)));
  rows.push_back(
      row_of(lecture.say({"Gouraud against Phong", "Gouraud gegen Phong"}), std::move(shading.differences)));
  rows.push_back(row_of(lecture.say({"Reflection vector (v·r)^a against half vector (n·h)^a",
                                     "Reflexionsvektor (v·r)^a gegen Halbvektor (n·h)^a"}),
                        vector_pictures(lecture)));
  const std::string& name = lecture.subject().name;
  const std::string file =
      name.empty() ? lecture.say({"sphere", "Kugel"}) : name.substr(name.find_last_of('/') + 1);
  return compose_sheet(lecture.say({"The Phong illumination model and Phong shading: ",
                                    "Das Phongsche Beleuchtungsmodell und Phong-Shading: "}) +
                           file,
                       rows);
}

} // namespace softgl::cli
