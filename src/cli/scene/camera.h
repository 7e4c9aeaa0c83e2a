// Where the picture is taken from: a direction and a frame that the model just fills.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh_builder.h"

namespace softgl::cli {

enum class UpAxis { kPlusX, kMinusX, kPlusY, kMinusY, kPlusZ, kMinusZ, kAuto };

const char* name_of(UpAxis axis); // "+X" ...

// A camera that is not fitted to the model. In the model's coordinates.
struct CameraPlacement {
  std::array<double, 3> eye = {0, 0, 0};
  std::optional<std::array<double, 3>> target, up; // the model's middle; the model's up
  double field_of_view = 0;                        // degrees; 0: that of the options
  double height = 0; // of a picture with parallel rays; 0: what shows all of the model
};

struct CameraOptions {
  double azimuth = 35;   // degrees to the right of the model's front
  double elevation = 25; // degrees above the horizon
  double roll = 0;
  double zoom = 1;
  double field_of_view = 30; // degrees, of the picture's height
  bool orthographic = false;
  UpAxis up = UpAxis::kPlusY;
  int width = 1024, height = 1024;
  std::optional<CameraPlacement> placement;
};

// Angles of a named view; false if the name is unknown.
bool named_view(const std::string& name, double& azimuth, double& elevation);
std::vector<std::string> view_names();

struct Camera {
  double view[16];       // column-major, a rotation and a translation
  double projection[16]; // column-major
  double eye[3];         // direction from the model to the camera, in model coordinates

  // From the camera's plane, of what has this window depth: 0 is the near plane, 1 the far one.
  double distance_of(double depth) const;
};

// The places that a camera shows. Each process may have a part of them.
struct CameraPoints {
  CameraPoints(const Mesh& mesh) : meshes{&mesh} {}
  explicit CameraPoints(std::vector<const Mesh*> parts) : meshes(std::move(parts)) {}

  std::vector<const Mesh*> meshes; // which outlive it
  // Makes each value the largest of those that the processes have; none: all places are here.
  std::function<void(double* values, size_t count)> largest_of_all;
};

// Part of the picture left free on each side of the tighter dimension.
inline constexpr double kMargin = 0.01;

Camera fit_camera(const CameraPoints& points, const CameraOptions& options);

} // namespace softgl::cli
