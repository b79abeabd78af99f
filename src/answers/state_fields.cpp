#include "answers/state_fields.h"

#include "answers/mechanics_fields.h"

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
  fields.number("S", "arc length between the supports, over the span L", &EdgeState::S)
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
      .number("slid", "sliding length along the surface, over L", of(&SupportedState::slid))
      .number("imaged", "length of the axis between the vertical planes through the supports, over L",
              of(&SupportedState::imaged));
}

Fields<InvertedState> inverted_fields() {
  return Fields<InvertedState>()
      .number("w", "deflection at midspan, over the span L", &InvertedState::w)
      .number("F", "force, over EI/L²", &InvertedState::F)
      .number("S", "length between the contacts, over L", &InvertedState::S)
      .number("q", "mobilised friction", &InvertedState::q);
}

Fields<EquilibriumRow> equilibrium_fields(const EquilibriumColumns& columns) {
  using P = const EquilibriumRow&;
  Fields<EquilibriumRow> fields;
  fields
      .number("length", kind::length, "length of the specimen's axis between the contacts",
              &EquilibriumRow::between_contacts)
      .titled("S")
      .number(columns.region ? "q" : "mu", columns.region ? "mobilised friction" : "friction",
              [](P p) { return p.point.q; })
      .number("deflection", kind::length, "deflection at midspan", [](P p) { return p.point.w; })
      .titled("w")
      .number("force", kind::force, "force at midspan", [](P p) { return p.point.F; })
      .titled("F");
  if (columns.drawn_in)
    fields.number("drawn_in", kind::length,
                  "sliding length: length that has slid in past the first contacts, over both supports",
                  [](P p) { return p.point.S - 1; });
  return fields;
}

Fields<EquilibriumStudy> equilibria_fields(const EquilibriumColumns& columns) {
  return Fields<EquilibriumStudy>()
      .words(
          "status", "ok, or branch_ended if the force falls to zero",
          [](const EquilibriumStudy& study) { return study.status == EquilibriumStatus::ok ? "ok" : "branch_ended"; })
      .group("units", "units of plain numbers", units_of_numbers<EquilibriumStudy>())
      .list(columns.region ? "region" : "curve",
            columns.region ? "all equilibria, with --region" : "loading curve, with friction fully mobilised",
            equilibrium_fields(columns), [](const EquilibriumStudy& study) { return points_of(study); });
}

std::vector<EquilibriumRow> points_of(const EquilibriumStudy& study) {
  std::vector<EquilibriumRow> points;
  const Fibre& fibre = study.fibre;
  for (const EquilibriumPoint& point : study.points)
    points.push_back({point, fibre.on_edges()
                                 ? point.S
                                 : fibre.length_between_contacts(fibre.at_deflection(point.w, point.q).state)});
  return points;
}

EquilibriumColumns columns_of(const EquilibriumStudy& study) { return {study.region, !study.fibre.on_edges()}; }

}  // namespace flexslip
