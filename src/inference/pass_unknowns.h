// The unknowns of the passes other than friction: errors of the rig, wear, losses of stiffness,
// settling.
//
// Each unknown θ has a linear effect on the rows:
//   w' = w + W θ,   F' = F + G θ,   ln(EI/nominal) = E θ,   ln(friction of the pass/friction of the first) = L θ.
// Reduced variables of the nominal EI.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "inference/pass_rows.h"
#include "inference/passes.h"
#include "inference/rig_error_effects.h"

namespace flexslip {

// The loss that one drop requires as a crack (theory.md, "Friction that cracks only would
// require").
struct NeededLoss {
  std::size_t before, after;  // rows of the record
  double log_loss;            // -ln of the remaining stiffness
};
std::vector<NeededLoss> losses_needed(const ReducedRecord& record, const std::vector<Drop>& drops, const Fibre& fibre);

// The drops, and the rows after which the force rises less than its trend by four times the noise
// of a step: cracks too small for the force to fall.
std::vector<Drop> with_breaks(std::vector<Drop> drops, const ReducedRecord& record, const std::vector<Leg>& legs);

class PassUnknowns {
 public:
  // Domain:     `read` are the states of `rows`.
  PassUnknowns(const PassesProblem& problem, const std::vector<Leg>& legs, const std::vector<NeededLoss>& needed,
               const PassRows& rows, const PassStates& read);

  Eigen::Index size() const { return mean.size(); }

  Eigen::VectorXd mean, deviation;  // prior of each
  Eigen::VectorXd below_zero;       // prior deviation below zero
  Eigen::MatrixXd W, G, E, L;       // one row for each of `rows`

  // W and G at other deflections and forces of the same rows. At the measured ones, noise would
  // look like an error of the rig.
  struct Moved {
    Eigen::MatrixXd W, G;
  };
  Moved at(const Eigen::VectorXd& w, const Eigen::VectorXd& F) const;

  // Coefficients of the unknowns for the total loss and settling in loadings that another pass
  // follows.
  Eigen::VectorXd log_loss, settled;
  static constexpr Eigen::Index stiffness = 0;  // index of ln EI
  // The index of a stated quantity, and the prior deviations (rig_error_effects.h).
  Eigen::Index of(StatedQuantity quantity) const { return static_cast<Eigen::Index>(quantity); }
  PerQuantity<double> deviations;

 private:
  Eigen::Index add(double prior_mean, double prior_deviation);
  Eigen::Index add_one_sided(double prior_deviation, double below);
  void add_rig(const PassRows& rows);
  void add_zero(const PassesProblem& problem, const PassRows& rows);
  void add_wear(const PassesOptions& options, const std::vector<Leg>& legs, const PassRows& rows,
                const PassStates& read);
  void add_losses(const PassesProblem& problem, const std::vector<Leg>& legs, const std::vector<NeededLoss>& needed,
                  const PassRows& rows);

  RigErrorEffects in_, out_;  // for a specimen that slides in or out
  std::vector<double> side_;
};

}  // namespace flexslip
