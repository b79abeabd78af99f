// The rows of all passes of a record that tell of friction, and what they read.
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

// Rows deep enough to show friction; of those within a drop none, of more than 1200 rows every so many.
PassRows rows_of(const PassesProblem& problem, const std::vector<Leg>& legs);

// All rows of the loading that is evaluated.
PassRows rows_evaluated(const PassesProblem& problem, const std::vector<Leg>& legs);

// The states that deflections and forces read, with the slopes of the map: F and S to w at fixed q, and to q at fixed w.
struct PassStates {
  Eigen::VectorXd S, q;  // q is NaN where no friction gives deflection and force
  Eigen::VectorXd F_q, F_w, S_q, S_w;

  bool is_read(Eigen::Index i) const { return q[i] == q[i]; }
};
PassStates states_read(const Eigen::VectorXd& w, const Eigen::VectorXd& F, const Fibre& fibre);

// The forces that frictions give at deflections, with slopes; `near` are states not far away. F is NaN where there is no state.
struct PassForces {
  Eigen::VectorXd F, F_q, F_w, S_q, S_w;
};
PassForces forces_modelled(const Eigen::VectorXd& w, const Eigen::VectorXd& q, const PassStates& near,
                           const Fibre& fibre);

// Does the specimen stick in a row? After a turn it does, until friction as read changes four times less steeply over the stage than it would at a
// length that stays. An error of the rig makes both slopes a little wrong, and hardly their ratio.
std::vector<char> stuck_rows(const PassRows& rows, const PassStates& read, double compliance, double force_noise);

}  // namespace flexslip
