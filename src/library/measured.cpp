#include <string>
#include <utility>
#include <vector>

#include "answers/fit_fields.h"
#include "answers/standard_fields.h"
#include "case/case_file.h"
#include "case/fitted.h"
#include "case/studies.h"
#include "flexslip/fit.h"
#include "flexslip/modulus.h"
#include "flexslip/read.h"
#include "instruments/export.h"
#include "library/inputs.h"
#include "result/table.h"

namespace flexslip::v1 {
namespace {

using library::checked;
using library::described;
using library::estimate;
using library::field;
using library::guarded;
using library::number;
using library::with;

std::vector<FittedWave> waves_of(const Json& parameters) {
  std::vector<FittedWave> waves;
  for (const auto& [amplitude, wavelength] : {std::pair{"amplitude", "wavelength"}, {"amplitude_2", "wavelength_2"}})
    if (field(parameters, amplitude).is_object())
      waves.push_back({estimate(parameters[amplitude]), estimate(parameters[wavelength])});
  return waves;
}

std::vector<Finding> findings_of(const Json& findings) {
  std::vector<Finding> all;
  for (const Json& each : findings) all.push_back({each["code"], each["severity"], each["sentence"], each["remedy"]});
  return all;
}

// The answer by its own JSON, so that both say the same.
Fit fitted(const Test& test) {
  const Json json = fit_json(fit_test(test, options_for(test, {})));
  const Json &judgement = json["judgement"], &parameters = json["parameters"], &energy = json["energy"];
  return {.verdict = json["verdict"]["code"],
          .sentence = json["verdict"]["sentence"],
          .slips = number(field(field(judgement, "causes"), "slips")),
          .cracks = number(field(field(judgement, "causes"), "cracks")),
          .both = number(field(field(judgement, "causes"), "both")),
          .mu0 = estimate(field(parameters, "mu0")),
          .mu0_is_limit = field(field(parameters, "mu0"), "bound") == true,
          .waves = waves_of(parameters),
          .bending_stiffness = estimate(field(parameters, "bending_stiffness")),
          .work_of_fracture = number(field(energy, "work_of_fracture")),
          .bending = number(field(energy, "bending")),
          .friction = number(field(energy, "friction")),
          .snaps = number(field(energy, "snaps")),
          .friction_share = number(field(energy, "friction_share")),
          .findings = findings_of(json["findings"]),
          .next = json["next"],
          .json = json_text(json)};
}

Modulus modulus_of(const Test& test) {
  const ModulusStudy study = study_modulus(test, {}, {});
  const StandardTest standard = standard_test(study);
  const Json json = modulus_fields()(standard, frame_of(standard));
  return {.status = json["status"],
          .stiffness = estimate(json["stiffness"]),
          .modulus = estimate(json["modulus"]),
          .chord = estimate(field(json["chord"], "modulus")),
          .maximum_force = number(field(json["greatest_force"], "value")),
          .strength = number(field(json["stress"], "value")),
          .json = json_text(json)};
}

// Empty without a role or a unit.
std::vector<double> in_si(const flexslip::Export& file, const ExportColumn& column) {
  const Kind* kind = words_for(column.role).kind;
  const auto unit = machine_unit(column.unit);
  if (!kind || !unit || unit->dimension != kind->dimension) return {};
  return flexslip::in_si(file, column, *kind);
}

Export exported(const flexslip::Export& file) {
  Export out{.format = file.format, .specimens = {}, .notes = file.notes};
  for (const flexslip::ExportedSpecimen& from : file.specimens) {
    ExportedSpecimen& specimen = out.specimens.emplace_back(
        ExportedSpecimen{.name = from.name, .columns = {}, .lines = from.lines, .unsure = {}});
    for (const ExportColumn& column : from.columns)
      specimen.columns.push_back(
          {column.name, column.unit, std::string(words_for(column.role).name), in_si(file, column)});
    for (const OpenQuestion& question : from.asks) specimen.unsure.push_back(question.words);
  }
  return out;
}

}  // namespace

Fit fit(const Setup& setup, const Record& record) {
  return guarded([&] { return fitted(checked(with(described(setup), record))); });
}

Fit fit_file(const Setup& setup, const std::string& path) {
  return guarded([&] {
    Test test = described(setup);
    test.record = {.file = path};
    return fitted(checked(test));
  });
}

Fit fit_case(const std::string& path, const std::vector<std::string>& changes) {
  return guarded([&] { return fitted(read_case(path, changes)); });
}

Modulus modulus(const Setup& setup, const Record& record) {
  return guarded([&] { return modulus_of(checked(with(described(setup), record))); });
}

Export read_export(const std::string& path) {
  return guarded([&] { return exported(flexslip::read_export(path)); });
}

}  // namespace flexslip::v1
