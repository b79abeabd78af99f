#include "data/record_statistics.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

using namespace flexslip;

namespace {

constexpr double train = 100;        // [N/m]
constexpr double stage_step = 1e-6;  // [m] of the stage

// A specimen of 10 N/m that loses a fifth of its force at every fortieth row, on a load train that follows: the stage moves evenly.
struct Sawtooth {
  Record record;
  std::vector<Drop> drops;
};

Sawtooth sawtooth(std::size_t rows) {
  Sawtooth made;
  double held = 1;
  for (std::size_t i = 0; i < rows; ++i) {
    if (i % 40 == 39) held *= 0.8;
    const double stage = stage_step * static_cast<double>(i + 1);
    const double deflection = stage / (1 + held * 10 / train);
    made.record.stage.push_back(stage);
    made.record.deflection.push_back(deflection);
    made.record.force.push_back(train * (stage - deflection));
    if (i > 0 && i % 40 == 39)
      made.drops.push_back({.before = i - 1,
                            .after = i,
                            .force_fall = made.record.force[i - 1] - made.record.force[i],
                            .advance = 0,
                            .significance = 100});
  }
  return made;
}

}  // namespace

TEST_CASE("record statistics: the load train recovers the additional deflection of a drop (identity)") {
  const Sawtooth made = sawtooth(300);
  const TrainInDrops stated = statistics_of(made.record, made.drops, train).train;
  CHECK(stated.drops == made.drops.size());
  CHECK(stated.misfits == 0);
  CHECK(stated.compliance == doctest::Approx(1 / train).epsilon(1e-9));  // rounding of differences of the columns
  CHECK(stated.leap == doctest::Approx(0).scale(1).epsilon(1e-9));
  const TrainInDrops stiff = statistics_of(made.record, made.drops, 10 * train).train;
  CHECK(stiff.misfits == 5);  // the first two drop by less than the stage moves meanwhile
  CHECK(stiff.compliance == stated.compliance);

  // A deflection mistaken for the stage jumps in each drop by the whole recovery of the load train.
  Record taken = made.record;
  taken.stage = taken.deflection;
  const TrainInDrops leaping = statistics_of(taken, made.drops, train).train;
  CHECK(leaping.leap == doctest::Approx(1).epsilon(1e-9));
  CHECK(leaping.leap_error == doctest::Approx(0).scale(1).epsilon(1e-9));
}

TEST_CASE("record statistics: rows between drops, of three drops or more (by hand)") {
  const Sawtooth made = sawtooth(300);
  CHECK(statistics_of(made.record, made.drops, train).rows_between_drops == 40);
  CHECK(std::isnan(statistics_of(made.record, {made.drops[0], made.drops[1]}, train).rows_between_drops));
}

TEST_CASE("record statistics: the widest stage_step of the stage, and where it lies (by hand)") {
  Sawtooth made = sawtooth(101);
  for (std::size_t i = 50; i < 101; ++i) made.record.stage[i] += 99 * stage_step;
  const WidestStep widest = statistics_of(made.record, made.drops, train).widest_step;
  CHECK(widest.behind == 49);
  CHECK(widest.length == doctest::Approx(100 * stage_step));
  CHECK(widest.usual == doctest::Approx(stage_step));
  CHECK(widest.share_of_travel == doctest::Approx(100.0 / 199));
}

TEST_CASE("record statistics: a force sinks by what it loses behind its maximum, drops apart (by hand)") {
  Sawtooth made = sawtooth(200);
  made.drops.clear();
  std::vector<double>& force = made.record.force;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double to_turn = static_cast<double>(i) / 150;
    force[i] = i <= 150 ? to_turn : 1 - 0.4 * static_cast<double>(i - 150) / 49;
  }
  const auto sinking = [&] { return statistics_of(made.record, made.drops, train).sinking; };
  constexpr double of_medians = 0.02;
  CHECK(std::abs(static_cast<double>(sinking().from) - 150) < 3);
  CHECK(sinking().share == doctest::Approx(0.4).epsilon(of_medians));
  made.drops.push_back({.before = 160, .after = 161, .force_fall = 0.1, .advance = 0, .significance = 9});
  CHECK(sinking().share == doctest::Approx(0.3).epsilon(of_medians));
  made.drops.front().before = 100;  // before the maximum
  made.drops.front().after = 101;
  CHECK(sinking().share == doctest::Approx(0.4).epsilon(of_medians));
  force.resize(force.size() + 150, 1.2);  // it rises again
  for (auto* column : {&made.record.stage, &made.record.deflection})
    while (column->size() < force.size()) column->push_back(column->back() + 1e-6);
  CHECK(sinking().share == doctest::Approx(0.4 / 1.2).epsilon(of_medians));
  for (double& each : force) each = -each;
  CHECK(sinking().share == 0);
}
