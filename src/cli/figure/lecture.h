// What all figures of one run have in common.
#pragma once

#include "figure/language.h"
#include "figure/page.h"
#include "figure/subject.h"

namespace softgl::cli {

class Lecture {
public:
  // The subject outlives it. `options` gives size, lights and background of the pictures.
  Lecture(Language language, const FigureSubject& subject, const RenderOptions& options);

  Language language() const { return language_; }
  const char* say(Wording wording) const { return wording.in(language_); }
  std::string number(double value, int digits = 2) const { return number_text(value, digits, language_); }

  const FigureSubject& subject() const { return subject_; }
  // Phong shading, all terms.
  const RenderOptions& options() const { return options_; }

  // By GL, with the finest or another mesh of the subject.
  Picture draw(const Mesh& mesh, const std::vector<Material>& materials, const RenderOptions& options) const;
  // Throws ProgramError if the subject cannot be seen. `warnings` gets those about textures.
  void check_subject(Warnings& warnings) const;

private:
  Language language_;
  const FigureSubject& subject_;
  RenderOptions options_;
};

inline constexpr int kAmplification = 4; // of pictures of differences

// |a - b|, amplified; the label says how large it is.
PageEntry difference_of(const Lecture& lecture, const std::string& name, const Picture& a, const Picture& b);

} // namespace softgl::cli
