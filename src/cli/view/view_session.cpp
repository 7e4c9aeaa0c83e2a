#include "view/view_session.h"

#include <cstdio>
#include <filesystem>
#include <new>

#include "command/picture_inputs.h"
#include "command/picture_plan.h"
#include "common/elapsed_time.h"
#include "common/file_writer.h"
#include "view/view_arguments.h"
#include "view/view_motion.h"

namespace softgl::cli {
namespace {

constexpr size_t kModelsKept = 2; // to and fro between two kinds of shading takes no reading

} // namespace

// Or the reason why it cannot be read.
struct ViewSession::LoadedModel {
  size_t number = 0;
  bool flat = false;
  Edges edges = Edges::kNone;
  std::optional<ProgramError> error;
  PreparedModel model;
  std::unique_ptr<MeshRenderer> renderer;
  Warnings warnings;
};

ViewSession::ViewSession(ViewState start, std::string save_as, unsigned threads)
    : state_(std::move(start)), save_as_(std::move(save_as)), threads_(threads),
      arguments_(to_arguments(state_)) {}

ViewSession::~ViewSession() = default;

void ViewSession::handle(const Event& event) {
  if (event.kind == Event::kKey && !error_) message_.clear();
  const size_t model = state_.model;
  state_ = apply(std::move(state_), event);
  if (state_.model != model) watch_.clear();
  arguments_ = to_arguments(state_);
  if (state_.request != ViewState::Request::kSave) return;
  state_.request = ViewState::Request::kNone;
  save();
}

ProgramOptions ViewSession::options(const std::string& output) const {
  std::vector<const char*> words = {"softgl"};
  for (const std::string& word : arguments_) words.push_back(word.c_str());
  words.push_back("--output");
  words.push_back(output.c_str());
  ParsedOptions parsed = parse_options(int(words.size()), words.data());
  if (!parsed.options) throw ProgramError(kUsageError, "this is no picture: " + command_line(arguments_));
  return std::move(*parsed.options);
}

ViewSession::LoadedModel& ViewSession::loaded(const ProgramOptions& options) {
  const bool flat = options.render.lighting.shading == Shading::kFlat;
  const Edges edges = options.render.lines.edges;
  for (auto each = models_.begin(); each != models_.end(); ++each)
    if (each->number == state_.model && each->flat == flat && each->edges == edges) {
      models_.splice(models_.begin(), models_, each);
      return models_.front();
    }
  while (models_.size() >= kModelsKept) models_.pop_back(); // before the next one takes memory
  LoadedModel& fresh = models_.emplace_front();
  fresh.number = state_.model;
  fresh.flat = flat;
  fresh.edges = edges;
  const std::string& path = state_.models[state_.model];
  watch_.add(path); // before it is read
  Warnings notes;
  RunTimes unused;
  try {
    fresh.model = prepare_model(path, options, threads_, fresh.warnings, notes, unused);
    fresh.renderer = std::make_unique<MeshRenderer>(fresh.model.mesh, fresh.model.materials,
                                                    fresh.model.frame, options.render.srgb);
  } catch (const ProgramError& error) { fresh.error = error; } catch (const std::bad_alloc&) {
    fresh.error.emplace(kCannotRead, path + ": not enough memory");
  }
  for (const std::string& file : fresh.model.files) watch_.add(file);
  for (const Material& material : fresh.model.materials)
    for (const TextureReference* texture : {&material.diffuse_map, &material.opacity_map})
      if (!texture->file.empty()) watch_.add(texture->file);
  if (!options.quiet) say(fresh.warnings);
  return fresh;
}

void ViewSession::say(const Warnings& warnings, size_t sentences, size_t notices) const {
  for (size_t i = sentences; i < warnings.sentences().size(); ++i)
    std::fprintf(stderr, "softgl: warning: %s\n", warnings.sentences()[i].c_str());
  for (size_t i = notices; i < warnings.notices().size(); ++i)
    std::fprintf(stderr, "softgl: note: %s\n", warnings.notices()[i].c_str());
}

RenderResult ViewSession::render(ProgramOptions& options, const Reduction& reduction) {
  Background& background = options.render.background;
  if (background.file.empty() || background.file != background_.file) {
    read_named_files(options);
    background_ = background;
  }
  background.picture = background_.picture;
  LoadedModel& model = loaded(options);
  if (model.error) throw ProgramError(*model.error);
  CameraOptions view = options.views.front().camera;
  view.up = model.model.up;
  const Camera camera = picture_camera(model.model, view);
  Event seen;
  seen.kind = Event::kSeen;
  seen.seen = seen_camera(camera, model.model.frame, view.up);
  RenderOptions render = options.render;
  render.pass = options.passes.front();
  render.up = model.model.up;
  if (reduction.one_sample) render.samples_per_side = 1;
  render.width = std::max(1, render.width / reduction.divisor);
  render.height = std::max(1, render.height / reduction.divisor);
  const size_t sentences = model.warnings.sentences().size(), notices = model.warnings.notices().size();
  const auto start = Clock::now();
  RenderResult result = model.renderer->draw(camera, render, model.warnings);
  seconds_ = seconds_since(start);
  if (!options.quiet) say(model.warnings, sentences, notices);
  state_ = apply(std::move(state_), seen);
  arguments_ = to_arguments(state_); // the same, unless another axis is up than before
  return result;
}

void ViewSession::draw(const Reduction& reduction) {
  error_.reset();
  message_.clear();
  drawn_ = arguments_; // also where it fails: it would again
  try {
    ProgramOptions asked = options("view.png");
    RenderResult result = render(asked, reduction);
    picture_ = result.picture.channels == 3 ? std::move(result.picture) : as_rgb(result.picture);
    said_.clear();
    if (!result.visible) message_ = "nothing of the model is visible in this view (key r: as at the start)";
  } catch (const ProgramError& error) { fail(error); } catch (const std::bad_alloc&) {
    fail({kCannotRead, state_.models[state_.model] + ": not enough memory"});
  }
}

void ViewSession::fail(const ProgramError& error) {
  error_ = error;
  message_ = error.what();
  if (said_ != message_) std::fprintf(stderr, "softgl: error: %s\n", error.what());
  said_ = message_;
}

std::string ViewSession::title() const {
  const std::string& path = state_.models[state_.model];
  char time[32];
  std::snprintf(time, sizeof time, " - %.0f ms", seconds_ * 1000);
  return path.substr(path.rfind('/') + 1) + (picture_.pixels.empty() ? "" : time);
}

std::string ViewSession::free_name() const {
  std::string stem = stem_of(state_.models[state_.model]);
  for (char& c : stem)
    if (c == '{' || c == '}') c = '_'; // they have a meaning in the name of an output
  for (int number = 1;; ++number) {
    std::string name = stem + "-" + std::to_string(number) + ".png";
    if (!std::filesystem::exists(name)) return name;
  }
}

void ViewSession::save(const std::string& file) {
  const std::string name = !file.empty() ? file : !save_as_.empty() ? save_as_ : free_name();
  try {
    ProgramOptions asked = options(name);
    const RenderResult result = render(asked, {});
    if (!result.visible)
      throw ProgramError(kCannotRead, "nothing of the model is visible in this view; no picture written");
    write_file(name, encode_image(result.picture, asked.format, asked.png));
    std::vector<std::string> words = arguments_;
    words.insert(words.end(), {"-o", name});
    std::printf("%s\n", command_line(words).c_str());
    std::fflush(stdout);
    message_ = "saved as " + name;
  } catch (const ProgramError& error) { fail(error); } catch (const std::bad_alloc&) {
    fail({kCannotRead, "not enough memory"});
  }
}

bool ViewSession::look_at_files() {
  if (!watch_.look()) return false;
  said_.clear();
  models_.clear();
  drawn_.clear();
  background_ = {};
  return true;
}

} // namespace softgl::cli
