#include "common/trigonometry.h"

#include <cmath>

namespace softgl::cli {
namespace {

constexpr double kRadians = 3.14159265358979323846 / 180;

// Taylor series for |x| <= pi/4, where the last term is below 1e-17.
double sine_series(double x) {
  const double s = x * x;
  double sum = 1;
  for (int n = 16; n >= 2; n -= 2) sum = 1 - s / (n * (n + 1)) * sum;
  return x * sum;
}

double cosine_series(double x) {
  const double s = x * x;
  double sum = 1;
  for (int n = 17; n >= 1; n -= 2) sum = 1 - s / (n * (n + 1)) * sum;
  return sum;
}

} // namespace

double sine(double degrees) {
  double angle = std::remainder(degrees, 360.0); // exact
  const double quarter = std::nearbyint(angle / 90);
  angle = (angle - 90 * quarter) * kRadians; // exact difference
  switch (int(quarter) & 3) {
  case 0: return sine_series(angle);
  case 1: return cosine_series(angle);
  case 2: return -sine_series(angle);
  default: return -cosine_series(angle);
  }
}

double cosine(double degrees) { return sine(std::remainder(degrees, 360.0) + 90); }

double tangent(double degrees) { return sine(degrees) / cosine(degrees); }

} // namespace softgl::cli
