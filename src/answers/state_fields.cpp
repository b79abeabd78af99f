#include "answers/state_fields.h"

namespace flexslip {

Fields<EdgeState> edge_state_fields(bool slopes) {
  using S = const EdgeState&;
  const auto of = [](auto get) {
    return [get](S row) { return row.state ? std::optional<double>(std::invoke(get, *row.state)) : std::nullopt; };
  };
  const auto slope = [](double FibreSlopes::*part) {
    return [part](S row) { return row.slopes ? std::optional((*row.slopes).*part) : std::nullopt; };
  };
  Fields<EdgeState> fields;
  fields.number("S", "length between the supports, over the span L", &EdgeState::S)
      .number("q", "mobilised friction", &EdgeState::q)
      .number("w", "deflection at midspan, over L", of(&FibreState::w))
      .number("F", "force, over EI/L²", of(&FibreState::F))
      .number("theta0", "slope at the supports, in radians", of(&FibreState::theta0))
      .number("Pn", "normal force at one support, over EI/L²", of(&FibreState::Pn))
      .number("U", "bending energy, over EI/L", of(&FibreState::U))
      .number("curvature", "curvature at midspan, times L", of(curvature_at_midspan));
  if (slopes)
    fields.number("w_S", "derivative of w with respect to S", slope(&FibreSlopes::w_S))
        .number("w_q", "derivative of w with respect to q", slope(&FibreSlopes::w_q))
        .number("F_S", "derivative of F with respect to S", slope(&FibreSlopes::F_S))
        .number("F_q", "derivative of F with respect to q", slope(&FibreSlopes::F_q))
        .number("Pn_S", "derivative of Pn with respect to S", slope(&FibreSlopes::Pn_S))
        .number("Pn_q", "derivative of Pn with respect to q", slope(&FibreSlopes::Pn_q))
        .number("U_S", "derivative of U with respect to S", slope(&FibreSlopes::U_S))
        .number("U_q", "derivative of U with respect to q", slope(&FibreSlopes::U_q));
  return fields;
}

Fields<RollerState> roller_state_fields() {
  const auto of = [](double SupportedState::*part) {
    return [part](const RollerState& row) { return row.state ? std::optional((*row.state).*part) : std::nullopt; };
  };
  return Fields<RollerState>()
      .number("w", "deflection at midspan, over the span L", &RollerState::w)
      .number("q", "mobilised friction", of(&SupportedState::q))
      .number("F", "force, over EI/L²", of(&SupportedState::F))
      .number("theta0", "slope at the contacts, in radians", of(&SupportedState::theta0))
      .number("Pn", "normal force at one support, over EI/L²", of(&SupportedState::Pn))
      .number("U", "bending energy, over EI/L", of(&SupportedState::U))
      .number("curvature", "curvature at midspan, times L", of(&SupportedState::curvature))
      .number("length", "length of the axis between the contacts, over L", of(&SupportedState::length))
      .number("slid", "length that has slid past the contacts along the surface, over L", of(&SupportedState::slid))
      .number("imaged", "length of the axis between the verticals through the supports, over L",
              of(&SupportedState::imaged));
}

Fields<InvertedState> inverted_fields() {
  return Fields<InvertedState>()
      .number("w", "deflection at midspan, over the span L", &InvertedState::w)
      .number("F", "force, over EI/L²", &InvertedState::F)
      .number("S", "length between the contacts, over L", &InvertedState::S)
      .number("q", "mobilised friction", &InvertedState::q);
}

}  // namespace flexslip
