#include "answers/sweep_fields.h"

#include "data/names.h"
#include "design/design_result.h"

namespace flexslip {
namespace {

Fields<ToldSweep> count_fields() {
  Fields<ToldSweep> fields;
  for (std::size_t i = 0; i < result_status_words.size(); ++i)
    fields.count(result_status_words[i], "number of designs with this status",
                 [i](const ToldSweep& told) { return told.counts[i]; });
  return fields;
}

Fields<ToldFault> fault_fields() {
  return Fields<ToldFault>()
      .words("file", "file of the part that is missing or damaged", &ToldFault::file)
      .own_numbers("rows", kind::number, "first and last row of the sweep in the part",
                   [](const ToldFault& fault) {
                     return std::vector{fault.first_row, fault.last_row};
                   })
      .words("state", "state of the part: missing or damaged", &ToldFault::state);
}

}  // namespace

std::vector<ToldFault> faults_of(const SweepMerge& merge, const SweepPlan& plan) {
  std::vector<ToldFault> faults;
  for (const PartFault& fault : merge.faults) {
    const auto [first, count] = rows_of_chunk(plan, fault.chunk);
    faults.push_back({fault.file, first + 1, first + count,
                      name_in_order<PartState::damaged>(fault.state, {"whole", "missing", "damaged"})});
  }
  return faults;
}

Fields<ToldSweep> sweep_fields() {
  const auto of_shard = [](auto part) {
    return [part](const ToldSweep& told) { return told.shard ? std::optional((*told.shard).*part) : std::nullopt; };
  };
  return Fields<ToldSweep>()
      .words("status", "whether the sweep is complete: done, or incomplete (parts are missing or damaged)",
             &ToldSweep::status)
      .words("file", "file that holds the sweep; null for a shard", &ToldSweep::file)
      .count("rows", "number of designs of the sweep; null if unknown", &ToldSweep::rows)
      .group("counts", "number of designs by status; null if they were not counted now", count_fields(),
             [](const ToldSweep& told) { return told.counts.empty() ? nullptr : &told; })
      .list("faults", "parts that are missing or damaged", fault_fields(), &ToldSweep::faults)
      .words("parts", "folder of the parts of a shard", of_shard(&ToldShard::parts))
      .own_numbers("shard", kind::number, "index of the shard and number of shards", of_shard(&ToldShard::shard))
      .count("rows_found", "number of designs of the shard that were already there", of_shard(&ToldShard::rows_found))
      .count("rows_computed", "number of designs of the shard computed now", of_shard(&ToldShard::rows_computed));
}

}  // namespace flexslip
