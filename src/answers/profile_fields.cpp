#include "answers/profile_fields.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include <fmt/format.h>

#include "answers/fit_fields.h"
#include "answers/mechanics_fields.h"

namespace flexslip {

std::vector<PointOfProfile> points_of(const Record& record, const FrictionProfile& profile) {
  std::vector<PointOfProfile> points;
  points.reserve(profile.points.size());
  for (const ProfilePoint& point : profile.points) points.push_back({record, point});
  return points;
}

namespace {

Fields<PointOfProfile> place_fields() {
  using P = const PointOfProfile&;
  return Fields<PointOfProfile>()
      .number("length", kind::length, "length of the specimen's axis between the contacts",
              [](P p) { return p.point.length; })
      .titled("S")
      .number("mu", "mobilised friction; equal to the friction coefficient while the specimen slides",
              [](P p) { return p.point.mu; })
      .number("mu_error", "standard error of mu", [](P p) { return standard_error(p.point); })
      .number("mu_error_force", "part of mu_error due to force noise, without errors common to all points",
              [](P p) { return p.point.from_force; })
      .number("drawn_in", kind::length, "sliding length: length that has slid in over both supports",
              [](P p) { return p.point.S - 1; });
}

Fields<PointOfProfile> row_fields() {
  return Fields<PointOfProfile>().row("row", "row of the file", [](const PointOfProfile& p) { return p.point.index; });
}

}  // namespace

Fields<PointOfProfile> pointwise_friction_fields() { return row_fields().all_of(place_fields()); }

Fields<PointOfProfile> profile_fields() {
  using P = const PointOfProfile&;
  const auto measured = [](std::vector<double> Record::*column) {
    return [column](P p) { return (p.record.*column)[p.point.index]; };
  };
  return row_fields()
      .own("stage", kind::length, "stage position, from the contact", measured(&Record::stage))
      .titled("w_s")
      .own("deflection", kind::length, "deflection at midspan", measured(&Record::deflection))
      .titled("w")
      .own("force", kind::force, "measured force", measured(&Record::force))
      .titled("F")
      .all_of(place_fields())
      .number("imaged", kind::length,
              "length of the axis between the vertical planes through the supports, as in a side-view image",
              [](P p) { return p.point.imaged; });
}

Fields<InvertedTest> inverted_test_fields() {
  using T = const InvertedTest&;
  return Fields<InvertedTest>()
      .words("status", "ok, or nothing_explained if friction explains no row",
             [](T test) { return test.profile.points.empty() ? "nothing_explained" : "ok"; })
      .group("units", "units of plain numbers", units_of_numbers<InvertedTest>())
      .group(
          "bending_stiffness", "bending stiffness used",
          Fields<BendingStiffnessUsed>()
              .own("value", kind::bending_stiffness, "EI", &BendingStiffnessUsed::value)
              .number("relative_error", "relative standard deviation of EI", &BendingStiffnessUsed::relative_error)
              .words("source", "source of EI: stated, stated_without_uncertainty or initial_slope",
                     [](const BendingStiffnessUsed& used) { return name_of(used.source); }),
          [](T test) -> const auto& { return test.stiffness; })
      .own("contact_offset", kind::length,
           "displacement at the contact point; it is subtracted from stage and deflection",
           [](T test) { return test.measurement.contact_offset; })
      .own("force_noise", kind::force, "standard deviation of one force reading",
           [](T test) { return test.measurement.force_noise; })
      .count("last_row", "last evaluated row of the file",
             [](T test) { return last_file_row(test.measurement, test.measurement.record.force.size() - 1); })
      .list("profile", "friction along the specimen, point by point", profile_fields(),
            [](T test) { return points_of(test.measurement.record, test.profile); })
      .own_numbers("unexplained", kind::number, "rows of the file without a solution for friction", [](T test) {
        std::vector<std::size_t> rows;
        for (const std::size_t point : test.profile.unexplained) rows.push_back(file_row(test.measurement, point));
        return rows;
      });
}

Frame frame_of(const InvertedTest& test) {
  return {.scales = test.scales, .reduced = test.measurement.test.reduced, .row = [&test](std::size_t point) {
            return file_row(test.measurement, point);
          }};
}

Fields<BandPlace> draw_fields(std::span<const std::string> names) {
  using P = const BandPlace&;
  Fields<BandPlace> fields;
  fields
      .number("length", kind::length, "length between the contacts",
              [](P p) { return p.fit->between_contacts(p.fit->band.S[p.i]); })
      .number("mu", "best-fit friction", [](P p) { return p.fit->mean.mu[p.i]; })
      .number("deviation", "standard deviation of friction", [](P p) { return p.fit->band.deviation[p.i]; });
  for (std::size_t k = 0; k < names.size(); ++k)
    fields.number(names[k], "friction of a posterior sample", [k](P p) { return p.fit->draws[k].mu[p.i]; });
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
  const auto correction = [](double Shift::*part) {
    return [part](P p) {
      const TestAnalysis& a = p.test.analysis;
      return is_fitted(p.test) ? std::optional(a.fit.correction.at(a.reduced.stage[p.i]).*part) : std::nullopt;
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
      .own("force", kind::force, "measured force", own(&Record::force))
      .titled("F")
      .number("model_force", kind::force, "simulated force of the best-fit profile",
              there([](const TestAnalysis& a) -> const auto& { return a.fit.force; }))
      .number("replay_force", kind::force, "simulated force of the measured profile, used as a table",
              there([](const TestAnalysis& a) -> const auto& { return a.replay.force; }))
      .number("deflection_off", kind::length, "fitted correction of the measured deflection for errors of the rig",
              correction(&Shift::deflection))
      .number("force_off", kind::force, "fitted correction of the measured force for errors of the rig",
              correction(&Shift::force))
      .number("length", kind::length, "length between the contacts", read(&ProfilePoint::length))
      .titled("S")
      .number("mu", "friction inverted at this row", read(&ProfilePoint::mu))
      .number("mu_error", "standard error of mu", read(standard_error));
}

ResultTable curve_table(const FittedTest& test) {
  const auto& read = profile_of(test).points;
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < test.analysis.record.force.size(); ++i) points.push_back({test, i, nullptr});
  for (const ProfilePoint& point : read) points[point.index].read = &point;
  return tabulated("curves", curve_fields(), points, frame_of(test));
}

void write_curves(const std::string& path, const FittedTest& test, const CsvMarks& marks) {
  write_csv(path, curve_table(test), marks);
}

void write_profile(const std::string& path, const FittedTest& test, const CsvMarks& marks) {
  write_csv(path, profile_fields(), points_of(test.analysis.record, profile_of(test)), frame_of(test), marks);
}

ResultTable draw_table(const FittedTest& test) {
  const auto& fit = test.analysis.fit;
  if (!is_fitted(test)) throw std::invalid_argument("a test without a fit has no draws");
  // simulate needs a table with increasing lengths between the contacts. On rollers the length first
  // decreases; only the branch that contains the middle of the band is written.
  const auto moves_outward = [&](std::size_t i) {
    return fit.along.contact_moves_outward_at(fit.along.at(fit.band.S[i]));
  };
  std::vector<BandPlace> places;
  for (std::size_t i = 0; i < fit.band.S.size(); ++i)
    if (moves_outward(i) == moves_outward(fit.band.S.size() / 2)) places.push_back({&fit, i});
  if (moves_outward(places.front().i)) std::reverse(places.begin(), places.end());
  std::vector<std::string> names;
  for (std::size_t k = 0; k < fit.draws.size(); ++k) names.push_back(fmt::format("draw_{}", k + 1));
  return tabulated("draws", draw_fields(names), places, frame_of(test));
}

void write_draws(const std::string& path, const FittedTest& test, const CsvMarks& marks) {
  write_csv(path, draw_table(test), marks);
}

}  // namespace flexslip
