#include "options/command_line.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "common/program_error.h"
#include "image/float_formats.h"
#include "options/batch_options.h"
#include "options/compare_options.h"
#include "options/figure_options.h"
#include "options/help_page.h"
#include "options/light_options.h"
#include "options/limit_options.h"
#include "options/look_options.h"
#include "options/many_options.h"
#include "options/option_kinds.h"
#include "options/option_values.h"
#include "options/taken_settings.h"
#include "options/view_options.h"

#ifndef SOFTGL_VERSION
#define SOFTGL_VERSION "unknown"
#endif

namespace softgl::cli {
namespace {

constexpr int kFigurePart = 400; // pixels a side of each picture: the sheet is then 2072 wide

constexpr const char* kProgramNotes =
    "Exit codes: 0 done, 2 wrong usage, 3 model unreadable or without visible geometry (and any warning with "
    "--strict), 4 picture cannot be written.\n"
    "Settings: SOFTGL_OPT_SIZE=800x600 is --size 800x600, and so for each option; --config FILE has lines "
    "size = 800x600. Environment: SOFTGL_THREADS, SOFTGL_ISA=baseline|v2|v3|v4.";

class HelpFormatter : public CLI::FormatterBase {
public:
  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const override {
    return help_page(describe(*app));
  }
};

// The command line by groups of options, and what follows from them together.
class CommandLine {
public:
  CommandLine()
      : app_("softgl draws OBJ, PLY and STL models with the OpenGL fixed-function pipeline, on the CPU.",
             "softgl") {
    app_.formatter(std::make_shared<HelpFormatter>());
    add_footer(app_,
               {"softgl part.obj -o part.png --up +Z --view front --size 1920x1080 --aa 4",
                "softgl bust.obj -o - --bg transparent --color '#d8c8b0' > bust.png",
                "softgl models/ -o 'thumbs/{model}.png' --size 256x256 --keep-going"},
               kProgramNotes);
    app_.set_version_flag("--version", std::string("softgl ") + SOFTGL_VERSION, "print the version and exit");
    app_.set_help_flag("-h,--help", "print this help and exit");
    app_.option_defaults()->always_capture_default(false);
    start_group(app_, "Picture");
    add_files();
    start_group(app_, "View");
    view_.add_to(app_);
    add_camera_place(app_, options_);
    start_group(app_, "Light");
    light_.add_shading(app_, options_);
    add_lights(app_, options_);
    add_reflectances(app_, options_);
    start_group(app_, "Look");
    add_colors();
    add_look(app_, options_);
    start_group(app_, "Many pictures");
    add_many(app_, options_);
    start_group(app_, "Models of unknown origin");
    add_limits(app_, options_.limits);
    add_number(app_, "--max-size", "N", "refuse pictures wider or higher", options_.limits.picture_side, 1,
               16384);
    start_group(app_, "Run");
    add_effort();
    add_run(app_, "more about the model and what is left out");
    start_group(app_, "Options");
    add_info();
    figure_ = add_figure(app_, options_);
    compare_ = add_compare(app_, options_.compare);
    add_stats(*compare_, "print times to standard error: json", stats_);
    add_window();
    batch_ = add_batch(app_, options_);
    add_config();
  }

  // Throws ProgramError for a mistake, and CLI::Success if it has printed what was asked for.
  ParsedOptions parse(int argc, const char* const* argv) {
    try {
      app_.parse(argc, argv);
      take_settings(app_, config_);
    } catch (const CLI::Success&) { throw; } catch (const CLI::Error& mistake) {
      refuse(one_line(mistake.what()));
    }
    options_.stats = !stats_.empty();
    if (*info_) {
      options_.command = ProgramOptions::kInfo;
      return {options_, 0};
    }
    if (*compare_) {
      options_.command = ProgramOptions::kCompare;
      return {options_, 0};
    }
    if (*batch_) {
      options_.command = ProgramOptions::kBatch;
      refuse(complete_batch(options_));
      return {options_, 0, given()};
    }
    if (*window_) options_.command = ProgramOptions::kView;
    std::string mistake = *figure_ ? complete_figure() : std::string();
    if (mistake.empty()) mistake = complete_output();
    if (mistake.empty()) mistake = complete_rendering();
    refuse(mistake);
    view_.complete(options_);
    refuse(complete_look(options_));
    return {options_, 0, given()};
  }

  // What CLI11 throws for --help and --version.
  int print(const CLI::Success& asked) const { return app_.exit(asked); }

  void let_last_count() {
    for (CLI::Option* option : app_.get_options())
      if (option->get_expected_max() == 1) option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  }

  CommandRow describe_all() const { return describe(app_); }

private:
  void add_files() {
    app_.add_option("model", options_.models,
                    "OBJ, PLY, STL files (also .gz, .zst), folders of them, - for standard input")
        ->type_name("MODEL");
    app_.add_option(
            "-o,--output", options_.output,
            "picture to write (.png .ppm .pam .jpg .bmp .tga .gif .apng .pfm .exr), - for standard output; "
            "{model}, {dir}, {view}, {pass}, {frame} and {n} (its number) in the name stand for themselves")
        ->type_name("FILE");
    app_.add_option("--format", options_.format, "picture format where the file name does not say it")
        ->check(offers(image_formats()))
        ->type_name("NAME");
    add_word(app_, "--png", "HOW", "effort for PNG files: fast, default or small", png_,
             {"fast", "default", "small"});
    add_parsed(
        app_, "-s,--size,--resolution", "WxH", "size of the picture [1024x1024]",
        [this](const std::string& text) { parse_size(text, options_.render.width, options_.render.height); });
  }

  void add_colors() {
    add_parsed(
        app_, "--bg,--bg-color", "COLOR",
        "background: #rrggbb, name, r,g,b from 0 to 1, TOP:BOTTOM, picture:FILE or transparent [#2e333a]",
        [this](const std::string& text) { options_.render.background = parse_background(text); })
        ->check(offers({"transparent"}));
    add_parsed(app_, "--color,--colour", "COLOR", "one color for the whole model instead of its materials",
               [this](const std::string& text) {
                 parse_color(text); // three numbers or a name; one number is no color
                 options_.materials.color = parse_reflectance(text);
               });
  }

  void add_effort() {
    app_.add_option("--aa", samples_, "samples per pixel: 1, 4 or 16 [1]")
        ->check(CLI::IsMember({1, 4, 16}))
        ->type_name("N");
    add_number(app_, "--threads", "N", "threads [as many as the machine has]", options_.threads, 1, 1024);
    add_stats(app_, "print times and counts: json (to standard error with -o -)", stats_);
  }

  void add_run(CLI::App& app, const char* verbose) {
    app.add_flag("--strict", options_.strict, "a warning ends the run with exit code 3");
    app.add_flag("-q,--quiet", options_.quiet, "no warnings");
    app.add_flag("-v,--verbose", options_.verbose, verbose);
  }

  void add_info() {
    info_ = app_.add_subcommand("info", "describe a model instead of drawing it");
    info_
        ->add_option("model", options_.models, "OBJ, PLY or STL file, also .gz or .zst; - for standard input")
        ->required()
        ->expected(1)
        ->type_name("MODEL");
    info_->add_flag("--json", options_.json, "as JSON");
    add_run(*info_, "more about what is left out");
    add_limits(*info_, options_.limits);
    add_number(*info_, "--threads", "N", "threads [as many as the machine has]", options_.threads, 1, 1024);
    add_stats(*info_, "print times to standard error: json", stats_);
    add_footer(*info_,
               {"softgl info part.obj", "softgl info part.obj --json | jq .triangles",
                "softgl info upload.stl --strict --max-triangles 1000000 --timeout 10"},
               "Exit codes: 0 done, 2 wrong usage, 3 model unreadable or without geometry (and any warning "
               "with --strict).");
  }

  // For every command that has options of its own.
  void add_config() {
    const auto add = [this](CLI::App& app, const char* group) {
      app.add_option("--config", config_, "settings for what the command line does not say [the user's own]")
          ->type_name("FILE")
          ->group(group);
    };
    add(app_, "Run");
    for (CLI::App* command : app_.get_subcommands([](const CLI::App*) { return true; }))
      if (!command->get_fallthrough()) add(*command, "Options");
  }

  // The window's program reads the same command line.
  void add_window() {
    window_ = app_.add_subcommand(
        "view", "show models in a window and read them again when their files change; takes "
                "the options of a picture, --size being that of the window [800x600], and "
                "-o the file that key s saves to");
    window_->add_option("model", options_.models, "OBJ, PLY or STL files and folders of them")
        ->type_name("MODEL");
    window_->add_option("--script", options_.script, "play events from this file, then end")
        ->type_name("FILE");
    add_footer(
        *window_,
        {"softgl view lantern.obj", "softgl view parts/ --up +Z --shading phong --edges sharp",
         "softgl view bust.obj --size 1200x900 --light 1,1,1 -o bust.png"},
        "Exit codes: 0 closed, 2 wrong usage, 3 the first model cannot be read, 4 there is no screen.");
    window_->fallthrough();
  }

  std::vector<GivenOption> given() const {
    std::vector<GivenOption> all;
    for (const CLI::Option* option : app_.get_options())
      if (option->count() > 0 && !option->get_positional())
        all.push_back({option->get_name(),
                       option->get_expected_max() > 0 ? option->results() : std::vector<std::string>{}});
    return all;
  }

  static void refuse(const std::string& mistake) {
    if (!mistake.empty()) throw ProgramError(kUsageError, mistake);
  }

  // What follows from the options together. Each gives the sentence about a mistake, or nothing.

  std::string complete_figure() {
    options_.command = ProgramOptions::kFigure;
    RenderOptions& render = options_.render;
    if (render.background.transparent || render.background.below || !render.background.file.empty())
      return "a figure's background has one color";
    if (render.srgb || render.ground || render.lines.edges != Edges::kNone || render.lines.edge_angle ||
        render.lines.style != LineOptions::kSurface || options_.place.eye || !options_.place.file.empty() ||
        !options_.place.output.empty())
      return "a figure has no lines, no ground, no --srgb and no place of the camera";
    if (!app_.count("--size")) render.width = render.height = kFigurePart;
    if (view_.camera.up == UpAxis::kAuto && options_.models.empty()) view_.camera.up = UpAxis::kPlusY;
    if (view_.views.size() > 1 || options_.turntable || options_.sheet_columns ||
        options_.passes != std::vector{Pass::kColor})
      return "a figure is one picture";
    return {};
  }

  std::string complete_output() {
    options_.png = png_ == "fast"    ? PngEffort::kFast
                   : png_ == "small" ? PngEffort::kSmall
                                     : PngEffort::kDefault;
    if (*figure_) return complete_figure_output(options_);
    if (options_.models.empty()) return "no model given";
    if (options_.output.empty() && *window_) options_.output = "view.png";
    if (options_.output.empty()) return "no output file given; -o PICTURE.png names one";
    std::string& format = options_.format;
    if (format.empty()) format = image_format_of(options_.output);
    if (format.empty() && options_.output != "-")
      return "cannot tell the picture format of \"" + options_.output +
             "\"; known are png, ppm, pam, jpg, bmp, tga, gif, apng, pfm and exr";
    if (format.empty()) format = "png";
    if (!is_image_format(format)) return "unknown picture format \"" + format + "\"";
    return complete_many(options_);
  }

  std::string complete_rendering() {
    RenderOptions& render = options_.render;
    if (*figure_ && (render.width > 2048 || render.height > 2048))
      return "a figure's parts are at most 2048 pixels wide and high";
    if (std::string mistake = light_.complete(options_, figure_->parsed()); !mistake.empty()) return mistake;
    const int most = options_.limits.picture_side;
    if (most && std::max(render.width, render.height) > most)
      return "--size asks for more pixels a side than --max-size " + std::to_string(most) + " allows";
    const int side = render.samples_per_side = samples_ == 16 ? 4 : samples_ == 4 ? 2 : 1;
    if (render.width * side > 16384 || render.height * side > 16384)
      return "--aa " + std::to_string(samples_) + " allows pictures of up to " +
             std::to_string(16384 / side) + " pixels a side";
    return {};
  }

  CLI::App app_;
  CLI::App *info_ = nullptr, *figure_ = nullptr, *compare_ = nullptr, *window_ = nullptr, *batch_ = nullptr;
  ProgramOptions options_;
  std::string config_;
  std::string png_ = "default", stats_;
  ViewWords view_;
  LightingWords light_;
  int samples_ = 1;
};

} // namespace

ParsedOptions parse_options(int argc, const char* const* argv) {
  CommandLine line;
  try {
    return line.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return {std::nullopt, line.print(asked)};
  } catch (const ProgramError& mistake) {
    std::fprintf(stderr, "softgl: %s (softgl --help shows the options)\n", mistake.what());
    return {std::nullopt, kUsageError};
  }
}

ProgramOptions parse_picture(const std::vector<std::string>& words) {
  std::vector<const char*> argv = {"softgl"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  CommandLine line;
  line.let_last_count();
  try {
    const ParsedOptions parsed = line.parse(int(argv.size()), argv.data());
    if (parsed.options->command == ProgramOptions::kRender && parsed.options->models.size() == 1)
      return *parsed.options;
  } catch (const CLI::Success&) {}
  throw ProgramError(kUsageError, "these are no options of a picture");
}

CommandRow describe_command_line() { return CommandLine().describe_all(); }

} // namespace softgl::cli
