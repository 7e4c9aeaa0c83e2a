// Jobs in processes of their own.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace softgl::cli {

// What a process did with a job.
struct JobAnswer {
  std::string text;
  bool last = false; // the process ends: it would not work as well as a new one
};

struct WorkerPlan {
  unsigned processes = 1;
  double grace = 10;                         // seconds that jobs have to end after SIGTERM, SIGINT or SIGHUP
  std::function<void()> begin;               // in a new process, which does nothing else if it throws
  std::function<JobAnswer(size_t job)> work; // in the process
  std::function<void(size_t job, const std::string&)> answered;
  std::function<void(size_t job, int wait_status)> died; // its process ended before it
};

// The calling process hands the jobs out in their order and works on none of them. It has no other thread.
// Each process that dies is replaced, and takes only its own job with it. After the first signal no job is
// begun, and the rest ends or, when the grace is over or a second signal comes, is killed; `dropped` then
// gets the numbers of the jobs that were killed. Returns the signal, or 0. The processes die with their
// parent. Throws ProgramError if no process can be started or one cannot begin.
int run_jobs(const std::vector<size_t>& jobs, const WorkerPlan& plan, std::vector<size_t>& dropped);

} // namespace softgl::cli
