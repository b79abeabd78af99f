#include "answers/equilibrium_fields.h"

#include "result/mechanics.h"

namespace flexslip {

Fields<ToldEquilibrium> equilibrium_fields(const EquilibriumColumns& columns) {
  using P = const ToldEquilibrium&;
  Fields<ToldEquilibrium> fields;
  fields
      .number("length", kind::length, "length of the specimen's axis between the contacts",
              &ToldEquilibrium::between_contacts)
      .titled("S")
      .number(columns.region ? "q" : "mu", columns.region ? "mobilised friction" : "friction",
              [](P p) { return p.point.q; })
      .number("deflection", kind::length, "deflection at midspan", [](P p) { return p.point.w; })
      .titled("w")
      .number("force", kind::force, "force at midspan", [](P p) { return p.point.F; })
      .titled("F");
  if (columns.drawn_in)
    fields.number("drawn_in", kind::length, "length that has slid past the first contacts, over both supports",
                  [](P p) { return p.point.S - 1; });
  return fields;
}

Fields<Equilibria> equilibria_fields(const EquilibriumColumns& columns) {
  return Fields<Equilibria>()
      .words("status", "whether the curve is complete: ok, or branch_ended, where the force has fallen to zero",
             &Equilibria::status)
      .group("units", "units of plain numbers", units_of_numbers<Equilibria>())
      .list(columns.region ? "region" : "curve",
            columns.region ? "all equilibria, with --region" : "curve of loading, where friction is fully mobilised",
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
