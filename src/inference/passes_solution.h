// What the fit of all passes ends with, and what that tells: friction, stiffness, losses and settling with their errors.
// Reduced variables of the nominal EI.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "data/record.h"
#include "inference/pass_rows.h"
#include "inference/pass_unknowns.h"
#include "inference/passes.h"

namespace flexslip {

struct PassesSolution {
  Eigen::VectorXd nodes;           // [L] lengths at which friction is known
  Eigen::VectorXd solution;        // friction at the nodes, then the unknowns
  Eigen::MatrixXd covariance;      // likewise
  double noise = 0;                // [EI/L^2]
  Eigen::VectorXd S;               // [L] of each row
  std::vector<Eigen::Index> used;  // rows that slide
};

// Every field of a fit whose status is ok.
// Domain:     a solution of the problem; `rows`, `unknowns` and `needed` are those it was found with.
PassesFit told_of(const PassesSolution& best, const PassesProblem& problem, const std::vector<Leg>& legs,
                  const std::vector<NeededLoss>& needed, const PassRows& rows, const PassUnknowns& unknowns);

}  // namespace flexslip
