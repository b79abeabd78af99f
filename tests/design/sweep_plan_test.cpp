#include "design/sweep_plan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "design/design_result.h"
#include "tests/design/some_sweep.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

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
  CHECK(shape_of(plan) == std::vector<std::uint64_t>{2, 3, 1});
  CHECK(inputs_of(plan, 0) == std::vector{90.0, 0.2, 0.0});
  CHECK(inputs_of(plan, 1)[1] == doctest::Approx(0.3).epsilon(1e-15));  // one rounding
  CHECK(inputs_of(plan, 2) == std::vector{90.0, 0.4, 0.0});
  CHECK(std::isinf(inputs_of(plan, 3)[0]));
  CHECK(message_of([&] { inputs_of(plan, 6); }).find('6') != std::string::npos);
}

TEST_CASE("identity: a Latin hypercube meets each stratum of each axis once, whatever the number of samples") {
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

TEST_CASE("oracle: axes and seeds are uncorrelated, as those of independent random numbers are") {
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
  // hypercube_point() of tests/outside/sweep.py, to the last bit. Other values: old sweeps cannot be gone on with.
  CHECK(inputs_of(plan, 0)[0] == 0.53816883311213548);
  CHECK(inputs_of(plan, 999'999'999'999)[1] == 0.23677890445156818);
}

TEST_CASE("identity: whole numbers may be written as powers of ten") {
  const std::string axes = "seed = 7\naxes = { mu0 = { from = 0.1, to = 0.9 } }\n";
  const std::string sweep = "[sweep]\nmethod = \"latin hypercube\"\nsamples = ";
  CHECK(digest_of_sweep(plan_of(sweep + "1e5\n" + axes)) == digest_of_sweep(plan_of(sweep + "100000\n" + axes)));
}

TEST_CASE("identity: the chunks of a plan are all its rows, in order") {
  CHECK(rc::check("chunks partition the rows", [](std::uint32_t samples) {
    const auto plan = hypercube_of(std::uint64_t{samples} + 1, 0);
    std::uint64_t next = 0;
    const std::uint64_t step = std::max<std::uint64_t>(1, chunks_of(plan) / 50);
    for (std::uint64_t chunk = 0; chunk < chunks_of(plan); chunk += step) {
      const auto [first, count] = rows_of_chunk(plan, chunk);
      RC_ASSERT(first == chunk * rows_in_chunk(plan));
      RC_ASSERT(count >= 1 && count <= rows_in_chunk(plan));
      next = first + count;
    }
    const auto [first, count] = rows_of_chunk(plan, chunks_of(plan) - 1);
    RC_ASSERT(first + count == plan.rows);
    RC_ASSERT(next <= plan.rows);
  }));
}

TEST_CASE("identity: the digest is of what matters: not of comments, names of files and layout") {
  const std::string sweep = "[sweep]\nmethod = \"grid\"\n[sweep.axes]\nmu0 = [0.3, 0.4]\n";
  const std::string digest = digest_of_sweep(plan_of(sweep));
  CHECK(digest_of_sweep(read_sweep("# another day\n" + some_case + "\n" + sweep, "there/copy.toml")) == digest);
  CHECK(digest_of_sweep(plan_of("[sweep]\nmethod = \"grid\"\naxes = { mu0 = [3e-1, 0.4] }\n")) == digest);
  CHECK(digest_of_sweep(plan_of("[sweep]\nmethod = \"grid\"\n[sweep.axes]\nmu0 = [0.3, 0.5]\n")) != digest);
  std::string stiffer = some_case;
  stiffer.replace(stiffer.find("30 GPa"), 2, "31");
  CHECK(digest_of_sweep(read_sweep(stiffer + sweep, "map.toml")) != digest);
}

TEST_CASE("identity: the digest is of the numbers: one that is another in its last bit makes another sweep") {
  const SweepPlan plan = plan_of("[sweep]\nmethod = \"grid\"\n[sweep.axes]\nmu0 = [0.3, 0.4]\n");
  const auto digest = [&](double last) {
    return digest_of_sweep(plan,
                           [&](std::span<const double> inputs) { return std::vector{inputs[0] == 0.4 ? last : 0.1}; });
  };
  CHECK(digest(0.2) == digest(0.2));
  CHECK(digest(0.2) != digest(std::nextafter(0.2, 1)));
  CHECK(digest(std::nan("")) != digest(0.2));
}

TEST_CASE("identity: the digest is of a friction table's content, wherever it lies") {
  const TemporaryFolder folder;
  const auto digest = [&](const std::string& name, const std::string& content) {
    folder.file(name + "/trace.csv", content);
    const std::string text = R"([specimen]
bending_stiffness = "1e-9 N m^2"
[rig]
span = "1 mm"
stiffness = "90 N/m"
[friction]
model = "table"
file = "trace.csv"
length = "S [um]"
[stage]
program = ["0 um", "300 um"]
step = "2 um"
[sweep]
method = "grid"
axes = { stiffness = ["80 N/m"] }
)";
    return digest_of_sweep(read_sweep(text, (folder.path() / name / "map.toml").string()));
  };
  CHECK(digest("a", "S [um],mu\n1000,0.5\n3000,0.6\n") == digest("b", "S [um],mu\n1000,0.5\n3000,0.6\n"));
  CHECK(digest("a", "S [um],mu\n1000,0.5\n3000,0.6\n") != digest("b", "S [um],mu\n1000,0.5\n3000,0.7\n"));
}

TEST_CASE("table: what a sweep cannot be is refused with line, key and remedy") {
  const auto says = [](const std::string& sweep) {
    const TemporaryFolder folder;
    const std::string path = folder.file("map.toml", some_case + sweep);
    return message_of([&] { read_sweep(path); });
  };
  struct Row {
    std::string sweep;
    std::vector<std::string> words;
  };
  const std::string grid = "[sweep]\nmethod = \"grid\"\n[sweep.axes]\n";  // lines 16 to 18
  const std::string sample = "[sweep]\nmethod = \"latin hypercube\"\nsamples = 9\nseed = 1\n[sweep.axes]\n";
  const std::vector<Row> table{
      {"", {"[sweep]", "add [sweep]"}},
      {"sweep = 3\n", {"stage", "one of the keys"}},  // of the section before it
      {"[sweep]\n", {"map.toml:16", "method", "grid"}},
      {"[sweep]\nmethod = \"random\"\n",
       {"map.toml:17: [sweep] method", "\"grid\" or \"latin hypercube\"", "'random'"}},
      {"[sweep]\nmethod = \"latin hypercub\"\n", {"did you mean \"latin hypercube\"?"}},
      {"[sweep]\nmethod = \"latin hypercube\"\nsamples = 1.5\nseed = 1\n", {"samples", "a whole number", "1.5"}},
      {"[sweep]\nmethod = \"latin hypercube\"\nsamples = true\nseed = 1\n", {"samples", "a whole number"}},
      {"[sweep]\nmethod = \"grid\"\n", {"axes", "[sweep.axes]"}},
      {grid, {"map.toml:18: [sweep] axes", "at least one axis"}},
      {grid + "mu = [1]\n", {"map.toml:19: [sweep] axes.mu", "did you mean 'mu0'?"}},
      {grid + "mu0 = []\n", {"at least one value"}},
      {grid + "mu0 = 0.4\n", {"map.toml:19", "the number 0.4", "{ from = …, to = …, points = … }"}},
      {grid + "mu0 = [0.3, -1]\n", {"map.toml:19: [sweep] axes.mu0[2]", "-1"}},
      {grid + "span = [\"1 N\"]\n", {"axes.span[1]", "a length"}},
      {grid + "span = [1]\n", {"axes.span[1]", "unit"}},
      {grid + "mu0 = { from = 0, to = 1 }\n", {"axes.mu0.points"}},
      {grid + "mu0 = { from = 0, to = 1, points = 1 }\n", {"axes.mu0.points", "at least 2"}},
      {grid + "mu0 = { from = 0, to = 1, points = 2000000 }\n", {"axes.mu0.points", "at most 1000000"}},
      {grid + "mu0 = { from = 1, to = 1, points = 3 }\n", {"axes.mu0.to", "a value other than from"}},
      {grid + "mu0 = { from = 0, to = 1, points = 3, spacing = \"log\" }\n", {"axes.mu0.from", "positive"}},
      {grid + "mu0 = { from = 0, to = 1, points = 3, spacing = \"cubic\" }\n", {"axes.mu0.spacing", "\"linear\""}},
      {grid + "mu0 = { from = 0, to = 1, steps = 3 }\n", {"axes.mu0.steps", "an unknown key"}},
      {grid + "stiffness = { from = \"1 N/m\", to = \"inf\", points = 3 }\n", {"axes.stiffness.to"}},
      {grid + "amplitude = { from = 0, to = 2, points = 3 }\n", {"axes.amplitude.to", "2"}},
      {"[sweep]\nmethod = \"grid\"\nseed = 1\n", {"[sweep] seed", "latin hypercube"}},
      {"[sweep]\nmethod = \"latin hypercube\"\nsamples = 0\nseed = 1\n", {"samples", "at least 1"}},
      {sample + "mu0 = [0.1]\n", {"axes.mu0", "in a Latin hypercube"}},
      {sample + "mu0 = { from = 0, to = 1, points = 3 }\n", {"axes.mu0.points"}},
      {grid + "mu0 = { from = 0, to = 1, points = 1000000 }\nphase = { from = 0, to = 1, points = 1000000 }\n"
              "amplitude = { from = 0, to = 1, points = 1000000 }\nstiffness = { from = \"1 N/m\", to = \"2 N/m\", "
              "points = 1000000 }\n",
       {"[sweep] axes", "at most 1e+12 designs", "1e+24", "fewer points"}},
  };
  for (const Row& row : table) {
    const std::string message = says(row.sweep);
    for (const std::string& word : row.words) {
      INFO(row.sweep, message);
      CHECK(message.find(word) != std::string::npos);
    }
  }
}

TEST_CASE("table: a section [sweep] is the sweep's affair: other commands take the same file") {
  const std::string sweep = "[sweep]\nmethod = \"grid\"\naxes = { mu0 = [0.3] }\n";
  CHECK(read_case(some_case + sweep, "map.toml").friction.has_value());
  CHECK(plan_of(sweep).rows == 1);
}

}  // namespace

namespace {

// NaN is another number than itself, but the same bits.
std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits(values.size());
  std::transform(values.begin(), values.end(), bits.begin(),
                 [](double value) { return std::bit_cast<std::uint64_t>(value); });
  return bits;
}

TEST_CASE("identity: a row does not depend on those before it, and what cannot be computed is said to be impossible") {
  const auto plan = read_sweep(R"([specimen]
diameter = "30 um"
modulus = "30 GPa"
[rig]
span = "1 mm"
stiffness = "90 N/m"
[friction]
model = "constant"
mu0 = 0.4
[stage]
program = ["0 um", "300 um"]
[sweep]
method = "grid"
axes = { diameter = ["20 um", "900 um", "30 um"] }
)",
                               "some.toml");
  RowComputer forwards(plan), alone(plan);
  const auto first = forwards(inputs_of(plan, 0));
  const auto second = forwards(inputs_of(plan, 1));
  CHECK(first.at(0) == 0);
  CHECK(second.at(0) == static_cast<double>(ResultStatus::impossible));  // thicker than a beam of this span
  CHECK(std::isnan(second.at(1)));
  const auto third = bits_of(forwards(inputs_of(plan, 2)));
  CHECK(third != bits_of(first));
  CHECK(third == bits_of(alone(inputs_of(plan, 2))));
}

TEST_CASE("identity: a row has as many outcomes as there are columns for them, each described, none of one name") {
  const auto plan = some_sweep(10);
  const auto columns = columns_of(plan);
  CHECK(RowComputer(plan)(inputs_of(plan, 0)).size() == columns.size() - plan.axes.size());
  CHECK(columns[status_column(plan)].path == "/outcomes/status");
  std::set<std::string> paths;
  for (const auto& column : columns) {
    paths.insert(column.path);
    CHECK(!column.units.empty());
    CHECK(!column.description.empty());
  }
  CHECK(paths.size() == columns.size());
}

TEST_CASE("limit: without friction there is no snap, no drop, and the work is bent into the specimen") {
  const auto plan = read_sweep(
      "reduced = true\n[rig]\nstiffness = 50\n[friction]\nmodel = \"constant\"\nmu0 = 0\n[stage]\nprogram = [0, 0.3]\n"
      "[sweep]\nmethod = \"grid\"\naxes = { travel = [0.1, 0.2] }\n",
      "some.toml");
  const auto columns = columns_of(plan);
  RowComputer compute(plan);
  const auto values = compute(inputs_of(plan, 1));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string& path = columns[plan.axes.size() + i].path;
    if (path == "/outcomes/stage_reached")
      CHECK(values[i] == doctest::Approx(0.2).epsilon(1e-12));  // rounding, amplified
    if (path == "/outcomes/snaps" || path == "/outcomes/drops") CHECK(values[i] == 0);
    if (path == "/outcomes/friction_heat") CHECK(std::abs(values[i]) < 1e-14);  // the rounding of energies of about 1
    if (path == "/outcomes/first_snap_stage") CHECK(std::isnan(values[i]));
    if (path == "/outcomes/work") CHECK(values[i] > 0);
  }
}

}  // namespace

}  // namespace flexslip
