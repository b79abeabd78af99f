// Ψ, its derivatives and its inverse for arrays of states, on the widest vectors that the processor has, chosen when the program runs.
//
// Reduced variables as in elastica.h. Each answer depends on its own state alone, not on its neighbours or their number, and is the
// same to the last bit on every processor and as that of elastica.h for the one state.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace flexslip {

// Where states are asked for: lengths and mobilised frictions in pairs.
class FibrePoints {
 public:
  // Domain:     arrays of one length, which outlive this; S >= 1, finite, and q in [-20, 20]; std::invalid_argument, naming the index,
  //             otherwise.
  FibrePoints(std::span<const double> S, std::span<const double> q);

  std::size_t size() const { return S_.size(); }
  const double* lengths() const { return S_.data(); }    // [L]
  const double* frictions() const { return q_.data(); }  // [1]

 private:
  std::span<const double> S_, q_;
};

// Deflections and forces; both NaN where there is no state (beyond_branch).
struct StateArrays {
  std::vector<double> w;  // [L]
  std::vector<double> F;  // [EI/L^2]
  explicit StateArrays(std::size_t n) : w(n), F(n) {}
};

// The same with their partial derivatives: with respect to S at fixed q, and to q at fixed S. These are NaN also at S = 1, where those to S
// are infinite.
struct SlopeArrays {
  std::vector<double> w, F;
  std::vector<double> w_S, w_q, F_S, F_q;
  explicit SlopeArrays(std::size_t n) : w(n), F(n), w_S(n), w_q(n), F_S(n), F_q(n) {}
  std::array<double*, 6> columns() { return {w.data(), F.data(), w_S.data(), w_q.data(), F_S.data(), F_q.data()}; }
};

// Max error:  as fibre_state, of which these are the values, bit by bit.
// Cost:       about 35 ns a state on a processor with AVX2; beyond S = 2.16, q in [-1.2, 3] or near the end of the branch as much as
//             fibre_state (docs/numerics.md).
StateArrays fibre_states(const FibrePoints& points);

// Likewise those of fibre_state_slopes. Cost: about 100 ns.
SlopeArrays fibre_states_slopes(const FibrePoints& points);

}  // namespace flexslip
