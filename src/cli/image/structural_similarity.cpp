#include "image/structural_similarity.h"

#include <algorithm>
#include <cmath>

namespace softgl::cli {
namespace {

constexpr int kRadius = 5;
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 255 * 0.01 * 255, kC2 = 0.03 * 255 * 0.03 * 255;

using Plane = GrowingArray<double>; // a variance is the small difference of large numbers

// ITU-R BT.601, as the paper's program takes it.
Plane brightness(const PictureSamples& picture) {
  const size_t count = picture.values.size() / 4;
  Plane plane;
  double* out = plane.extend(count);
  for (size_t i = 0; i < count; ++i) {
    const float* p = &picture.values[4 * i];
    out[i] = 255 + (0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2] - 255) * p[3] / 255;
  }
  return plane;
}

class Window {
public:
  Window(int width, int height) : width_(width), height_(height) {
    for (int i = 0; i <= kRadius; ++i) weights_[i] = std::exp(-i * i / (2 * kSigma * kSigma));
  }

  // The mean of the plane's values around each pixel.
  Plane mean(const Plane& plane) const {
    Plane rows, result;
    rows.extend(plane.size());
    result.extend(plane.size());
    for (int y = 0; y < height_; ++y) along(&plane[at(0, y)], &rows[at(0, y)], width_, 1, 1);
    along(rows.data(), result.data(), height_, size_t(width_), size_t(width_));
    return result;
  }

private:
  size_t at(int x, int y) const { return size_t(y) * size_t(width_) + size_t(x); }

  // `lanes` lines side by side, whose values are `step` apart.
  void along(const double* in, double* out, int length, size_t step, size_t lanes) const {
    for (int i = 0; i < length; ++i) {
      double* to = out + size_t(i) * step;
      std::fill_n(to, lanes, 0.0);
      const int first = std::max(0, i - kRadius), last = std::min(length - 1, i + kRadius);
      double sum = 0;
      for (int j = first; j <= last; ++j) sum += weights_[std::abs(i - j)];
      for (int j = first; j <= last; ++j) {
        const double weight = weights_[std::abs(i - j)] / sum;
        const double* from = in + size_t(j) * step;
        for (size_t lane = 0; lane < lanes; ++lane) to[lane] += weight * from[lane];
      }
    }
  }

  int width_, height_;
  double weights_[kRadius + 1];
};

Plane product(const Plane& a, const Plane& b) {
  Plane result;
  double* out = result.extend(a.size());
  for (size_t i = 0; i < a.size(); ++i) out[i] = a[i] * b[i];
  return result;
}

} // namespace

GrowingArray<float> structural_similarity(const PictureSamples& a, const PictureSamples& b) {
  const Window window(a.width, a.height);
  const Plane x = brightness(a), y = brightness(b);
  const Plane mean_x = window.mean(x), mean_y = window.mean(y);
  const Plane xx = window.mean(product(x, x)), yy = window.mean(product(y, y)),
              xy = window.mean(product(x, y));
  GrowingArray<float> result;
  float* out = result.extend(x.size());
  for (size_t i = 0; i < x.size(); ++i) {
    const double mx = mean_x[i], my = mean_y[i];
    const double vx = std::max(0.0, xx[i] - mx * mx), vy = std::max(0.0, yy[i] - my * my);
    const double covariance = xy[i] - mx * my;
    out[i] =
        float((2 * mx * my + kC1) * (2 * covariance + kC2) / ((mx * mx + my * my + kC1) * (vx + vy + kC2)));
  }
  return result;
}

} // namespace softgl::cli
