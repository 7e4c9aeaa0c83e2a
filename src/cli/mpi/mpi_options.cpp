#include "mpi/mpi_options.h"

#include <cstdlib>
#include <cstring>

#include "common/program_error.h"
#include "image/float_formats.h"

namespace softgl::cli {
namespace {

[[noreturn]] void refuse(const std::string& sentence) {
  throw ProgramError(kUsageError, "softgl-mpi: " + sentence);
}

// The value of `--name VALUE` or `--name=VALUE`; null if this word is another one.
const char* value_of(const char* name, int argc, const char* const* argv, int& i) {
  const size_t length = std::strlen(name);
  if (std::strncmp(argv[i], name, length) != 0) return nullptr;
  if (argv[i][length] == '=') return argv[i] + length + 1;
  if (argv[i][length] != '\0') return nullptr;
  if (i + 1 == argc) refuse(std::string(name) + " needs a value");
  return argv[++i];
}

} // namespace

MpiOptions take_mpi_options(int argc, const char* const* argv) {
  MpiOptions options;
  options.words.push_back("softgl");
  for (int i = 1; i < argc; ++i) {
    if (const char* how = value_of("--deal", argc, argv, i)) {
      if (std::strcmp(how, "blocks") != 0 && std::strcmp(how, "turns") != 0)
        refuse("--deal is blocks or turns, not \"" + std::string(how) + "\"");
      options.deal = std::strcmp(how, "turns") == 0 ? Deal::kTurns : Deal::kBlocks;
    } else if (const char* number = value_of("--radix", argc, argv, i)) {
      options.radix = std::atoi(number);
      if (options.radix < 2 || options.radix > 64) refuse("--radix is a number from 2 to 64");
    } else {
      options.words.push_back(argv[i]);
    }
  }
  return options;
}

CommandRow describe_mpi() {
  CommandRow row;
  row.program = "softgl-mpi";
  row.text = "softgl-mpi draws one picture with several processes, each of which reads and draws a part of "
             "the models.";
  OptionRow models, deal, radix;
  models.names = {"model"};
  models.value = "MODEL";
  models.text = "OBJ, PLY, STL files (also .gz, .zst) and folders of them: the parts of what the picture "
                "shows; a single "
                "OBJ file is cut into as many as there are processes";
  models.required = models.many = models.file = true;
  deal.names = {"--deal"};
  deal.value = "HOW";
  deal.text = "which process gets a part: blocks, neighbors in the list, or turns [blocks]";
  deal.choices = {"blocks", "turns"};
  deal.any_value = false;
  radix.names = {"--radix"};
  radix.value = "N";
  radix.text =
      "processes that exchange pixels at once, 2 to 64; 2 is binary swap [by the number of processes]";
  deal.group = radix.group = "Options";
  row.operands = {models};
  row.options = {deal, radix};
  row.takes_program_options = true;
  row.examples = {"mpirun -n 4 softgl-mpi parts/*.obj -o out.png",
                  "srun -n 64 softgl-mpi scan.obj -o scan.png --bg white",
                  "mpirun -n 8 softgl-mpi city/ -o city.png --deal turns --verbose"};
  row.notes = "The picture has the bytes of one process's, whatever the number of processes.\n"
              "Refused: several pictures, turns and sheets, passes but the color, pictures of floats, --bits "
              "16, --srgb, "
              "--ground, lines and points, --sandbox, --timeout, --max-memory, --stats and standard input.\n"
              "Exit codes: 0 done, 2 wrong usage, 3 a model is unreadable or nothing is visible, 4 the "
              "picture cannot be "
              "written.";
  return row;
}

void refuse_what_is_not_drawn(const ProgramOptions& options) {
  const RenderOptions& render = options.render;
  if (options.command != ProgramOptions::kRender) refuse("it draws pictures and has no commands");
  for (const std::string& model : options.models)
    if (model == "-") refuse("every process reads files, and none standard input");
  if (options.turntable || options.sheet_columns || options.views.size() > 1 || options.passes.size() > 1 ||
      options.skip_existing || options.keep_going || options.output.find('{') != std::string::npos)
    refuse("one run draws one picture of one view");
  if (is_data(render.pass) || is_data(options.passes.front()) || options.passes.front() == Pass::kCoverage)
    refuse("only colors are composed, not --pass " + std::string(name_of(options.passes.front())));
  if (render.values != Values::kBytes || is_float_format(options.format) || render.srgb)
    refuse("colors are composed as bytes: no --bits 16, --srgb or format of floats");
  if (is_animation(options.format)) refuse("one run draws one picture and no animation");
  if (render.ground) refuse("the shadow of --ground needs the whole model in one process");
  if (render.lines.style != LineOptions::kSurface || render.lines.edges != Edges::kNone)
    refuse("it draws surfaces: no --edges, --wireframe or --points");
  if (options.limits.sandbox || options.limits.seconds > 0 || options.limits.memory_bytes)
    refuse("limits are those of the batch system: no --sandbox, --timeout or --max-memory");
  if (options.stats) refuse("no --stats; --verbose says what each process does");
}

} // namespace softgl::cli
