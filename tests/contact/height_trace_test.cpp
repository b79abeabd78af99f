#include "contact/height_trace.h"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <doctest/doctest.h>

#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/uniform.h"

namespace flexslip {

TEST_CASE("height trace: even positions are unchanged, falling ones reversed (identity)") {
  const std::vector<double> x{3, 2, 1, 0}, z{5, 6, 7, 9};
  const HeightTrace turned = sampled(x, z);
  CHECK(turned.begin == 0);
  CHECK(turned.step == 1);
  CHECK(turned.height == std::vector<double>{9, 7, 6, 5});
}

TEST_CASE("height trace: of uneven positions a straight line stays one (limit)") {
  const std::vector<double> x{0, 1, 1.5, 3, 5}, z{1, 3, 4, 7, 11};
  const HeightTrace even = sampled(x, z);
  CHECK(even.step == 1.25);
  for (std::size_t i = 0; i < 5; ++i) CHECK(even.height[i] == doctest::Approx(1 + 2 * even.position(i)).epsilon(1e-15));
}

TEST_CASE("height trace: positions that turn back are refused (limit)") {
  CHECK(has(message_of([] { sampled(std::vector{0.0, 1.0, 1.0}, std::vector{0.0, 0.0, 0.0}); }), "3 does not"));
}

TEST_CASE("height trace: levelling is least squares (oracle: Eigen's QR on powers)") {
  Uniform uniform;
  const int n = 200;
  HeightTrace trace{0, 0.1, {}};
  for (int i = 0; i < n; ++i) trace.height.push_back(uniform(-1, 1) + 0.01 * i + 1e-4 * i * i);
  for (const std::size_t degree : {0u, 1u, 2u, 5u}) {
    const auto powers = static_cast<Eigen::Index>(degree + 1);
    Eigen::MatrixXd A(n, powers);
    for (int i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < powers; ++j) A(i, j) = std::pow(i / 100.0 - 1, static_cast<double>(j));
    const Eigen::VectorXd z = Eigen::Map<const Eigen::VectorXd>(trace.height.data(), n);
    const Eigen::VectorXd rest = z - A * A.colPivHouseholderQr().solve(z);
    const HeightTrace level = levelled(trace, degree);
    for (int i = 0; i < n; ++i) CHECK(std::abs(level.height[static_cast<std::size_t>(i)] - rest[i]) < 1e-13 * 7);
  }
  CHECK(has(message_of([&] { levelled(trace, 10); }), "degree 10"));
}

TEST_CASE("height trace: the filter leaves half of a wave as long as its cutoff (table: ISO 16610-21)") {
  HeightTrace trace{0, 0.05, {}};
  for (int i = 0; i < 4000; ++i) trace.height.push_back(std::cos(2 * std::numbers::pi * 0.05 * i / 4));
  const HeightTrace half = smoothed(trace, 4);
  // exp(-π (α f λ)²) with α² = ln 2/π, a wave of 8 through a cutoff of 4: 2^(-1/4)
  for (std::size_t i = 1000; i < 3000; ++i)
    CHECK(std::abs(half.height[i] - 0.5 * trace.height[i]) <
          1e-6);  // its weights end at 1.5 cutoffs, with 2e-14, in steps of an 80th
  const HeightTrace short_one = smoothed(trace, 2);
  CHECK(short_one.height[2000] == doctest::Approx(std::pow(2, -0.25) * trace.height[2000]).epsilon(1e-6));
}

TEST_CASE("height trace: the filter is the weighted mean by its definition, also at the ends (oracle)") {
  Uniform uniform;
  HeightTrace trace{0, 0.1, {}};
  for (int i = 0; i < 150; ++i) trace.height.push_back(uniform(-1, 1));
  for (const double cutoff : {0.05, 0.7, 5.0, 100.0}) {
    const HeightTrace through = smoothed(trace, cutoff);
    for (int i = 0; i < 150; ++i) {
      double sum = 0, weights = 0;
      for (int j = 0; j < 150; ++j) {
        const double x = 0.1 * (i - j) / cutoff;
        if (std::abs(x) > 1.5) continue;  // where weights end
        const double w = std::exp(-std::numbers::pi * x * x / (std::numbers::ln2 / std::numbers::pi));
        sum += w * trace.height[static_cast<std::size_t>(j)];
        weights += w;
      }
      CHECK(std::abs(through.height[static_cast<std::size_t>(i)] - sum / weights) < 1e-13);
    }
    HeightTrace tiny = trace;  // nanometres in metres
    for (double& each : tiny.height) each *= 1e-9;
    tiny = smoothed(std::move(tiny), cutoff);
    for (std::size_t i = 0; i < 150; ++i) CHECK(std::abs(tiny.height[i] - 1e-9 * through.height[i]) < 1e-22);
  }
  CHECK(smoothed({0, 1, std::vector<double>(10, 0.0)}, 3).height == std::vector<double>(10, 0.0));
}

}  // namespace flexslip
