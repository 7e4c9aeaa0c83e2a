#include "command/figure.h"

#include <algorithm>
#include <filesystem>

#include "common/parallel.h"
#include "figure/drawing_painter.h"
#include "figure/figure_list.h"
#include "figure/html_writer.h"
#include "figure/lecture_sheet.h"
#include "figure/svg_writer.h"

namespace softgl::cli {
namespace {

GrowingArray<uint8_t> bytes_of(const std::string& text) {
  GrowingArray<uint8_t> bytes;
  bytes.append(reinterpret_cast<const uint8_t*>(text.data()), text.size());
  return bytes;
}

GrowingArray<uint8_t> encode(Page page, const Lecture& lecture, const ProgramOptions& options) {
  if (options.format == "html") {
    std::vector<Page> pages;
    pages.push_back(std::move(page));
    return bytes_of(html_document(std::move(pages), lecture.language(), options.png));
  }
  const std::string title = page.title;
  const Drawing drawing = lay_out(std::move(page));
  if (options.format == "svg")
    return bytes_of(svg_file(drawing, title, lecture.say({"en", "de"}), options.png));
  return encode_image(paint(drawing, natural_scale(drawing)), options.format, options.png);
}

} // namespace

std::vector<FigureFile> draw_figures(const FigureSubject& subject, const ProgramOptions& options,
                                     unsigned threads, Warnings& warnings) {
  const FigureOptions& figure = options.figure;
  const Lecture lecture(figure.language, subject, options.render);
  std::vector<const FigureKind*> kinds;
  for (const std::string& name : figure.names) kinds.push_back(find_figure(name));
  if (kinds.empty() ||
      std::any_of(kinds.begin(), kinds.end(), [](const FigureKind* kind) { return kind->shows_subject; }))
    lecture.check_subject(warnings);
  std::vector<FigureFile> files;
  if (kinds.empty()) {
    files.push_back({options.output, encode_image(lecture_sheet(lecture), options.format, options.png)});
    return files;
  }
  const bool together = options.format == "html" && !figure.folder;
  std::vector<Page> pages(kinds.size());
  files.resize(together ? 1 : kinds.size());
  parallel_for(kinds.size(), threads, [&](size_t i, unsigned) {
    pages[i] = draw_figure(*kinds[i], lecture);
    if (together) return;
    files[i].path =
        figure.folder
            ? (std::filesystem::path(options.output) / (pages[i].name + "." + options.format)).string()
            : options.output;
    files[i].bytes = encode(std::move(pages[i]), lecture, options);
  });
  if (together)
    files.front() = {options.output,
                     bytes_of(html_document(std::move(pages), lecture.language(), options.png))};
  return files;
}

std::string list_of_figures(Language language) {
  std::string text;
  for (const FigureKind& kind : figure_kinds()) {
    std::string name = kind.name;
    name.resize(12, ' ');
    text += name + kind.title.in(language) + "\n";
  }
  return text;
}

} // namespace softgl::cli
