#include "figure/lecture.h"

#include <algorithm>
#include <cstdlib>

#include "common/program_error.h"

namespace softgl::cli {

Lecture::Lecture(Language language, const FigureSubject& subject, const RenderOptions& options)
    : language_(language), subject_(subject), options_(options) {
  options_.lighting.shading = Shading::kPhong;
  options_.lighting.terms = kAllTerms;
}

Picture Lecture::draw(const Mesh& mesh, const std::vector<Material>& materials,
                      const RenderOptions& options) const {
  Warnings repeated; // what is said about textures was said when the subject was checked
  return MeshRenderer(mesh, materials, subject_.frame).draw(subject_.camera, options, repeated).picture;
}

void Lecture::check_subject(Warnings& warnings) const {
  MeshRenderer renderer(subject_.levels.back().mesh, subject_.materials, subject_.frame);
  if (!renderer.draw(subject_.camera, options_, warnings).visible)
    throw ProgramError(kCannotRead, subject_.name + ": nothing is visible in this view; no picture written");
}

PageEntry difference_of(const Lecture& lecture, const std::string& name, const Picture& a, const Picture& b) {
  PageEntry entry;
  entry.name = name;
  entry.picture.width = a.width;
  entry.picture.height = a.height;
  int largest = 0;
  double sum = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    const int d = std::abs(a.pixels[i] - b.pixels[i]);
    entry.picture.pixels.append(uint8_t(std::min(255, kAmplification * d)));
    largest = std::max(largest, d);
    sum += d;
  }
  const double mean = a.pixels.empty() ? 0 : sum / double(a.pixels.size());
  entry.label = lecture.say({"difference ×", "Differenz ×"}) + std::to_string(kAmplification) +
                lecture.say({", mean ", ", Mittel "}) + lecture.number(mean);
  entry.formula =
      lecture.say({"largest ", "größte "}) + std::to_string(largest) + lecture.say({" of 255", " von 255"});
  return entry;
}

} // namespace softgl::cli
