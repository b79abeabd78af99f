// States, as `state`, `invert` and `equilibrium` tell them, described once: single ones in reduced variables, and curves of them.
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

// A state on edges, of a length and a friction; none where none exists.
struct EdgeState {
  double S, q;
  std::optional<FibreState> state{};
  std::optional<FibreSlopes> slopes{};
};
Fields<EdgeState> edge_state_fields(bool slopes);

// A state on rollers, or of a thick fibre, of a deflection.
struct RollerState {
  double w;
  std::optional<SupportedState> state{};
};
Fields<RollerState> roller_state_fields();

// Length and friction of a deflection and a force.
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
      .list("states", "row by row", of_each, &States<State>::states);
}

inline constexpr std::string_view no_state = "ok, or beyond_branch: some rows have no state";
inline constexpr std::string_view no_friction = "ok, or no_friction: some rows are explained by none";

struct ToldEquilibrium {
  EquilibriumPoint point;
  double between_contacts;  // [L]
};

struct EquilibriumColumns {
  bool region;    // all equilibria, not the curve of loading
  bool drawn_in;  // is not told by the length
};

Fields<ToldEquilibrium> equilibrium_fields(const EquilibriumColumns& columns);

// Of `equilibrium --json`.
Fields<EquilibriumStudy> equilibria_fields(const EquilibriumColumns& columns);

// What a study tells, and in which columns.
std::vector<ToldEquilibrium> points_of(const EquilibriumStudy& study);
EquilibriumColumns columns_of(const EquilibriumStudy& study);

}  // namespace flexslip
