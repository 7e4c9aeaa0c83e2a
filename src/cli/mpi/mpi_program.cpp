#include "mpi/mpi_program.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <set>
#include <sys/resource.h>
#include <thread>

#include "command/camera_file.h"
#include "command/picture_inputs.h"
#include "command/picture_plan.h"
#include "common/elapsed_time.h"
#include "common/file_writer.h"
#include "image/image_writer.h"
#include "mpi/compositor.h"
#include "mpi/mpi_options.h"
#include "mpi/parts_reader.h"
#include "mpi/ranks.h"
#include "mpi/split_reader.h"
#include "options/command_line.h"
#include "options/help_page.h"
#include "scene/placed_camera.h"

namespace softgl::cli {
namespace {

// What the first rank says while others wait: a line for each step of a run that takes its time.
class StepLines {
public:
  StepLines(const Ranks& ranks, const ProgramOptions& options)
      : ranks_(ranks), verbose_(options.verbose), quiet_(options.quiet) {}

  void done(const std::string& what) {
    const double seconds = seconds_since(start_);
    if (!ranks_.is_first() || quiet_ || !(verbose_ || seconds > 2)) return;
    std::fprintf(stderr, "softgl-mpi: %s after %.1f s\n", what.c_str(), seconds);
  }

private:
  const Ranks& ranks_;
  const bool verbose_, quiet_;
  const Clock::time_point start_ = Clock::now();
};

// Folders become the models in them. The first rank looks, and the others believe it. With their sizes.
std::vector<NumberedText> find_parts(const ProgramOptions& options, const Ranks& ranks) {
  std::vector<NumberedText> parts;
  ranks.together([&] {
    if (!ranks.is_first()) return;
    ProgramOptions each = options;
    each.output = "{n}.png"; // names that nobody uses
    for (const std::string& path : plan_pictures(each).models) {
      std::error_code ignored; // reading it will say it
      const uintmax_t bytes = std::filesystem::file_size(path, ignored);
      parts.push_back({path, ignored ? 0 : uint64_t(bytes)});
    }
  });
  return unpacked(ranks.broadcast(packed(parts)));
}

class MpiProgram {
public:
  MpiProgram(const ProgramOptions& options, const MpiOptions& mpi, const Ranks& ranks)
      : options_(options), mpi_(mpi), ranks_(ranks), lines_(ranks, options) {}

  void run() {
    ranks_.together([&] { read_named_files(options_); });
    const std::vector<NumberedText> files = find_parts(options_, ranks_);
    RankModel parts = read(files);
    lines_.done("read");
    const Camera camera = choose_camera(parts);
    PartSamples samples = draw(parts, camera);
    print_messages(parts);
    ranks_.together([&] {
      if (ranks_.is_first()) write(std::move(samples));
    });
    lines_.done("written");
    describe_ranks(parts);
  }

private:
  static std::string count_of(size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  }

  unsigned threads() const {
    if (options_.threads) return options_.threads;
    return std::max(1u, std::thread::hardware_concurrency() / unsigned(ranks_.on_this_machine()));
  }

  // One file is cut, and more of them are dealt.
  RankModel read(const std::vector<NumberedText>& files) const {
    bool split = false;
    ranks_.together([&] {
      split = ranks_.is_first() && ranks_.count() > 1 && files.size() == 1 && can_split(files.front().text);
    });
    return ranks_.any(split) ? read_split(files.front().text, options_, threads(), ranks_)
                             : read_parts(files, mpi_.deal, options_, threads(), ranks_);
  }

  UpAxis guess_up_axis(const RankModel& parts) const {
    const UpEvidence evidence = parts.up_evidence(ranks_);
    const bool z = z_is_up(evidence);
    if (ranks_.is_first() && options_.verbose)
      std::fprintf(stderr, "softgl-mpi: note: what speaks for +Z (positive) and +Y: %s\n",
                   as_text(evidence).c_str());
    if (ranks_.is_first() && z && !options_.quiet)
      std::fputs("softgl-mpi: note: turned: its +Z seems to point up (--up +Y draws it as it is)\n", stderr);
    return z ? UpAxis::kPlusZ : UpAxis::kPlusY;
  }

  Camera choose_camera(const RankModel& parts) {
    Camera camera{};
    CameraOptions view = options_.views.front().camera;
    if (view.up == UpAxis::kAuto) view.up = guess_up_axis(parts);
    const CameraPoints points = parts.points(ranks_);
    try { // all ranks find the same camera, or the same mistake
      camera = view.placement ? place_camera(points, view, parts.frame) : fit_camera(points, view);
    } catch (const ProgramError& error) { throw SharedError(error.code, error.what()); }
    ranks_.together([&] {
      if (ranks_.is_first() && !options_.place.output.empty())
        write_camera(options_.place.output, placement_of(camera, parts.frame));
    });
    return camera;
  }

  PartSamples draw(RankModel& parts, const Camera& camera) {
    options_.render.pass = options_.passes.front();
    const bool interleaved = parts.is_interleaved(ranks_), lines = parts.lines_on_surfaces(ranks_);
    std::unique_ptr<PartRenderer> renderer;
    PartSamples samples;
    ranks_.together([&] {
      std::vector<Warnings> warnings(parts.meshes().size());
      renderer =
          std::make_unique<PartRenderer>(parts.meshes(), parts.frame, options_.render, interleaved, warnings);
      for (size_t i = 0; i < warnings.size(); ++i) parts.messages[i].warnings.add_new(warnings[i]);
      if (const Material* material = renderer->transparent_material())
        throw ProgramError(kCannotRead, "material \"" + printable(material->name) +
                                            "\" is transparent, and only opaque parts are composed; --color "
                                            "COLOR draws all of it opaque");
      samples = renderer->draw(camera, parts.steps, lines);
    });
    lines_.done("drawn");
    bool visible = false;
    samples = compose_samples(std::move(samples), mpi_.radix, ranks_, visible);
    if (!visible) {
      ranks_.together([&] { samples = renderer->draw_edges(camera); });
      samples = compose_samples(std::move(samples), mpi_.radix, ranks_, visible);
      as_wireframe_ = visible;
    }
    if (!visible)
      throw SharedError(kCannotRead, "nothing of the model is visible in this view; no picture written");
    lines_.done("composed");
    return samples;
  }

  // All that ranks have to say, in the order of the parts.
  void print_messages(RankModel& parts) {
    uint64_t count = 0;
    std::string text;
    for (const PartMessages& part : parts.messages) {
      count += part.warnings.count();
      const auto add = [&](const char* kind, const std::vector<std::string>& sentences) {
        for (const std::string& sentence : sentences)
          text += packed({{"softgl-mpi: " + std::string(kind) + sentence + "\n", part.number}});
      };
      if (!options_.quiet) add("warning: ", part.warnings.sentences());
      if (options_.verbose) add("note: ", part.notes.sentences());
    }
    std::vector<NumberedText> lines;
    for (const std::string& rank : ranks_.gather(text))
      for (NumberedText& line : unpacked(rank)) lines.push_back(std::move(line));
    std::stable_sort(lines.begin(), lines.end(),
                     [](const NumberedText& a, const NumberedText& b) { return a.number < b.number; });
    std::set<std::string> said; // several ranks may find the same
    for (const NumberedText& line : lines)
      if (said.insert(line.text).second) std::fputs(line.text.c_str(), stderr);
    if (ranks_.is_first() && !options_.quiet) print_own_warnings();
    count = ranks_.sum(count) + as_wireframe_ + without_transparency();
    if (options_.strict && count > 0)
      throw SharedError(kCannotRead, std::to_string(count) + (count == 1 ? " warning" : " warnings") +
                                         " with --strict; no picture written");
  }

  bool without_transparency() const {
    return options_.render.background.transparent && !has_alpha(options_.format);
  }

  void print_own_warnings() const {
    if (without_transparency())
      std::fprintf(stderr,
                   "softgl-mpi: warning: pictures of format %s have no transparency; the background "
                   "is white\n",
                   options_.format.c_str());
    if (as_wireframe_)
      std::fputs("softgl-mpi: warning: its surfaces have no visible area in this view; their edges are drawn "
                 "instead\n",
                 stderr);
  }

  void write(PartSamples samples) const {
    const Picture picture = picture_of(std::move(samples), options_.render);
    write_file(options_.output, encode_image(picture, options_.format, options_.png));
  }

  void describe_ranks(const RankModel& parts) const {
    if (!options_.verbose) return;
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const std::string line =
        count_of(parts.models.size(), "part") + ", " + count_of(parts.triangles(), "triangle") + ", " +
        count_of(ranks_.sent_messages(), "message") + " of " + std::to_string(ranks_.sent_bytes()) +
        " bytes sent, at most " + std::to_string(usage.ru_maxrss / 1024) + " MiB of memory";
    const std::vector<std::string> lines = ranks_.gather(line);
    for (size_t rank = 0; rank < lines.size(); ++rank)
      std::fprintf(stderr, "softgl-mpi: rank %zu: %s\n", rank, lines[rank].c_str());
  }

  ProgramOptions options_;
  const MpiOptions& mpi_;
  const Ranks& ranks_;
  StepLines lines_;
  bool as_wireframe_ = false;
};

void say(const char* sentence) { std::fprintf(stderr, "softgl-mpi: error: %s\n", sentence); }

// The first rank reads the command line first: what it has to say about it is said once.
int run(int argc, const char* const* argv, const Ranks& ranks) {
  const MpiOptions mpi = take_mpi_options(argc, argv);
  ParsedOptions parsed;
  const auto parse = [&] { parsed = parse_options(int(mpi.words.size()), mpi.words.data()); };
  if (std::any_of(mpi.words.begin(), mpi.words.end(), [](const char* word) {
        return std::strcmp(word, "--help") == 0 || std::strcmp(word, "-h") == 0;
      })) {
    if (ranks.is_first()) std::fputs(help_page(describe_mpi()).c_str(), stdout);
    return kSuccess;
  }
  if (ranks.is_first()) parse();
  const std::string end =
      ranks.broadcast(parsed.options || !ranks.is_first() ? "" : std::to_string(parsed.exit_code));
  if (!end.empty()) return std::stoi(end);
  if (!ranks.is_first()) parse();
  if (!parsed.options) ranks.abort(kUsageError); // it has said why
  refuse_what_is_not_drawn(*parsed.options);
  if (parsed.options->threads || ranks.on_this_machine() > 1) {
    const unsigned share =
        std::max(1u, std::thread::hardware_concurrency() / unsigned(ranks.on_this_machine()));
    const unsigned threads = parsed.options->threads ? parsed.options->threads : share;
    ::setenv("SOFTGL_THREADS", std::to_string(threads).c_str(), 1);
  }
  MpiProgram(*parsed.options, mpi, ranks).run();
  return kSuccess;
}

} // namespace

int run_mpi(int argc, const char* const* argv) {
  const Ranks ranks;
  try {
    return run(argc, argv, ranks);
  } catch (const SharedError& error) {
    if (ranks.is_first()) say(error.what());
    return error.code;
  } catch (const ProgramError& error) { // the command line's, the same in every rank
    if (ranks.is_first()) say(error.what());
    return error.code;
  } catch (const std::bad_alloc&) { // between calls to the other ranks, which wait
    say(("not enough memory in rank " + std::to_string(ranks.rank())).c_str());
    ranks.abort(kCannotRead);
  } catch (const std::exception& error) {
    say(error.what());
    ranks.abort(kCannotRead);
  }
}

} // namespace softgl::cli
