#include "view/view_arguments.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "common/program_error.h"
#include "image/float_formats.h"
#include "view/number_text.h"
#include "view/view_motion.h"

namespace softgl::cli {
namespace {

constexpr int kLargestSide = 16384; // of a picture's samples

// One word where the value could be taken for an option.
void append(std::vector<std::string>& words, const std::string& name, const std::string& value) {
  if (!value.empty() && value.front() == '-') {
    words.push_back(name + "=" + value);
    return;
  }
  words.push_back(name);
  words.push_back(value);
}

std::string terms_text(unsigned terms) {
  std::string text;
  const auto add = [&](Term term, const char* name) {
    if (terms & term) text += (text.empty() ? "" : ",") + std::string(name);
  };
  add(kAmbient, "ambient");
  add(kDiffuse, "diffuse");
  add(kSpecular, "specular");
  add(kEmission, "emission");
  return text;
}

void append_angles(const ViewState& state, std::vector<std::string>& words) {
  const bool angles = state.azimuth || state.elevation;
  if (!state.view.empty() && (angles || state.view != "iso")) append(words, "--view", state.view);
  if (state.azimuth) append(words, "--az", fixed_text(*state.azimuth, 2));
  if (state.elevation) append(words, "--el", fixed_text(*state.elevation, 2));
  if (state.roll != 0) append(words, "--roll", fixed_text(state.roll, 2));
}

// Five digits of the distance are a fraction of a pixel.
void append_orbit(const ViewState& state, std::vector<std::string>& words) {
  const Orbit& orbit = *state.orbit;
  if (state.orthographic) append_angles(state, words); // the height is that of this view
  const OrbitPlace place = place_of(orbit, state.seen ? state.seen->up : UpAxis::kPlusY);
  const int digits = 5 - int(std::ceil(std::log10(std::max(orbit.distance, 1e-30))));
  append(words, "--eye", triple_text(place.eye, digits));
  append(words, "--target", triple_text(orbit.target, digits));
  append(words, "--view-up", triple_text(place.view_up, 5));
}

void append_camera(const ViewState& state, std::vector<std::string>& words) {
  if (state.orbit) {
    append_orbit(state, words);
  } else {
    append_angles(state, words);
    words.insert(words.end(), state.place.begin(), state.place.end());
  }
  if (state.zoom != 1) append(words, "--zoom", significant_text(state.zoom, 4));
  if (state.orthographic) words.emplace_back("--ortho");
}

void append_look(const ViewState& state, std::vector<std::string>& words) {
  if (state.shading != Shading::kGouraud)
    append(words, "--shading", state.shading == Shading::kFlat ? "flat" : "phong");
  if (state.reflection_vector) append(words, "--specular", "reflection");
  if (state.terms != kAllTerms) append(words, "--terms", terms_text(state.terms));
  for (const std::string& light : state.lights) append(words, "--light", light);
  if (state.style == LineOptions::kWireframe) words.emplace_back("--wireframe");
  if (state.style == LineOptions::kPoints) words.emplace_back("--points");
  if (state.edges != Edges::kNone) append(words, "--edges", state.edges == Edges::kAll ? "all" : "sharp");
  if (state.hidden_lines) words.emplace_back("--hidden-lines");
  if (state.ground) words.emplace_back("--ground");
  int side = state.samples_per_side;
  while (side > 1 && std::max(state.width, state.height) * side > kLargestSide) side /= 2;
  if (side > 1) append(words, "--aa", std::to_string(side * side));
}

// What would be taken for an option or for a command.
std::string model_argument(const std::string& path) {
  const bool word = path.find_first_of("/.") == std::string::npos;
  return word || path.front() == '-' ? "./" + path : path;
}

const std::set<std::string> kOfState = {
    "--output", "--size",      "--view",   "--az",      "--el",           "--roll",     "--zoom",
    "--ortho",  "--eye",       "--target", "--view-up", "--shading",      "--specular", "--terms",
    "--light",  "--wireframe", "--points", "--edges",   "--hidden-lines", "--ground",   "--aa"};
const std::set<std::string> kOfFiles = {"--turntable",    "--sheet",      "--fps",     "--skip-existing",
                                        "--keep-going",   "--stats",      "--camera",  "--sandbox",
                                        "--bits",         "--max-memory", "--timeout", "--strict",
                                        "--write-camera", "--max-size"};

} // namespace

ViewState state_of(const ParsedOptions& parsed, const std::vector<std::string>& models) {
  const ProgramOptions& options = *parsed.options;
  const CameraOptions& camera = options.views.front().camera;
  const auto refuse = [](const std::string& sentence) { throw ProgramError(kUsageError, sentence); };
  ViewState state;
  state.models = models;
  bool sized = false;
  for (const GivenOption& option : parsed.given) {
    if (kOfFiles.count(option.name)) refuse("a window has no " + option.name);
    sized |= option.name == "--size";
    if (option.name == "--view") state.view = option.values.front();
    if (option.name == "--az") state.azimuth = std::stod(option.values.front());
    if (option.name == "--el") state.elevation = std::stod(option.values.front());
    if (option.name == "--light") state.lights = option.values;
    const bool place = option.name == "--eye" || option.name == "--target" || option.name == "--view-up";
    if (!place && kOfState.count(option.name)) continue;
    std::vector<std::string>& words = place ? state.place : state.rest;
    if (option.values.empty()) words.push_back(option.name);
    for (const std::string& value : option.values) append(words, option.name, value);
  }
  if (options.views.size() > 1 || options.passes.size() > 1) refuse("a window shows one picture");
  if (is_animation(options.format) || is_float_format(options.format))
    refuse("a window saves no " + options.format + "; png is a format of one picture");
  const LineOptions& lines = options.render.lines;
  const LightingOptions& lighting = options.render.lighting;
  if (sized) {
    state.width = options.render.width;
    state.height = options.render.height;
  }
  state.roll = camera.roll;
  state.zoom = camera.zoom;
  state.orthographic = camera.orthographic;
  state.shading = lighting.shading;
  state.reflection_vector = lighting.reflection_vector;
  state.terms = lighting.terms;
  state.style = lines.style;
  // Wireframes alone have all edges without being told.
  state.edges =
      lines.edges == Edges::kAll && lines.style == LineOptions::kWireframe ? Edges::kNone : lines.edges;
  state.hidden_lines = lines.hidden;
  state.ground = options.render.ground;
  state.samples_per_side = options.render.samples_per_side;
  state.start = std::make_shared<const ViewState>(state);
  return state;
}

std::vector<std::string> to_arguments(const ViewState& state) {
  std::vector<std::string> words = {model_argument(state.models.at(state.model))};
  append(words, "--size", std::to_string(state.width) + "x" + std::to_string(state.height));
  append_camera(state, words);
  append_look(state, words);
  words.insert(words.end(), state.rest.begin(), state.rest.end());
  return words;
}

std::string command_line(const std::vector<std::string>& arguments) {
  std::string text = "softgl";
  for (const std::string& word : arguments) {
    text += ' ';
    const bool plain =
        !word.empty() && word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                                "0123456789+-,./:=_@%") == std::string::npos;
    if (plain) {
      text += word;
      continue;
    }
    text += '\'';
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += '\'';
  }
  return text;
}

} // namespace softgl::cli
