// Ψ and its derivatives for arrays of states, vectorised for the processor on which the program
// runs.
//
// Reduced variables as in elastica.h. Each result depends on its own state alone. It is
// bit-identical on every processor and to the scalar functions of elastica.h.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace flexslip {

// Pairs of sliding length and mobilised friction.
class FibrePoints {
 public:
  // Domain:     arrays of equal length, which outlive this; S >= 1, finite, and q in [-20, 20];
  //             std::invalid_argument with the index otherwise.
  FibrePoints(std::span<const double> S, std::span<const double> q);

  std::size_t size() const { return S_.size(); }
  const double* lengths() const { return S_.data(); }    // [L]
  const double* frictions() const { return q_.data(); }  // [1]

 private:
  std::span<const double> S_, q_;
};

// Deflections and forces; both NaN without a state (beyond_branch).
struct StateArrays {
  std::vector<double> w;  // [L]
  std::vector<double> F;  // [EI/L^2]
  explicit StateArrays(std::size_t n) : w(n), F(n) {}
};

// Deflections and forces with their partial derivatives, X_S at fixed q and X_q at fixed S. The
// derivatives are also NaN at S = 1, where those with respect to S are infinite.
struct SlopeArrays {
  std::vector<double> w, F;
  std::vector<double> w_S, w_q, F_S, F_q;
  explicit SlopeArrays(std::size_t n) : w(n), F(n), w_S(n), w_q(n), F_S(n), F_q(n) {}
  std::array<double*, 6> columns() { return {w.data(), F.data(), w_S.data(), w_q.data(), F_S.data(), F_q.data()}; }
};

// Max error:  bit-identical to fibre_state.
// Cost:       about 35 ns a state with AVX2. The cost of fibre_state for S > 2.16, q outside [-1.2,
//             3] and near the end of the branch (docs/numerics.md).
StateArrays fibre_states(const FibrePoints& points);

// Max error:  bit-identical to fibre_state_slopes.
// Cost:       about 100 ns a state.
SlopeArrays fibre_states_slopes(const FibrePoints& points);

}  // namespace flexslip
