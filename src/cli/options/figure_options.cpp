#include "options/figure_options.h"

#include <algorithm>
#include <filesystem>

#include "figure/figure_list.h"
#include "image/float_formats.h"
#include "image/image_writer.h"
#include "options/option_kinds.h"

namespace softgl::cli {
namespace {

std::string notes() {
  std::string names;
  for (const FigureKind& kind : figure_kinds()) (names += names.empty() ? "" : ", ") += kind.name;
  return "Figures: " + names + ".\n" + R"(-o lecture.html: all figures, or those that are named, in one file.
-o cosine.svg, cosine.png: one figure.
-o figures/: a file for each figure in a folder; --format svg, png or html [svg].
-o sheet.png and no name: pictures of the sphere or the model on one sheet.
--size is that of each picture [400x400]. Highlights have the reflection vector, unless --specular half says otherwise.
Exit codes are those of softgl.)";
}

// Names of figures and at most one model.
std::string sort_words(ProgramOptions& options) {
  FigureOptions& figure = options.figure;
  for (const std::string& word : figure.words) {
    if (word == "all")
      for (const FigureKind& kind : figure_kinds()) figure.names.emplace_back(kind.name);
    else if (find_figure(word))
      figure.names.push_back(word);
    else if (word != "-" && word.find_first_of("./") == std::string::npos && !std::filesystem::exists(word))
      return "no figure is called \"" + word + "\"; softgl figure --list shows all";
    else
      options.models.push_back(word);
  }
  if (options.models.size() > 1) return "a figure shows one model";
  return {};
}

bool ends_with(const std::string& text, const char* end) { return text.ends_with(end); }

} // namespace

CLI::App* add_figure(CLI::App& app, ProgramOptions& options) {
  FigureOptions& figure = options.figure;
  CLI::App* command = app.add_subcommand(
      "figure", "the figures of a lecture on Phong's illumination model: each by its name, or all of them");
  command
      ->add_option("what", figure.words,
                   "names of figures, or all; and a model for those that show one [a sphere]")
      ->type_name("NAME|MODEL.obj");
  command->add_flag("--list", figure.list, "list the figures");
  command
      ->add_option_function<std::string>(
          "--lang",
          [&figure](const std::string& word) {
            figure.language = word == "de" ? Language::kGerman : Language::kEnglish;
          },
          "language: de or en [that of LC_ALL, LC_MESSAGES or LANG, else en]")
      ->check(one_of({"de", "en"}))
      ->type_name("LANG");
  add_footer(*command,
             {"softgl figure -o lecture.html", "softgl figure cosine -o cosine.svg --lang de",
              "softgl figure all bust.obj -o figures/ --format png --size 600x600"},
             notes().c_str());
  command->fallthrough();
  return command;
}

std::string complete_figure_output(ProgramOptions& options) {
  FigureOptions& figure = options.figure;
  std::string mistake = sort_words(options);
  if (!mistake.empty() || figure.list) return mistake;
  const std::string& output = options.output;
  std::string& format = options.format;
  if (output.empty()) return "no output file given; -o lecture.html names one";
  std::error_code none;
  figure.folder = ends_with(output, "/") || std::filesystem::is_directory(output, none);
  if (format.empty())
    format = figure.folder                                             ? "svg"
             : ends_with(output, ".html") || ends_with(output, ".htm") ? "html"
             : ends_with(output, ".svg")                               ? "svg"
                                                                       : image_format_of(output);
  if (format.empty()) {
    if (output != "-")
      return "cannot tell what \"" + output + "\" is to be; known are .html, .svg, .png and a folder/";
    format = "png";
  }
  const bool page = format == "html" || format == "svg";
  if (!page && !is_image_format(format)) return "unknown format \"" + format + "\"";
  if (!page && (is_animation(format) || is_float_format(format) || options.bits == 16))
    return "a figure is a picture of 8 bits, and no animation";
  if (figure.names.empty() && (page || figure.folder))
    for (const FigureKind& kind : figure_kinds()) figure.names.emplace_back(kind.name);
  if (figure.names.size() > 1 && !figure.folder && format != "html")
    return "several figures are one .html, or a file each in a folder/";
  return {};
}

} // namespace softgl::cli
