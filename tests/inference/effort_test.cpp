// No input without an end: whatever record, legal but absurd, meets whatever rig, a whole fit takes no more than its rows allow.
#include "numerics/effort.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "inference/analysis.h"
#include "tests/generators.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

// One in so many is 10^[-decades, decades], the others 1.
double off(int one_in, double decades) {
  const double exponent = *between(-decades, decades);
  return *whole(1, one_in) == 1 ? std::pow(10, exponent) : 1;
}

// Of a simulated test with or without cracks, of a force that wanders, or of a staircase of several readings at a place.
ReducedRecord some_record() {
  const SimulatedTruth truth{
      .friction = Friction::sinusoid(*between(0, 0.8), *between(0, 0.4), *between(4, 40) / 1278, 1),
      .stiffness = std::pow(10, *between(0.5, 3)),
      .noise = std::pow(10, *between(-4, -1)),
      .step = *between(0.8, 6) / 1278,
      .deflection = *between(0.06, 0.5),
      .seed = static_cast<std::uint64_t>(*whole(1, 1 << 20)),
      .fibre = {}};
  ReducedRecord record = simulated_record(truth, *whole(1, 3) == 1 ? six_cracks : std::vector<Crack>{});
  const int kind = *whole(1, 6);
  std::mt19937_64 generator(truth.seed);
  for (std::size_t i = 1; i < record.force.size(); ++i) {
    const double uniform = (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53;
    if (kind == 1) record.force[i] = record.force[i - 1] + (uniform - 0.4) * 0.5;
    if (kind == 2) record.stage[i] = record.stage[i - i % 7];
    if (kind <= 2) record.deflection[i] = record.stage[i] - record.force[i] / truth.stiffness;
  }
  return record;
}

TestDescription some_description() {
  constexpr std::array trains{90.65, 30.0, 0.001, infinity};
  const double train = trains[static_cast<std::size_t>(*whole(0, 3))] * off(2, 2);
  const double wide = *whole(1, 5) == 1 ? *between(0.001, 0.06) : 0;
  const double thick = *whole(1, 3) == 1 ? std::pow(10, *between(-3, -1.3)) : 0;
  return {.span = scales.span() * off(3, 1),
          .load_train_stiffness = train,
          .bending_stiffness = *whole(1, 6) == 1 ? std::nullopt : std::optional(scales.bending_stiffness() * off(2, 2)),
          .contact_error = *whole(1, 3) == 1 ? std::optional(*between(0, 20e-6)) : std::nullopt,
          .fibre = wide + thick > 0 ? Fibre({wide, thick}) : Fibre()};
}

// Of 800 such tests the worst took 270,000 states a row.
TEST_CASE("effort: a fit takes no more than its rows allow, whatever its record meets (identity)") {
  constexpr std::uint64_t most_each = 400'000;
  constexpr std::size_t shortest = 100;  // [rows] below, draws and scans of a given number count
  CHECK(rc::check("absurd tests", [] {
    const Record record = to_physical(some_record(), scales);
    const TestDescription description = some_description();
    effort_spent.clear();
    analyse(record, description);
    RC_ASSERT(effort_spent.spent() <= most_each * (record.force.size() + shortest));
  }));
}

}  // namespace
}  // namespace flexslip
