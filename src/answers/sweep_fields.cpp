#include "answers/sweep_fields.h"

#include "data/names.h"
#include "design/design_result.h"

namespace flexslip {
namespace {

Fields<ToldSweep> count_fields() {
  Fields<ToldSweep> fields;
  for (std::size_t i = 0; i < result_status_words.size(); ++i)
    fields.count(result_status_words[i], "designs with this status",
                 [i](const ToldSweep& told) { return told.counts[i]; });
  return fields;
}

Fields<ToldFault> fault_fields() {
  return Fields<ToldFault>()
      .words("file", "where the part should be, or what is damaged", &ToldFault::file)
      .own_numbers("rows", kind::number, "first and last of the sweep in it",
                   [](const ToldFault& fault) {
                     return std::vector{fault.first_row, fault.last_row};
                   })
      .words("state", "missing or damaged", &ToldFault::state);
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
      .words("status", "done, or incomplete: parts are missing or damaged", &ToldSweep::status)
      .words("file", "that holds the sweep; null of a shard", &ToldSweep::file)
      .count("rows", "designs of the sweep; null where that is not known", &ToldSweep::rows)
      .group("counts", "of them by status; null where they were not counted now", count_fields(),
             [](const ToldSweep& told) { return told.counts.empty() ? nullptr : &told; })
      .list("faults", "parts that are missing or damaged", fault_fields(), &ToldSweep::faults)
      .words("parts", "folder of a shard", of_shard(&ToldShard::parts))
      .own_numbers("shard", kind::number, "which of how many", of_shard(&ToldShard::shard))
      .count("rows_found", "designs of the shard that were there already", of_shard(&ToldShard::rows_found))
      .count("rows_computed", "designs of the shard computed now", of_shard(&ToldShard::rows_computed));
}

}  // namespace flexslip
