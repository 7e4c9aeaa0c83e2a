#include "options/many_options.h"

#include "image/float_formats.h"
#include "image/gif_encoder.h"
#include "options/option_kinds.h"
#include "options/option_values.h"

namespace softgl::cli {

void add_many(CLI::App& app, ProgramOptions& options) {
  add_parsed(app, "--pass", "LIST",
             "color, depth, normal, uv, id (materials), ambient, diffuse, specular, emission or "
             "coverage (a mask); several with commas and {pass} [color]",
             [&options](const std::string& text) { options.passes = parse_passes(text); })
      ->check(offers(pass_names()));
  app.add_option("--bits", options.bits, "bits of a channel of a .png: 8 or 16 [8]")
      ->check(CLI::IsMember({8, 16}))
      ->type_name("N");
  add_number(app, "--turntable", "N",
             "N pictures around the model: by {frame}, as one .gif or .apng, or raw to -", options.turntable,
             2, 10000);
  add_number(app, "--fps", "N", "frames a second of a .gif or .apng, 1 to 100 [25]",
             options.frames_per_second, 1, 100);
  add_parsed(
      app, "--sheet", "CxR", "contact sheets of C columns and R rows, by {page}; C alone: one sheet",
      [&options](const std::string& text) { parse_sheet(text, options.sheet_columns, options.sheet_rows); });
  app.add_flag("--recursive", options.recursive, "also the models in folders within folders");
  app.add_flag("--skip-existing", options.skip_existing, "do not draw pictures whose files are there");
  app.add_flag("--keep-going", options.keep_going,
               "draw the others when one fails; the exit code is that of the first");
}

std::string complete_many(ProgramOptions& options) {
  if (options.format == "exr" && !can_write_exr())
    return "this softgl was built without tinyexr and writes no OpenEXR; pfm is another format of floats";
  if (options.bits == 16 && (options.format != "png" || options.sheet_columns))
    return "--bits 16 is for .png pictures; .pfm and .exr have floats";
  if (is_float_format(options.format) && options.sheet_columns) return "a sheet has no floats";
  options.render.values = is_float_format(options.format) ? Values::kFloats
                          : options.bits == 16            ? Values::kWords
                                                          : Values::kBytes;
  if (options.format == "gif" && !can_write_gif())
    return "this softgl was built without giflib and writes no GIF; apng is another format";
  if (is_animation(options.format) && options.sheet_columns) return "a sheet is no animation";
  return {};
}

} // namespace softgl::cli
