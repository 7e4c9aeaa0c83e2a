// Pictures of the subject that are on the sheet and on the pages.
#pragma once

#include "figure/lecture.h"

namespace softgl::cli {

// Each term of the light alone, and their sum as the last one.
std::vector<PageEntry> term_pictures(const Lecture& lecture);
// Exponents 1, 4, 16, 64 and 128.
std::vector<PageEntry> exponent_pictures(const Lecture& lecture);
// Reflection vector, half vector, their difference, half vector with four times the exponent, and the
// difference.
std::vector<PageEntry> vector_pictures(const Lecture& lecture);

struct ShadingPictures {
  std::vector<PageEntry> gouraud, phong, differences; // for each level of the subject
};
ShadingPictures shading_pictures(const Lecture& lecture);

// The specular term's formula with the vector that the options choose.
std::string specular_formula(const Lecture& lecture);

} // namespace softgl::cli
