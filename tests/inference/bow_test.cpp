// A specimen that is bowed reads like a preload that was tared: by a shooting of the bowed beam, which knows neither.
#include <array>
#include <cmath>

#include <Eigen/Dense>
#include <doctest/doctest.h>

#include "bending_test/equilibrium.h"
#include "inference/fit.h"

namespace flexslip {
namespace {

using Vector = Eigen::Vector3d;

// Half of a beam of EI = 1 over a span of 1, from its support to midspan, whose natural shape is an arc. Unknown: the reaction, the slope at the support, and
// the length between them.
struct BowedBeam {
  double bow;       // sagitta, downwards
  double friction;  // at the supports, against sliding in

  // Slope, way along the span and way down at midspan, less what they are to be there.
  Vector off_at_midspan(const Vector& unknown, double deflection) const {
    const double reaction = unknown[0], slope = unknown[1], length = unknown[2];
    const double along = reaction * (std::sin(slope) - friction * std::cos(slope)), up = upwards(reaction, slope);
    const auto rates = [&](const Vector& at) {
      const double moment = at[1] * up + at[2] * along;
      return Vector(-moment - 8 * bow, std::cos(at[0]), std::sin(at[0]));
    };
    constexpr int steps = 400;
    const double h = length / steps;
    Vector at(slope, 0, 0);
    for (int i = 0; i < steps; ++i) {
      const Vector a = rates(at), b = rates(at + h / 2 * a), c = rates(at + h / 2 * b), d = rates(at + h * c);
      at += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return at - Vector(0, 0.5, deflection + bow);
  }

  double upwards(double reaction, double slope) const {
    return reaction * (std::cos(slope) + friction * std::sin(slope));
  }

  // [EI/L^2] The force at a deflection from the natural shape, by Newton's method.
  double force(double deflection) const {
    const double shape = deflection + bow;
    Vector at(24 * deflection, 3 * shape, 0.5 + shape * shape);
    for (int iteration = 0; iteration < 30; ++iteration) {
      const Vector off = off_at_midspan(at, deflection);
      if (off.norm() < 1e-12) break;
      Eigen::Matrix3d by;
      constexpr double step = 1e-6;
      for (int k = 0; k < 3; ++k) {
        Vector moved = at;
        moved[k] += step;
        by.col(k) = (off_at_midspan(moved, deflection) - off) / step;
      }
      at -= by.partialPivLu().solve(off);
    }
    REQUIRE(off_at_midspan(at, deflection).norm() < 1e-9);
    return 2 * upwards(at[0], at[1]);
  }
};

TEST_CASE("oracle: a bow moves the force as a preload of its sagitta does, to two fifths of that") {
  for (const double friction : {0.0, 0.2, 0.4})
    for (const double deflection : {0.1, 0.2, 0.3}) {
      CAPTURE(friction);
      CAPTURE(deflection);
      const double straight = BowedBeam{0, friction}.force(deflection);
      const auto curve = sliding_up_to(deflection, friction, 400, Fibre());
      CHECK(straight == doctest::Approx(force_at(curve, deflection)).epsilon(1e-5));
      for (const double bow : {usual_bow, -usual_bow, 2 * usual_bow}) {
        CAPTURE(bow);
        const double by_bow = BowedBeam{bow, friction}.force(deflection) - straight;
        const double by_preload = BowedBeam{0, friction}.force(deflection + bow) - 48 * bow - straight;
        CHECK(std::abs(by_preload - by_bow) < 0.4 * std::abs(by_bow));
      }
    }
}

}  // namespace
}  // namespace flexslip
