#include "bending_test/energy.h"

namespace flexslip {

EnergyAccount account_after(const EnergyAccount& account, const Stretch& stretch, const Rig& rig) {
  EnergyAccount next = account;
  next.stage_work += stretch.work.stage;
  next.friction += stretch.work.friction;
  next.snaps += stretch.work.released;
  next.cracks += stretch.work.cracked;
  next.bending = stretch.to.left * state_at(rig.fibre, stretch.to).U;
  next.load_train = 0.5 * stretch.to.F * stretch.to.F / rig.stiffness;
  next.imbalance = next.stage_work - (next.bending + next.load_train + next.friction + next.snaps + next.cracks);
  return next;
}

double work_of_fracture(const EnergyAccount& account) { return account.stage_work - account.load_train; }

}  // namespace flexslip
