#include "image/comparison.h"

#include <algorithm>
#include <cmath>

#include "image/structural_similarity.h"

namespace softgl::cli {
namespace {

uint8_t as_byte(float value) { return uint8_t(std::clamp(value, 0.0f, 255.0f) + 0.5f); }

class Comparer {
public:
  Comparer(const PictureSamples& a, const PictureSamples& b, const ComparisonRules& rules)
      : a_(a), b_(b), rules_(rules) {}

  Comparison compare() {
    result_.left = a_.width;
    result_.top = a_.height;
    result_.verdicts.reserve(size_t(a_.width) * size_t(a_.height));
    double sum = 0, squares = 0;
    for (int y = 0; y < a_.height; ++y)
      for (int x = 0; x < a_.width; ++x) {
        const Verdict verdict = judge(x, y);
        result_.verdicts.push_back(verdict);
        if (verdict == Verdict::kMasked) continue;
        ++result_.compared;
        add(x, y, sum, squares);
        if (verdict == Verdict::kEdge) ++result_.edges;
        if (verdict == Verdict::kDiffers) note_difference(x, y);
      }
    if (result_.differing == 0) result_.left = result_.top = 0;
    const double values = double(result_.compared) * double(channels());
    if (values > 0) {
      result_.mean = sum / values;
      result_.root_mean_square = std::sqrt(squares / values);
    }
    if (squares > 0) measure_similarity();
    return std::move(result_);
  }

private:
  size_t channels() const { return a_.alpha || b_.alpha ? 4 : 3; }

  static const float* at(const PictureSamples& picture, int x, int y) {
    return &picture.values[4 * (size_t(y) * size_t(picture.width) + size_t(x))];
  }

  static float difference(const float* p, const float* q, size_t channel) {
    return p[3] == 0 && q[3] == 0 ? 0 : std::fabs(p[channel] - q[channel]);
  }

  bool same(const float* p, const float* q) const {
    for (size_t channel = 0; channel < 4; ++channel)
      if (difference(p, q, channel) > rules_.tolerance[channel]) return false;
    return true;
  }

  bool is_near(const float* color, const PictureSamples& picture, int x, int y) const {
    for (int j = std::max(0, y - 1); j <= std::min(picture.height - 1, y + 1); ++j)
      for (int i = std::max(0, x - 1); i <= std::min(picture.width - 1, x + 1); ++i)
        if (same(color, at(picture, i, j))) return true;
    return false;
  }

  Verdict judge(int x, int y) const {
    if (rules_.mask) {
      const float* m = at(*rules_.mask, x, y);
      if (m[0] + m[1] + m[2] <= 1.5f * 255) return Verdict::kMasked;
    }
    const float *p = at(a_, x, y), *q = at(b_, x, y);
    if (same(p, q)) return Verdict::kSame;
    return rules_.ignore_edges && is_near(p, b_, x, y) && is_near(q, a_, x, y) ? Verdict::kEdge
                                                                               : Verdict::kDiffers;
  }

  void add(int x, int y, double& sum, double& squares) {
    const float *p = at(a_, x, y), *q = at(b_, x, y);
    for (size_t channel = 0; channel < 4; ++channel) {
      const double d = difference(p, q, channel);
      result_.largest[channel] = std::max(result_.largest[channel], d);
      sum += d;
      squares += d * d;
    }
  }

  void note_difference(int x, int y) {
    ++result_.differing;
    result_.left = std::min(result_.left, x);
    result_.right = std::max(result_.right, x);
    result_.top = std::min(result_.top, y);
    result_.bottom = y;
  }

  void measure_similarity() {
    const GrowingArray<float> similarity = structural_similarity(a_, b_);
    double sum = 0;
    for (size_t i = 0; i < similarity.size(); ++i) {
      if (result_.verdicts[i] == Verdict::kMasked) continue;
      sum += similarity[i];
      result_.least_similarity = std::min<double>(result_.least_similarity, similarity[i]);
    }
    result_.similarity = sum / double(result_.compared);
  }

  const PictureSamples &a_, &b_;
  const ComparisonRules& rules_;
  Comparison result_;
};

} // namespace

Comparison compare_pictures(const PictureSamples& a, const PictureSamples& b, const ComparisonRules& rules) {
  return Comparer(a, b, rules).compare();
}

Picture as_opaque_picture(const PictureSamples& samples) {
  Picture picture;
  picture.width = samples.width;
  picture.height = samples.height;
  const size_t count = samples.values.size() / 4;
  uint8_t* out = picture.pixels.extend(3 * count);
  for (size_t i = 0; i < count; ++i) {
    const float* p = &samples.values[4 * i];
    for (size_t c = 0; c < 3; ++c) out[3 * i + c] = as_byte(255 + (p[c] - 255) * p[3] / 255);
  }
  return picture;
}

Picture draw_differences(const PictureSamples& a, const Comparison& comparison) {
  Picture picture = as_opaque_picture(a);
  for (size_t i = 0; i < comparison.verdicts.size(); ++i) {
    uint8_t* p = &picture.pixels[3 * i];
    const float gray = 0.299f * float(p[0]) + 0.587f * float(p[1]) + 0.114f * float(p[2]);
    p[0] = p[1] = p[2] = as_byte(192 + gray / 4);
    switch (comparison.verdicts[i]) {
    case Verdict::kSame: break;
    case Verdict::kDiffers: p[0] = 224, p[1] = p[2] = 0; break;
    case Verdict::kEdge: p[0] = p[1] = 224, p[2] = 0; break;
    case Verdict::kMasked: p[0] = p[1] = p[2] = as_byte(96 + gray / 4); break;
    }
  }
  return picture;
}

} // namespace softgl::cli
