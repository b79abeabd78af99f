#include "inference/process_forward.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "bending_test/sliding_table.h"
#include "fibre/state_table.h"
#include "inference/chain.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

using Eigen::Index;

Mode linearised_at(const FrictionProcess& process, const Mode& mode, ForwardStates states, double eta) {
  Mode other = mode;
  other.at.eta = eta;
  other.at.S = std::move(states.S);
  other.at.mu = std::move(states.mu);
  other.at.slope = std::move(states.slope);
  other.at.found.clear();
  complete(other.at, process.passages());
  other.sites.clear();
  return other;
}

}  // namespace

ForwardRun::ForwardRun(const Passages& passages) : passages_(passages) {
  const auto [least, greatest] = std::minmax_element(passages.S.begin(), passages.S.end());
  const double seen = *greatest - *least;
  const double from = std::max(*least - 0.05 * seen, 1.0005), to = std::min(*greatest + 0.1 * seen, 2.05);
  constexpr std::size_t count = 800;
  // Evenly spaced along the specimen.
  const double begin = passages.along.at(from), end = passages.along.at(to);
  for (std::size_t i = 0; i < count; ++i)
    S_.push_back(passages.along.sliding_length_at(begin + (end - begin) * static_cast<double>(i) /
                                                              static_cast<double>(count - 1)));
}

ForwardStates ForwardRun::states(std::span<const double> mu, double eta, std::span<const double> stages) const {
  std::vector<double> q(mu.begin(), mu.end());
  for (double& value : q) value = std::clamp(value, 0.0, 2.0);
  const auto curve = passages_.fibre.tabulated_states({S_, q});
  const double stiffer = elementary::exp(eta);
  const std::size_t n = S_.size();
  const auto stage = [&](std::size_t i) { return curve.w[i] + stiffer * curve.F[i] * passages_.compliance; };
  ForwardStates states;
  std::size_t i = 0;
  double G = stage(0), G_next = stage(1);
  for (const double W : stages) {
    while (i + 2 < n && G_next < W) {
      ++i;
      G = G_next;
      G_next = stage(i + 1);
    }
    // On the rise from i to i + 1: the stage has passed all previous maxima.
    const double part = G_next > G ? std::clamp((W - G) / (G_next - G), 0.0, 1.0) : 1.0;
    states.S.push_back(S_[i] + part * (S_[i + 1] - S_[i]));
    states.mu.push_back(q[i] + part * (q[i + 1] - q[i]));
    states.slope.push_back((q[i + 1] - q[i]) / (S_[i + 1] - S_[i]));
    states.force.push_back(stiffer * (curve.F[i] + part * (curve.F[i + 1] - curve.F[i])));
  }
  return states;
}

Mode fitted_forward(const FrictionProcess& process, const ForwardRun& run, const Mode& mode) {
  const Passages& passages = process.passages();
  const Observations observations = process.observations_of(mode);
  const Chain chain(observations, mode.kernel, hyperparameters_of(mode.theta));
  const Coefficients& beta = chain.mean();
  const auto& columns = process.columns();
  const std::size_t waves = mode.theta.waves;
  // mean, drift, η, ln λ of the last wave, then cosine and sine of each.
  struct Guess {
    double mean, drift, eta, log_wavelength;
    std::array<double, 2 * max_waves> wave;
  };
  Guess start{.mean = FrictionProcess::mean_friction + beta[columns.mean],
              .drift = beta[columns.drift],
              .eta = columns.stiffness >= 0 ? beta[columns.stiffness] : 0,
              .log_wavelength = mode.theta.log_wavelength(waves - 1),
              .wave = {}};
  start.eta = std::clamp(start.eta, -0.09, 0.09);
  for (std::size_t i = 0; i < 2 * waves; ++i) start.wave[i] = beta[columns.waves + static_cast<Index>(i)];
  const auto path = [&](const Guess& f) {
    std::vector<double> mu;
    mu.reserve(run.lengths().size());
    std::array<double, max_waves> rate{};
    for (std::size_t wave = 0; wave < waves; ++wave)
      rate[wave] = 2 * std::numbers::pi *
                   elementary::exp(-(wave + 1 == waves ? f.log_wavelength : mode.theta.log_wavelength(wave)));
    // cos and sin of evenly spaced places, by rotation
    const double first = passages.place(run.lengths()[0]), step = passages.place(run.lengths()[1]) - first;
    std::array<elementary::SineAndCosine, max_waves> now{}, turn{};
    for (std::size_t wave = 0; wave < waves; ++wave) {
      now[wave] = elementary::sine_and_cosine(rate[wave] * first);
      turn[wave] = elementary::sine_and_cosine(rate[wave] * step);
    }
    for (std::size_t i = 0; i < run.lengths().size(); ++i) {
      const double x = first + step * static_cast<double>(i);
      double value = f.mean + f.drift * std::clamp(x / passages.range, -0.6, 0.6);
      for (std::size_t wave = 0; wave < waves; ++wave) {
        auto& at = now[wave];
        value += f.wave[2 * wave] * at.cosine + f.wave[2 * wave + 1] * at.sine;
        at = {at.sine * turn[wave].cosine + at.cosine * turn[wave].sine,
              at.cosine * turn[wave].cosine - at.sine * turn[wave].sine};
      }
      mu.push_back(value);
    }
    return mu;
  };
  const double scale =
      passages.options.forward_noise * std::max(elementary::exp(mode.theta.values[Theta::log_noise]), 0.005);
  // Quadratic for small residuals, linear for readings on another tooth.
  const auto misfit = [&](const Guess& f) {
    const auto states = run.states(path(f), f.eta, mode.at.stage);
    double sum = 0;
    for (std::size_t i = 0; i < passages.size(); ++i) {
      const double r = (states.force[i] - mode.at.force[i]) / scale;
      sum += std::sqrt(1 + r * r) - 1;
    }
    const double stiffness = f.eta / std::max(passages.stiffness_error, 1e-3);
    return sum + 0.5 * stiffness * stiffness + 0.5 * f.drift * f.drift / 0.04;
  };
  const auto levelled = [&](Guess f) {
    for (int round = 0; round < 2; ++round) {
      const auto states = run.states(path(f), f.eta, mode.at.stage);
      double sum = 0;
      for (std::size_t i = 0; i < passages.size(); ++i) sum += passages.q[i] - states.mu[i];
      f.mean += std::clamp(sum / static_cast<double>(passages.size()), -0.3, 0.3);
    }
    return f;
  };
  Guess best = start;
  double least = infinity;
  for (const double larger : {1.0, 1.5, 2.2})
    for (const double turned : {0.0, 0.9, -0.9}) {
      Guess f = start;
      const auto turn = elementary::sine_and_cosine(turned);
      double &a = f.wave[2 * waves - 2], &b = f.wave[2 * waves - 1];
      const double cosine = larger * (a * turn.cosine - b * turn.sine),
                   sine = larger * (a * turn.sine + b * turn.cosine);
      const double size = elementary::length(cosine, sine);
      const double within = size > 0.35 ? 0.35 / size : 1;
      a = cosine * within;
      b = sine * within;
      f = levelled(f);
      if (const double value = misfit(f); value < least) {
        least = value;
        best = f;
      }
    }
  // Steps along each parameter, shorter if none improves.
  std::array<double, 6> step{0.04, 0.04, 0.01, 0.1 * elementary::exp(start.log_wavelength) / passages.range,
                             0.03, 0.03};
  for (int round = 0; round < 10; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i < step.size(); ++i) {
      if (i == 2 && columns.stiffness < 0) continue;  // EI is exact
      for (const double sign : {1.0, -1.0}) {
        Guess f = best;
        double* const number = i == 0   ? &f.mean
                               : i == 1 ? &f.drift
                               : i == 2 ? &f.eta
                               : i == 3 ? &f.log_wavelength
                                        : &f.wave[2 * waves - 2 + (i - 4)];
        *number += sign * step[i];
        if (const double value = misfit(f); value < least) {
          least = value;
          best = f;
          moved = true;
          break;
        }
      }
    }
    if (!moved)
      for (double& length : step) length *= 0.4;
  }
  Mode other = mode;
  other.theta.values[Theta::first_wave + waves - 1] = best.log_wavelength;
  return linearised_at(process, other, run.states(path(best), best.eta, mode.at.stage), best.eta);
}

std::vector<double> forces_of(const FrictionTable& friction, const Rig& rig, std::span<const double> stages) {
  const double seen = friction.S.back() - friction.S.front();
  const double S_max = std::min(friction.S.back() + std::max(0.1 * seen, 0.01), longest_ladder);
  // Fine enough for the observed length, unless nearly all sliding happened before the first
  // reading.
  constexpr double min_share = 1e-4;
  const double step = std::max(seen / 1000, min_share * (S_max - rig.fibre.least_length()));
  const SlidingLadder ladder(S_max, step, rig.fibre);
  const auto mu = Friction::table(friction).at(ladder.lengths()).mu;
  const auto curve = ladder.curve(mu);
  return measured_curve(curve.w, curve.F, 1 / rig.stiffness, stages);
}

}  // namespace flexslip
