// Sine and cosine of angles in degrees, the same on every machine: C libraries differ in the last bit, and a
// camera that differs in the last bit can change pixels.
#pragma once

namespace softgl::cli {

double sine(double degrees);
double cosine(double degrees);
double tangent(double degrees);

} // namespace softgl::cli
