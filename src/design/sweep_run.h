// The rows of a sweep, computed chunk by chunk on several threads and kept as parts: what is there whole is not computed again.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "design/sweep_parts.h"
#include "design/sweep_plan.h"

namespace flexslip {

// Every count-th chunk, from the index-th on: shards differ by one chunk at most, and each meets all regions of a grid.
struct Shard {
  std::uint64_t index = 1;  // from 1 to count
  std::uint64_t count = 1;
};

struct SweepOptions {
  unsigned threads = 1;
  Shard shard{};
  const std::atomic<bool>* stop = nullptr;  // chunks that are under way are given up
  std::function<void(std::uint64_t rows_done, std::uint64_t rows_to_do)> progress{};  // after each row, on any thread
};

enum class SweepStatus { done, stopped };

struct SweepRun {
  SweepStatus status;
  std::uint64_t rows_found;            // in parts that were there
  std::uint64_t rows_computed;         // and kept
  std::vector<std::uint64_t> damaged;  // chunks whose parts were removed
};

// Computes the chunks of a shard whose parts are missing or damaged; with a copy of the function for each.
// Fails:      InputError if a part cannot be written.
SweepRun run_sweep(const SweepParts& parts, const RowFunction& outcomes_of, const SweepOptions& options);

// Where the parts of an output lie: beside it.
std::string parts_folder_of(const std::string& output);

// Fails:      InputError with both sizes, if the disk of the output has no room for the parts of the shard that are missing and, if it is not
//             one of several, the file.
void require_space(const SweepPlan& plan, const std::string& output, const Shard& shard);

// [s] that a design takes on one thread: the mean of rows from all over the sweep, as many as two seconds take.
double seconds_of_design(const SweepPlan& plan, const RowFunction& outcomes_of);

}  // namespace flexslip
