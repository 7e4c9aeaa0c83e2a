#include "options/compare_options.h"

#include "options/option_kinds.h"
#include "options/option_values.h"

namespace softgl::cli {
namespace {

constexpr const char* kCompareNotes =
    "A difference picture has what differs in red, edges that are ignored in yellow, what the mask leaves "
    "out "
    "darker. Of folders, all pictures are compared by name (PNG, JPEG, BMP, TGA, PPM, PGM, PFM); one that is "
    "missing differs. SSIM is the structural similarity of Wang, Bovik, Sheikh and Simoncelli (2004), 1 "
    "being "
    "the same.\n\n"
    "Exit codes: 0 same, 1 different, 2 wrong usage, 3 a picture cannot be read, 4 a file cannot be written.";

} // namespace

CLI::App* add_compare(CLI::App& app, CompareOptions& options) {
  CLI::App& compare = *app.add_subcommand("compare", "compare two pictures, or the pictures of two folders");
  add_footer(compare,
             {"softgl compare expected.png actual.png",
              "softgl compare a.png b.png diff.png --tolerance 2 --ignore-edges --max-pixels 0.01%",
              "softgl compare golden/ build/pictures/ build/diff/ --junit report.xml"},
             kCompareNotes);
  compare.add_option("first", options.first, "picture or folder")->required()->type_name("EXPECTED");
  compare.add_option("second", options.second, "picture or folder")->required()->type_name("ACTUAL");
  compare
      .add_option("difference", options.difference,
                  "picture of the differences; for folders a folder of such")
      ->type_name("DIFF");
  add_parsed(compare, "--tolerance", "N", "difference of 255 that counts as none; one number, or r,g,b,a [0]",
             [&options](const std::string& text) { options.tolerance = parse_tolerance(text); });
  add_parsed(compare, "--max-pixels", "N",
             "pixels that may differ: a number, or a percentage such as 0.1% [0]",
             [&options](const std::string& text) {
               options.most_pixels_is_percentage = !text.empty() && text.back() == '%';
               options.most_pixels = parse_count_or_percentage(text);
             });
  add_number(compare, "--min-ssim", "X", "same if the mean SSIM is at least this, whatever pixels differ",
             options.least_similarity, -1, 1);
  compare.add_flag("--ignore-edges", options.ignore_edges,
                   "do not count pixels whose colors the other picture has beside them");
  compare.add_option("--mask", options.mask, "compare only where this picture is bright")->type_name("FILE");
  compare
      .add_option("--sheet", options.sheet,
                  "both pictures and their difference side by side; for folders a folder of such")
      ->type_name("FILE");
  compare.add_option("--junit", options.junit, "report for continuous integration, as JUnit XML")
      ->type_name("FILE");
  compare.add_flag("--json", options.json, "print numbers as JSON");
  compare.add_flag("-q,--quiet", options.quiet, "print nothing");
  return &compare;
}

} // namespace softgl::cli
