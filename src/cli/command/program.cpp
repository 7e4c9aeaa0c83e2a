#include "command/program.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <new>
#include <sys/resource.h>
#include <thread>

#include "command/figure.h"
#include "command/model_loader.h"
#include "command/options.h"
#include "common/compressed_text.h"
#include "common/program_error.h"
#include "common/time_limit.h"
#include "mesh/face_triangulation.h"
#include "scene/up_axis.h"

namespace softgl::cli {
namespace {

using Clock = std::chrono::steady_clock;
double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

class Program {
public:
  explicit Program(const ProgramOptions& options) : options_(options) {}

  int run() {
    const auto start = Clock::now();
    if (options_.command == ProgramOptions::kCompare) {
      CompareOptions compare = options_.compare;
      compare.threads = threads();
      return run_compare(compare);
    }
    if (options_.command == ProgramOptions::kFigure && options_.model.empty()) {
      FigureSubject sphere = sphere_subject(options_.camera);
      override_reflectances(sphere.materials);
      write(draw_figure(sphere, options_.render, warnings_));
      return kSuccess;
    }
    const SourceText text = open_text(options_.model, options_.limits.input_bytes);
    RemarkList remarks;
    LoadedModel loaded = load_model(text, threads(), remarks, warnings_, notes_, options_.limits.load);
    times_.read = since(start);
    if (options_.command == ProgramOptions::kInfo) {
      info(loaded, text, remarks);
    } else {
      draw(loaded, text, remarks, start);
    }
    return options_.strict && warnings_.count() > 0 ? kCannotRead : kSuccess;
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
  unsigned threads() const {
    if (options_.threads) return options_.threads;
    const unsigned count = std::thread::hardware_concurrency();
    return count ? count : 1;
  }

  void info(LoadedModel& loaded, const SourceText& text, RemarkList& remarks) {
    const ModelFrame frame = frame_model(loaded.model);
    note_bounds(loaded.report, frame);
    loaded.report.area = surface_area(loaded.model);
    build_mesh_for_remarks(loaded, frame, remarks);
    warnings_.add(remarks, text);
    const std::string out = options_.json ? as_json(loaded.report, warnings_) : as_text(loaded.report);
    print(out, stdout);
  }

  static void note_bounds(ModelReport& report, const ModelFrame& frame) {
    for (int axis = 0; axis < 3; ++axis) {
      report.low[axis] = frame.low[axis];
      report.high[axis] = frame.high[axis];
    }
  }

  static void print(const std::string& text, std::FILE* file) {
    if (std::fwrite(text.data(), 1, text.size(), file) != text.size() || std::fflush(file) != 0)
      throw ProgramError(kCannotWrite, "standard output: cannot write");
  }

  // Materials are only looked up while the mesh is built.
  void build_mesh_for_remarks(LoadedModel& loaded, const ModelFrame& frame, RemarkList& remarks) const {
    MeshOptions mesh_options;
    mesh_options.flat = true;
    build_mesh(loaded.model, frame, loaded.library, mesh_options, remarks);
  }

  void draw(LoadedModel& loaded, const SourceText& text, RemarkList& remarks, Clock::time_point start) {
    const auto prepare_start = Clock::now();
    ObjModel& model = loaded.model;
    paint_over(loaded);
    const bool flat = options_.render.lighting.shading == Shading::kFlat;
    ModelFrame frame = frame_model(model);
    note_bounds(loaded.report, frame);
    if (options_.verbose) loaded.report.area = surface_area(model);
    if (!flat) generate_normals(model, frame, options_.normals);
    MeshOptions mesh_options;
    mesh_options.flat = flat;
    mesh_options.with_texcoords = loaded.report.textures > 0 && !options_.materials.color;
    Mesh mesh = build_mesh(model, frame, loaded.library, mesh_options, remarks);
    model = ObjModel(); // the mesh is all that is needed from here on
    warnings_.add(remarks, text);
    CameraOptions camera_options = options_.camera;
    if (camera_options.up == UpAxis::kAuto) camera_options.up = guess_up_axis(mesh, frame, loaded, text);
    notes_.add(text.name(), std::string("up is ") + name_of(camera_options.up));
    const Camera camera = fit_camera(mesh, camera_options);
    times_.prepare = since(prepare_start);

    Picture picture;
    if (options_.command == ProgramOptions::kFigure) {
      const auto subject = model_subject(text.name(), std::move(mesh), std::move(loaded.library.materials()),
                                         std::move(frame), camera);
      picture = draw_figure(subject, options_.render, warnings_);
    } else {
      picture = draw_picture(mesh, loaded.library.materials(), frame, camera, text.name());
    }
    refuse_warnings(text.name());
    const auto write_start = Clock::now();
    write(picture);
    times_.write = since(write_start);
    times_.total = since(start);
    if (options_.stats) print_stats(loaded.report);
    if (options_.verbose) std::fputs(as_text(loaded.report).c_str(), stderr);
  }

  UpAxis guess_up_axis(const Mesh& mesh, const ModelFrame& frame, const LoadedModel& loaded,
                       const SourceText& text) {
    const std::string_view comments =
        loaded.report.format == std::string_view("STL")
            ? "# STL"
            : std::string_view(text.begin(), std::min<size_t>(text.size(), 4096));
    const UpEvidence evidence = up_evidence(mesh, frame, loaded.library.materials(), comments);
    notes_.add(text.name(), "what speaks for +Z (positive) and +Y: " + as_text(evidence));
    if (!z_is_up(evidence)) return UpAxis::kPlusY;
    warnings_.add_notice(text.name(), "turned: its +Z seems to point up (--up +Y draws it as it is)");
    return UpAxis::kPlusZ;
  }

  Picture draw_picture(const Mesh& mesh, const std::vector<Material>& materials, const ModelFrame& frame,
                       const Camera& camera, const std::string& name) {
    if (options_.render.background.transparent && !has_alpha(options_.format))
      warnings_.add(options_.output == "-" ? "standard output" : options_.output,
                    "pictures of format " + options_.format +
                        " have no transparency; the background is white");
    RenderResult result = render(mesh, materials, frame, camera, options_.render, warnings_);
    times_.upload = result.upload_seconds;
    times_.draw = result.draw_seconds;
    times_.average = result.average_seconds;
    if (!result.visible)
      throw ProgramError(kCannotRead,
                         name + ": nothing of the model is visible in this view; no picture written");
    if (result.as_wireframe)
      warnings_.add(name,
                    result.transparent
                        ? "nothing of it shows because its materials are transparent (d, Tr or map_d); its "
                          "edges are drawn instead"
                        : "its surfaces have no visible area in this view; their edges are drawn instead");
    return std::move(result.picture);
  }

  void refuse_warnings(const std::string& name) const {
    if (!options_.strict || warnings_.count() == 0) return;
    throw ProgramError(kCannotRead, name + ": " + std::to_string(warnings_.count()) +
                                        (warnings_.count() == 1 ? " warning" : " warnings") +
                                        " with --strict; no picture written");
  }

  void write(const Picture& picture) const {
    write_file(options_.output, encode_image(picture, options_.format, options_.png));
  }

  void paint_over(LoadedModel& loaded) const {
    const MaterialOptions& chosen = options_.materials;
    if (chosen.color || chosen.ambient || chosen.diffuse) loaded.model.colors.release();
    if (chosen.color)
      for (Material& material : loaded.library.materials()) {
        replace(chosen.color, material.ambient);
        replace(chosen.color, material.diffuse);
        for (float& value : material.emission) value = 0;
        material.diffuse_map = {};
        material.opacity_map = {};
        material.opacity = 1;
      }
    override_reflectances(loaded.library.materials());
  }

  void override_reflectances(std::vector<Material>& materials) const {
    const MaterialOptions& chosen = options_.materials;
    for (Material& material : materials) {
      replace(chosen.ambient, material.ambient);
      replace(chosen.diffuse, material.diffuse);
      replace(chosen.specular, material.specular);
      material.shininess = chosen.shininess.value_or(material.shininess);
    }
  }

  static void replace(const MaterialOptions::Reflectance& chosen, float* reflectance) {
    if (chosen) std::copy(chosen->begin(), chosen->end(), reflectance);
  }

  void print_stats(const ModelReport& report) {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    times_.peak_kib = usage.ru_maxrss;
    times_.cpu = double(std::clock()) / CLOCKS_PER_SEC;
    const std::string out =
        stats_as_json(report, times_, options_.render.width, options_.render.height, warnings_);
    print(out, options_.output == "-" ? stderr : stdout);
  }

  const ProgramOptions& options_;
  Warnings warnings_, notes_;
  RunTimes times_;
};

void start_limits(const RunLimits& limits) {
  if (limits.seconds > 0) start_time_limit(limits.seconds);
  if (limits.memory_bytes == 0) return;
  // What is allocated, and not what is merely mapped: libraries and the model's file do not count.
  const rlimit memory{limits.memory_bytes, limits.memory_bytes};
  if (::setrlimit(RLIMIT_DATA, &memory) != 0)
    throw ProgramError(kUsageError, "--max-memory: the system does not allow this limit");
}

} // namespace

int run_program(int argc, const char* const* argv) {
  const char* name = "";
  const auto fail = [](ExitCode code, const char* about, const char* sentence) {
    std::fprintf(stderr, "softgl: error: %s%s\n", about, sentence);
    return code;
  };
  ParsedOptions parsed;
  try {
    parsed = parse_options(argc, argv);
    if (!parsed.options) return parsed.exit_code;
    name = parsed.options->model.c_str();
    if (parsed.options->threads)
      ::setenv("SOFTGL_THREADS", std::to_string(parsed.options->threads).c_str(), 1);
    start_limits(parsed.options->limits);
    Program program(*parsed.options);
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
