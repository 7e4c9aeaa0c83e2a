// The pictures of the subject on one sheet.
#pragma once

#include "figure/lecture.h"

namespace softgl::cli {

// Rows: the terms and their sum; exponents; Gouraud shading, Phong shading and their difference over
// tessellation; both vectors of the specular term.
Picture lecture_sheet(const Lecture& lecture);

} // namespace softgl::cli
