// The states that every method is tried on, and those that it is held to: 40 digits, S from 1.001 to 1.6, q from -1 to 2.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "tests/fibre/accuracy.h"

namespace flexslip {

struct Points {
  std::vector<double> S, q;
};

// As a test visits them: S up to 1.5, friction from 0.3 to 0.8.
inline const Points& visited_states() {
  static const Points states = [] {
    Points made;
    for (int i = 0; i < 1000; ++i) {
      made.S.push_back(1.0001 + 0.5 * i / 1000);
      made.q.push_back(0.3 + 0.5 * (i % 7) / 7);
    }
    return made;
  }();
  return states;
}

struct ReferenceRow {
  std::string_view group;
  double S, q;
  Digits u, w, F, theta0, Pn, U;
  Digits w_S, w_q, F_S, F_q, U_S, U_q, Pn_S, Pn_q, condition_F_S, condition_F_q, theta0_S, theta0_q;
};

inline const std::vector<ReferenceRow>& reference_rows() {
  static const std::vector<ReferenceRow> rows = [] {
    std::vector<ReferenceRow> all{
#include "reference/states.inc"
    };
    std::erase_if(all, [](const ReferenceRow& row) { return row.group != "working"; });
    return all;
  }();
  return rows;
}

inline const Points& reference_states() {
  static const Points states = [] {
    Points made;
    for (const auto& row : reference_rows()) {
      made.S.push_back(row.S);
      made.q.push_back(row.q);
    }
    return made;
  }();
  return states;
}

// Counters `error_w` and `error_F`, the worst of states with arrays w and F made from reference_states(): relative, that of F
// divided by its condition number (docs/numerics.md).
template <class States>
void report_errors(benchmark::State& run, const States& states) {
  double error_w = 0;
  double error_F = 0;
  for (std::size_t i = 0; i < reference_rows().size(); ++i) {
    const auto& row = reference_rows()[i];
    const double condition = 1 + std::abs((row.S - 1) * row.F_S.hi / row.F.hi) + std::abs(row.condition_F_q.hi);
    if (!std::isfinite(states.w[i]) || !std::isfinite(states.F[i])) return run.SkipWithError("a state was not found");
    error_w = std::max(error_w, unit * error_of(states.w[i], row.w));
    error_F = std::max(error_F, unit * error_of(states.F[i], row.F) / condition);
  }
  run.counters["error_w"] = error_w;
  run.counters["error_F"] = error_F;
}

}  // namespace flexslip
