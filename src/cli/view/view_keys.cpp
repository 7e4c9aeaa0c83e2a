#include "view/view_keys.h"

#include <algorithm>

#include "view/view_motion.h"

namespace softgl::cli {
namespace {

constexpr double kKeyTurn = 5, kKeyZoom = 1.15; // degrees

void show_view(ViewState& state, const char* name) {
  state.view = name;
  state.azimuth.reset();
  state.elevation.reset();
  state.orbit.reset();
  state.place.clear();
  state.roll = 0;
  state.zoom = 1;
  state.seen.reset();
}

// One term at least is drawn.
void toggle_term(ViewState& state, Term term) {
  if (state.terms != unsigned(term)) state.terms ^= term;
}

void toggle_style(ViewState& state, LineOptions::Style style) {
  state.style = state.style == style ? LineOptions::kSurface : style;
}

void go_back_to_start(ViewState& state) {
  if (!state.start) return;
  ViewState fresh = *state.start;
  fresh.start = state.start;
  fresh.width = state.width;
  fresh.height = state.height;
  fresh.model = state.model;
  fresh.light_key = state.light_key;
  if (fresh.model != state.start->model) fresh.place.clear(); // a place in another model
  state = std::move(fresh);
}

struct KeyRow {
  const char* key;
  void (*act)(ViewState&);
};

constexpr KeyRow kRows[] = {
    {"1", [](ViewState& s) { show_view(s, "iso"); }},
    {"2", [](ViewState& s) { show_view(s, "front"); }},
    {"3", [](ViewState& s) { show_view(s, "back"); }},
    {"4", [](ViewState& s) { show_view(s, "left"); }},
    {"5", [](ViewState& s) { show_view(s, "right"); }},
    {"6", [](ViewState& s) { show_view(s, "top"); }},
    {"7", [](ViewState& s) { show_view(s, "bottom"); }},
    {"Left", [](ViewState& s) { turn(s, kKeyTurn, 0); }},
    {"Right", [](ViewState& s) { turn(s, -kKeyTurn, 0); }},
    {"Up", [](ViewState& s) { turn(s, 0, -kKeyTurn); }},
    {"Down", [](ViewState& s) { turn(s, 0, kKeyTurn); }},
    {"+", [](ViewState& s) { magnify(s, kKeyZoom); }},
    {"-", [](ViewState& s) { magnify(s, 1 / kKeyZoom); }},
    {"o", [](ViewState& s) { s.orthographic = !s.orthographic; }},
    {"f", [](ViewState& s) { s.shading = Shading::kFlat; }},
    {"g", [](ViewState& s) { s.shading = Shading::kGouraud; }},
    {"p", [](ViewState& s) { s.shading = Shading::kPhong; }},
    {"v", [](ViewState& s) { s.reflection_vector = !s.reflection_vector; }},
    {"F2", [](ViewState& s) { toggle_term(s, kAmbient); }},
    {"F3", [](ViewState& s) { toggle_term(s, kDiffuse); }},
    {"F4", [](ViewState& s) { toggle_term(s, kSpecular); }},
    {"F5", [](ViewState& s) { toggle_term(s, kEmission); }},
    {"w", [](ViewState& s) { toggle_style(s, LineOptions::kWireframe); }},
    {"d", [](ViewState& s) { toggle_style(s, LineOptions::kPoints); }},
    {"e",
     [](ViewState& s) {
       s.edges = s.edges == Edges::kNone  ? Edges::kAll
                 : s.edges == Edges::kAll ? Edges::kSharp
                                          : Edges::kNone;
     }},
    {"x", [](ViewState& s) { s.hidden_lines = !s.hidden_lines; }},
    {"b", [](ViewState& s) { s.ground = !s.ground; }},
    {"a", [](ViewState& s) { s.samples_per_side = s.samples_per_side == 4 ? 1 : 2 * s.samples_per_side; }},
    {"PageDown", [](ViewState& s) { show_model(s, (s.model + 1) % s.models.size()); }},
    {"PageUp", [](ViewState& s) { show_model(s, (s.model + s.models.size() - 1) % s.models.size()); }},
    {"r", go_back_to_start},
    {"s", [](ViewState& s) { s.request = ViewState::Request::kSave; }},
    {"h", [](ViewState& s) { s.help = !s.help; }},
    {"F1", [](ViewState& s) { s.help = !s.help; }},
    {"q", [](ViewState& s) { s.request = ViewState::Request::kQuit; }},
    {"Escape", [](ViewState& s) { s.request = ViewState::Request::kQuit; }},
    {"l", [](ViewState& s) { s.light_key = true; }},
};

constexpr const char* kLines[] = {
    "left drag\tturn the model; arrows turn by 5 degrees",
    "middle drag\tmove the model; also shift and left",
    "right drag\tnearer and farther; also the wheel",
    "+ -\tnearer, farther",
    "l + left drag\tturn the first light",
    "1 2 3 4 5 6 7\tthree-quarter, front, back, left, right, top, bottom",
    "o\tparallel rays, or perspective",
    "f g p\tflat, Gouraud or Phong shading",
    "v\thalf vector, or reflection vector",
    "F2 F3 F4 F5\tambient, diffuse, specular, emission: on or off",
    "w d\twireframe, points (dots)",
    "e\tedges: none, all, sharp ones",
    "x\thidden lines and points, too",
    "b\tshadow on the ground below",
    "a\t1, 4 or 16 samples a pixel",
    "PageDown PageUp\tnext model, model before",
    "r\tas at the start",
    "s\tsave the picture, print its command",
    "h F1\tthis help",
    "q Escape\tend",
};

} // namespace

void press_key(ViewState& state, const std::string& key) {
  const auto* row = std::find_if(std::begin(kRows), std::end(kRows),
                                 [&key](const KeyRow& each) { return key == each.key; });
  if (row != std::end(kRows)) row->act(state);
}

std::vector<std::string> key_lines() { return {std::begin(kLines), std::end(kLines)}; }

} // namespace softgl::cli
