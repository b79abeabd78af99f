#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "design/design_result.h"
#include "design/sweep_plan.h"
#include "tests/design/some_sweep.h"

namespace flexslip {
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
