// The direction in which the colors of a block vary most: where encoders of blocks begin to look for ends.
#pragma once

#include <algorithm>

namespace softgl {

/// The texels that lie farthest apart along that direction, of those of `count` that count; zeros if none
/// does. N components each.
template <int N>
void ends_of_axis(const int (*texel)[N], const bool* counts, int count, double (&low)[N], double (&high)[N]) {
  double mean[N] = {}, axis[N] = {}, matrix[N][N] = {};
  int n = 0;
  for (int i = 0; i < count; ++i) {
    if (!counts[i]) continue;
    ++n;
    for (int k = 0; k < N; ++k) mean[k] += texel[i][k];
  }
  std::fill_n(low, N, 0.0), std::fill_n(high, N, 0.0);
  if (n == 0) return;
  for (double& m : mean) m /= n;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < N && counts[i]; ++j)
      for (int k = 0; k < N; ++k) matrix[j][k] += (texel[i][j] - mean[j]) * (texel[i][k] - mean[k]);
  // The row of the greatest variance is not perpendicular to the axis that is looked for.
  int start = 0;
  for (int k = 1; k < N; ++k)
    if (matrix[k][k] > matrix[start][start]) start = k;
  std::copy_n(matrix[start], N, axis);
  for (int round = 0; round < 8; ++round) {
    double next[N] = {}, largest = 0;
    for (int j = 0; j < N; ++j) {
      for (int k = 0; k < N; ++k) next[j] += matrix[j][k] * axis[k];
      largest = std::max(largest, next[j] < 0 ? -next[j] : next[j]);
    }
    if (largest == 0) break;
    for (int j = 0; j < N; ++j) axis[j] = next[j] / largest;
  }
  double least = 0, greatest = 0;
  bool any = false;
  for (int i = 0; i < count; ++i) {
    if (!counts[i]) continue;
    double d = 0;
    for (int k = 0; k < N; ++k) d += axis[k] * texel[i][k];
    if (!any || d < least) least = d, std::copy_n(texel[i], N, low);
    if (!any || d > greatest) greatest = d, std::copy_n(texel[i], N, high);
    any = true;
  }
}

} // namespace softgl
