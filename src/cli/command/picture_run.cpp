#include "command/picture_run.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>
#include <optional>

#include "command/camera_file.h"
#include "command/output_set.h"
#include "command/picture_inputs.h"
#include "command/picture_plan.h"
#include "command/prepared_model.h"
#include "common/elapsed_time.h"
#include "common/parallel.h"
#include "common/program_error.h"
#include "common/progress.h"
#include "common/stable_hash.h"
#include "scene/placed_camera.h"
#include "scene/turntable_camera.h"

namespace softgl::cli {
namespace {

// A model's part of the run.
struct Outcome {
  size_t first = 0, count = 0; // jobs
  Warnings warnings, notes;
  ModelReport report;
  RunTimes times;
  std::optional<ProgramError> error;
  bool done = false;
};

StableHash hash_of(const RenderResult& result) {
  const bool floats = result.picture.pixels.empty();
  const Picture& picture = result.picture;
  const FloatPicture& values = result.floats;
  StableHash hash;
  for (const int number : {floats ? values.width : picture.width, floats ? values.height : picture.height,
                           floats ? values.channels : picture.channels, floats ? 32 : picture.bits})
    hash.add(uint64_t(number));
  if (floats)
    hash.add(values.values.data(), values.values.size() * sizeof(float));
  else
    hash.add(picture.pixels.data(), picture.pixels.size());
  return hash;
}

class PictureRun {
public:
  PictureRun(const ProgramOptions& options, unsigned threads, PictureRecord* record)
      : options_(options), plan_(plan_pictures(options)), outputs_(plan_, options), record_(record),
        hashes_(record ? plan_.jobs.size() : 0), outcomes_(plan_.models.size()),
        progress_(stderr, !record && !options.quiet && is_terminal(stderr), plan_.jobs.size()) {
    for (size_t i = plan_.jobs.size(); i-- > 0;) {
      Outcome& outcome = outcomes_[plan_.jobs[i].model];
      outcome.first = i;
      ++outcome.count;
    }
    const size_t models = plan_.models.size();
    at_once_ = unsigned(std::clamp<size_t>(models, 1, threads));
    threads_each_ = std::max(1u, threads / at_once_);
  }

  // Pictures that are drawn at the same time: GL then needs no threads of its own.
  unsigned pictures_at_once() const {
    const size_t each = plan_.models.empty() ? 0 : plan_.jobs.size() / plan_.models.size();
    return at_once_ * unsigned(std::clamp<size_t>(each, 1, threads_each_));
  }

  int run() {
    parallel_for(plan_.models.size(), at_once_, [this](size_t model, unsigned) { run_model(model); });
    return finish();
  }

private:
  void run_model(size_t model) {
    Outcome& outcome = outcomes_[model];
    if (outcome.count == 0) return end_model(outcome); // all its pictures exist
    const auto start = Clock::now();
    try {
      draw_model(plan_.models[model], outcome);
    } catch (const ProgramError& error) { outcome.error = error; } catch (const std::bad_alloc&) {
      outcome.error.emplace(kCannotRead, plan_.models[model] + ": not enough memory");
    }
    outcome.times.total = seconds_since(start);
    end_model(outcome);
    if (outcome.error && !options_.keep_going) throw *outcome.error;
  }

  void draw_model(const std::string& path, Outcome& outcome) {
    std::vector<char> arrived(outcome.count);
    try {
      const PreparedModel model =
          prepare_model(path, options_, threads_each_, outcome.warnings, outcome.notes, outcome.times);
      outcome.report = model.report;
      draw_jobs(model, outcome, arrived);
    } catch (...) {
      if (options_.keep_going)
        for (size_t i = 0; i < outcome.count; ++i)
          if (!arrived[i]) outputs_.leave(outcome.first + i);
      throw;
    }
  }

  void draw_jobs(const PreparedModel& model, Outcome& outcome, std::vector<char>& arrived) {
    std::vector<std::unique_ptr<MeshRenderer>> renderers(threads_each_);
    std::vector<Warnings> warnings(outcome.count);
    std::mutex mutex; // of the times
    std::vector<std::optional<ProgramError>> errors(outcome.count);
    const auto draw = [&](size_t i, unsigned worker) {
      const size_t number = outcome.first + i;
      const PictureJob& job = plan_.jobs[number];
      CameraOptions view = options_.views[job.view].camera;
      view.up = model.up;
      const Camera camera = camera_of(model, view, job);
      if (!renderers[worker])
        renderers[worker] =
            std::make_unique<MeshRenderer>(model.mesh, model.materials, model.frame, options_.render.srgb);
      RenderOptions render = options_.render;
      render.pass = options_.passes[job.pass];
      render.up = model.up;
      RenderResult result = renderers[worker]->draw(camera, render, warnings[i]);
      judge(model, result, warnings[i]);
      refuse_warnings(model, outcome.warnings.count() + warnings[i].count());
      if (record_) hashes_[number] = hash_of(result);
      const auto write_start = Clock::now();
      arrived[i] = true;
      const double upload = result.upload_seconds, drawing = result.draw_seconds,
                   average = result.average_seconds;
      outputs_.take(number, std::move(result));
      const std::scoped_lock lock(mutex);
      outcome.times.upload += upload;
      outcome.times.draw += drawing;
      outcome.times.average += average;
      outcome.times.write += seconds_since(write_start);
      progress_.step();
    };
    const auto draw_and_go_on = [&](size_t i, unsigned worker) {
      try {
        draw(i, worker);
      } catch (const ProgramError& error) {
        if (!options_.keep_going) throw;
        errors[i] = error;
        if (!arrived[i]) outputs_.leave(outcome.first + i);
        arrived[i] = true;
      }
    };
    const auto add_warnings = [&] {
      for (const Warnings& each : warnings) outcome.warnings.add_new(each);
    };
    try {
      parallel_for(outcome.count, threads_each_, draw_and_go_on);
    } catch (...) {
      add_warnings();
      throw;
    }
    add_warnings();
    const auto first = std::find_if(errors.begin(), errors.end(), [](const auto& error) { return !!error; });
    if (first != errors.end()) throw ProgramError(**first);
  }

  Camera camera_of(const PreparedModel& model, const CameraOptions& view, const PictureJob& job) const {
    if (options_.turntable) return turntable_camera(model.mesh, view, int(job.frame), options_.turntable);
    const Camera camera = picture_camera(model, view);
    if (!options_.place.output.empty() && job.pass == 0)
      write_camera(options_.place.output, placement_of(camera, model.frame));
    return camera;
  }

  void judge(const PreparedModel& model, const RenderResult& result, Warnings& warnings) const {
    if (options_.render.background.transparent && !has_alpha(options_.format))
      warnings.add(options_.output == "-" ? "standard output" : options_.output,
                   "pictures of format " + options_.format +
                       " have no transparency; the background is white");
    if (!result.visible)
      throw ProgramError(kCannotRead,
                         model.name + ": nothing of the model is visible in this view; no picture written");
    if (result.as_wireframe)
      warnings.add(model.name,
                   result.transparent
                       ? "nothing of it shows because its materials are transparent (d, Tr or map_d); its "
                         "edges are drawn instead"
                       : "its surfaces have no visible area in this view; their edges are drawn instead");
  }

  void refuse_warnings(const PreparedModel& model, uint64_t count) const {
    if (!options_.strict || count == 0) return;
    throw ProgramError(kCannotRead, model.name + ": " + std::to_string(count) +
                                        (count == 1 ? " warning" : " warnings") +
                                        " with --strict; no picture written");
  }

  // Messages by model, whichever ends first.
  void end_model(Outcome& outcome) {
    const std::scoped_lock lock(mutex_);
    outcome.done = true;
    for (; next_ < outcomes_.size() && outcomes_[next_].done; ++next_) {
      const Outcome& next = outcomes_[next_];
      std::string text;
      if (!options_.quiet)
        for (const std::string& sentence : next.warnings.sentences())
          text += "softgl: warning: " + sentence + "\n";
      if (!options_.quiet)
        for (const std::string& sentence : next.warnings.notices())
          text += "softgl: note: " + sentence + "\n";
      if (options_.verbose)
        for (const std::string& sentence : next.notes.sentences()) text += "softgl: note: " + sentence + "\n";
      if (options_.verbose && !next.error && next.count > 0) text += as_text(next.report);
      if (options_.keep_going && next.error)
        text += "softgl: error: " + std::string(next.error->what()) + "\n";
      if (!text.empty()) progress_.say(text);
      if (next.error && !options_.keep_going) next_ = outcomes_.size(); // the last that is heard of
    }
  }

  int finish() {
    size_t failed = 0;
    int code = kSuccess;
    for (const Outcome& outcome : outcomes_)
      if (outcome.error) {
        if (failed++ == 0) code = outcome.error->code;
      }
    if (failed > 0)
      progress_.say("softgl: " + std::to_string(failed) + " of " + std::to_string(outcomes_.size()) +
                    (outcomes_.size() == 1 ? " model" : " models") + " failed\n");
    if (options_.stats) print_stats();
    if (record_) fill_record();
    return code;
  }

  void fill_record() const {
    StableHash all;
    for (const StableHash& each : hashes_) all.add(each.value());
    record_->pixels = (hashes_.size() == 1 ? hashes_.front() : all).text();
    for (const Outcome& outcome : outcomes_) record_->warnings += outcome.warnings.count();
  }

  void print_stats() {
    std::string text;
    for (const Outcome& outcome : outcomes_) {
      if (outcome.error || outcome.count == 0) continue;
      text +=
          (text.empty() ? "" : ",\n") + stats_as_json(outcome.report, outcome.times, options_.render.width,
                                                      options_.render.height, outcome.warnings);
      text.pop_back();
    }
    if (plan_.models.size() != 1) text = "[\n" + text + "\n]";
    print_text(text + "\n", options_.output == "-" ? stderr : stdout);
  }

  const ProgramOptions& options_;
  const PicturePlan plan_;
  OutputSet outputs_;
  PictureRecord* record_;
  std::vector<StableHash> hashes_; // for each picture of a record
  std::vector<Outcome> outcomes_;  // for each model
  std::mutex mutex_;
  size_t next_ = 0; // model whose messages are next
  Progress progress_;
  unsigned at_once_ = 1, threads_each_ = 1;
};

} // namespace

int draw_pictures(const ProgramOptions& given, unsigned threads, PictureRecord* record) {
  ProgramOptions options = given;
  read_named_files(options);
  PictureRun run(options, threads, record);
  if (run.pictures_at_once() > 1) ::setenv("SOFTGL_THREADS", "1", 1); // before GL is first used
  return run.run();
}

} // namespace softgl::cli
