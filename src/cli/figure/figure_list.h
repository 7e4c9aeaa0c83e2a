// All figures of the lecture, in the order of the argument.
#pragma once

#include <span>

#include "figure/lecture.h"

namespace softgl::cli {

struct FigureKind {
  const char* name; // on the command line and of the file
  Wording title;
  Page (*draw)(const Lecture& lecture); // all but name and title
  bool shows_subject;
};

std::span<const FigureKind> figure_kinds();
const FigureKind* find_figure(const std::string& name); // null: no such figure

Page draw_figure(const FigureKind& kind, const Lecture& lecture);

// Light that falls on a surface.
Page cosine_figure(const Lecture& lecture);
Page diffuse_figure(const Lecture& lecture);
Page reflection_figure(const Lecture& lecture);
Page specular_figure(const Lecture& lecture);
// The equation.
Page terms_figure(const Lecture& lecture);
Page exponents_figure(const Lecture& lecture);
Page vectors_figure(const Lecture& lecture);
// What goes wrong.
Page behind_figure(const Lecture& lecture);
Page epsilon_figure(const Lecture& lecture);
Page unit_figure(const Lecture& lecture);
Page energy_figure(const Lecture& lecture);
// Shading of triangles.
Page gouraud_figure(const Lecture& lecture);
Page missed_figure(const Lecture& lecture);
Page mach_figure(const Lecture& lecture);
Page truth_figure(const Lecture& lecture);

} // namespace softgl::cli
