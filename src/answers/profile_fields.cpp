#include "answers/profile_fields.h"

#include "result/mechanics.h"

namespace flexslip {

std::vector<ReadPoint> points_of(const Record& record, const FrictionProfile& profile) {
  std::vector<ReadPoint> points;
  points.reserve(profile.points.size());
  for (const ProfilePoint& point : profile.points) points.push_back({record, point});
  return points;
}

Fields<ReadPoint> profile_fields() {
  using P = const ReadPoint&;
  const auto measured = [](std::vector<double> Record::*column) {
    return [column](P p) { return (p.record.*column)[p.point.index]; };
  };
  return Fields<ReadPoint>()
      .row("row", "row of the file", [](P p) { return p.point.index; })
      .own("stage", kind::length, "stage position, from the contact", measured(&Record::stage))
      .titled("w_s")
      .own("deflection", kind::length, "deflection at midspan", measured(&Record::deflection))
      .titled("w")
      .own("force", kind::force, "force measured", measured(&Record::force))
      .titled("F")
      .number("length", kind::length, "length of the specimen's axis between the contacts",
              [](P p) { return p.point.length; })
      .titled("S")
      .number("drawn_in", kind::length, "length pulled in (both supports)", [](P p) { return p.point.S - 1; })
      .number("imaged", kind::length,
              "length of the axis between the verticals through the supports, as a camera sees it",
              [](P p) { return p.point.imaged; })
      .number("position", kind::length, "position of the support along the specimen, from midspan",
              [](P p) { return 0.5 * p.point.length; })
      .number("mu", "mobilised friction: the coefficient of friction while the specimen slides",
              [](P p) { return p.point.mu; })
      .number("mu_error", "standard error of mu", [](P p) { return standard_error(p.point); })
      .number("mu_error_force", "part of mu_error from the noise of the force", [](P p) { return p.point.from_force; })
      .number("mu_error_bending_stiffness", "part of mu_error from EI, which moves all points together",
              [](P p) { return p.point.from_bending_stiffness; })
      .number("mu_error_contact", "part of mu_error from the contact point, which moves all points together",
              [](P p) { return p.point.from_contact; });
}

Fields<ReadTest> read_test_fields() {
  using T = const ReadTest&;
  return Fields<ReadTest>()
      .words("status", "whether friction was read off: ok, or nothing_explained",
             [](T test) { return test.profile.points.empty() ? "nothing_explained" : "ok"; })
      .group("units", "units of plain numbers", units_of_numbers<ReadTest>())
      .group(
          "bending_stiffness", "bending stiffness used",
          Fields<BendingStiffnessUsed>()
              .own("value", kind::bending_stiffness, "EI", &BendingStiffnessUsed::value)
              .number("relative_error", "relative standard deviation of EI", &BendingStiffnessUsed::relative_error)
              .words("source",
                     "where EI comes from: stated, stated_without_uncertainty, initial_slope or mirror_symmetry",
                     [](const BendingStiffnessUsed& used) { return name_of(used.source); }),
          [](T test) -> const auto& { return test.stiffness; })
      .own("contact_offset", kind::length, "displacement of the contact, subtracted from stage and deflection",
           [](T test) { return test.measurement.contact_offset; })
      .own("force_noise", kind::force, "standard deviation of one force reading",
           [](T test) { return test.measurement.force_noise; })
      .count("last_row", "last row of the file that is evaluated",
             [](T test) { return last_file_row(test.measurement, test.measurement.record.force.size() - 1); })
      .list("profile", "friction along the specimen, point by point", profile_fields(),
            [](T test) { return points_of(test.measurement.record, test.profile); })
      .own_numbers("unexplained", kind::number, "rows of the file that no friction explains", [](T test) {
        std::vector<std::size_t> rows;
        for (const std::size_t point : test.profile.unexplained) rows.push_back(file_row(test.measurement, point));
        return rows;
      });
}

Frame frame_of(const ReadTest& test, const Scales& scales) {
  return {.scales = scales, .reduced = test.measurement.test.reduced, .row = [&test](std::size_t point) {
            return file_row(test.measurement, point);
          }};
}

}  // namespace flexslip
