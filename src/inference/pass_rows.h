// The rows of all passes that carry information on friction, and their states.
// Reduced variables of the nominal EI.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "data/record.h"
#include "fibre/fibre.h"
#include "inference/passes.h"

namespace flexslip {

inline Eigen::Index index_of(std::size_t i) { return static_cast<Eigen::Index>(i); }

inline bool is_in(const Leg& leg, std::size_t row) { return row >= leg.first && row < leg.last; }

struct PassRows {
  std::vector<std::size_t> row, pass;  // in the record; in its legs
  std::vector<double> side;            // +1 in a pass inwards, -1 outwards
  Eigen::VectorXd stage, w, F;

  std::size_t size() const { return row.size(); }
  void add(const ReducedRecord& record, const std::vector<Leg>& legs, std::size_t leg,
           const std::vector<std::size_t>& chosen);
};

// The rows deep enough for friction and not within a drop, thinned to 1200.
PassRows rows_of(const PassesProblem& problem, const std::vector<Leg>& legs);

// All rows of the evaluated loading.
PassRows rows_evaluated(const PassesProblem& problem, const std::vector<Leg>& legs);

// The states inverted from deflections and forces, with derivatives of F and S in w and q.
struct PassStates {
  Eigen::VectorXd S, q;  // q is NaN if no friction explains deflection and force
  Eigen::VectorXd F_q, F_w, S_q, S_w;

  bool is_read(Eigen::Index i) const { return q[i] == q[i]; }
};
PassStates states_read(const Eigen::VectorXd& w, const Eigen::VectorXd& F, const Fibre& fibre);

// The modelled forces for given frictions and deflections, with derivatives; `near` are approximate
// states. F is NaN without a state.
struct PassForces {
  Eigen::VectorXd F, F_q, F_w, S_q, S_w;
};
PassForces forces_modelled(const Eigen::VectorXd& w, const Eigen::VectorXd& q, const PassStates& near,
                           const Fibre& fibre);

// For each row, true if the specimen sticks. It sticks after a turn until the inverted friction
// changes four times more slowly with the stage than at constant length. Errors of the rig barely
// change this ratio.
std::vector<char> stuck_rows(const PassRows& rows, const PassStates& read, double compliance, double force_noise);

}  // namespace flexslip
