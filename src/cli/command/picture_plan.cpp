#include "command/picture_plan.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "common/program_error.h"

namespace softgl::cli {
namespace {

namespace fs = std::filesystem;

template <class Iterator> std::vector<std::string> list_models(const std::string& folder) {
  std::vector<std::string> models;
  std::error_code problem;
  for (Iterator i(folder, problem), end; !problem && i != end; i.increment(problem))
    if (is_model_name(i->path().string()) && !i->is_directory()) models.push_back(i->path().string());
  if (problem) throw ProgramError(kCannotRead, folder + ": cannot read: " + problem.message());
  if (models.empty()) throw ProgramError(kCannotRead, folder + ": no OBJ, PLY or STL files in this folder");
  std::sort(models.begin(), models.end());
  return models;
}

std::string padded(size_t number, size_t digits) {
  const std::string text = std::to_string(number);
  return std::string(digits > text.size() ? digits - text.size() : 0, '0') + text;
}

size_t digits_of(size_t number) { return std::max<size_t>(3, std::to_string(number).size()); }

using Names = std::map<std::string, std::string>;

// Names of a template are {word}.
std::string fill(const std::string& pattern, const Names& names) {
  std::string text;
  for (size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '{') {
      text += pattern[i];
      continue;
    }
    const size_t end = pattern.find('}', i);
    const std::string word = end == std::string::npos ? "" : pattern.substr(i + 1, end - i - 1);
    const auto found = names.find(word);
    if (found == names.end()) {
      std::string message = "the output name \"";
      message.append(pattern).append("\" can have ");
      const char* separator = "{";
      for (const auto& [name, value] : names) {
        message.append(separator).append(name).append("}");
        separator = ", {";
      }
      throw ProgramError(kUsageError, message);
    }
    text += found->second;
    i = end;
  }
  return text;
}

class Planner {
public:
  explicit Planner(const ProgramOptions& options) : options_(options) {}

  PicturePlan plan() {
    for (const std::string& model : options_.models) {
      if (model != "-" && fs::is_directory(model)) {
        const std::vector<std::string> inside = models_in(model, options_.recursive);
        plan_.models.insert(plan_.models.end(), inside.begin(), inside.end());
      } else {
        plan_.models.push_back(model);
      }
    }
    const size_t frames = size_t(std::max(1, options_.turntable));
    for (size_t model = 0; model < plan_.models.size(); ++model)
      for (size_t view = 0; view < options_.views.size(); ++view)
        for (size_t pass = 0; pass < options_.passes.size(); ++pass)
          for (size_t frame = 0; frame < frames; ++frame)
            plan_.jobs.push_back({model, view, pass, frame, 0, 0});
    assign_outputs(frames);
    if (options_.output != "-") refuse_same_names();
    if (options_.skip_existing) leave_out_existing();
    return std::move(plan_);
  }

private:
  void assign_outputs(size_t frames) {
    const size_t cells = size_t(options_.sheet_columns) *
                         (options_.sheet_rows ? size_t(options_.sheet_rows) : plan_.jobs.size());
    const size_t together = cells ? cells : is_animation(options_.format) ? frames : 1;
    for (size_t i = 0; i < plan_.jobs.size(); ++i) {
      PictureJob& job = plan_.jobs[i];
      if (i % together == 0) plan_.outputs.push_back({path_of(job, i, cells > 0, together), 0});
      job.output = plan_.outputs.size() - 1;
      job.slot = plan_.outputs.back().count++;
    }
  }

  std::string path_of(const PictureJob& job, size_t number, bool sheet, size_t together) const {
    if (options_.output == "-") return "-";
    const std::string& model = plan_.models[job.model];
    const size_t slash = model.rfind('/');
    Names names;
    if (sheet) {
      names["page"] = padded(number / together + 1, digits_of(plan_.jobs.size() / together));
      if (plan_.models.size() == 1) names["model"] = stem_of(model);
      return fill(options_.output, names);
    }
    names["model"] = stem_of(model);
    names["dir"] = slash == std::string::npos ? "." : slash == 0 ? "/" : model.substr(0, slash);
    names["view"] = options_.views[job.view].name;
    names["pass"] = name_of(options_.passes[job.pass]);
    names["n"] = padded(number / together + 1, digits_of(plan_.jobs.size() / together));
    if (together == 1) names["frame"] = padded(job.frame + 1, digits_of(size_t(options_.turntable)));
    return fill(options_.output, names);
  }

  std::string describe(size_t output) const {
    const PictureJob& job = *std::find_if(plan_.jobs.begin(), plan_.jobs.end(),
                                          [output](const PictureJob& j) { return j.output == output; });
    if (options_.sheet_columns) return "page " + std::to_string(output + 1);
    std::string text = plan_.models[job.model] + ", " + options_.views[job.view].name;
    if (options_.passes.size() > 1) text += std::string(", ") + name_of(options_.passes[job.pass]);
    if (options_.turntable) text += ", frame " + std::to_string(job.frame + 1);
    return text;
  }

  // Before anything is drawn.
  void refuse_same_names() const {
    std::map<std::string, size_t> seen;
    for (size_t i = 0; i < plan_.outputs.size(); ++i) {
      const auto [first, is_new] =
          seen.emplace(fs::path(plan_.outputs[i].path).lexically_normal().string(), i);
      if (!is_new)
        throw ProgramError(
            kUsageError,
            plan_.outputs[i].path + " would be two pictures: " + describe(first->second) + " and " +
                describe(i) + "; " +
                (options_.sheet_columns
                     ? "{page} in the output name tells them apart"
                     : "{model}, {view}, {pass}, {frame} or {n} in the output name tell them apart"));
    }
  }

  void leave_out_existing() {
    std::vector<PlannedOutput> outputs;
    std::vector<size_t> numbers;
    for (const PlannedOutput& output : plan_.outputs) {
      const bool kept = output.path == "-" || !fs::exists(output.path);
      numbers.push_back(kept ? outputs.size() : SIZE_MAX);
      if (kept) outputs.push_back(output);
    }
    std::erase_if(plan_.jobs, [&](const PictureJob& job) { return numbers[job.output] == SIZE_MAX; });
    for (PictureJob& job : plan_.jobs) job.output = numbers[job.output];
    plan_.outputs = std::move(outputs);
  }

  const ProgramOptions& options_;
  PicturePlan plan_;
};

} // namespace

bool is_model_name(const std::string& path) {
  std::string name = path;
  for (char& c : name) c = char(c >= 'A' && c <= 'Z' ? c + 32 : c);
  for (const char* packed : {".gz", ".zst"})
    if (name.ends_with(packed)) name.resize(name.rfind('.'));
  return name.ends_with(".obj") || name.ends_with(".ply") || name.ends_with(".stl");
}

std::vector<std::string> models_in(const std::string& folder, bool deep) {
  return deep ? list_models<fs::recursive_directory_iterator>(folder)
              : list_models<fs::directory_iterator>(folder);
}

std::string stem_of(const std::string& path) {
  if (path == "-") return "stdin";
  std::string name = path.substr(path.rfind('/') + 1);
  const auto drop_end = [&name] {
    const size_t dot = name.rfind('.');
    if (dot != std::string::npos && dot > 0) name.resize(dot);
  };
  const bool packed = name.ends_with(".gz") || name.ends_with(".zst");
  drop_end();
  if (packed && is_model_name(name)) drop_end();
  return name;
}

PicturePlan plan_pictures(const ProgramOptions& options) { return Planner(options).plan(); }

} // namespace softgl::cli
