#include "report/path_legs.h"

#include <algorithm>

namespace flexslip {

std::vector<Leg> legs_of(const History& history, const LegOptions& options) {
  std::vector<double> stages{0};
  stages.reserve(history.path.size() + 1);
  for (const PathPoint& point : history.path) stages.push_back(point.stage);
  std::vector<Leg> legs;
  for (const Leg& leg : find_legs(stages, options)) {
    const Leg of_path{std::max<std::size_t>(leg.first, 1) - 1, leg.last - 1, leg.direction};
    if (of_path.last > of_path.first) legs.push_back(of_path);
  }
  return legs;
}

Json legs_json(const History& history, const std::vector<Leg>& legs, const Scales& scales) {
  Json out = Json::array();
  EnergyAccount before{};
  double from = 0;
  for (const Leg& leg : legs) {
    const EnergyAccount& after = history.energy_at[leg.last - 1];
    const double to = history.path[leg.last - 1].stage;
    const auto change = [&](double EnergyAccount::*part) { return scales.physical_energy(after.*part - before.*part); };
    out.push_back({{"direction", leg.direction == Direction::loading ? "loading" : "unloading"},
                   {"from", scales.physical_length(from)},
                   {"to", scales.physical_length(to)},
                   {"stage_work", change(&EnergyAccount::stage_work)},
                   {"bending", change(&EnergyAccount::bending)},
                   {"load_train", change(&EnergyAccount::load_train)},
                   {"friction", change(&EnergyAccount::friction)},
                   {"snaps", change(&EnergyAccount::snaps)},
                   {"cracks", change(&EnergyAccount::cracks)},
                   {"work_of_fracture", scales.physical_energy(work_of_fracture(after) - work_of_fracture(before))}});
    before = after;
    from = to;
  }
  return out;
}

}  // namespace flexslip
