// A sweep as an array of jobs of Slurm.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flexslip {

struct SlurmJobs {
  std::string program, case_file, output;  // absolute paths
  std::vector<std::string> changes;        // of the case
  std::uint64_t shards;
  unsigned threads;  // of each job
  double minutes;    // that a job is expected to take
};

// A commented script that submits itself, and the merge after it.
// Fails:      InputError if sbatch could not read the name of the output.
std::string slurm_script(const SlurmJobs& jobs);

}  // namespace flexslip
