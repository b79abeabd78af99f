#include "cli/slurm_script.h"

#include <cmath>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "cli/shell_word.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

// A file name as sbatch reads it in quotes: % begins what it replaces, and a quote would end it.
std::string sbatch_name(const std::string& path) {
  if (path.find_first_of("\"\\\n") != std::string::npos)
    throw InputError(
        {.field = "--output",
         .expected = "a path without double quotes, backslashes and line breaks, as sbatch does not read them",
         .found = in_quotes(path),
         .remedy = "pass another --output"});
  std::string name;
  for (const char c : path) name += c == '%' ? "%%" : std::string(1, c);
  return name;
}

std::string time_in_words(double minutes) {
  return minutes < 1 ? "less than a minute" : fmt::format("about {:.0f} minutes", minutes);
}

constexpr std::string_view script = R"script(#!/bin/bash
# A sweep of FlexSlip as an array of jobs, each {minutes} on {threads} threads.
#
#   bash THIS_FILE      submits the array, and a job after it that joins the parts
#   sbatch THIS_FILE    submits the array alone
#
# Whatever ends a job, running this again computes only what is missing.
#
#SBATCH --job-name={job}
#SBATCH --array=1-{shards}
#SBATCH --cpus-per-task={threads}
#SBATCH --time={time:.0f}   # minutes
#SBATCH --output="{log}"
#SBATCH --open-mode=append
# As your cluster wants it; "##" leaves a line out. A job needs little memory, however large the sweep.
##SBATCH --mem=1G
##SBATCH --partition=NAME
##SBATCH --account=NAME
# module load hdf5   # where the nodes have their libraries as modules

FLEXSLIP={program}   # as the compute nodes see it
CASE={case_file}
CHANGES=({changes})
OUTPUT={output}

if [[ ${{1:-}} == merge ]]; then exec "$FLEXSLIP" merge "$OUTPUT.parts" --output "$OUTPUT"; fi

# Outside of the array: submit it, and the merge when all its jobs have ended, with the same options. afterany, not afterok: if a
# job failed, the merge writes no file, but says in the log which parts are missing and how to compute them.
if [[ -z ${{SLURM_ARRAY_TASK_ID:-}} ]]; then
  set -euo pipefail
  array=$(sbatch --parsable "$0")
  array=${{array%%;*}}   # without the name of the cluster
  merge=$(sbatch --parsable --dependency="afterany:$array" --array=0 --cpus-per-task=1 "$0" merge)
  echo "array job $array, merge job ${{merge%%;*}}; watch them with: squeue --me"
  exit
fi

exec "$FLEXSLIP" sweep "$CASE" "${{CHANGES[@]}}" --output "$OUTPUT" --shard "$SLURM_ARRAY_TASK_ID/{shards}" --threads "$SLURM_CPUS_PER_TASK"
)script";

}  // namespace

std::string slurm_script(const SlurmJobs& jobs) {
  constexpr double safety = 3;         // nodes differ, and so do the designs of a sweep
  constexpr double least_minutes = 5;  // for starting up
  std::string changes;
  for (const std::string& change : jobs.changes)
    changes += fmt::format("{}--set {}", changes.empty() ? "" : " ", shell_word(change));
  const std::string log = sbatch_name(jobs.output + ".log");
  return fmt::format(script, fmt::arg("minutes", time_in_words(jobs.minutes)), fmt::arg("threads", jobs.threads),
                     fmt::arg("job", shell_word(std::filesystem::path(jobs.output).filename().string())),
                     fmt::arg("shards", jobs.shards),
                     fmt::arg("time", std::ceil(safety * jobs.minutes + least_minutes)), fmt::arg("log", log),
                     fmt::arg("program", shell_word(jobs.program)), fmt::arg("case_file", shell_word(jobs.case_file)),
                     fmt::arg("changes", changes), fmt::arg("output", shell_word(jobs.output)));
}

}  // namespace flexslip
