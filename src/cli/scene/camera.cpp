#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/trigonometry.h"
#include "scene/camera_axes.h"

namespace softgl::cli {
namespace {

struct Extremes {
  double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
};

struct Placement {
  double x, y, distance;
};

// The bounds between which the camera may move sideways without cutting the model.
struct Interval {
  double low, high;
};

struct Fit {
  Placement place;
  Interval x, y;
};

// Center and distance from which the view pyramid of slopes tx, ty just holds all points: two opposite sides
// of the pyramid touch a point each, so the answer is exact and needs no search.
Fit place_perspective(const CameraPoints& points, const Axes& axes, double tx, double ty) {
  double sides[4] = {-1e300, -1e300, -1e300, -1e300};
  double &right = sides[0], &left = sides[1], &top = sides[2], &bottom = sides[3];
  for_each_position(points, [&](const float* p) {
    const double x = along(axes.right, p), y = along(axes.up, p), z = along(axes.back, p);
    right = std::max(right, x + z * tx);
    left = std::max(left, -x + z * tx);
    top = std::max(top, y + z * ty);
    bottom = std::max(bottom, -y + z * ty);
  });
  find_largest(points, sides);
  const double distance = std::max((right + left) / (2 * tx), (top + bottom) / (2 * ty));
  return {{(right - left) / 2, (top - bottom) / 2, distance},
          {right - distance * tx, distance * tx - left},
          {top - distance * ty, distance * ty - bottom}};
}

// How far something is seen from the middle, and one by its distance there.
struct Outermost {
  double seen = -1e300, inverse = 1;

  // Of two at one place the nearer one counts, so that their order does not matter.
  void add(double other, double other_inverse) {
    if (other > seen || (other == seen && other_inverse > inverse)) seen = other, inverse = other_inverse;
  }
};

// On both sides of the middle, of all processes.
void find_outermost(const CameraPoints& points, Outermost& first, Outermost& second) {
  double seen[2] = {first.seen, second.seen};
  find_largest(points, seen);
  double inverse[2] = {first.seen == seen[0] ? first.inverse : 0,
                       second.seen == seen[1] ? second.inverse : 0};
  find_largest(points, inverse);
  first = {seen[0], inverse[0]};
  second = {seen[1], inverse[1]};
}

// The axis that does not fill the picture is centered as seen: both outermost points at the same distance
// from the middle. Their two lines cross where the next guess lies; bisection where that leaves the interval.
double centered(const CameraPoints& points, const double* axis, const double* back, double distance,
                double slope, double start, Interval bounds) {
  double place = start;
  for (int step = 0; step < 16 && bounds.high - bounds.low > 0.001 * slope * distance; ++step) {
    Outermost below, above;
    for_each_position(points, [&](const float* p) {
      const double inverse = 1 / (distance - along(back, p));
      const double seen = (along(axis, p) - place) * inverse;
      below.add(-seen, inverse);
      above.add(seen, inverse);
    });
    find_outermost(points, below, above);
    const double sum = above.seen - below.seen;
    if (std::fabs(sum) < 0.004 * slope) break;
    (sum > 0 ? bounds.low : bounds.high) = place;
    place += sum / (below.inverse + above.inverse);
    if (!(place > bounds.low && place < bounds.high)) place = (bounds.low + bounds.high) / 2;
  }
  return place;
}

bool is_single_place(const Extremes& box) {
  return box.high[0] - box.low[0] + box.high[1] - box.low[1] + box.high[2] - box.low[2] < 1e-9;
}

Camera fit_orthographic(const Axes& axes, const Extremes& box, const CameraOptions& options) {
  Camera camera{};
  const double aspect = aspect_of(options);
  double half_height =
      std::max((box.high[1] - box.low[1]) / 2, (box.high[0] - box.low[0]) / 2 / aspect) / kFill;
  if (!(half_height > 1e-9)) half_height = is_single_place(box) ? 1 : (box.high[2] - box.low[2]) / 2;
  half_height /= options.zoom;
  const double depth = std::max(box.high[2] - box.low[2], half_height * 1e-3) * 1.01;
  set_view(camera, axes, (box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2,
           (box.low[2] + box.high[2]) / 2 + depth);
  set_orthographic(camera, half_height, aspect, depth / 4, depth * 7 / 4);
  return camera;
}

Camera fit_perspective(const CameraPoints& points, const Axes& axes, const Extremes& box,
                       const CameraOptions& options) {
  Camera camera{};
  const double ty = tangent(options.field_of_view / 2), tx = ty * aspect_of(options);
  const Fit fit = place_perspective(points, axes, tx * kFill, ty * kFill);
  Placement place = fit.place;
  if (is_single_place(box)) {
    place = {(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2, box.high[2] + 1 / ty};
  } else if (!(place.distance - box.high[2] > 1e-6)) { // seen exactly along a line
    place.distance = box.high[2] + (box.high[2] - box.low[2]) / ty + 1e-3;
  } else {
    place.x = centered(points, axes.right, axes.back, place.distance, tx, place.x, fit.x);
    place.y = centered(points, axes.up, axes.back, place.distance, ty, place.y, fit.y);
  }
  set_view(camera, axes, place.x, place.y, place.distance);
  set_perspective(camera, options, place.distance - box.high[2], place.distance - box.low[2]);
  return camera;
}

constexpr struct {
  const char* name;
  double azimuth, elevation;
} kViews[] = {{"iso", 35, 25},  {"front", 0, 0}, {"back", 180, 0},  {"left", -90, 0},
              {"right", 90, 0}, {"top", 0, 90},  {"bottom", 0, -90}};

} // namespace

const char* name_of(UpAxis axis) {
  static constexpr const char* kNames[] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z", "auto"};
  return kNames[int(axis)];
}

std::vector<std::string> view_names() {
  std::vector<std::string> names;
  for (const auto& view : kViews) names.emplace_back(view.name);
  return names;
}

bool named_view(const std::string& name, double& azimuth, double& elevation) {
  for (const auto& view : kViews)
    if (name == view.name) {
      azimuth = view.azimuth;
      elevation = view.elevation;
      return true;
    }
  return false;
}

Camera fit_camera(const CameraPoints& points, const CameraOptions& options) {
  const Axes axes = camera_axes(options);
  Extremes box;
  for_each_position(points, [&](const float* p) {
    const double values[3] = {along(axes.right, p), along(axes.up, p), along(axes.back, p)};
    for (int i = 0; i < 3; ++i) {
      box.low[i] = std::min(box.low[i], values[i]);
      box.high[i] = std::max(box.high[i], values[i]);
    }
  });
  double sides[6];
  for (int i = 0; i < 3; ++i) sides[i] = -box.low[i], sides[3 + i] = box.high[i];
  find_largest(points, sides);
  for (int i = 0; i < 3; ++i) box.low[i] = -sides[i], box.high[i] = sides[3 + i];
  if (box.low[0] > box.high[0]) std::fill_n(box.low, 3, 0.0), std::fill_n(box.high, 3, 0.0);
  return options.orthographic ? fit_orthographic(axes, box, options)
                              : fit_perspective(points, axes, box, options);
}

double Camera::distance_of(double depth) const {
  const double z = 2 * depth - 1; // of normalized device coordinates
  return projection[11] != 0 ? projection[14] / (projection[10] + z) : (z - projection[14]) / -projection[10];
}

} // namespace softgl::cli
