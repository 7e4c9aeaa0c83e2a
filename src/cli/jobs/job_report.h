// A JSON line for each job that ended, and what such lines say when the list is drawn again.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <unordered_set>
#include <vector>

namespace softgl::cli {

struct JobResult {
  std::string job;   // what there was to do, see job_key() in command/batch.h
  std::string where; // line of the list
  std::string model, output;
  int exit_code = 0; // 128 and the signal that ended the process
  double milliseconds = 0;
  uint64_t peak_memory = 0; // bytes; 0: not known
  uint64_t warnings = 0;
  std::string pixels;  // hash; empty without a picture
  std::string written; // stamp_of() the files
  std::string error;   // a sentence
};

std::string as_json_line(const JobResult& result);

// The sizes and times of files, as 16 digits; empty if one is missing or empty. It is compared with itself
// only, so a clock that jumps does no harm.
std::string stamp_of(const std::vector<std::string>& files);

// Lines at the end of a file, or on standard output for an empty name. Each is written at once, so that
// several processes may write one file.
class JobReport {
public:
  // Makes the folder. Throws ProgramError (kCannotWrite). A line that a killed run left unfinished is closed.
  explicit JobReport(const std::string& path);
  ~JobReport();
  JobReport(const JobReport&) = delete;
  JobReport& operator=(const JobReport&) = delete;

  void add(const JobResult& result);
  // What went wrong first; the drawing goes on.
  const std::string& fault() const { return fault_; }

private:
  std::string name_, fault_;
  int file_;
};

// What reports say is done.
class DoneJobs {
public:
  // `pattern` may have * in it. A file that is not there says nothing, nor does a line that is no JSON.
  // Throws ProgramError (kCannotRead).
  void read(const std::string& pattern);

  bool has(const std::string& job, const std::string& stamp) const;

private:
  std::unordered_set<std::string> done_; // job and stamp
};

} // namespace softgl::cli
