#include "data/drops.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "data/failure.h"

using namespace flexslip;

namespace {

constexpr std::size_t test_points = 300;
constexpr double force_noise = 4e-6;  // [N] of the authors' tests

enum class Noise { none, white, correlated, heavy_tailed };

// Half an arch: like a flexible fibre, the force rises to 8 mN and falls for the last third of the test.
Record smooth_test(Noise kind, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::student_t_distribution<double> student(5);
  Record record;
  double wander = 0, error = 0;
  for (int i = -50; i < static_cast<int>(test_points); ++i) {  // 50 points to settle
    const double draw =
        kind == Noise::heavy_tailed ? student(generator) * std::sqrt(0.6) : normal(generator);  // unit variance
    // Like the measured irregularity, steps are correlated by +0.3 from one to the next.
    wander = 0.85 * wander + draw;
    error = 0.5 * error + 0.8 * force_noise * wander;
    if (kind == Noise::white) error = force_noise * draw;
    if (kind == Noise::none) error = 0;
    if (i < 0) continue;
    const double x = static_cast<double>(i) / (test_points - 1);
    record.stage.push_back(6e-4 * x);
    record.force.push_back(8e-3 * std::sin(0.75 * std::numbers::pi * x) + error);
    record.deflection.push_back(record.stage.back() - record.force.back() / 90);
  }
  return record;
}

void add_drop(Record& record, std::size_t before, double fall) {
  for (std::size_t i = before + 1; i < record.force.size(); ++i) {
    record.force[i] -= fall;
    record.deflection[i] += fall / 90;
  }
}

double false_alarms(Noise kind, const DropOptions& options, int tests) {
  std::size_t found = 0;
  for (int seed = 0; seed < tests; ++seed)
    found += find_drops(smooth_test(kind, static_cast<unsigned>(seed)), options).drops.size();
  return static_cast<double>(found) / tests;
}

TEST_CASE("drops: false alarms do not exceed the stated number (simulation)") {
  const int tests = 300;
  for (const double stated : {0.1, 1.0}) {
    const double chance = 3 * std::sqrt(stated / tests);  // three deviations of a Poisson count
    for (const Noise kind : {Noise::white, Noise::correlated}) {
      const double found = false_alarms(kind, {.false_alarms_per_test = stated}, tests);
      INFO("stated ", stated, " found ", found);
      CHECK(found <= stated + chance);
    }
  }
  CHECK(false_alarms(Noise::white, {.false_alarms_per_test = 10}, 50) >
        0.5);  // the promise is not kept by finding nothing
}

TEST_CASE("drops: heavy-tailed irregularity gives more false alarms than stated, by a known factor (simulation)") {
  const double found = false_alarms(Noise::heavy_tailed, {.false_alarms_per_test = 0.1}, 200);
  MESSAGE("Student's t of 5 degrees, correlated: ", found, " false alarms a test at a stated 0.1");
  CHECK(found < 1.0);  // empirical: tails beyond five deviations, about one step in a thousand
}

TEST_CASE("drops: a drop beyond the noise is found, with its size, wherever it lies (truth known)") {
  for (const std::size_t before : {1u, 5u, 40u, 150u, 197u, 250u, 292u, 298u}) {
    Record record = smooth_test(Noise::white, 1);
    const double rise = record.force[before + 1] - record.force[before];
    add_drop(record, before, 5e-5 + std::max(0.0, rise));
    const Drops result = find_drops(record, {.false_alarms_per_test = 0.01});
    REQUIRE(result.status == DropStatus::ok);
    INFO("before ", before);
    REQUIRE(result.drops.size() == 1);
    const Drop& drop = result.drops[0];
    CHECK(drop.before <= before);
    CHECK(drop.after > before);
    CHECK(std::abs(drop.force_fall - (record.force[drop.before] - record.force[drop.after])) == 0);
    CHECK(drop.force_fall > 4e-5);
    CHECK(drop.force_fall > result.smallest_fall);
    // The stage moves one step: all of k_c advance that is not the fall is that step.
    const double travel = record.stage[drop.after] - record.stage[drop.before];
    CHECK(drop.advance ==
          doctest::Approx(travel + drop.force_fall / 90).scale(0).epsilon(1e-9));  // differences of 1e-4 m
  }
}

TEST_CASE("drops: no drops is an answer, and so is too short (limit)") {
  const Drops none = find_drops(smooth_test(Noise::white, 2), {.false_alarms_per_test = 1e-4});
  CHECK(none.status == DropStatus::ok);
  CHECK(none.drops.empty());
  CHECK(find_drops(first_points(smooth_test(Noise::white, 2), 29)).status == DropStatus::too_short);
  CHECK(find_drops(first_points(smooth_test(Noise::white, 2), 30)).status == DropStatus::ok);
  CHECK(find_drops({}).status == DropStatus::too_short);

  Record flat = smooth_test(Noise::white, 2);
  flat.force.assign(flat.force.size(), 0.0);
  CHECK(find_drops(flat).drops.empty());
}

TEST_CASE("drops: a smooth curve without noise has none, rising or falling (limit)") {
  const Record record = smooth_test(Noise::none, 1);
  CHECK(find_drops(record).drops.empty());
}

TEST_CASE("drops: force that steps down by its resolution as it slowly falls has none (limit)") {
  Record record = smooth_test(Noise::white, 1);
  for (std::size_t i = 0; i < test_points; ++i) record.force[i] = 1e-4 * std::round(90 - 0.13 * static_cast<double>(i));
  CHECK(find_drops(record).drops.empty());
}

TEST_CASE("drops: what the force does while the stage halts is none (limit)") {
  Record record = smooth_test(Noise::white, 4);
  add_drop(record, 120, 1e-3);
  REQUIRE(find_drops(record).drops.size() == 1);
  CHECK(find_drops(record, {.halts = {120}}).drops.empty());
  CHECK(find_drops(record, {.halts = {60, 121}}).drops.size() == 1);
}

TEST_CASE("drops: of a coarse force with noise below its resolution none are false (limit)") {
  constexpr double resolution = 1;
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal(0, 0.3 * resolution);
    Record record;
    for (int i = 0; i < 1100; ++i) {
      record.stage.push_back(5e-6 * i);
      record.force.push_back(resolution * std::round((0.12 * i + normal(generator)) / resolution));
      record.deflection.push_back(record.stage.back());
    }
    const Drops drops = find_drops(record);
    CHECK(drops.smallest_fall > 2 * resolution);
    found += drops.drops.size();
  }
  CHECK(found <= 2);  // of 0.1 a test
}

TEST_CASE("drops: one that takes two steps is one, and what takes three alike is a slow fall (truth known)") {
  Record record = smooth_test(Noise::white, 4);
  for (const std::size_t before : {100u, 101u, 102u, 150u, 151u}) add_drop(record, before, 2e-4);
  const Drops result = find_drops(record);
  REQUIRE(result.drops.size() == 1);
  CHECK(result.drops[0].before == 150);
  CHECK(result.drops[0].after == 152);
  REQUIRE(result.slow_falls.size() == 1);
  CHECK(result.slow_falls[0].before == 100);
  CHECK(result.slow_falls[0].after == 103);
}

TEST_CASE("drops: a step with most of a fall makes it a drop, for any neighbouring steps (truth known)") {
  Record record = smooth_test(Noise::white, 4);
  add_drop(record, 100, 6e-4);
  add_drop(record, 101, 1e-4);
  add_drop(record, 102, 1e-4);
  CHECK(find_drops(record).drops.size() == 1);
  CHECK(find_drops(record).slow_falls.empty());
}

TEST_CASE("drops: what no single step shows, three together do (truth known)") {
  Record record = smooth_test(Noise::white, 5);
  const std::size_t top = 199;  // where the curve is level
  const Drops without = find_drops(record);
  for (const std::size_t before : {top, top + 1, top + 2}) add_drop(record, before, 0.75 * without.smallest_fall);
  CHECK(without.drops.empty());
  CHECK(without.slow_falls.empty());
  CHECK(find_drops(record).slow_falls.size() == 1);
}

TEST_CASE("drops: the unit of force does not matter (identity)") {
  Record record = smooth_test(Noise::correlated, 6);
  for (std::size_t before = 120; before < 280; before += 7) add_drop(record, before, 1e-4);
  const Drops newtons = find_drops(record);
  for (double& F : record.force) F *= 1024;  // a power of two: exact
  const Drops other = find_drops(record);
  REQUIRE(newtons.drops.size() == other.drops.size());
  CHECK(newtons.drops.size() >= 20);
  for (std::size_t i = 0; i < other.drops.size(); ++i) {
    CHECK(newtons.drops[i].before == other.drops[i].before);
    CHECK(newtons.drops[i].after == other.drops[i].after);
    CHECK(newtons.drops[i].significance == other.drops[i].significance);
  }
}

TEST_CASE("drops: allowing more false alarms finds no fewer points (identity)") {
  Record record = smooth_test(Noise::correlated, 7);
  for (std::size_t before = 120; before < 280; before += 9)
    add_drop(record, before, 2e-5 + 2e-7 * static_cast<double>(before));
  std::size_t fewer = 0;
  for (const double stated : {0.001, 0.1, 1.0, 10.0}) {
    const std::size_t found = find_drops(record, {.false_alarms_per_test = stated}).drops.size();
    CHECK(found >= fewer);
    fewer = found;
  }
}

TEST_CASE("drops: broken contracts are refused (contract)") {
  const Record record = smooth_test(Noise::white, 1);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(find_drops(record, {.false_alarms_per_test = bad}), std::invalid_argument);
  Record broken = record;
  broken.force[17] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(find_drops(broken), std::invalid_argument);
}

#ifdef FLEXSLIP_SOURCE_DIR

std::vector<std::vector<std::string>> rows_of(const std::string& name) {
  std::ifstream file(std::string(FLEXSLIP_SOURCE_DIR) + "/../shared/data/spicules/" + name);
  std::vector<std::vector<std::string>> rows;
  std::string line, cell;
  std::getline(file, line);  // header
  while (std::getline(file, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    while (std::getline(cells, cell, ',')) rows.back().push_back(cell);
  }
  return rows;
}

TEST_CASE("drops: at least 99 % of the drops that the authors marked are found, and their failures (outside)") {
  const auto specimens = rows_of("specimens.csv");
  if (specimens.empty()) {
    MESSAGE("skipped: no campaign data");
    return;
  }
  // The index in the file is the point after the drop, counted from 1, in spite of its description: only then do all
  // 182 marks lie on steps by which the force falls.
  std::map<std::string, std::set<std::size_t>> marks;
  for (const auto& row : rows_of("slip_events.csv")) marks[row[0]].insert(std::stoul(row[2]) - 1);

  std::size_t marked = 0, found = 0, slowly = 0, unmarked = 0, failures_within_one = 0, failures_within_two = 0;
  std::size_t noisy_failures = 0;
  std::mt19937_64 engine(1);
  for (const auto& specimen : specimens) {
    const std::string number = specimen[0].substr(2);
    Record record;
    for (const auto& row : rows_of("ss/SS" + std::string(2 - number.size(), '0') + number + ".csv")) {
      record.stage.push_back(std::stod(row[0]));
      record.deflection.push_back(std::stod(row[1]));
      record.force.push_back(std::stod(row[2]));
    }
    REQUIRE(check_record(record).fault == RecordFault::none);

    const auto given = static_cast<std::size_t>(std::stod(specimen[11]));
    const std::size_t points = find_failure(record).points;
    failures_within_one += points + 1 >= given && points <= given + 1;
    failures_within_two += points + 2 >= given && points <= given + 2;
    std::normal_distribution<double> noise(0, 0.005 * *std::max_element(record.force.begin(), record.force.end()));
    for (int copy = 0; copy < 4; ++copy) {
      Record noisy = record;
      for (double& force : noisy.force) force += noise(engine);
      const std::size_t with_noise = find_failure(noisy).points;
      noisy_failures += with_noise + 2 >= given && with_noise <= given + 2;
    }

    const auto& mine = marks[specimen[0]];
    const Drops result = find_drops(first_points(record, given));
    const auto covered_by = [&](const Drop& drop) {
      return static_cast<std::size_t>(std::distance(mine.upper_bound(drop.before), mine.upper_bound(drop.after)));
    };
    std::size_t here = 0, extra = 0;
    for (const Drop& drop : result.drops) {
      here += covered_by(drop);
      extra += covered_by(drop) == 0;
    }
    for (const Drop& slow : result.slow_falls) slowly += covered_by(slow);
    const auto before_failure = static_cast<std::size_t>(
        std::count_if(mine.begin(), mine.end(), [=](std::size_t after) { return after < given; }));
    MESSAGE(specimen[0], " ", specimen[1], ": ", here, " of ", before_failure, " marks found, ", extra,
            " drops not marked; failure ", given, " given, ", points, " found");
    marked += before_failure;
    found += here;
    unmarked += extra;
  }
  MESSAGE(found, " of ", marked, " marks found, ", unmarked, " drops not marked");
  CHECK(marked == 182);
  // The authors marked seven steps of two falls that take four and five steps.
  CHECK(static_cast<double>(found + slowly) >= 0.99 * static_cast<double>(marked));
  CHECK(slowly <= 7);
  CHECK(unmarked <= 40);             // each a fall of 20 µN or more, most of them slips the authors passed over
  CHECK(failures_within_one >= 23);  // of 26
  CHECK(failures_within_two == 26);
  MESSAGE(noisy_failures, " of 104 failures found within two points with noise");
  CHECK(noisy_failures >= 98);
}

#endif

}  // namespace
