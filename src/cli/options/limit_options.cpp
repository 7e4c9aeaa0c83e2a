#include "options/limit_options.h"

#include "options/option_kinds.h"

namespace softgl::cli {
namespace {

void add_mebibytes(CLI::App& app, const char* name, const char* description, uint64_t& bytes) {
  app.add_option_function<uint64_t>(
         name, [&bytes](uint64_t mebibytes) { bytes = mebibytes << 20; }, description)
      ->check(range(1, 1e7))
      ->type_name("MIB");
}

} // namespace

void add_limits(CLI::App& app, RunLimits& limits) {
  app.add_flag("--strict-mtl", limits.load.strict_materials,
               "no guesses: Kd 0 0 0 is black, and the alpha of map_Kd no opacity");
  app.add_flag("--allow-any-path", limits.load.any_path, "the model may name files outside of its folder");
  add_mebibytes(app, "--max-input", "refuse larger models [standard input: 256]", limits.input_bytes);
  add_number(app, "--max-triangles", "N", "refuse models of more triangles", limits.load.triangles, 1, 1e12);
  add_mebibytes(app, "--max-memory", "end where more memory is needed", limits.memory_bytes);
  app.add_flag(
      "--sandbox", limits.sandbox,
      "allow the program no other files than the model's folder and the picture's, no network and no "
      "other programs");
  add_number(app, "--timeout", "S", "end after so many seconds", limits.seconds, 0.01, 1e6);
}

} // namespace softgl::cli
