// The model as one would write it with the elliptic functions of a library, at their best: the closed form in sn, cn, dn and E
// (docs/theory.md, "The state") without any further trigonometry, and the root u by Newton's iteration with its exact
// derivative, on (1 - 1/S)^(1/4), which is nearly linear in u. Ours starts from the same idea.
#pragma once

#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/reference.h"
#include "contact/friction.h"

namespace flexslip {

struct JacobiPoint {
  double sn, cn, dn;
  double E;  // E(am u | k^2)
};

struct RivalState {
  double w, F;
};

// `jacobi` is a library's: (u, k) -> JacobiPoint.
template <JacobiPoint (*jacobi)(double, double)>
RivalState rival_state(double S, double q) {
  const double beta0 = std::atan2(1.0, -q);
  const double k = std::sin(beta0 / 2);
  const double k1 = std::cos(beta0 / 2);

  struct HalfFibre {
    double a, z;   // half span and deflection, the half fibre's length being u
    double slope;  // da/du
    double sin_b;
  };
  const auto half_fibre = [k, k1](double u) -> HalfFibre {
    const auto [sn, cn, dn, E] = jacobi(u, k);
    const double cd = cn / dn;
    const double sd = sn / dn;
    const double sin_b = 2 * k * cd * k1 / dn;
    const double cos_b = 1 - 2 * k * cd * k * cd;
    const double C = 2 * E - u - 2 * k * k * sn * cd;
    const double D = 2 * k * k1 * sd;
    const double z = cos_b * D - sin_b * C;
    return {.a = cos_b * C + sin_b * D, .z = z, .slope = 1 - D * z, .sin_b = sin_b};
  };

  const double target = std::sqrt(std::sqrt(1 - 1 / S));
  double u = target * std::sqrt(std::sqrt(15 * (1 + q * q)));  // the limit of small deflection
  for (int iteration = 0; iteration < 20; ++iteration) {
    const HalfFibre half = half_fibre(u);
    const double gap = 1 - half.a / u;  // 1 - 1/S
    const double root = std::sqrt(std::sqrt(gap));
    const double step = 4 * root * root * root * (root - target) * u / (half.a / u - half.slope);
    u -= step;
    if (std::abs(step) < 1e-8 * u) break;  // quadratic convergence: the next would be below rounding
  }
  const HalfFibre half = half_fibre(u);
  return {.w = half.z / (2 * half.a), .F = 8 * half.a * half.a * half.sin_b};
}

struct RivalStates {
  std::vector<double> w, F;
};

template <JacobiPoint (*jacobi)(double, double)>
RivalStates rival_states(const Points& states) {
  RivalStates made;
  made.w.reserve(states.S.size());
  made.F.reserve(states.S.size());
  for (std::size_t i = 0; i < states.S.size(); ++i) {
    const auto [w, F] = rival_state<jacobi>(states.S[i], states.q[i]);
    made.w.push_back(w);
    made.F.push_back(F);
  }
  return made;
}

// A thousand states an iteration.
template <JacobiPoint (*jacobi)(double, double)>
void states_by(benchmark::State& run) {
  report_errors(run, rival_states<jacobi>(reference_states()));
  for (auto _ : run) benchmark::DoNotOptimize(rival_states<jacobi>(visited_states()));
  run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(visited_states().S.size()));
}

// The curve of equilibrium_curve(friction, Sliding::in, 1.5, 2000); the straight fibre, where the closed form is 0/0, is left out.
template <JacobiPoint (*jacobi)(double, double)>
void equilibrium_curve_by(benchmark::State& run) {
  const Friction friction = Friction::sinusoid(0.6, 0.4, 0.0628318530717959, 0);
  constexpr int n = 2000;
  for (auto _ : run) {
    Points curve;
    for (int i = 1; i < n; ++i) {
      const double part = static_cast<double>(i) / (n - 1);
      curve.S.push_back(1 + 0.5 * part * part);
      curve.q.push_back(friction.at(curve.S.back()).mu);
    }
    benchmark::DoNotOptimize(rival_states<jacobi>(curve));
  }
}

}  // namespace flexslip
