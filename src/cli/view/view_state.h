// What the window of `softgl view` shows, and how keys and the mouse change it. Knows no window.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/lighting_options.h"
#include "scene/look.h"

namespace softgl::cli {

// A camera that the mouse has moved: from this direction and distance it looks to a place of the model.
struct Orbit {
  double azimuth = 0, elevation = 0, roll = 0; // as those of CameraOptions
  std::array<double, 3> target = {0, 0, 0};    // in the model's coordinates
  double distance = 1;                         // in the model's units
};

// The camera of the picture as it is, however it came about: a drag goes on from there.
struct SeenCamera {
  Orbit orbit;
  UpAxis up = UpAxis::kPlusY; // of the model
  double height = 1;          // of what the picture shows at the target, in the model's units
};

struct ViewState {
  // What the picture is: to_arguments() says it as options.
  std::vector<std::string> models; // files
  size_t model = 0;                // the one that is shown
  int width = 800, height = 600;
  std::string view; // a named view; empty: none, and the angles count from the front
  std::optional<double> azimuth, elevation;
  double roll = 0, zoom = 1;
  bool orthographic = false;
  std::vector<std::string> place; // the options of a camera with a place, as they were given
  std::optional<Orbit> orbit;     // takes the place of all of these but `zoom` and `orthographic`
  Shading shading = Shading::kGouraud;
  bool reflection_vector = false;
  unsigned terms = kAllTerms;
  std::vector<std::string> lights; // values of --light; none: the key light
  LineOptions::Style style = LineOptions::kSurface;
  Edges edges = Edges::kNone;
  bool hidden_lines = false, ground = false;
  int samples_per_side = 1;
  std::vector<std::string> rest; // the options that no event changes

  // What the window is doing.
  enum class Drag { kNone, kOrbit, kPan, kZoom, kLight } drag = Drag::kNone;
  bool light_key = false; // is held
  bool help = false;
  std::optional<SeenCamera> seen;                                      // known once there is a picture
  std::shared_ptr<const ViewState> start;                              // what a reset goes back to
  enum class Request { kNone, kSave, kQuit } request = Request::kNone; // for the window to take and clear
};

struct Event {
  enum Kind {
    kKey,     // goes down: `key`
    kKeyUp,   // `key`
    kPress,   // `button`
    kMove,    // by x, y pixels to the right and down
    kRelease, // of any button
    kWheel,   // by y steps, positive is away from the user
    kResize,  // the window is x wide and y high
    kSeen,    // the picture has the camera `seen`
  };
  enum Button { kLeft, kMiddle, kRight };
  Kind kind = kKey;
  std::string key; // "a", "1", "+", "F1", "Left", "PageUp" ...
  Button button = kLeft;
  bool shift = false; // is held
  int x = 0, y = 0;
  SeenCamera seen;
};

// An event that means nothing changes nothing.
ViewState apply(ViewState state, const Event& event);

} // namespace softgl::cli
