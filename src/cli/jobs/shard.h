// A list of jobs in parts that are the same on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace softgl::cli {

struct Shard {
  uint64_t number = 1, count = 1; // `number` is 1 to `count`
};

// "3/10"; "slurm" for the task of a Slurm array, by SLURM_ARRAY_TASK_ID and the variables beside it;
// "kubernetes/10" for the pod of an indexed Job, by JOB_COMPLETION_INDEX. Throws std::invalid_argument with a
// sentence.
Shard parse_shard(const std::string& text);

struct JobWeight {
  std::string name; // different for each job
  uint64_t bytes = 0;
};

// The numbers of the shard's jobs, the heaviest first. A job weighs its bytes and 1 MiB, which stands for the
// drawing. The jobs are sorted by weight, the heaviest first, those of one weight by the StableHash of their
// names, then by the names. Each in turn goes to the shard that has least so far, of several to the first. So
// the order of the list does not matter, and two shards differ by no more than the heaviest job.
std::vector<size_t> jobs_of_shard(const std::vector<JobWeight>& jobs, const Shard& shard);

} // namespace softgl::cli
