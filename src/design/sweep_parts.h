// What a sweep has computed so far, in a folder: a file a chunk of rows, there whole or not at all, with a checksum. Several
// programs, on several computers, may write different chunks into one folder. And the one file that the sweep ends in: HDF5, with a column for
// every input and outcome.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "design/sweep_plan.h"

namespace flexslip {

enum class PartState { whole, missing, damaged };

struct Part {
  PartState state;
  std::vector<double> values;  // of each column in turn, all its rows; empty unless whole
};

class SweepParts {
 public:
  // The folder of a plan, made if it is not there.
  // Fails:      InputError if it is another plan's, or cannot be made.
  SweepParts(std::filesystem::path folder, const SweepPlan& plan);

  // A folder that is there.
  // Fails:      InputError if it is none of a sweep, or of another version.
  explicit SweepParts(std::filesystem::path folder);

  // Does a folder say that it is one of parts?
  static bool are_in(const std::filesystem::path& folder);

  // Is there a file for each chunk, whole or not?
  bool are_all_there() const;

  const SweepPlan& plan() const { return plan_; }
  const std::string& digest() const { return digest_; }  // of the plan
  const std::filesystem::path& folder() const { return folder_; }

  std::filesystem::path file_of(std::uint64_t chunk) const;

  // Cost:       6 ns a byte, for the checksum.
  Part read(std::uint64_t chunk) const;

  // Domain:     as Part::values.
  // Fails:      InputError if it cannot be written.
  void write(std::uint64_t chunk, std::span<const double> values) const;

  void remove(std::uint64_t chunk) const;

  // Removes all that is a sweep's, also what runs that were stopped left half written; and the folder if nothing else is in it.
  void remove_all() const;

 private:
  std::string head_of(std::uint64_t chunk) const;

  std::filesystem::path folder_;
  SweepPlan plan_;
  std::string digest_;
  std::size_t columns_;
};

// [bytes] that all parts of a plan take on the disk.
double bytes_of_parts(const SweepPlan& plan);

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
