// The fields of states (`state`, `invert`, `equilibrium`) in reduced variables: single states and
// curves.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bending_test/equilibrium.h"
#include "case/studies.h"
#include "fibre/elastica.h"
#include "fibre/supported_state.h"
#include "result/fields.h"

namespace flexslip {

// A state on knife edges by length and friction; empty if none exists.
struct EdgeState {
  double S, q;
  std::optional<FibreState> state{};
  std::optional<FibreSlopes> slopes{};
};
Fields<EdgeState> edge_state_fields(bool slopes);

// A state on rollers or with a thickness, by deflection; empty if none exists.
struct RollerState {
  double w;
  std::optional<SupportedState> state{};
};
Fields<RollerState> roller_state_fields();

// Length and friction for a deflection and a force; empty if no friction explains them.
struct InvertedState {
  double w, F;
  std::optional<double> S{}, q{};
};
Fields<InvertedState> inverted_fields();

template <class State>
struct States {
  std::string_view status;
  std::vector<State> states;
};
template <class State>
Fields<States<State>> states_fields(std::string_view status, const Fields<State>& of_each) {
  return Fields<States<State>>()
      .words("status", status, &States<State>::status)
      .list("states", "states, row by row", of_each, &States<State>::states);
}

inline constexpr std::string_view no_state = "ok, or beyond_branch if some rows have no state";
inline constexpr std::string_view no_friction = "ok, or no_friction if some rows have no solution";

struct EquilibriumRow {
  EquilibriumPoint point;
  double between_contacts;  // [L]
};

struct EquilibriumColumns {
  bool region;    // all equilibria, instead of the loading curve
  bool drawn_in;  // the sliding length is not determined by the length
};

Fields<EquilibriumRow> equilibrium_fields(const EquilibriumColumns& columns);

// The fields of `equilibrium --json`.
Fields<EquilibriumStudy> equilibria_fields(const EquilibriumColumns& columns);

// The points of a study and its columns.
std::vector<EquilibriumRow> points_of(const EquilibriumStudy& study);
EquilibriumColumns columns_of(const EquilibriumStudy& study);

}  // namespace flexslip
