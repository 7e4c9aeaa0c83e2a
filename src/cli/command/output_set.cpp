#include "command/output_set.h"

#include <algorithm>
#include <filesystem>

#include "common/file_writer.h"
#include "image/float_formats.h"
#include "scene/sheet.h"

namespace softgl::cli {

// What has come for one file: whole pictures of a sheet, else encoded frames, or all bytes.
struct OutputSet::Pending {
  size_t left = 0, missing = 0;
  size_t first_job = 0;
  std::vector<Picture> pictures;
  std::vector<GifFrame> gif;
  std::vector<PngFrame> png;
  GrowingArray<uint8_t> bytes;
};

OutputSet::OutputSet(const PicturePlan& plan, const ProgramOptions& options)
    : plan_(plan), options_(options), pending_(plan.outputs.size()) {
  for (size_t i = plan.jobs.size(); i-- > 0;) pending_[plan.jobs[i].output].first_job = i;
  for (size_t i = 0; i < plan.outputs.size(); ++i) {
    const size_t count = pending_[i].left = plan.outputs[i].count;
    if (options.sheet_columns)
      pending_[i].pictures.resize(count);
    else if (options.format == "gif")
      pending_[i].gif.resize(count);
    else if (options.format == "apng")
      pending_[i].png.resize(count);
  }
}

OutputSet::~OutputSet() = default;

void OutputSet::take(size_t job, RenderResult result) {
  encode(plan_.jobs[job], std::move(result), pending_[plan_.jobs[job].output]);
  arrive(job, true);
}

void OutputSet::leave(size_t job) { arrive(job, false); }

// Each job has a place of its own.
void OutputSet::encode(const PictureJob& job, RenderResult result, Pending& pending) const {
  Picture& picture = result.picture;
  if (options_.format == "gif" && picture.channels == 1) picture = as_rgb(picture);
  if (options_.sheet_columns)
    pending.pictures[job.slot] = std::move(picture);
  else if (options_.format == "gif")
    pending.gif[job.slot] = encode_gif_frame(picture);
  else if (options_.format == "apng")
    pending.png[job.slot] = encode_png_frame(picture, options_.png);
  else if (is_float_format(options_.format))
    pending.bytes = encode_floats(result.floats, options_.format);
  else
    pending.bytes = encode_image(picture, options_.format, options_.png);
}

void OutputSet::arrive(size_t job, bool with_picture) {
  const size_t number = plan_.jobs[job].output;
  Pending& pending = pending_[number];
  {
    const std::scoped_lock lock(mutex_);
    if (!with_picture) ++pending.missing;
    if (--pending.left > 0) return;
  }
  // A sheet shows what there is; half an animation is none.
  const PlannedOutput& output = plan_.outputs[number];
  const bool wanted = pending.missing == 0 || (options_.sheet_columns && pending.missing < output.count);
  write(number, wanted ? assemble(output, pending, pending.first_job) : GrowingArray<uint8_t>());
  pending = Pending();
}

GrowingArray<uint8_t> OutputSet::assemble(const PlannedOutput& output, Pending& pending,
                                          size_t first_job) const {
  if (options_.sheet_columns)
    return encode_image(compose(output, pending, first_job), options_.format, options_.png);
  if (options_.format == "gif") return assemble_gif(pending.gif, options_.frames_per_second);
  if (options_.format == "apng") return assemble_apng(pending.png, options_.frames_per_second);
  return std::move(pending.bytes);
}

Picture OutputSet::compose(const PlannedOutput& output, Pending& pending, size_t first_job) const {
  std::vector<SheetRow> rows;
  for (size_t i = 0; i < output.count; ++i) {
    if (i % size_t(options_.sheet_columns) == 0) rows.emplace_back();
    Picture& picture = pending.pictures[i];
    std::string label = label_of(plan_.jobs[first_job + i]);
    if (picture.pixels.empty()) {
      picture.width = options_.render.width;
      picture.height = options_.render.height;
      picture.pixels.fill(3 * size_t(picture.width) * size_t(picture.height), 230);
      label += " failed";
    } else if (picture.channels != 3) {
      picture = as_rgb(picture);
    }
    rows.back().entries.push_back({std::move(picture), std::move(label)});
  }
  return compose_sheet("", rows);
}

// What tells this picture from the others of the run.
std::string OutputSet::label_of(const PictureJob& job) const {
  std::string detail;
  const auto add = [&detail](const std::string& text) { detail += (detail.empty() ? "" : ", ") + text; };
  if (options_.views.size() > 1) add(options_.views[job.view].name);
  if (options_.passes.size() > 1) add(name_of(options_.passes[job.pass]));
  if (options_.turntable) add(std::to_string(job.frame + 1) + " of " + std::to_string(options_.turntable));
  if (plan_.models.size() > 1 || detail.empty())
    return stem_of(plan_.models[job.model]) + (detail.empty() ? "" : "\n" + detail);
  return detail;
}

void OutputSet::write(size_t output, GrowingArray<uint8_t> bytes) {
  const std::string& path = plan_.outputs[output].path;
  if (path != "-") {
    if (bytes.empty()) return;
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code ignored; // writing the file will say it
    if (options_.output.find('{') != std::string::npos && !folder.empty())
      std::filesystem::create_directories(folder, ignored);
    write_file(path, bytes);
    return;
  }
  const std::scoped_lock lock(mutex_);
  early_[output] = std::move(bytes);
  for (auto first = early_.find(next_); first != early_.end(); first = early_.find(++next_)) {
    if (!first->second.empty()) write_file("-", first->second);
    early_.erase(first);
  }
}

} // namespace softgl::cli
