#include "fibre/state_table.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fibre/cell_table.h"

namespace flexslip {
namespace {

const CellTable& table() {
  static const CellTable states(CellTable::Along::length, {table_sigma, 32, table_q.least, table_q.greatest, 48},
                                [](std::span<const double> sigma, std::span<const double> q) {
                                  std::vector<double> S;
                                  S.reserve(sigma.size());
                                  for (const double x : sigma) S.push_back(1 + x * x);
                                  StateArrays at = fibre_states({S, q});
                                  for (std::size_t i = 0; i < S.size(); ++i) {
                                    const double rounded = std::sqrt(S[i] - 1);  // to which the state belongs
                                    at.w[i] /= rounded;
                                    at.F[i] /= rounded;
                                  }
                                  return CellTable::Pair{std::move(at.w), std::move(at.F)};
                                });
  return states;
}

// States of which the table has nothing.
struct Rest {
  std::vector<std::size_t> index;
  std::vector<double> S, q;
  Rest(const FibrePoints& points, const std::vector<double>& w) {
    for (std::size_t i = 0; i < w.size(); ++i) {
      if (!std::isnan(w[i])) continue;
      index.push_back(i);
      S.push_back(points.lengths()[i]);
      q.push_back(points.frictions()[i]);
    }
  }
};

}  // namespace

StateArrays tabulated_states(const FibrePoints& points) {
  StateArrays states(points.size());
  table().values(points.lengths(), points.frictions(), points.size(), states.w.data(), states.F.data());
  const Rest rest(points, states.w);
  const StateArrays exact = fibre_states({rest.S, rest.q});
  for (std::size_t j = 0; j < rest.index.size(); ++j) {
    states.w[rest.index[j]] = exact.w[j];
    states.F[rest.index[j]] = exact.F[j];
  }
  return states;
}

SlopeArrays tabulated_states_slopes(const FibrePoints& points) {
  SlopeArrays states(points.size());
  const auto columns = states.columns();
  table().slopes(points.lengths(), points.frictions(), points.size(), columns);
  const Rest rest(points, states.w);
  SlopeArrays exact = fibre_states_slopes({rest.S, rest.q});
  const auto from = exact.columns();
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t j = 0; j < rest.index.size(); ++j) columns[k][rest.index[j]] = from[k][j];
  return states;
}

}  // namespace flexslip
