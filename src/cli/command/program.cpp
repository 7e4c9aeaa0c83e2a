#include "command/program.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <sys/resource.h>
#include <thread>

#include "command/batch.h"
#include "command/compare.h"
#include "command/figure.h"
#include "command/model_loader.h"
#include "command/picture_run.h"
#include "command/prepared_model.h"
#include "command/sandbox_paths.h"
#include "command/window_start.h"
#include "common/compressed_text.h"
#include "common/elapsed_time.h"
#include "common/file_writer.h"
#include "common/program_error.h"
#include "common/time_limit.h"
#include "mesh/face_triangulation.h"
#include "options/command_line.h"

namespace softgl::cli {
namespace {

class Program {
public:
  Program(const ProgramOptions& options, const std::vector<GivenOption>& given)
      : options_(options), given_(given) {}

  int run() {
    switch (options_.command) {
    case ProgramOptions::kBatch: return run_batch(options_, given_, threads());
    case ProgramOptions::kCompare: return compare();
    case ProgramOptions::kFigure: return measured(&Program::figure, "draw", options_.output == "-");
    case ProgramOptions::kInfo: return measured(&Program::info, "measure", true);
    case ProgramOptions::kView: return no_window();
    default: return draw_pictures(options_, threads());
    }
  }

  void print_messages() const {
    if (!options_.quiet)
      for (const std::string& sentence : warnings_.sentences())
        std::fprintf(stderr, "softgl: warning: %s\n", sentence.c_str());
    if (!options_.quiet)
      for (const std::string& sentence : warnings_.notices())
        std::fprintf(stderr, "softgl: note: %s\n", sentence.c_str());
    if (options_.verbose)
      for (const std::string& sentence : notes_.sentences())
        std::fprintf(stderr, "softgl: note: %s\n", sentence.c_str());
  }

private:
  // softgl-view draws in its window.
  static int no_window() {
    throw ProgramError(kUsageError,
                       "no window: softgl view MODEL starts softgl-view, which is built where there is "
                       "SDL 2");
  }

  unsigned threads() const {
    if (options_.threads) return options_.threads;
    const unsigned count = std::thread::hardware_concurrency();
    return count ? count : 1;
  }

  // --stats of a command that reads at most one model: reading, preparing, and all the rest under the given
  // name.
  int measured(int (Program::*command)(), const char* rest, bool to_errors) {
    const auto start = Clock::now();
    const int code = (this->*command)();
    if (!options_.stats) return code;
    const double total = seconds_since(start);
    const double known = times_.read + times_.prepare;
    print_text("{\n" +
                   usage_as_json({{"read", times_.read},
                                  {"prepare", times_.prepare},
                                  {rest, total - known},
                                  {"total", total}}) +
                   "\n}\n",
               to_errors ? stderr : stdout);
    return code;
  }

  int compare() const {
    CompareOptions compare = options_.compare;
    compare.threads = threads();
    compare.stats = options_.stats;
    return run_compare(compare);
  }

  int info() {
    const auto start = Clock::now();
    const SourceText text = open_text(options_.models.front(), options_.limits.input_bytes);
    RemarkList remarks;
    LoadedModel loaded = load_model(text, threads(), remarks, warnings_, notes_, options_.limits.load);
    times_.read = seconds_since(start);
    const ModelFrame frame = frame_model(loaded.model);
    note_bounds(frame, loaded.report);
    loaded.report.area = surface_area(loaded.model);
    measure_surface(loaded, frame, remarks);
    warnings_.add(remarks, text);
    print_text(options_.json ? as_json(loaded.report, warnings_) : as_text(loaded.report), stdout);
    return options_.strict && warnings_.count() > 0 ? kCannotRead : kSuccess;
  }

  // Materials are only looked up while the mesh is built.
  static void measure_surface(LoadedModel& loaded, const ModelFrame& frame, RemarkList& remarks) {
    MeshOptions mesh_options;
    mesh_options.flat = true;
    const Mesh mesh = build_mesh(loaded.model, frame, loaded.library, mesh_options, remarks);
    ModelReport& report = loaded.report;
    report.surface = report_surface(mesh, frame);
    for (const MaterialPart& part : report.surface->parts) {
      const std::string& name = loaded.library.materials()[part.material].name;
      report.material_names.push_back(name.empty() ? "(default)" : printable(name));
    }
  }

  int figure() {
    if (options_.figure.list) {
      print_text(list_of_figures(options_.figure.language), stdout);
      return kSuccess;
    }
    CameraOptions view = options_.views.front().camera;
    if (options_.models.empty()) {
      FigureSubject sphere = sphere_subject(view);
      override_reflectances(options_.materials, sphere.materials);
      write_figures(sphere);
      return kSuccess;
    }
    PreparedModel model =
        prepare_model(options_.models.front(), options_, threads(), warnings_, notes_, times_);
    if (view.up == UpAxis::kAuto) view.up = model.up;
    const Camera camera = fit_camera(model.mesh, view);
    write_figures(model_subject(model.name, std::move(model.mesh), std::move(model.materials),
                                std::move(model.frame), camera));
    if (options_.verbose) std::fputs(as_text(model.report).c_str(), stderr);
    return kSuccess;
  }

  void write_figures(const FigureSubject& subject) {
    const std::vector<FigureFile> files = draw_figures(subject, options_, threads(), warnings_);
    refuse_warnings(subject.name);
    if (options_.figure.folder) {
      std::error_code ignored; // writing the files will say it
      std::filesystem::create_directories(options_.output, ignored);
    }
    for (const FigureFile& file : files) write_file(file.path, file.bytes);
  }

  void refuse_warnings(const std::string& name) const {
    if (!options_.strict || warnings_.count() == 0) return;
    throw ProgramError(kCannotRead, name + ": " + std::to_string(warnings_.count()) +
                                        (warnings_.count() == 1 ? " warning" : " warnings") +
                                        " with --strict; no picture written");
  }

  const ProgramOptions& options_;
  const std::vector<GivenOption>& given_;
  Warnings warnings_, notes_;
  RunTimes times_;
};

// The processes of a batch have a time limit for each job, and a sandbox each.
void start_limits(const ProgramOptions& options) {
  const RunLimits& limits = options.limits;
  if (limits.seconds > 0 && options.command != ProgramOptions::kBatch) start_time_limit(limits.seconds);
  if (limits.memory_bytes == 0) return;
  // What is allocated, and not what is merely mapped: libraries and the model's file do not count.
  const rlimit memory{limits.memory_bytes, limits.memory_bytes};
  if (::setrlimit(RLIMIT_DATA, &memory) != 0)
    throw ProgramError(kUsageError, "--max-memory: the system does not allow this limit");
}

void start_sandbox(const ProgramOptions& options) {
  if (!options.limits.sandbox || options.command == ProgramOptions::kBatch) return;
  for (const std::string& lacking : enter_sandbox(sandbox_paths(options)))
    if (options.verbose) std::fprintf(stderr, "softgl: note: %s\n", lacking.c_str());
}

} // namespace

int run_program(int argc, const char* const* argv) {
  if (argc > 1 && std::strcmp(argv[1], "view") == 0) start_window(argc - 2, argv + 2);
  const char* name = "";
  const auto fail = [](ExitCode code, const char* about, const char* sentence) {
    std::fprintf(stderr, "softgl: error: %s%s\n", about, sentence);
    return code;
  };
  ParsedOptions parsed;
  try {
    parsed = parse_options(argc, argv);
    if (!parsed.options) return parsed.exit_code;
    if (parsed.options->models.size() == 1) name = parsed.options->models.front().c_str();
    if (parsed.options->threads)
      ::setenv("SOFTGL_THREADS", std::to_string(parsed.options->threads).c_str(), 1);
    start_limits(*parsed.options);
    start_sandbox(*parsed.options);
    Program program(*parsed.options, parsed.given);
    try {
      const int code = program.run();
      program.print_messages();
      return code;
    } catch (...) {
      program.print_messages();
      throw;
    }
  } catch (const ProgramError& error) {
    return fail(error.code, "", error.what());
  } catch (const std::bad_alloc&) {
    return fail(kCannotRead, name, *name ? ": not enough memory" : "not enough memory");
  } catch (const std::exception& error) { return fail(kCannotRead, "", error.what()); }
}

} // namespace softgl::cli
