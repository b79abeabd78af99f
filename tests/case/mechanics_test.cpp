#include "case/mechanics.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "bending_test/equilibrium.h"
#include "bending_test/history.h"
#include "inference/analysis.h"
#include "tests/approximately.h"
#include "tests/design/some_design.h"
#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

Test rod(const std::string& modulus, const std::string& rig = "") {
  return read_case("[specimen]\ndiameter = \"40 um\"\n" + modulus + "\n[rig]\nspan = \"1.2 mm\"\n" + rig +
                       "\n[friction]\nmodel = \"constant\"\nmu0 = 0.5\n[stage]\nprogram = [\"0 um\", \"100 um\"]\n",
                   "rod.toml");
}

}  // namespace

TEST_CASE("mechanics: E I of a rod, with the uncertainty stated or assumed (formula)") {
  const double EI = 30e9 * std::acos(-1.0) / 64 * std::pow(40e-6, 4);
  const auto stated = bending_stiffness_of(
      rod("modulus = { value = \"30 GPa\", uncertainty = \"1.5 GPa\" }", "stiffness = \"90 N/m\""));
  CHECK(stated.value == to(1e-14, EI));
  CHECK(stated.relative_error == to(1e-14, 0.05));
  CHECK(stated.source == StiffnessSource::stated);
  const auto assumed = bending_stiffness_of(rod("modulus = \"30 GPa\"", "stiffness = \"90 N/m\""));
  CHECK(assumed.relative_error == 0.03);
  CHECK(assumed.source == StiffnessSource::assumed_error);
  const Test open = rod("", "stiffness = \"90 N/m\"");
  CHECK(!states_stiffness(open));
  CHECK(has(message_of([&] { bending_stiffness_of(open); }), "modulus"));
}

TEST_CASE(
    "mechanics: a toe that is within two errors of the zero of its file does not lower EI that is not stated (truth)") {
  const TemporaryFolder folder;
  constexpr double span = 20e-3, EI = 1e-4, k = 40, friction = 0.25;
  constexpr double toe = 0.0035 * span, seat = 0.04, noise = 0.004;  // [m], [greatest force]
  const auto curve = sliding_up_to(0.2, friction, 300);
  const Scales scales(span, EI);
  const double greatest = scales.physical_force(curve.back().F);
  for (const unsigned seed : {1, 2, 3, 4, 5, 6}) {
    std::mt19937 random(seed);
    std::normal_distribution<double> error(0, noise * greatest);
    std::string rows = "stage [m],force [N]\n";
    for (const auto& point : curve) {
      const double force = scales.physical_force(point.F);
      const double stage = scales.physical_length(point.w + point.F / k) - toe * std::expm1(-force / (seat * greatest));
      rows += fmt::format("{},{}\n", stage, force + error(random));
    }
    folder.file("test.csv", rows);
    const Measurement measurement = read_measurement(
        read_case(
            fmt::format("[rig]\nspan = '{} m'\nstiffness = '{} N/m'\nsupports = 'edges'\n[record]\nfile = 'test.csv'\n"
                        "stage = 'stage'\nforce = 'force'\n",
                        span, k * EI / (span * span * span)),
            (folder.path() / "case.toml").string()),
        {.points = min_fitted_points, .span = true});
    CAPTURE(seed);
    CAPTURE(measurement.contact_offset / span);
    CHECK(measurement.contact == ContactSource::found);
    const BendingStiffnessUsed told = bending_stiffness_of(measurement.test, measurement);
    CAPTURE(told.relative_error);
    CHECK(std::abs(told.value / EI - 1) < 2 * told.relative_error);
  }
}

TEST_CASE("mechanics: the section's uncertainty counts in EI as its second moment says (formula)") {
  const auto error_of = [](const std::string& specimen) {
    return bending_stiffness_of(read_case("[specimen]\n" + specimen, "case.toml")).relative_error;
  };
  const double small = 1e-6;  // of I along the lengths, by differences over 1e-4
  const std::string modulus = "modulus = '30 GPa ± 2 %'\n";
  CHECK(error_of(modulus + "diameter = '1 um ± 1 %'") == doctest::Approx(std::hypot(0.02, 0.04)).epsilon(small));
  CHECK(error_of(modulus + "width = '2 um ± 3 %'\nheight = '1 um ± 1 %'") ==
        doctest::Approx(std::hypot(0.02, 0.03, 0.03)).epsilon(small));
  // D^4 - (D - 2 t)^4 of D = 4 and t = 1: ∂/∂t = 8 (D - 2 t)^3 = 64 of 240.
  CHECK(error_of(modulus + "diameter = '4 um'\nwall = '1 um ± 3 %'") ==
        doctest::Approx(std::hypot(0.02, 0.03 * 64 / 240)).epsilon(small));
  CHECK(error_of("modulus = '30 GPa'\ndiameter = '1 um ± 0 %'") == default_modulus_error);
  CHECK(error_of("modulus = '30 GPa'\ndiameter = '1 um'") == default_stiffness_error);
  CHECK(error_of("modulus = '30 GPa ± 0 %'\ndiameter = '1 um ± 0 %'") == 0);
}

TEST_CASE("mechanics: what the test says of the rig's errors, and what is usual where it says nothing (identity)") {
  Measurement measurement;
  measurement.test = read_case("[rig]\nspan = '1 mm'\nstiffness = '90 N/m'", "case.toml");
  const RigErrors usual = rig_errors_of(measurement);
  CHECK(usual.load_train == RigErrors{}.load_train);
  CHECK(usual.span == RigErrors{}.span);
  CHECK(usual.force_gain == RigErrors{}.force_gain);
  CHECK(usual.preload == RigErrors{}.preload);
  CHECK(usual.slow_force == RigErrors{}.slow_force);
  measurement.relaxation = Relaxation{.rests = 1, .rows = 9, .share = {}, .over_loading = 0.05};
  CHECK(rig_errors_of(measurement).slow_force == to(1e-15, std::hypot(RigErrors{}.slow_force, 0.05)));
  measurement.relaxation->over_loading = 2;
  CHECK(rig_errors_of(measurement).slow_force == max_uncertainty);
  measurement.begins_free = true;
  CHECK(rig_errors_of(measurement).preload == usual_bow);
  measurement.test = read_case(
      "[specimen]\ndiameter = '30 um ± 2 %'\nmodulus = '30 GPa'\n[rig]\nspan = '1 mm ± 2 um'\n"
      "stiffness = '90 N/m ± 0.4 %'\nsupport_stiffness = '45 N/m'\nroller_radius = '0.1 mm ± 3 %'\n"
      "[record]\nfile = 'a.csv'\nstage = 'w [um]'\nforce = 'F [N]'\ngain_error = '0 %'\npreload_error = '3 um'\n"
      "slow_force_error = '1 %'",
      "case.toml");
  const RigErrors errors = rig_errors_of(measurement);
  CHECK(errors.preload == doctest::Approx(0.003));
  measurement.test.record->preload_error = 51e-6;
  CHECK_THROWS_AS(rig_errors_of(measurement), InputError);
  CHECK(errors.span == doctest::Approx(0.002));
  CHECK(errors.thickness == doctest::Approx(0.02));
  CHECK(errors.support_radius == doctest::Approx(0.03));
  CHECK(errors.force_gain == 0);
  CHECK(errors.slow_force == 0.01);
  CHECK(errors.load_train == doctest::Approx(0.002));  // half of the compliance is that of the supports
}

TEST_CASE("mechanics: load train and supports are springs in line, and taken apart again (identity)") {
  const Test soft = rod("modulus = \"30 GPa\"", "stiffness = \"90 N/m\"\nsupport_stiffness = \"200 N/m\"");
  CHECK(load_train_stiffness_of(soft) == 90);
  CHECK(support_compliance_of(soft) == to(1e-15, 1 / 400.0));  // each support carries half the force
  CHECK(rig_stiffness_of(soft) == to(1e-15, 1 / (1 / 90.0 + 1 / 400.0)));
  CHECK(without_supports(rig_stiffness_of(soft), support_compliance_of(soft)) == to(1e-13, 90.0));
  CHECK(with_supports(INFINITY, 1 / 400.0) == to(1e-15, 400.0));
  CHECK(std::isinf(without_supports(400, 1 / 400.0)));
  CHECK(rig_stiffness_of(rod("", "stiffness = \"90 N/m\"")) == 90);
}

namespace {

StageProgramme programme(const std::string& stage, const std::string& path = "case.toml") {
  return programme_of(read_case(
      "[specimen]\ndiameter = \"40 um\"\nmodulus = \"30 GPa\"\n[rig]\nspan = \"1 mm\"\nstiffness = \"90 N/m\"\n"
      "[friction]\nmodel = \"constant\"\nmu0 = 0.5\n[stage]\n" +
          stage + "\n",
      path));
}

}  // namespace

TEST_CASE("mechanics: turning points exactly, or every reading of steps") {
  const auto exact = programme("program = [\"0 um\", \"300 um\", \"100 um\"]\nstep = \"continuous\"");
  CHECK(!exact.in_steps);
  CHECK(!exact.measured);
  REQUIRE(exact.positions.size() == 3);
  CHECK(exact.positions[2] == to(1e-15, 1e-4));
  CHECK(exact.farthest == to(1e-15, 3e-4));
  const auto steps = programme("program = [\"0 um\", \"300 um\", \"100 um\"]\nstep = \"50 um\"");
  CHECK(steps.in_steps);
  REQUIRE(steps.positions.size() == 11);  // 0, 50, …, 300, 250, …, 100
  CHECK(steps.positions[6] == to(1e-14, 3e-4));
  CHECK(steps.positions.back() == to(1e-14, 1e-4));
}

TEST_CASE("mechanics: a measured one is that of its file") {
  const TemporaryFolder folder;
  folder.file("stage.csv", "w_s [um]\n0\n40\n90\n20\n");
  const auto read = programme("file = \"" + folder.path().string() + "/stage.csv\"\nstage = \"w_s\"");
  CHECK(read.measured);
  CHECK(read.farthest == to(1e-15, 9e-5));
  CHECK(read.positions.size() == 4);
}

TEST_CASE("mechanics: what is none is refused by its key (limit)") {
  CHECK(has(message_of([] { programme("program = [\"0 um\", \"0 um\"]"); }), "[stage] program[2]"));
  CHECK(has(message_of([] { programme("program = [\"0 um\", \"1 m\"]"); }), "[stage] program[2]"));
}

namespace {

// The spicule with other friction.
std::string with_friction(const std::string& keys) {
  const std::size_t from = spicule.find("[friction]");
  return spicule.substr(0, from) + "[friction]\n" + keys + spicule.substr(spicule.find("[stage]"));
}

// Where friction may be ten times as great.
std::string at_the_axis(std::string text) {
  const std::string_view rig = "[rig]";
  return text.replace(text.find(rig), rig.size(), "[rig]\nfriction_at = \"axis\"");
}

History simulated(const std::string& text) {
  const Test input = read_case(text, "case.toml");
  const Scales scales = scales_of(input, bending_stiffness_of(input));
  const StageProgramme programme = programme_of(input);
  std::vector<double> stages;
  for (const double position : programme.positions) stages.push_back(scales.reduced_length(position));
  return follow_in_steps(bending_test_of(input, scales, scales.reduced_length(programme.farthest)), stages);
}

std::string refusal_of(const std::string& text) {
  return message_of([&] { simulated(text); });
}

bool begins(const std::string& text, std::string_view part) { return text.find(part) == 0; }

}  // namespace

TEST_CASE(
    "mechanics: a specimen thinner than what rounding leaves of its sliding is refused, unless friction acts at its "
    "axis (limit)") {
  const auto fibre_of_diameter = [](const std::string& diameter, const std::string& rig) {
    const Test test = read_case("[specimen]\ndiameter = \"" + diameter +
                                    "\"\nmodulus = \"30 GPa\"\n[rig]\nspan = \"1 mm\"\nstiffness = \"inf\"\n" + rig,
                                "case.toml");
    return fibre_of(test, scales_of(test)).supports().half_depth;
  };
  CHECK(fibre_of_diameter("2.1 nm", "") == to(1e-9, 1.05e-6));
  CHECK(message_of([&] {
          fibre_of_diameter("1.9 nm", "");
        }).find("The specimen is 1.9 nm thick, less than the limit of 2 nm") != std::string::npos);
  CHECK(fibre_of_diameter("1.9 nm", "friction_at = \"axis\"\n") == 0);
}

TEST_CASE("identity: friction stated at a reference is the same friction stated at the span, along a whole test") {
  constexpr double span = 1278e-6, reference = 1.4e-3;
  for (const double drift : {800.0, -300.0}) {
    const double mu0 = 0.4, amplitude = 0.3;
    const double at_span = mu0 - drift * (reference - span);
    const auto text = [&](double mean, const std::string& last) {
      // Amplitudes are relative to mu0.
      return with_friction(
          fmt::format("model = \"sinusoid\"\nmu0 = {}\namplitude = {}\nwavelength = \"40 um\"\ndrift = \"{} 1/m\"\n{}",
                      mean, amplitude * mu0 / mean, drift, last));
    };
    const History a = simulated(text(mu0, "reference = \"1.4 mm\"\n"));
    const History b = simulated(text(at_span, ""));
    REQUIRE(a.path.size() == b.path.size());
    REQUIRE(a.path.size() == 351);
    double most = 0, reached = 1;
    int snaps = 0;
    for (std::size_t i = 0; i < a.path.size(); ++i) {
      most = std::max({most, std::abs(a.path[i].F - b.path[i].F), std::abs(a.path[i].S - b.path[i].S),
                       std::abs(a.path[i].q - b.path[i].q)});
      reached = std::max(reached, a.path[i].S);
      CHECK(a.path[i].motion == b.path[i].motion);
      if (a.path[i].motion == Motion::snap) ++snaps;
    }
    CHECK(reached * span > reference);
    CHECK(snaps > 0);
    // Roundings of μ, 2e-16 each, times the condition of a state at a stage position: below 1e3, as no reading stands at a fold.
    CHECK(most < 1e-12);
  }
}

TEST_CASE("limit: a reference at the span changes no bit") {
  const auto text = [](const std::string& last) {
    return with_friction("model = \"constant\"\nmu0 = 0.3\ndrift = \"0.8 1/mm\"\n" + last);
  };
  const History a = simulated(text(""));
  const History b = simulated(text("reference = \"1278 um\"\n"));
  REQUIRE(a.path.size() == b.path.size());
  for (std::size_t i = 0; i < a.path.size(); ++i) CHECK(a.path[i].F == b.path[i].F);
}

TEST_CASE("limit: friction that a drift carries below zero is zero, with a reference as without") {
  const History path =
      simulated(with_friction("model = \"constant\"\nmu0 = 0.02\ndrift = \"0.8 1/mm\"\nreference = \"1.4 mm\"\n"));
  int without = 0, with_it = 0;
  for (const PathPoint& point : path.path) {
    CHECK(point.q >= 0);
    ++(point.q == 0 ? without : with_it);
  }
  CHECK(without > 10);  // up to 1.375 mm
  CHECK(with_it > 10);
}

TEST_CASE("table: friction beyond what is computed is refused with key, value, limit and remedy") {
  const auto drifting = [](const std::string& keys) {
    return at_the_axis(with_friction("model = \"constant\"\n" + keys));
  };
  CHECK(refusal_of(drifting("mu0 = 21\n")) ==
        "case.toml:10: [friction] mu0: Friction reaches 21, its waves and drift included, and the limit is 20. Write a "
        "smaller mu0.");
  // 700 um are 0.548 spans: the specimen is at most 1 + 2.4 0.548^2 = 1.72 spans long.
  CHECK(refusal_of(drifting("mu0 = 19\ndrift = \"40 1/mm\"\n")) ==
        "case.toml:11: [friction] drift: The drift of 40 1/mm takes friction from 19 at 1.278 mm to 55.8075 at 2.198 "
        "mm, and the limit is 20. Check its unit, or bend less far.");
  CHECK(refusal_of(drifting("mu0 = 19\ndrift = \"-40 1/mm\"\n")) == "");
  CHECK(refusal_of(drifting("mu0 = 19\ndrift = \"-40 1/mm\"\nreference = \"1.4 mm\"\n")) ==
        "case.toml:11: [friction] drift: The drift of -40 1/mm takes friction from 19 at 1.4 mm to 23.88 at 1.278 mm, "
        "and the limit is 20. Check its unit, and the unit of reference.");
  CHECK(refusal_of(drifting("mu0 = 19\ndrift = \"1 1/mm\"\nreference = \"2.5 mm\"\n")) == "");
  CHECK(refusal_of(drifting("mu0 = 0.3\nstatic_excess = 19.8\n")) ==
        "case.toml:11: [friction] static_excess: An excess of 19.8 raises static friction to 20.1, and the limit is "
        "20. Write a smaller one.");
  CHECK(begins(refusal_of(drifting("mu0 = 0.3\ndrift = \"1 1/mm\"\nstatic_excess = 19\n")),
               "case.toml:12: [friction] static_excess: An excess of 19 raises static friction to "));
  const auto rough = [](const std::string& mu0) {
    return with_friction("model = \"rough\"\nmu0 = " + mu0 + "\nrms = 1\ncorrelation_length = \"5 um\"\nseed = 1\n");
  };
  const std::string along = refusal_of(at_the_axis(rough("19")));
  CHECK(begins(along, "case.toml:10: [friction] mu0: Friction reaches "));
  CHECK(has(along, ", its roughness included, and the limit is 20. Write a smaller mu0 or rms."));
  CHECK(begins(refusal_of(rough("1.9")), "case.toml:9: [friction] mu0: Friction reaches "));
  CHECK(has(refusal_of(rough("1.9")), ", its roughness included, and the limit at the surface is 2."));
}

TEST_CASE("table: a reference that is no length between the supports is refused") {
  const auto refusal = [](const std::string& reference) {
    return refusal_of(
        with_friction("model = \"constant\"\nmu0 = 0.3\ndrift = \"0.8 1/mm\"\nreference = \"" + reference + "\"\n"));
  };
  CHECK(refusal("1.4 um") ==
        "case.toml:11: [friction] reference: The reference length of 1.4 µm is not between the span of 1.278 mm and "
        "100 spans. Check its unit.");
  CHECK(begins(refusal("1.4 m"),
               "case.toml:11: [friction] reference: The reference length of 1.4 m is not between the span of"));
  CHECK(refusal("1.277 mm") == "");  // the span, to four digits
}

}  // namespace flexslip
