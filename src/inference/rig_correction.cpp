#include "inference/rig_correction.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace flexslip {

RigCorrection::RigCorrection(std::vector<double> stage, std::vector<Shift> shift, double compliance)
    : stage_(std::move(stage)), shift_(std::move(shift)), compliance_(compliance) {}

Shift RigCorrection::at(double stage) const {
  if (stage_.empty()) return {0, 0};
  const auto beyond = static_cast<std::size_t>(std::upper_bound(stage_.begin(), stage_.end(), stage) - stage_.begin());
  if (beyond == stage_.size()) return shift_.back();
  const double from = beyond > 0 ? stage_[beyond - 1] : 0;
  const Shift before = beyond > 0 ? shift_[beyond - 1] : Shift{0, 0}, after = shift_[beyond];
  const double part = std::max((stage - from) / (stage_[beyond] - from), 0.0);
  return {before.deflection + part * (after.deflection - before.deflection),
          before.force + part * (after.force - before.force)};
}

double RigCorrection::corrected_stage(double stage) const {
  const Shift shift = at(stage);
  return stage + shift.deflection + compliance_ * shift.force;
}

ReducedRecord RigCorrection::corrected(ReducedRecord record) const {
  for (std::size_t i = 0; i < record.stage.size(); ++i) {
    const Shift shift = at(record.stage[i]);
    record.stage[i] = corrected_stage(record.stage[i]);
    record.deflection[i] += shift.deflection;
    record.force[i] += shift.force;
  }
  return record;
}

}  // namespace flexslip
