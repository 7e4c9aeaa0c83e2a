#include "jobs/job_report.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <glob.h>
#include <nlohmann/json.hpp>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

#include "common/json_text.h"
#include "common/program_error.h"
#include "common/source_text.h"
#include "common/stable_hash.h"

namespace softgl::cli {
namespace {

int open_report(const std::string& path) {
  if (path.empty()) return STDOUT_FILENO;
  std::error_code ignored; // opening the file will say it
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) throw ProgramError(kCannotWrite, path + ": cannot write: " + std::strerror(errno));
  struct stat status {};
  char last = '\n';
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0 &&
      ::pread(file, &last, 1, status.st_size - 1) == 1 && last != '\n' && ::write(file, "\n", 1) < 0)
    return file; // the first line that is added says it
  return file;
}

} // namespace

std::string as_json_line(const JobResult& result) {
  std::string line =
      "{\"job\": " + json_string(result.job) + ", \"where\": " + json_string(result.where) +
      ", \"model\": " + json_string(result.model) + ", \"output\": " + json_string(result.output) +
      ", \"exit_code\": " + std::to_string(result.exit_code) +
      ", \"milliseconds\": " + json_number(result.milliseconds) +
      ", \"peak_memory\": " + (result.peak_memory ? std::to_string(result.peak_memory) : "null") +
      ", \"warnings\": " + std::to_string(result.warnings);
  const auto add = [&line](const char* name, const std::string& text) {
    if (!text.empty()) line += std::string(", \"") + name + "\": " + json_string(text);
  };
  add("pixels", result.pixels);
  add("written", result.written);
  add("error", result.error);
  return line + "}\n";
}

std::string stamp_of(const std::vector<std::string>& files) {
  StableHash hash;
  for (const std::string& file : files) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0 || status.st_size == 0) return {};
    hash.add(uint64_t(status.st_size));
    hash.add(uint64_t(status.st_mtim.tv_sec));
    hash.add(uint64_t(status.st_mtim.tv_nsec));
  }
  return hash.text();
}

JobReport::JobReport(const std::string& path)
    : name_(path.empty() ? "standard output" : path), file_(open_report(path)) {}

JobReport::~JobReport() {
  if (file_ != STDOUT_FILENO) ::close(file_);
}

void JobReport::add(const JobResult& result) {
  const std::string line = as_json_line(result);
  for (size_t written = 0; written < line.size();) {
    const ssize_t count = ::write(file_, line.data() + written, line.size() - written);
    if (count >= 0) {
      written += size_t(count);
    } else if (errno != EINTR) {
      if (fault_.empty()) fault_ = name_ + ": cannot write: " + std::strerror(errno);
      return;
    }
  }
}

void DoneJobs::read(const std::string& pattern) {
  glob_t names{};
  const int found = ::glob(pattern.c_str(), GLOB_NOCHECK, nullptr, &names);
  const std::vector<std::string> paths(names.gl_pathv, names.gl_pathv + (found == 0 ? names.gl_pathc : 0));
  ::globfree(&names);
  for (const std::string& path : paths) {
    if (::access(path.c_str(), F_OK) != 0) continue;
    const SourceText text = SourceText::open_named(path);
    std::string_view rest(text.begin(), text.size());
    while (!rest.empty()) {
      const size_t end = std::min(rest.find('\n'), rest.size());
      const nlohmann::json line = nlohmann::json::parse(rest.begin(), rest.begin() + end, nullptr, false);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (!line.is_object() || line.value("exit_code", nlohmann::json()) != 0) continue;
      const nlohmann::json job = line.value("job", nlohmann::json()),
                           written = line.value("written", nlohmann::json());
      if (job.is_string() && written.is_string())
        done_.insert(job.get<std::string>() + written.get<std::string>());
    }
  }
}

bool DoneJobs::has(const std::string& job, const std::string& stamp) const {
  return !stamp.empty() && done_.count(job + stamp) > 0;
}

} // namespace softgl::cli
