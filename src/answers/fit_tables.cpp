#include "answers/fit_tables.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "answers/fit_fields.h"
#include "answers/profile_fields.h"
#include "result/table.h"

namespace flexslip {
Fields<BandPlace> draw_fields(std::span<const std::string> names) {
  using P = const BandPlace&;
  Fields<BandPlace> fields;
  fields
      .number("length", kind::length, "length between the contacts",
              [](P p) { return p.fit->between_contacts(p.fit->band.S[p.i]); })
      .number("mu", "friction, mean of the fit", [](P p) { return p.fit->mean.mu[p.i]; })
      .number("deviation", "standard deviation of friction", [](P p) { return p.fit->band.deviation[p.i]; });
  for (std::size_t k = 0; k < names.size(); ++k)  // all over the lengths of the band
    fields.number(names[k], "friction of a profile drawn from the fit", [k](P p) { return p.fit->draws[k].mu[p.i]; });
  return fields;
}

Fields<CurvePoint> curve_fields() {
  using P = const CurvePoint&;
  const auto own = [](auto column) { return [column](P p) { return (p.test.analysis.record.*column)[p.i]; }; };
  const auto there = [](auto get) {
    return [get](P p) -> std::optional<double> {
      const std::vector<double>& values = get(p.test.analysis);
      return is_fitted(p.test) && p.i < values.size() ? std::optional(values[p.i]) : std::nullopt;
    };
  };
  const auto read = [](auto value) {
    return [value](P p) { return p.read ? std::optional<double>(std::invoke(value, *p.read)) : std::nullopt; };
  };
  return Fields<CurvePoint>()
      .row("row", "row of the file", &CurvePoint::i)
      .own("stage", kind::length, "stage position, from the contact", own(&Record::stage))
      .titled("w_s")
      .own("deflection", kind::length, "deflection at midspan", own(&Record::deflection))
      .titled("w")
      .own("force", kind::force, "force measured", own(&Record::force))
      .titled("F")
      .number("model_force", kind::force, "force of the mean of the fit, run forward",
              there([](const TestAnalysis& a) -> const auto& { return a.fit.force; }))
      .number("replay_force", kind::force, "force of the measured profile, run forward as a table",
              there([](const TestAnalysis& a) -> const auto& { return a.replay.force; }))
      .number("length", kind::length, "length between the contacts", read(&ProfilePoint::length))
      .titled("S")
      .number("mu", "friction read off at this row", read(&ProfilePoint::mu))
      .number("mu_error", "standard error of mu", read(standard_error));
}

void write_curves(const std::string& path, const FittedTest& test) {
  const auto& read = profile_of(test).points;
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < test.analysis.record.force.size(); ++i) points.push_back({test, i, nullptr});
  for (const ProfilePoint& point : read) points[point.index].read = &point;
  write_csv(path, curve_fields(), points, frame_of(test));
}

void write_profile(const std::string& path, const FittedTest& test) {
  write_csv(path, profile_fields(), points_of(test.analysis.record, profile_of(test)), frame_of(test));
}

ResultTable draw_table(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  if (!is_fitted(test)) throw std::invalid_argument("a test without a fit has no draws");
  // Over rising lengths between the contacts, as simulate reads a table: those on the side of the middle where rollers take some off at first.
  const auto rolls_back = [&](std::size_t i) { return fit.along.rolls_back_at(fit.along.at(fit.band.S[i])); };
  std::vector<BandPlace> places;
  for (std::size_t i = 0; i < fit.band.S.size(); ++i)
    if (rolls_back(i) == rolls_back(fit.band.S.size() / 2)) places.push_back({&fit, i});
  if (rolls_back(places.front().i)) std::reverse(places.begin(), places.end());
  std::vector<std::string> names;
  for (std::size_t k = 0; k < fit.draws.size(); ++k) names.push_back(fmt::format("draw_{}", k + 1));
  return tabulated("draws", draw_fields(names), places, frame_of(test));
}

void write_draws(const std::string& path, const FittedTest& test) { write_csv(path, draw_table(test)); }

}  // namespace flexslip
