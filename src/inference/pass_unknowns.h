// What is unknown of the passes of a record besides friction along the fibre: errors of the rig, wear, losses of stiffness, settling.
//
// Each unknown θ is linear in what it does to the rows:
//   w' = w + W θ,   F' = F + G θ,   ln(EI/nominal) = E θ,   ln(friction of the pass/that of the first) = L θ.
// Reduced variables of the nominal EI.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "inference/pass_rows.h"
#include "inference/passes.h"
#include "inference/rig_error_effects.h"

namespace flexslip {

// What a drop of the force needs if it is a crack (theory.md, "Friction that cracks only would require").
struct NeededLoss {
  std::size_t before, after;  // rows of the record
  double log_loss;            // of stiffness, as -ln of what it leaves
};
std::vector<NeededLoss> losses_needed(const ReducedRecord& record, const std::vector<Drop>& drops, const Fibre& fibre);

// The drops, and besides them the rows behind which a loading rises by less than its course, beyond four times the noise of a step: a crack too small,
// or in too steep a rise, for the force to fall.
std::vector<Drop> with_breaks(std::vector<Drop> drops, const ReducedRecord& record, const std::vector<Leg>& legs);

class PassUnknowns {
 public:
  // Domain:     `read` are the states that `rows` read.
  PassUnknowns(const PassesProblem& problem, const std::vector<Leg>& legs, const std::vector<NeededLoss>& needed,
               const PassRows& rows, const PassStates& read);

  Eigen::Index size() const { return mean.size(); }

  Eigen::VectorXd mean, deviation;  // of the prior of each
  Eigen::VectorXd below_zero;       // its deviation there
  Eigen::MatrixXd W, G, E, L;       // a row for each of `rows`

  // W and G at other deflections and forces of the same rows. At those read, noise itself would pass for an error of the rig.
  struct Moved {
    Eigen::MatrixXd W, G;
  };
  Moved at(const Eigen::VectorXd& w, const Eigen::VectorXd& F) const;

  // Of all that is lost, and of all that settles, in loadings that another pass follows: coefficients of the unknowns.
  Eigen::VectorXd log_loss, settled;
  static constexpr Eigen::Index stiffness = 0;  // of ln EI
  // Of a quantity that is stated, and its prior deviation (rig_error_effects.h).
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

  RigErrorEffects in_, out_;  // of the rig, for a specimen that slides in or out
  std::vector<double> side_;
};

}  // namespace flexslip
