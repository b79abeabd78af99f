#include "io/json.h"

#include "io/text_file.h"

namespace flexslip {

Json units_json(bool reduced) {
  if (reduced) return {{"length", "L"}, {"force", "EI/L^2"}, {"energy", "EI/L"}};
  return {{"length", "m"}, {"force", "N"}, {"energy", "J"}};
}

Json snaps_json(std::span<const Snap> snaps, const Scales& scales) {
  Json out = Json::array();
  for (const Snap& snap : snaps)
    out.push_back({{"stage", scales.physical_length(snap.stage)},
                   {"deflection_before", scales.physical_length(snap.before.w)},
                   {"deflection_after", scales.physical_length(snap.after.w)},
                   {"force_before", scales.physical_force(snap.before.F)},
                   {"force_after", scales.physical_force(snap.after.F)},
                   {"length_before", scales.physical_length(snap.before.S)},
                   {"length_after", scales.physical_length(snap.after.S)}});
  return out;
}

Json energy_json(const EnergyAccount& energy, const Scales& scales) {
  const auto physical = [&](double reduced) { return scales.physical_energy(reduced); };
  return {{"stage_work", physical(energy.stage_work)}, {"bending", physical(energy.bending)},
          {"load_train", physical(energy.load_train)}, {"friction", physical(energy.friction)},
          {"snaps", physical(energy.snaps)},           {"imbalance", physical(energy.imbalance)}};
}

void write_json(const std::string& path, const Json& json) {
  write_text(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");  // file names may be no UTF-8
}

}  // namespace flexslip
