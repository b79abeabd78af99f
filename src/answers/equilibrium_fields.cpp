#include "answers/equilibrium_fields.h"

#include "result/mechanics.h"

namespace flexslip {

Fields<ToldEquilibrium> equilibrium_fields(const EquilibriumColumns& columns) {
  using P = const ToldEquilibrium&;
  Fields<ToldEquilibrium> fields;
  fields
      .number("length", kind::length, "of the specimen's axis between the contacts", &ToldEquilibrium::between_contacts)
      .titled("S")
      .number(columns.region ? "q" : "mu", columns.region ? "mobilised friction" : "friction",
              [](P p) { return p.point.q; })
      .number("deflection", kind::length, "at midspan", [](P p) { return p.point.w; })
      .titled("w")
      .number("force", kind::force, "at midspan", [](P p) { return p.point.F; })
      .titled("F");
  if (columns.drawn_in)
    fields.number("drawn_in", kind::length, "what has slid past the first contacts, over both supports",
                  [](P p) { return p.point.S - 1; });
  return fields;
}

Fields<Equilibria> equilibria_fields(const EquilibriumColumns& columns) {
  return Fields<Equilibria>()
      .words("status", "ok, or branch_ended: the curve ends where the force has fallen to zero", &Equilibria::status)
      .group("units", "of plain numbers", units_of_numbers<Equilibria>())
      .list(columns.region ? "region" : "curve",
            columns.region ? "all equilibria, with --region" : "of loading, where friction is fully mobilised",
            equilibrium_fields(columns), &Equilibria::points);
}

Equilibria told_of(const EquilibriumStudy& study) {
  Equilibria told{study.status == EquilibriumStatus::ok ? "ok" : "branch_ended", {}};
  const Fibre& fibre = study.fibre;
  for (const EquilibriumPoint& point : study.points)
    told.points.push_back(
        {point, fibre.on_edges() ? point.S : fibre.length_between_contacts(fibre.bent(point.w, point.q).state)});
  return told;
}

EquilibriumColumns columns_of(const EquilibriumStudy& study) { return {study.region, !study.fibre.on_edges()}; }

}  // namespace flexslip
