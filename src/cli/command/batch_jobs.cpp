#include "command/batch_jobs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sys/stat.h>
#include <unordered_map>

#include "command/picture_plan.h"
#include "common/program_error.h"
#include "common/stable_hash.h"
#include "jobs/job_list.h"

#ifndef SOFTGL_VERSION
#define SOFTGL_VERSION "unknown"
#endif

namespace softgl::cli {
namespace {

namespace fs = std::filesystem;
using OptionWords = std::vector<std::string>;

// Of the run as a whole.
constexpr const char* kNotOfJobs[] = {"--output",     "-o",      "--threads",       "--config", "--sandbox",
                                      "--max-memory", "--stats", "--skip-existing", "--sheet"};
// They do not change a picture.
constexpr const char* kWithoutEffect[] = {"--threads", "--quiet",     "--verbose",
                                          "--config",  "--sandbox",   "--max-memory",
                                          "--timeout", "--recursive", "--keep-going"};

template <class Names> bool is_one_of(const std::string& word, const Names& names) {
  return std::any_of(std::begin(names), std::end(names), [&](const std::string& name) {
    return word == name || (word.rfind(name, 0) == 0 && word[name.size()] == '=');
  });
}

bool is_newer(const timespec& a, const timespec& b) {
  return a.tv_sec != b.tv_sec ? a.tv_sec > b.tv_sec : a.tv_nsec > b.tv_nsec;
}

class JobReader {
public:
  JobReader(const ProgramOptions& options, const std::vector<GivenOption>& given) : options_(options) {
    for (const GivenOption& option : given) {
      if (option.name == "--output") continue;
      OptionWords words = {option.name};
      for (const std::string& value : option.values) {
        if (&value != &option.values.front()) words.push_back(option.name);
        words.push_back(value);
      }
      const bool changes = !is_one_of(option.name, kWithoutEffect);
      for (const std::string& word : words) {
        common_.push_back(word);
        if (changes) common_key_.add(word);
      }
    }
    common_key_.add(SOFTGL_VERSION);
  }

  std::vector<BatchJob> read() {
    for (const std::string& operand : options_.models) {
      if (operand != "-" && fs::is_directory(operand)) {
        for (const std::string& model : models_in(operand, options_.recursive)) add_model(model);
      } else if (is_model_name(operand)) {
        add_model(operand);
      } else {
        for (JobLine& line : read_job_list(SourceText::open(operand))) add(std::move(line));
      }
    }
    refuse_same_files();
    return std::move(jobs_);
  }

private:
  void add_model(const std::string& model) {
    JobLine line;
    line.where = line.model = model;
    add(std::move(line));
  }

  void add(JobLine line) {
    BatchJob& job = jobs_.emplace_back();
    job.where = std::move(line.where);
    job.model = std::move(line.model);
    job.output = line.output.empty() ? options_.output : line.output;
    job.fault = std::move(line.fault);
    if (job.fault.empty()) try {
        job.options = options_for(line.options, job.output);
        name_files(job);
      } catch (const ProgramError& mistake) { job.fault = mistake.what(); }
    look_at_files(job, line.options);
  }

  // Most jobs have the options of another one.
  std::shared_ptr<const ProgramOptions> options_for(const OptionWords& own, const std::string& output) {
    if (output.empty()) throw ProgramError(kUsageError, "no output file given, neither here nor by -o");
    if (output == "-") throw ProgramError(kUsageError, "the picture of a job is a file");
    std::string all = image_format_of(output);
    for (const std::string& word : own) {
      if (is_one_of(word, kNotOfJobs)) throw ProgramError(kUsageError, word + " is no option of a job");
      all += '\0' + word;
    }
    std::shared_ptr<const ProgramOptions>& known = known_[all];
    if (known) return known;
    OptionWords words = {"model", "--output=" + output};
    words.insert(words.end(), common_.begin(), common_.end());
    words.insert(words.end(), own.begin(), own.end());
    return known = std::make_shared<const ProgramOptions>(parse_picture(words));
  }

  static void name_files(BatchJob& job) {
    if (job.model == "-" || fs::is_directory(job.model))
      throw ProgramError(kUsageError, "a job draws one model, which is a file");
    ProgramOptions options = *job.options;
    options.models = {job.model};
    options.output = job.output;
    for (const PlannedOutput& output : plan_pictures(options).outputs) job.files.push_back(output.path);
  }

  void look_at_files(BatchJob& job, const OptionWords& own) const {
    struct stat model {};
    if (::stat(job.model.c_str(), &model) == 0) job.bytes = uint64_t(model.st_size);
    StableHash key = common_key_;
    for (const std::string& word : own) key.add(word);
    key.add(job.model);
    key.add(job.output);
    key.add(job.bytes);
    key.add(uint64_t(model.st_mtim.tv_sec));
    key.add(uint64_t(model.st_mtim.tv_nsec));
    job.key = key.text();
    for (const std::string& name : job.files) {
      struct stat file {};
      if (::stat(name.c_str(), &file) != 0 || file.st_size == 0 || is_newer(model.st_mtim, file.st_mtim))
        job.outdated = true;
    }
  }

  void refuse_same_files() const {
    std::unordered_map<std::string, size_t> seen;
    for (size_t i = 0; i < jobs_.size(); ++i)
      for (const std::string& file : jobs_[i].files) {
        const auto [first, is_new] = seen.emplace(fs::path(file).lexically_normal().string(), i);
        if (!is_new)
          throw ProgramError(kUsageError, file + " would be two pictures: " + jobs_[first->second].where +
                                              " and " + jobs_[i].where);
      }
  }

  const ProgramOptions& options_;
  OptionWords common_; // options of the command line
  StableHash common_key_;
  std::map<std::string, std::shared_ptr<const ProgramOptions>> known_;
  std::vector<BatchJob> jobs_;
};

} // namespace

std::vector<BatchJob> read_jobs(const ProgramOptions& options, const std::vector<GivenOption>& given) {
  return JobReader(options, given).read();
}

} // namespace softgl::cli
