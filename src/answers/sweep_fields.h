// What `sweep --json` and `merge --json` tell of what came of a sweep.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "design/sweep_parts.h"
#include "result/fields.h"

namespace flexslip {

struct ToldShard {
  std::string parts;                   // the folder
  std::array<std::uint64_t, 2> shard;  // which of how many
  std::uint64_t rows_found, rows_computed;
};

struct ToldFault {
  std::string file;
  std::uint64_t first_row, last_row;  // of the sweep, counted from 1
  std::string_view state;
};

struct ToldSweep {
  std::string_view status;
  std::optional<std::string> file{};
  std::optional<std::uint64_t> rows{};
  std::vector<std::uint64_t> counts{};  // as SweepMerge; empty where they were not counted
  std::vector<ToldFault> faults{};
  std::optional<ToldShard> shard{};
};

std::vector<ToldFault> faults_of(const SweepMerge& merge, const SweepPlan& plan);

Fields<ToldSweep> sweep_fields();

}  // namespace flexslip
