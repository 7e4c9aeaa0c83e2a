#include "view/view_state.h"

#include <algorithm>
#include <cmath>

#include "view/light_turn.h"
#include "view/view_keys.h"
#include "view/view_motion.h"

namespace softgl::cli {
namespace {

constexpr double kTurn = 180;       // degrees of a drag over the picture's height
constexpr double kWheelStep = 1.15; // magnification

ViewState::Drag drag_of(const ViewState& state, const Event& event) {
  using Drag = ViewState::Drag;
  if (event.button == Event::kLeft && state.light_key) return Drag::kLight;
  if (event.button == Event::kMiddle || (event.button == Event::kLeft && event.shift)) return Drag::kPan;
  return event.button == Event::kRight ? Drag::kZoom : Drag::kOrbit;
}

void move(ViewState& state, const Event& event) {
  const double degrees = kTurn / state.height;
  switch (state.drag) {
  case ViewState::Drag::kNone: return;
  case ViewState::Drag::kOrbit: return turn(state, -event.x * degrees, event.y * degrees);
  case ViewState::Drag::kPan: return pan(state, event.x, event.y);
  case ViewState::Drag::kZoom: return magnify(state, std::pow(kWheelStep, -event.y / 20.0));
  case ViewState::Drag::kLight: break;
  }
  if (!state.seen) return;
  if (state.lights.empty()) state.lights.emplace_back("key");
  const Axes axes = axes_of(state.seen->orbit, state.seen->up);
  state.lights.front() = turned_light(state.lights.front(), event.x * degrees, event.y * degrees, axes,
                                      state.seen->orbit.target);
}

void resize(ViewState& state, int width, int height) {
  state.width = std::clamp(width, 1, 16384);
  state.height = std::clamp(height, 1, 16384);
}

} // namespace

ViewState apply(ViewState state, const Event& event) {
  switch (event.kind) {
  case Event::kKey: press_key(state, event.key); break;
  case Event::kKeyUp:
    if (event.key == "l") state.light_key = false;
    break;
  case Event::kPress: state.drag = drag_of(state, event); break;
  case Event::kMove: move(state, event); break;
  case Event::kRelease: state.drag = ViewState::Drag::kNone; break;
  case Event::kWheel: magnify(state, std::pow(kWheelStep, event.y)); break;
  case Event::kResize: resize(state, event.x, event.y); break;
  case Event::kSeen:
    state.seen = event.seen;
    if (state.orbit) state.seen->orbit = *state.orbit; // the options have it rounded
    break;
  }
  return state;
}

} // namespace softgl::cli
