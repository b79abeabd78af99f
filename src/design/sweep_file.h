// The one file that a sweep ends in: HDF5, with a column for every input and outcome.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "design/sweep_parts.h"

namespace flexslip {

struct PartFault {
  std::uint64_t chunk;
  PartState state;   // missing or damaged
  std::string file;  // where it should be, or what is damaged
};

enum class MergeStatus {
  done,
  incomplete,  // no file is written, for the faults
  stopped,     // no file is written
};

struct SweepMerge {
  MergeStatus status;
  std::vector<PartFault> faults;      // of all parts, if incomplete
  std::vector<std::uint64_t> counts;  // of rows, for each RowStatus; if done
};

struct MergeOptions {
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::uint64_t rows_done, std::uint64_t rows)> progress{};
};

// Joins parts, each looked for in all folders in turn. The file is there whole or not at all; the folders stay as they are.
// Domain:     at least one folder, all of one plan; std::invalid_argument otherwise.
// Fails:      InputError if the file cannot be written.
// Cost:       about 3 µs a row on one thread; memory does not grow with the rows, but by 100 bytes for each part at fault.
SweepMerge merge_sweep(std::span<const SweepParts> folders, const std::string& path, const MergeOptions& options);

// The plan of a file that merge_sweep wrote, as SweepParts::digest() says it; none if it is no such file.
std::optional<std::string> digest_of_sweep_file(const std::string& path);

// Is the file there? It is that of the sweep with this digest.
// Fails:      InputError if another file is there.
bool finds_sweep(const std::string& path, const std::string& digest);

// [bytes] that the file of a plan takes at most.
double bytes_of_sweep_file(const SweepPlan& plan);

}  // namespace flexslip
