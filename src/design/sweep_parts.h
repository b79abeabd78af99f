// What a sweep has computed so far, in a folder: a file a chunk of rows, there whole or not at all, with a checksum. Several
// programs, on several computers, may write different chunks into one folder.
#pragma once

#include <cstdint>
#include <filesystem>
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

}  // namespace flexslip
