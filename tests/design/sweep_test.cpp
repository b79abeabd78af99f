#include "design/sweep.h"

#include <atomic>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "design/design_result.h"
#include "numerics/effort.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

const std::string some_case = R"([specimen]
diameter = "30 um"
modulus = "30 GPa"
[rig]
span = "1 mm"
stiffness = "90 N/m"
[friction]
model = "sinusoid"
mu0 = 0.4
amplitude = 0.2
wavelength = "10 um"
phase = 1
[stage]
program = ["0 um", "300 um"]
step = "2 um"
)";

SweepPlan plan_of(const std::string& sweep) { return read_sweep(some_case + sweep, "map.toml"); }

SweepPlan hypercube_of(std::uint64_t samples, std::uint64_t seed) {
  return plan_of("[sweep]\nmethod = \"latin hypercube\"\nsamples = " + std::to_string(samples) +
                 "\nseed = " + std::to_string(seed) +
                 "\n[sweep.axes]\nmu0 = { from = 0, to = 1 }\namplitude = { from = 0, to = 1 }\n");
}

TEST_CASE("table: a grid in the order of the file, the last axis fastest") {
  const auto plan = plan_of(R"([sweep]
method = "grid"
axes = { stiffness = ["90 N/m", "inf"], mu0 = { from = 0.2, to = 0.4, points = 3 }, step = ["continuous"] }
)");
  CHECK(plan.rows == 6);
  CHECK(inputs_of(plan, 0) == std::vector{90.0, 0.2, 0.0});
  CHECK(inputs_of(plan, 1)[1] == doctest::Approx(0.3).epsilon(1e-15));  // one rounding
  CHECK(inputs_of(plan, 2) == std::vector{90.0, 0.4, 0.0});
  CHECK(std::isinf(inputs_of(plan, 3)[0]));
  CHECK(message_of([&] { inputs_of(plan, 6); }).find('6') != std::string::npos);
}

TEST_CASE("identity: a Latin hypercube meets each stratum of each axis once, for any number of samples") {
  for (const std::uint64_t samples : {1ULL, 2ULL, 3ULL, 5ULL, 64ULL, 65ULL, 1000ULL, 4097ULL}) {
    const auto plan = hypercube_of(samples, 7);
    std::set<double> mu0, amplitude;
    for (std::uint64_t row = 0; row < samples; ++row) {
      const auto inputs = inputs_of(plan, row);
      mu0.insert(std::floor(inputs[0] * static_cast<double>(samples)));
      amplitude.insert(std::floor(inputs[1] * static_cast<double>(samples)));
    }
    CHECK(mu0.size() == samples);
    CHECK(amplitude.size() == samples);
    CHECK(*mu0.begin() == 0);
    CHECK(*amplitude.rbegin() == static_cast<double>(samples - 1));
  }
}

TEST_CASE("oracle: axes and seeds are uncorrelated, like independent random numbers") {
  constexpr std::uint64_t samples = 10'000;
  const auto plan = hypercube_of(samples, 1);
  const auto other = hypercube_of(samples, 2);
  double axes = 0, seeds = 0, neighbours = 0;
  for (std::uint64_t row = 0; row < samples; ++row) {
    const double x = inputs_of(plan, row)[0] - 0.5;
    axes += x * (inputs_of(plan, row)[1] - 0.5);
    seeds += x * (inputs_of(other, row)[0] - 0.5);
    neighbours += x * (inputs_of(plan, (row + 1) % samples)[0] - 0.5);
  }
  // Of independent numbers, 12 times the mean product has the standard deviation 1/sqrt(samples): four of them.
  const double bound = 4 / std::sqrt(static_cast<double>(samples)) / 12 * static_cast<double>(samples);
  CHECK(std::abs(axes) < bound);
  CHECK(std::abs(seeds) < bound);
  CHECK(std::abs(neighbours) < bound);
}

TEST_CASE("oracle: rows of a Latin hypercube of 10^12 samples, against the same arithmetic in Python") {
  const auto plan = hypercube_of(1'000'000'000'000, 2021);
  // hypercube_point() of tests/outside/sweep.py, to the last bit. Other values would make other samples of old seeds.
  CHECK(inputs_of(plan, 0)[0] == 0.53816883311213548);
  CHECK(inputs_of(plan, 999'999'999'999)[1] == 0.23677890445156818);
}

TEST_CASE("identity: whole numbers may be written as powers of ten") {
  const std::string axes = "seed = 7\naxes = { mu0 = { from = 0.1, to = 0.9 } }\n";
  const std::string sweep = "[sweep]\nmethod = \"latin hypercube\"\nsamples = ";
  CHECK(plan_of(sweep + "1e5\n" + axes).rows == 100'000);
}

TEST_CASE("table: an invalid sweep is refused with line, key and remedy") {
  const auto says = [](const std::string& sweep) { return message_of([&] { plan_of(sweep); }); };
  struct Row {
    std::string sweep;
    std::vector<std::string> words;
  };
  const std::string grid = "[sweep]\nmethod = \"grid\"\n[sweep.axes]\n";  // lines 16 to 18
  const std::string sample = "[sweep]\nmethod = \"latin hypercube\"\nsamples = 9\nseed = 1\n[sweep.axes]\n";
  const std::vector<Row> table{
      {"", {"[sweep]", "Add [sweep]"}},
      {"sweep = 3\n", {"stage", "There is no such key. The keys are"}},  // of the section before it
      {"[sweep]\n", {"map.toml:16", "method", "grid"}},
      {"[sweep]\nmethod = \"random\"\n",
       {"map.toml:17: [sweep] method", "\"grid\" or \"latin hypercube\"", "'random'"}},
      {"[sweep]\nmethod = \"latin hypercub\"\n", {"Did you mean \"latin hypercube\"?"}},
      {"[sweep]\nmethod = \"latin hypercube\"\nsamples = 1.5\nseed = 1\n", {"samples", "a whole number", "1.5"}},
      {"[sweep]\nmethod = \"latin hypercube\"\nsamples = true\nseed = 1\n", {"samples", "a whole number"}},
      {"[sweep]\nmethod = \"grid\"\n", {"axes", "[sweep.axes]"}},
      {grid, {"map.toml:18: [sweep] axes", "The sweep has no axis. Add "}},
      {grid + "mu = [1]\n", {"map.toml:19: [sweep] axes.mu", "Did you mean 'mu0'?"}},
      {grid + "mu0 = []\n", {"The list of values is empty"}},
      {grid + "mu0 = 0.4\n", {"map.toml:19", "The number 0.4", "{ from = …, to = …, points = … }"}},
      {grid + "mu0 = [0.3, -1]\n", {"map.toml:19: [sweep] axes.mu0[2]", "-1"}},
      {grid + "span = [\"1 N\"]\n", {"axes.span[1]", "a length"}},
      {grid + "span = [1]\n", {"axes.span[1]", "unit"}},
      {grid + "mu0 = { from = 0, to = 1 }\n", {"axes.mu0.points"}},
      {grid + "mu0 = { from = 0, to = 1, points = 1 }\n", {"axes.mu0.points", "at least 2"}},
      {grid + "mu0 = { from = 1, to = 1, points = 3 }\n", {"axes.mu0.to", "Both ends of the range are the number 1"}},
      {grid + "mu0 = { from = 0, to = 1, points = 3, spacing = \"log\" }\n", {"axes.mu0.from", "positive"}},
      {grid + "mu0 = { from = 0, to = 1, points = 3, spacing = \"cubic\" }\n", {"axes.mu0.spacing", "\"linear\""}},
      {grid + "mu0 = { from = 0, to = 1, steps = 3 }\n", {"axes.mu0.steps", "There is no such key"}},
      {grid + "stiffness = { from = \"1 N/m\", to = \"inf\", points = 3 }\n", {"axes.stiffness.to"}},
      {grid + "amplitude = { from = 0, to = 2, points = 3 }\n", {"axes.amplitude.to", "2"}},
      {"[sweep]\nmethod = \"grid\"\nseed = 1\n", {"[sweep] seed", "latin hypercube"}},
      {"[sweep]\nmethod = \"latin hypercube\"\nsamples = 0\nseed = 1\n", {"samples", "at least 1"}},
      {sample + "mu0 = [0.1]\n", {"axes.mu0", "in a Latin hypercube"}},
      {sample + "mu0 = { from = 0, to = 1, points = 3 }\n", {"axes.mu0.points"}},
      {grid + "mu0 = { from = 0, to = 1, points = 1000000 }\nphase = { from = 0, to = 1, points = 1000000 }\n"
              "amplitude = { from = 0, to = 1, points = 1000000 }\nstiffness = { from = \"1 N/m\", to = \"2 N/m\", "
              "points = 1000000 }\n",
       {"[sweep] axes", "1e+24 designs, more than the limit of 1e+12", "fewer points"}},
  };
  for (const Row& row : table) {
    const std::string message = says(row.sweep);
    for (const std::string& word : row.words) {
      INFO(row.sweep, message);
      CHECK(message.find(word) != std::string::npos);
    }
  }
}

TEST_CASE("table: other commands ignore a section [sweep]") {
  const std::string sweep = "[sweep]\nmethod = \"grid\"\naxes = { mu0 = [0.3] }\n";
  CHECK(read_case(some_case + sweep, "map.toml").friction.has_value());
  CHECK(plan_of(sweep).rows == 1);
}

SweepPlan three_diameters() {
  return read_sweep(R"([specimen]
diameter = "30 um"
modulus = "30 GPa"
[rig]
span = "1 mm"
stiffness = "90 N/m"
[friction]
model = "sinusoid"
mu0 = 0.4
amplitude = 0.2
wavelength = "10 um"
[stage]
program = ["0 um", "300 um"]
[sweep]
method = "grid"
axes = { diameter = ["20 um", "900 um", "30 um"], mu0 = [0.3, 0.4] }
)",
                    "some.toml");
}

TEST_CASE("identity: a row equals the result of its case, and a test that cannot be computed is impossible") {
  const SweepPlan plan = three_diameters();
  const auto points = points_of(plan, {0, plan.rows}, 1);
  REQUIRE(points.size() == 6);
  CHECK(points[3].result.status == ResultStatus::impossible);  // thicker than a beam of this span
  CHECK(!points[3].result.outcome);
  Test alone = plan.loading;
  set(alone, "diameter", 30e-6);
  set(alone, "mu0", 0.3);
  CHECK(points[4].values == std::vector{30e-6, 0.3});
  CHECK(points[4].result.outcome->work == result_of(alone).outcome->work);
}

TEST_CASE("identity: rows are the same for any span and any number of threads") {
  const SweepPlan plan = three_diameters();
  const auto all = points_of(plan, {0, plan.rows}, 3);
  for (std::uint64_t row = 0; row < plan.rows; ++row) {
    const auto alone = points_of(plan, {row, 1}, 1);
    REQUIRE(alone.size() == 1);
    CHECK(alone[0].values == all[row].values);
    CHECK(alone[0].result.status == all[row].result.status);
    if (alone[0].result.outcome)
      CHECK(alone[0].result.outcome->friction_heat == all[row].result.outcome->friction_heat);
  }
  CHECK(points_of(plan, {plan.rows, 0}, 1).empty());
  CHECK(message_of([&] { points_of(plan, {plan.rows - 1, 2}, 1); }).find("no row 6 of 6") != std::string::npos);
}

TEST_CASE("limit: rows that are stopped give nothing, including rows that are refused at once") {
  const SweepPlan plan = three_diameters();
  const std::atomic<bool> stop = true;
  const Stoppable stoppable(&stop);
  CHECK_THROWS_AS(points_of(plan, {0, 6}, 2), Stopped);
  CHECK_THROWS_AS(points_of(plan, {2, 2}, 1), Stopped);  // of the diameter that is impossible
}

TEST_CASE("limit: without friction there is no snap and no drop, and all work is bending energy") {
  const auto plan = read_sweep(
      "reduced = true\n[rig]\nstiffness = 50\n[friction]\nmodel = \"constant\"\nmu0 = 0\n[stage]\nprogram = [0, 0.3]\n"
      "[sweep]\nmethod = \"grid\"\naxes = { travel = [0.1, 0.2] }\n",
      "some.toml");
  const DesignOutcome outcome = points_of(plan, {1, 1}, 1)[0].result.outcome.value();
  CHECK(outcome.stage_reached == doctest::Approx(0.2).epsilon(1e-12));  // rounding, amplified
  CHECK(outcome.snaps == 0);
  CHECK(outcome.drops == 0);
  CHECK(!outcome.first_snap);
  CHECK(std::abs(outcome.friction_heat) < 1e-14);  // the rounding of energies of about 1
  CHECK(outcome.work > 0);
}

}  // namespace
}  // namespace flexslip
