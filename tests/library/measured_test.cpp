// Fits, moduli and exports of the library against those of the inner rooms.
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "answers/fit_fields.h"
#include "answers/standard_fields.h"
#include "case/case_file.h"
#include "case/fitted.h"
#include "case/studies.h"
#include "flexslip/flexslip.h"
#include "result/table.h"
#include "tests/has.h"

namespace flexslip {
namespace {

const std::string example = FLEXSLIP_SOURCE_DIR "/examples/simulated/case.toml";
const std::string export_file = FLEXSLIP_SOURCE_DIR "/examples/simulated/test.csv";
const v1::Setup setup{
    .diameter = 34.8e-6, .modulus = {29.6e9, 0.03 * 29.6e9}, .span = 1278e-6, .load_train_stiffness = 90.65};

v1::Record record_in(const std::string& path) {
  const v1::Export file = v1::read_export(path);
  REQUIRE(file.specimens.size() == 1);
  return {.stage = file.specimens[0].columns[0].values, .force = file.specimens[0].columns[1].values};
}

TEST_CASE("the fit of a case is that of the program") {
  const Test test = read_case(example);
  const FittedTest inner = fit_test(test, options_for(test, {}));
  const v1::Fit fit = v1::fit_case(example);
  CHECK(fit.json == json_text(fit_json(inner)));
  CHECK(fit.verdict == "slip");
  CHECK(fit.mu0.value == inner.analysis.fit.mu0.value);
  CHECK(fit.mu0.standard_error == inner.analysis.fit.mu0.standard_error);
  CHECK(fit.mu0.low == inner.analysis.fit.mu0.low);
  CHECK(fit.cracks == inner.judgement.causes.cracks);
  CHECK(std::isnan(fit.both));
  REQUIRE(fit.waves.size() == 1);
  CHECK(fit.waves[0].wavelength.value ==
        inner.analysis.scales.physical_length(inner.analysis.fit.waves[0].wavelength.value));
  CHECK(fit.work_of_fracture == inner.analysis.scales.physical_energy(inner.analysis.energy.work_of_fracture));
  CHECK(fit.friction_share == inner.analysis.energy.friction_share);
  CHECK(fit.next == fit.findings[4].remedy);
}

TEST_CASE("a record in memory, its file and the case that says the same have one answer") {
  const Test test = read_case(R"([specimen]
diameter = "34.8 um"
modulus = { value = "29.6 GPa", uncertainty = "3 %" }
[rig]
span = "1278 um"
stiffness = "90.65 N/m"
[record]
)",
                              "", {"record.file=" + export_file});
  const FittedTest inner = fit_test(test, options_for(test, {}));
  for (const v1::Fit& fit : {v1::fit(setup, record_in(export_file)), v1::fit_file(setup, export_file)}) {
    CHECK(fit.verdict == "slip");
    CHECK(fit.mu0.value == doctest::Approx(inner.analysis.fit.mu0.value).epsilon(1e-9));
    CHECK(fit.mu0.standard_error == doctest::Approx(inner.analysis.fit.mu0.standard_error).epsilon(1e-9));
    CHECK(fit.cracks == doctest::Approx(inner.judgement.causes.cracks).epsilon(1e-9));
  }
}

TEST_CASE("a change of a case is that of --set, and a wrong one names its key") {
  CHECK(v1::fit_case(example, {"rig.roller_radius=1 um"}).json != v1::fit_case(example).json);
  try {
    v1::fit_case(example, {"rig.stiffness=90 N"});
    FAIL("a stiffness in N was taken");
  } catch (const v1::Error& error) {
    CHECK(error.key == "rig.stiffness");
    CHECK(has(error.what(), "a stiffness"));
  }
}

TEST_CASE("a record that shows no friction has a verdict and no numbers") {
  v1::Record line;
  for (int i = 0; i < 200; ++i) {
    line.stage.push_back(1e-7 * i);
    line.force.push_back(3e-6 * i + 1e-7 * std::sin(1e4 * std::sin(i)));
  }
  const v1::Fit fit = v1::fit(setup, line);
  CHECK(fit.verdict == "no_drops");
  CHECK(std::isnan(fit.mu0.value));
  CHECK(std::isnan(fit.friction_share));
  CHECK(fit.waves.empty());
}

TEST_CASE("the modulus is that of the program") {
  const ModulusStudy study = study_modulus(read_case(example), {}, {});
  const v1::Modulus modulus = v1::modulus(setup, record_in(export_file));
  CHECK(modulus.status == "ok");
  CHECK(modulus.stiffness.value == doctest::Approx(study.numbers.stiffness.value).epsilon(1e-12));
  CHECK(modulus.modulus.value == doctest::Approx(standard_modulus(study.numbers).value().value).epsilon(1e-12));
  CHECK(modulus.chord.value == doctest::Approx(study.numbers.chord.value().modulus.value).epsilon(1e-12));
  CHECK(modulus.maximum_force == doctest::Approx(study.numbers.greatest.force).epsilon(1e-12));
  CHECK(modulus.strength == doctest::Approx(study.numbers.greatest.stress.value()).epsilon(1e-12));
  CHECK(has(modulus.json, "\"at_conventional_strain\""));
}

TEST_CASE("an export has its columns in SI") {
  const v1::Export file = v1::read_export(export_file);
  const auto& columns = file.specimens.front().columns;
  CHECK(columns[0].role == "crosshead");
  CHECK(columns[0].unit == "um");
  CHECK(columns[0].values.back() == 850e-6);
  CHECK(columns[1].values.back() == 7.6048e-3);
  CHECK(file.specimens.front().lines.front() == 4);
  CHECK_THROWS_AS(v1::read_export("no such file.csv"), v1::Error);
}

TEST_CASE("a record with a fault is refused") {
  v1::Record record = record_in(export_file);
  const auto message = [&] {
    try {
      v1::fit(setup, record);
    } catch (const v1::Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  record.force.pop_back();
  CHECK(has(message(), "Force [N] has 425 readings, where stage [m] has 426"));
  record.force.push_back(v1::not_known);
  CHECK(has(message(), "Reading 425 of force [N] is not a finite number"));
  record = {};
  CHECK(has(message(), "The record has no readings"));
}

}  // namespace
}  // namespace flexslip
