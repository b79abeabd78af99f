#include "inference/beginning.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

const BeginningOf known{.span = scales.span(),
                        .load_train_stiffness = scales.physical_stiffness(90),
                        .bending_stiffness = scales.bending_stiffness(),
                        .bending_stiffness_error = 0.03};

// A simulated test, its stage counted from elsewhere [L], with readings of no force before the contact.
struct Made {
  double mu = 0.5, stiffening = 1, noise = 0.015;
  double contact = 0;  // [L]
  std::size_t before = 0;
  std::uint64_t seed = 1;
};

Record made(const Made& truth) {
  ReducedRecord record = simulated_record({.friction = Friction::constant(truth.mu),
                                           .stiffening = truth.stiffening,
                                           .noise = truth.noise,
                                           .deflection = 0.3,
                                           .seed = truth.seed});
  std::mt19937_64 generator(truth.seed);
  std::normal_distribution<double> normal(0, truth.noise);
  for (std::size_t i = 0; i < truth.before; ++i) {
    const double force = normal(generator), stage = -2.0 / 1278 * static_cast<double>(i);
    record.stage.insert(record.stage.begin(), stage);
    record.force.insert(record.force.begin(), force);
    record.deflection.insert(record.deflection.begin(), stage - force / 90);
  }
  for (auto* column : {&record.stage, &record.deflection})
    for (double& value : *column) value += truth.contact;
  return to_physical(record, scales);
}

// How far the contact found is from the true one [L], in its errors.
double errors_off(const Record& record, const BeginningOf& test, double truth) {
  const Contact contact = find_contact(record, test);
  REQUIRE(contact.status == ContactStatus::found);
  CHECK(contact.offset.standard_error >= least_contact_error * test.span);
  return (contact.offset.value - truth * test.span) / contact.offset.standard_error;
}

TEST_CASE(
    "beginning: whatever the friction, the stiffness within its error and the rows before, the contact is within its "
    "errors") {
  CHECK(rc::check("any beginning", [] {
    const Made truth{.mu = 0.01 * *rc::gen::inRange(0, 100),
                     .stiffening = 1 + 0.001 * *rc::gen::inRange(-50, 50),
                     .noise = 0.001 * *rc::gen::inRange(1, 30),
                     .contact = 0.001 * *rc::gen::inRange(-20, 300),
                     .before = *rc::gen::element<std::size_t>(0, 1, 3, 8, 40),
                     .seed = *rc::gen::inRange<std::uint64_t>(1, 1000)};
    RC_ASSERT(std::abs(errors_off(made(truth), known, truth.contact)) < 3);  // 0.3 % of normal errors lie beyond
  }));
}

TEST_CASE("beginning: a bending stiffness that nobody states is found with the contact (simulation)") {
  BeginningOf unknown = known;
  unknown.bending_stiffness = {};
  int covered = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    covered += std::abs(errors_off(made({.seed = seed}), unknown, 0)) < 2;
  CHECK(covered >= 43);  // 95 % of 50, and three deviations below
  CHECK(find_contact(made({.noise = 0}), unknown).slope == doctest::Approx(48 * scales.stiffness_unit()).epsilon(0.03));
}

TEST_CASE("beginning: more rows do not make a contact sharper (limit)") {
  const Record many = to_physical(
      simulated_record({.friction = Friction::constant(0.5), .noise = 0.001, .step = 0.05 / 1278, .deflection = 0.1}),
      scales);
  CHECK(find_contact(many, known).offset.standard_error >= least_contact_error * known.span);
}

TEST_CASE("beginning: a bending stiffness that is stated hardly larger hardly moves it, in rough records, too") {
  BeginningOf stiffer = known;
  *stiffer.bending_stiffness *= 1 + 1e-7;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    const Record record = made({.noise = 0.1, .contact = 0.015, .before = 8, .seed = seed});
    const Estimate one = find_contact(record, known).offset, other = find_contact(record, stiffer).offset;
    CHECK(std::abs(other.value - one.value) < 1e-3 * one.standard_error);
    CHECK(other.standard_error == doctest::Approx(one.standard_error).epsilon(1e-3));
  }
}

TEST_CASE("beginning: single readings that are far off do not move it") {
  const Record clean = made({});
  const double greatest = *std::max_element(clean.force.begin(), clean.force.end());
  for (const std::size_t at : {0U, 3U, 10U, 20U})
    for (const double by : {-0.3, 0.2, 2.0}) {
      Record record = clean;
      record.force[at] += by * greatest;
      record.deflection[at] -= by * greatest / known.load_train_stiffness;
      CAPTURE(at);
      CAPTURE(by);
      CHECK(std::abs(errors_off(record, known, 0)) < 1);
    }
}

TEST_CASE(
    "beginning: a seat that gives way at first is found with an error that holds the truth, a firm one is not called "
    "so (simulation)") {
  int covered = 0, settling = 0, firm = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Record record = made({.noise = 0.005, .seed = seed});
    firm += !find_contact(record, known).settles;
    const double greatest = *std::max_element(record.force.begin(), record.force.end());
    for (std::size_t i = 0; i < record.force.size(); ++i) {
      const double gives_way = 10e-6 * (1 - std::exp(-20 * std::max(record.force[i], 0.0) / greatest));
      record.stage[i] += gives_way;
      record.deflection[i] += gives_way;
    }
    settling += find_contact(record, known).settles;
    covered += std::abs(errors_off(record, known, 10e-6 / known.span)) < 2;
  }
  CHECK(covered >= 33);  // 95 % of 40, and three deviations below
  CHECK(settling >= 36);
  CHECK(firm >= 38);
}

TEST_CASE("beginning: where there is no contact to find, the status says so (limit)") {
  CHECK(find_contact({}, known).status == ContactStatus::too_few_points);
  std::vector<double> x;
  for (int i = 0; i < 50; ++i) x.push_back(1e-6 * i);
  CHECK(find_contact({x, x, std::vector<double>(50, 0.0)}, known).status == ContactStatus::not_rising);
  CHECK(find_contact({x, x, std::vector<double>(50, -1e-3)}, known).status == ContactStatus::not_rising);
}

TEST_CASE("beginning: counted from elsewhere it moves along (identity)") {
  const Contact contact = find_contact(made({.contact = 0.02}), known);
  const Contact moved = counted_from(1e-5, contact);
  CHECK(moved.offset.value == contact.offset.value - 1e-5);
  CHECK(moved.offset.high == contact.offset.high - 1e-5);
  CHECK(moved.offset.standard_error == contact.offset.standard_error);
}

}  // namespace
}  // namespace flexslip
