// What `design`, `sweep` and `merge` tell, described once: of a planned test, of a map of them, and of what came of a sweep.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "design/design_answer.h"
#include "design/design_result.h"
#include "design/sweep_parts.h"
#include "result/fields.h"

namespace flexslip {

// An answer with the sentences that tell it.
struct ToldDesign {
  const DesignAnswer& answer;
  std::string words;
  std::vector<std::string> changes;  // one of each change
};

// Units: those of the case. What is infinite or does not exist is null.
Fields<ToldDesign> design_fields();

// A map: a row for each of its points.
Fields<MapPoint> map_fields(const std::vector<DesignAxis>& axes);
Fields<std::vector<MapPoint>> design_map_fields(const std::vector<DesignAxis>& axes);

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
