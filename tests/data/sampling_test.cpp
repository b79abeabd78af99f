#include "data/sampling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "tests/uniform.h"

namespace flexslip {
namespace {

struct Columns {
  std::vector<double> displacement, force;
};

// A rising curve with drops, noise of 0.01 on a force of 10.
Columns readings() {
  std::mt19937_64 generator(3);
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
  Columns columns;
  for (int i = 0; i < 400; ++i) {
    const double noise = std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform());
    columns.displacement.push_back(i);
    columns.force.push_back(0.025 * i - 0.2 * (i / 20) + 0.01 * noise);
  }
  return columns;
}

Columns interpolated(const Columns& from, std::size_t rows) {
  Columns columns;
  for (std::size_t i = 0; i < rows; ++i) {
    const double at =
        static_cast<double>(i) * static_cast<double>(from.force.size() - 1) / static_cast<double>(rows - 1);
    const auto j = std::min(static_cast<std::size_t>(at), from.force.size() - 2);
    const double part = at - static_cast<double>(j);
    columns.displacement.push_back(from.displacement[j] + part * (from.displacement[j + 1] - from.displacement[j]));
    columns.force.push_back(from.force[j] + part * (from.force[j + 1] - from.force[j]));
  }
  return columns;
}

// A force that rises to a greatest force of 1, smoothly or with drops, with noise of 0.03 to 0.4 %.
struct Noisy {
  Columns columns;
  double noise;
};

Noisy noisy(Uniform& uniform, int rows) {
  Noisy record{{}, 3e-4 * std::pow(13, uniform(0, 1))};
  const double drops = uniform(0, 1) < 0.5 ? 0 : std::floor(uniform(1, 40));
  const double decade = std::pow(10, uniform(-4, 0));
  for (int i = 0; i < rows; ++i) {
    const double at = i / static_cast<double>(rows), since = at * drops - std::floor(at * drops);
    const double normal = std::sqrt(-2 * std::log(1 - uniform(0, 1))) * std::cos(2 * std::numbers::pi * uniform(0, 1));
    const double fallen = at * drops < 1 ? 0 : 0.03 * std::exp(-3 * since);
    record.columns.displacement.push_back(i);
    record.columns.force.push_back(decade * (std::sin(1.4 * at) - fallen + record.noise * normal));
  }
  record.noise *= decade;
  return record;
}

void round_to_steps(std::vector<double>& force, double step) {
  for (double& each : force) each = step * std::round(each / step);
}

// A force in N from a file with this many digits in mN.
void write_digits(std::vector<double>& force, int digits) {
  for (double& each : force) {
    std::ostringstream text;
    text << std::setprecision(digits) << 1e3 * each;
    each = 1e-3 * std::stod(text.str());
  }
}

Sampling sampling_of(const Columns& columns, std::size_t most = 2000) {
  return flexslip::sampling_of(columns.displacement, columns.force, most);
}

}  // namespace

TEST_CASE("limit: readings that are all new all count") {
  const auto sampling = sampling_of(readings());
  CHECK(sampling.rows.size() == 400);
  CHECK(sampling.repeated + sampling.held + sampling.interpolated == 0);
  CHECK(sampling.stride == 1);
  CHECK(flexslip::sampling_of({}, {}, 10).rows.empty());
}

TEST_CASE("identity: rows that are repeated count once") {
  const auto once = readings();
  Columns columns;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < once.force.size(); ++i) {
    first.push_back(columns.force.size());
    for (std::size_t copy = 0; copy <= i % 3; ++copy) {
      columns.displacement.push_back(once.displacement[i]);
      columns.force.push_back(once.force[i]);
    }
  }
  const auto sampling = sampling_of(columns);
  CHECK(sampling.rows == first);
  CHECK(sampling.repeated == columns.force.size() - first.size());
}

TEST_CASE("identity: a force held over two rows or three counts where it is new") {
  for (const std::size_t over : {2, 3}) {
    auto columns = readings();
    for (std::size_t i = 0; i < columns.force.size(); ++i) columns.force[i] = columns.force[i - i % over];
    const auto sampling = sampling_of(columns);
    CHECK(sampling.held > 360 - 400 / over - 2);
    for (const std::size_t row : sampling.rows)
      CHECK((row % over == 0 || std::abs(columns.force[row]) <= 0.05 * 10));  // what is not yet loaded stays
  }
}

TEST_CASE("identity: a force in steps of 0.2 to 2 times its noise, of 4 to 10 digits, loses no row") {
  Uniform uniform;
  constexpr int records = 280;
  int lose = 0;
  for (int i = 0; i < records; ++i) {
    auto [columns, noise] = noisy(uniform, static_cast<int>(uniform(200, 3000)));
    round_to_steps(columns.force, noise * 0.2 * std::pow(10, uniform(0, 1)));
    write_digits(columns.force, 4 + i % 7);
    lose += sampling_of(columns, 3000).rows.size() < columns.force.size() ? 1 : 0;
  }
  CAPTURE(lose);
  CHECK(100 * lose <= records);
}

TEST_CASE("identity: rows that are interpolated two to ten times are recognised in most files of 4 to 10 digits") {
  Uniform uniform;
  constexpr int records = 280;
  int recognised = 0;
  for (int i = 0; i < records; ++i) {
    auto [columns, noise] = noisy(uniform, static_cast<int>(uniform(200, 1000)));
    if (uniform(0, 1) < 0.3) round_to_steps(columns.force, noise * 0.2 * std::pow(10, uniform(0, 1)));
    auto many =
        interpolated(columns, static_cast<std::size_t>(uniform(2, 10) * static_cast<double>(columns.force.size())));
    write_digits(many.force, 4 + i % 7);
    recognised += sampling_of(many, 10000).interpolated > 0 ? 1 : 0;
  }
  CAPTURE(recognised);
  CHECK(100 * recognised >= 85 * records);
}

TEST_CASE(
    "identity: of a record interpolated to any number of rows the readings count, and no row on the way of a drop") {
  const auto columns = readings();
  for (const std::size_t rows : {1200, 1701, 5000, 40000}) {
    CAPTURE(rows);
    const auto many = interpolated(columns, rows);
    const auto sampling = sampling_of(many, 100000);
    CHECK(sampling.rows.size() >= 395);
    CHECK(sampling.rows.size() <= 405);
    CHECK(sampling.interpolated + sampling.rows.size() == rows);
    const double row = 399.0 / static_cast<double>(rows - 1);  // in readings
    for (const std::size_t i : sampling.rows) {
      const double at = many.displacement[i];
      CHECK(std::abs(at - std::round(at)) <= 1.01 * row);
    }
  }
}

TEST_CASE(
    "limit: rows while the stage stands are readings, however straight their force falls, and so are the others") {
  auto columns = readings();
  const double stands_at = columns.displacement[250], force = columns.force[250];
  std::vector<double> held_displacement, held_force;
  for (int i = 1; i <= 500; ++i) {
    held_displacement.push_back(stands_at);
    held_force.push_back(force - 1e-3 * i);
  }
  columns.displacement.insert(columns.displacement.begin() + 251, held_displacement.begin(), held_displacement.end());
  columns.force.insert(columns.force.begin() + 251, held_force.begin(), held_force.end());
  CHECK(sampling_of(columns).rows.size() == 900);
}

TEST_CASE("identity: points behind which the stage halted are counted from the first asked for") {
  Sampling sampling = sampling_of(readings());
  sampling.halts = {sampling.rows[7], sampling.rows[20], sampling.rows[31]};
  CHECK(sampling.halts_between(0, sampling.rows.size()) == std::vector<std::size_t>{7, 20, 31});
  CHECK(sampling.halts_between(20, 31) == std::vector<std::size_t>{0});
  CHECK(sampling.halts_between(21, 31).empty());
}

TEST_CASE("limit: rows far before and after the load go first, and take no row of it") {
  const auto test = readings();
  Columns columns;
  const auto add = [&](double displacement, double force) {
    columns.displacement.push_back(displacement);
    columns.force.push_back(force);
  };
  constexpr int free = 3000;
  for (int i = 0; i < free; ++i) add(test.displacement.front() - 1e-6 * (free - i), 1e-7 * (i % 7));
  for (std::size_t i = 0; i < test.force.size(); ++i) add(test.displacement[i], test.force[i]);
  for (int i = 0; i < free; ++i) add(test.displacement.back() + 1e-6 * i, 1e-7 * (i % 5));
  const auto sampling = sampling_of(columns, 1000);
  CHECK(sampling.stride == 1);
  CHECK(sampling.rows.size() <= 1000);
  CHECK(sampling.unloaded == columns.force.size() - sampling.rows.size());
  CHECK(sampling.rows.front() > 2500);
  CHECK(sampling.rows.front() < free - 100);
  CHECK(sampling.rows.back() >= free + test.force.size() + 90);
  CHECK(sampling.end == columns.force.size());
}

TEST_CASE("limit: of too many rows, every stride-th counts") {
  const Columns columns = readings();
  const auto sampling = sampling_of(columns, 150);
  CHECK(sampling.stride == 3);
  CHECK(sampling.rows.size() >= 133);
  CHECK(sampling.rows[1] == sampling.rows[0] + 3);
  const auto greatest = std::max_element(columns.force.begin(), columns.force.end()) - columns.force.begin();
  CHECK(std::binary_search(sampling.rows.begin(), sampling.rows.end(), static_cast<std::size_t>(greatest)));
}

}  // namespace flexslip
