#include "command/batch.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <new>
#include <set>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

#include "command/batch_jobs.h"
#include "command/picture_run.h"
#include "command/sandbox_paths.h"
#include "common/elapsed_time.h"
#include "common/file_writer.h"
#include "common/program_error.h"
#include "common/progress.h"
#include "common/sandbox.h"
#include "common/time_limit.h"
#include "jobs/job_report.h"
#include "jobs/worker_processes.h"

namespace softgl::cli {
namespace {

// The most memory that the process has had in use since start(). The kernel's files are opened before the
// sandbox.
class MemoryPeak {
public:
  void open() {
    status_ = ::open("/proc/self/status", O_RDONLY | O_CLOEXEC);
    reset_ = ::open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC);
  }
  void start() const {
    if (::pwrite(reset_, "5", 1, 0) < 0) return; // the peak is then that of all jobs so far
  }
  // In bytes; 0: not known.
  uint64_t bytes() const {
    char text[4096];
    const ssize_t size = ::pread(status_, text, sizeof text - 1, 0);
    if (size <= 0) return 0;
    text[size] = 0;
    const char* line = std::strstr(text, "VmHWM:");
    return line ? std::strtoull(line + std::strlen("VmHWM:"), nullptr, 10) << 10 : 0;
  }

private:
  int status_ = -1, reset_ = -1; // of a process that lives for drawing
};

// Its first line has numbers, the second is a sentence about what went wrong.
std::string as_text(const JobResult& result) {
  std::ostringstream text;
  text << result.exit_code << ' ' << result.milliseconds << ' ' << result.peak_memory << ' '
       << result.warnings << ' ' << result.pixels << '\n'
       << result.error;
  return text.str();
}

void read_text(const std::string& text, JobResult& result) {
  std::istringstream stream(text);
  std::string numbers;
  std::getline(stream, numbers);
  std::getline(stream, result.error, '\0');
  std::istringstream(numbers) >> result.exit_code >> result.milliseconds >> result.peak_memory >>
      result.warnings >> result.pixels;
}

class BatchRun {
public:
  BatchRun(const ProgramOptions& options, std::vector<BatchJob> jobs, unsigned threads)
      : options_(options), shard_(options.batch.shard.value_or(Shard())), jobs_(std::move(jobs)),
        mine_(choose_jobs()), todo_(choose_missing()), report_(report_name(shard_text())),
        progress_(stderr, !options.quiet && is_terminal(stderr), todo_.size()) {
    processes_ = unsigned(std::clamp<size_t>(todo_.size(), 1, threads));
    threads_each_ = std::max(1u, threads / processes_);
  }

  int run() {
    const auto start = Clock::now();
    std::vector<std::string> files;
    for (const size_t job : mine_)
      files.insert(files.end(), jobs_[job].files.begin(), jobs_[job].files.end());
    remove_unfinished(files);
    if (options_.limits.sandbox) collect_sandbox_paths();
    WorkerPlan plan;
    plan.processes = processes_;
    plan.begin = [this] { begin_process(); };
    plan.work = [this](size_t job) { return draw(job); };
    plan.answered = [this](size_t job, const std::string& text) { take_answer(job, text); };
    plan.died = [this](size_t job, int status) { take_death(job, status); };
    std::vector<size_t> to_draw;
    for (const size_t job : todo_) {
      if (jobs_[job].fault.empty()) {
        to_draw.push_back(job);
        continue;
      }
      JobResult result = result_of(job);
      result.exit_code = kUsageError;
      result.error = jobs_[job].fault;
      finish(job, result);
    }
    std::vector<size_t> dropped;
    int signal = run_jobs(to_draw, plan, dropped);
    if (signal == 0 && !killed_.empty()) {
      plan.processes = 1;
      alone_ = true;
      signal = run_jobs(killed_, plan, dropped);
    }
    for (const size_t job : dropped) remove_unfinished(jobs_[job].files);
    print_summary(seconds_since(start), signal);
    if (signal) return 128 + signal;
    if (exit_code_ == kSuccess && !report_.fault().empty()) return kCannotWrite;
    return exit_code_;
  }

private:
  std::string shard_text() const {
    return std::to_string(shard_.number) + "-of-" + std::to_string(shard_.count);
  }

  std::string report_name(const std::string& shard) const {
    const std::string word = "{shard}";
    std::string name = options_.batch.report;
    const size_t at = name.find(word);
    return at == std::string::npos ? name : name.replace(at, word.size(), shard);
  }

  std::vector<size_t> choose_jobs() const {
    std::vector<JobWeight> weights;
    for (const BatchJob& job : jobs_)
      weights.push_back({job.files.empty() ? job.where : job.files.front(), job.bytes});
    return jobs_of_shard(weights, shard_);
  }

  std::vector<size_t> choose_missing() const {
    if (!options_.batch.resume) return mine_;
    const bool by_report = !options_.batch.report.empty();
    DoneJobs done;
    if (by_report) done.read(report_name("*"));
    std::vector<size_t> missing;
    for (const size_t number : mine_) {
      const BatchJob& job = jobs_[number];
      const bool there = by_report ? done.has(job.key, stamp_of(job.files)) : !job.outdated;
      if (!there || !job.fault.empty()) missing.push_back(number);
    }
    return missing;
  }

  void collect_sandbox_paths() {
    std::set<std::string> read, write;
    for (const size_t number : todo_) {
      if (!jobs_[number].fault.empty()) continue;
      const SandboxPaths paths = sandbox_paths(options_of(jobs_[number]));
      read.insert(paths.read.begin(), paths.read.end());
      write.insert(paths.write.begin(), paths.write.end());
    }
    sandbox_.read.assign(read.begin(), read.end());
    sandbox_.write.assign(write.begin(), write.end());
  }

  static ProgramOptions options_of(const BatchJob& job) {
    ProgramOptions options = *job.options;
    options.models = {job.model};
    options.output = job.output;
    options.keep_going = false; // it has one model
    return options;
  }

  // In a process of its own.
  void begin_process() {
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (nothing >= 0) ::dup2(nothing, STDIN_FILENO);
    ::setenv("SOFTGL_THREADS", std::to_string(threads_each_).c_str(), 1);
    memory_.open();
    if (options_.limits.sandbox) enter_sandbox(sandbox_);
  }

  JobAnswer draw(size_t number) const {
    const BatchJob& job = jobs_[number];
    const auto start = Clock::now();
    JobAnswer answer;
    JobResult result;
    memory_.start();
    const auto fail = [&result](int code, const std::string& sentence) {
      result.exit_code = code;
      result.error = sentence;
    };
    try {
      const ProgramOptions options = options_of(job);
      start_time_limit(options.limits.seconds);
      for (const std::string& file : job.files) make_folder_of(file);
      PictureRecord record;
      draw_pictures(options, threads_each_, &record);
      result.warnings = record.warnings;
      result.pixels = record.pixels;
    } catch (const ProgramError& error) { fail(error.code, error.what()); } catch (const std::bad_alloc&) {
      fail(kCannotRead, job.model + ": not enough memory");
      answer.last = true; // a process that has lost much memory in pieces has less for the next job
    } catch (const std::exception& error) { fail(kCannotRead, job.model + ": " + error.what()); }
    start_time_limit(0);
    result.milliseconds = 1e3 * seconds_since(start);
    result.peak_memory = memory_.bytes();
    answer.text = as_text(result);
    return answer;
  }

  static void make_folder_of(const std::string& file) {
    std::error_code ignored; // writing the file will say it
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  }

  JobResult result_of(size_t number) const {
    JobResult result;
    result.job = jobs_[number].key;
    result.where = jobs_[number].where;
    result.model = jobs_[number].model;
    result.output = jobs_[number].output;
    return result;
  }

  void take_answer(size_t job, const std::string& text) {
    JobResult result = result_of(job);
    read_text(text, result);
    if (result.exit_code == kSuccess) result.written = stamp_of(jobs_[job].files);
    finish(job, result);
  }

  void take_death(size_t number, int status) {
    const BatchJob& job = jobs_[number];
    remove_unfinished(job.files);
    // The kernel kills whoever is largest when memory ends, and the others may have had most of it.
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL && !alone_) {
      killed_.push_back(number);
      return;
    }
    JobResult result = result_of(number);
    const double seconds = job.options->limits.seconds;
    if (WIFSIGNALED(status)) {
      result.exit_code = 128 + WTERMSIG(status);
      result.error = job.model + ": the process that drew it was ended by signal " +
                     std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")";
    } else if (seconds > 0 && WEXITSTATUS(status) == kCannotRead) {
      std::ostringstream sentence;
      sentence << job.model << ": not finished after " << seconds << " s (--timeout)";
      result.exit_code = kCannotRead;
      result.error = sentence.str();
    } else {
      result.exit_code = WEXITSTATUS(status) ? WEXITSTATUS(status) : int(kCannotRead);
      result.error =
          job.model + ": the process that drew it ended with code " + std::to_string(WEXITSTATUS(status));
    }
    finish(number, result);
  }

  void finish(size_t number, const JobResult& result) {
    report_.add(result);
    progress_.step();
    if (result.exit_code == kSuccess) {
      ++drawn_;
      return;
    }
    ++failed_;
    if (number < first_failed_) {
      first_failed_ = number;
      exit_code_ = result.exit_code;
    }
    progress_.say("softgl: error: " + (result.where == result.model ? "" : result.where + ": ") +
                  result.error + "\n");
  }

  void print_summary(double seconds, int signal) {
    if (!report_.fault().empty()) progress_.say("softgl: error: " + report_.fault() + "\n");
    if (options_.quiet) return;
    std::ostringstream text;
    text.precision(3);
    text << "softgl: " << mine_.size() << (mine_.size() == 1 ? " job" : " jobs");
    if (shard_.count > 1) text << " of shard " << shard_.number << '/' << shard_.count;
    text << ": " << drawn_ << " drawn, " << mine_.size() - todo_.size() << " there already, " << failed_
         << " failed";
    const size_t left = todo_.size() - drawn_ - failed_;
    if (left > 0) text << ", " << left << " not begun or dropped";
    if (signal) text << " after signal " << signal;
    text << "; " << seconds << " s\n";
    progress_.say(text.str());
  }

  const ProgramOptions& options_;
  const Shard shard_;
  const std::vector<BatchJob> jobs_;      // of all shards
  const std::vector<size_t> mine_, todo_; // the shard's, the heaviest first
  JobReport report_;
  Progress progress_;
  SandboxPaths sandbox_;
  MemoryPeak memory_;
  unsigned processes_ = 1, threads_each_ = 1;
  std::vector<size_t> killed_; // to be drawn once more
  bool alone_ = false;         // they are
  size_t drawn_ = 0, failed_ = 0, first_failed_ = SIZE_MAX;
  int exit_code_ = kSuccess;
};

} // namespace

int run_batch(const ProgramOptions& options, const std::vector<GivenOption>& given, unsigned threads) {
  return BatchRun(options, read_jobs(options, given), threads).run();
}

} // namespace softgl::cli
