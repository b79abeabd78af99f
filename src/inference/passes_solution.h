// The solution of the fit of all passes, and its results: friction, stiffness, losses and settling
// with their errors. Reduced variables of the nominal EI.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "data/record.h"
#include "inference/pass_rows.h"
#include "inference/pass_unknowns.h"
#include "inference/passes.h"

namespace flexslip {

struct PassesSolution {
  Eigen::VectorXd nodes;           // [L] lengths of the nodes
  Eigen::VectorXd solution;        // friction at the nodes, then the unknowns
  Eigen::MatrixXd covariance;      // of the solution
  double noise = 0;                // [EI/L^2]
  Eigen::VectorXd S;               // [L] of each row
  std::vector<Eigen::Index> used;  // rows that slide
};

// The results of a solution, with the status ok.
// Domain:     `rows`, `unknowns` and `needed` are those of the solution.
PassesFit passes_fit_of(const PassesSolution& best, const PassesProblem& problem, const std::vector<Leg>& legs,
                        const std::vector<NeededLoss>& needed, const PassRows& rows, const PassUnknowns& unknowns);

}  // namespace flexslip
