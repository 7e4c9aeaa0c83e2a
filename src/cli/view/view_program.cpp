#include "view/view_program.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <thread>
#include <utility>

#include "command/picture_plan.h"
#include "common/file_writer.h"
#include "common/source_text.h"
#include "image/image_writer.h"
#include "view/script.h"
#include "view/text_box.h"
#include "view/view_arguments.h"
#include "view/view_keys.h"
#include "view/view_session.h"
#include "view/window.h"

namespace softgl::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLook = 200;       // milliseconds between two looks at the files
constexpr int kStill = 150;      // after the last movement
constexpr int kPatience = 20000; // of a script

constexpr const char* kScriptHelp = R"(
A script has a step a line, for tests and demonstrations:
  key NAME | drag left|middle|right|shift|light DX DY | wheel STEPS | size WxH
  save [FILE] | shot FILE (what the window shows) | wait reload
Without a screen: SDL_VIDEODRIVER=dummy.

Key s prints the command that makes the picture that it saves, as MODEL-1.png, MODEL-2.png ...
without -o.
)";

void print_keys() {
  std::fputs("\nKeys and mouse:\n", stdout);
  for (const std::string& line : key_lines()) {
    const size_t tab = line.find('\t');
    std::printf("  %-17s%s\n", line.substr(0, tab).c_str(), line.substr(tab + 1).c_str());
  }
  std::fputs(kScriptHelp, stdout);
}

// Files, and those of folders.
std::vector<std::string> models_of(const ProgramOptions& options) {
  for (const std::string& model : options.models)
    if (model == "-") throw ProgramError(kUsageError, "a window reads files, not standard input");
  ProgramOptions each = options;
  each.output = "{n}.png"; // names that nobody uses
  return plan_pictures(each).models;
}

class ViewProgram {
public:
  ViewProgram(ViewSession& session, const ViewState& state)
      : session_(session), window_(session.title() + " - reading", state.width, state.height) {}

  int run() {
    if (!draw_first()) return session_.error()->code;
    auto last_look = Clock::now(), last_move = last_look - std::chrono::milliseconds(kStill);
    while (!ended()) {
      bool said = false; // something that is shown without another picture
      int patience = session_.is_stale() ? 0 : is_reduced() ? kStill / 3 : kLook;
      while (const std::optional<Event> event = window_.wait(std::exchange(patience, 0))) {
        session_.handle(*event);
        said |= event->kind == Event::kKey;
        if (event->kind == Event::kMove || event->kind == Event::kWheel || event->kind == Event::kResize)
          last_move = Clock::now();
      }
      if (since(last_look) >= kLook) {
        session_.look_at_files();
        last_look = Clock::now();
      }
      const bool moving = since(last_move) < kStill;
      if (session_.is_stale()) {
        draw(moving ? effort_.reduction() : Reduction());
        if (moving) last_move = Clock::now(); // who moves gets the time that the picture took
      } else if (is_reduced() && !moving) {
        draw({drawn_.divisor > 1, 1}); // slow pictures get better in steps
      } else if (window_.needs_showing() || said) {
        show();
      }
    }
    return kSuccess;
  }

  int play(const std::vector<ScriptStep>& steps) {
    if (!draw_first()) return session_.error()->code;
    for (const ScriptStep& step : steps) {
      switch (step.kind) {
      case ScriptStep::kEvents:
        for (const Event& event : step.events) {
          session_.handle(event);
          if (event.kind == Event::kResize) window_.set_size(event.x, event.y);
        }
        break;
      case ScriptStep::kSave: session_.save(step.file); break;
      case ScriptStep::kShot: write_shot(step.file); break;
      case ScriptStep::kReload: wait_for_reload(); break;
      }
      while (window_.wait(0)) {} // a script has no user
      if (session_.is_stale())
        draw({});
      else
        show();
      if (ended()) break;
    }
    return kSuccess;
  }

private:
  static long since(Clock::time_point start) {
    return long(std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start).count());
  }

  bool ended() const { return session_.state().request == ViewState::Request::kQuit; }

  bool draw_first() {
    show();
    draw({});
    return !session_.error();
  }

  // Whether there is a better picture than the one that is shown.
  bool is_reduced() const {
    return drawn_.divisor > 1 || (drawn_.one_sample && session_.state().samples_per_side > 1);
  }

  void draw(const Reduction& reduction) {
    session_.draw(reduction);
    drawn_ = reduction;
    if (!session_.error()) effort_.took(session_.seconds(), reduction);
    window_.set_title(session_.title());
    show();
  }

  void show() {
    Picture help, message;
    const ViewState& state = session_.state();
    if (state.help) help = draw_text_box(key_lines(), state.width, state.height);
    if (!session_.message().empty()) message = draw_text_box({session_.message()}, state.width, state.height);
    window_.show(session_.picture(), help, message);
  }

  void write_shot(const std::string& file) const {
    const std::string format = image_format_of(file);
    if (format != "png" && format != "ppm")
      throw ProgramError(kUsageError, "shot writes .png and .ppm files");
    write_file(file, encode_image(window_.shot(), format, PngEffort::kFast));
  }

  void wait_for_reload() {
    const auto start = Clock::now();
    while (!session_.look_at_files()) {
      if (since(start) > kPatience) throw ProgramError(kUsageError, "wait reload: no file has changed");
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  ViewSession& session_;
  Window window_;
  DrawingEffort effort_;
  Reduction drawn_; // of the picture that is shown
};

int view(const ParsedOptions& parsed) {
  const ProgramOptions& options = *parsed.options;
  const bool named_output = std::any_of(parsed.given.begin(), parsed.given.end(),
                                        [](const GivenOption& option) { return option.name == "--output"; });
  if (named_output && (options.output == "-" || options.output.find('{') != std::string::npos))
    throw ProgramError(kUsageError, "a window saves to one file");
  if (options.threads) ::setenv("SOFTGL_THREADS", std::to_string(options.threads).c_str(), 1);
  const ViewState state = state_of(parsed, models_of(options));
  std::vector<ScriptStep> steps;
  if (!options.script.empty()) {
    const SourceText text = SourceText::open(options.script);
    steps = parse_script(std::string(text.begin(), text.end()), text.name());
  }
  const unsigned threads =
      options.threads ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  ViewSession session(state, named_output ? options.output : "", threads);
  ViewProgram program(session, state);
  return options.script.empty() ? program.run() : program.play(steps);
}

} // namespace

int run_view(int argc, const char* const* argv) {
  std::vector<const char*> words = {"softgl", "view"};
  words.insert(words.end(), argv + 1, argv + argc);
  const bool help = std::any_of(words.begin(), words.end(), [](const char* word) {
    return std::strcmp(word, "--help") == 0 || std::strcmp(word, "-h") == 0;
  });
  try {
    const ParsedOptions parsed = parse_options(int(words.size()), words.data());
    if (parsed.options) return view(parsed);
    if (help && parsed.exit_code == kSuccess) print_keys();
    return parsed.exit_code;
  } catch (const ProgramError& error) {
    std::fprintf(stderr, "softgl: error: %s\n", error.what());
    return error.code;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "softgl: error: %s\n", error.what());
    return kCannotRead;
  }
}

} // namespace softgl::cli
