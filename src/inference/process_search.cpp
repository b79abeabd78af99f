#include "inference/process_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <Eigen/Core>

#include "inference/chain.h"
#include "inference/process_forward.h"
#include "numerics/dense.h"
#include "numerics/elementary.h"
#include "numerics/progress.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// The gain of evidence by a wave at many wavelengths, with its amplitude integrated out and all
// else as in a mode.
std::vector<ScannedWavelength> scan_of(const FrictionProcess& process, const Mode& mode) {
  const Observations observations = process.observations_of(mode);
  const Chain chain(observations, mode.kernel, hyperparameters_of(mode.theta));
  const std::size_t n = observations.all.size();
  const auto white = chain.whitened_columns();
  const auto p = white.rows() - 1;
  const double range = process.passages().range;
  const double least = 1 / process.max_wavelength(), most = 1 / process.min_wavelength();
  const double step = 1 / (process.options().scan_steps * range);
  const std::size_t count = most > least ? static_cast<std::size_t>((most - least) / step) + 1 : 0;
  // cos and sin of 2π f x for four f at once, then for the next four by rotation.
  constexpr std::size_t at_once = 4;
  std::vector<Chain::Eight> waves(n), whitened(n);
  std::vector<elementary::SineAndCosine> turn(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double x = 2 * std::numbers::pi * observations.all[k].place;
    turn[k] = elementary::sine_and_cosine(at_once * step * x);
    for (std::size_t l = 0; l < at_once; ++l) {
      const auto begin = elementary::sine_and_cosine((least + static_cast<double>(l) * step) * x);
      waves[k][l] = begin.cosine;
      waves[k][at_once + l] = begin.sine;
    }
  }
  std::vector<ScannedWavelength> scan;
  constexpr double prior = 1 / (FrictionProcess::wave_deviation * FrictionProcess::wave_deviation);
  for (std::size_t i = 0; i < count; i += at_once) {
    chain.whiten(waves, whitened);
    std::array<Chain::Eight, max_columns + 1> with{};  // the columns and y
    Chain::Eight squares{};
    std::array<double, at_once> products{};
    for (std::size_t k = 0; k < n; ++k) {
      const double* const series = white.col(static_cast<Index>(k)).data();
      const Chain::Eight& w = whitened[k];
      for (std::size_t c = 0; c <= static_cast<std::size_t>(p); ++c)
        for (std::size_t l = 0; l < 2 * at_once; ++l) with[c][l] += series[c] * w[l];
      for (std::size_t l = 0; l < 2 * at_once; ++l) squares[l] += w[l] * w[l];
      for (std::size_t l = 0; l < at_once; ++l) products[l] += w[l] * w[at_once + l];
    }
    for (std::size_t l = 0; l < at_once && i + l < count; ++l) {
      // Project out the columns of the mode: β ~ N(mean, covariance), and the remainder is
      // orthogonal to them.
      Coefficients c(p), s(p);
      for (Index j = 0; j < p; ++j) {
        c[j] = with[static_cast<std::size_t>(j)][l];
        s[j] = with[static_cast<std::size_t>(j)][at_once + l];
      }
      const Coefficients cc = chain.covariance() * c, cs = chain.covariance() * s;
      const double a = squares[l] - c.dot(cc) + prior, b = squares[at_once + l] - s.dot(cs) + prior;
      const double ab = products[l] - c.dot(cs);
      const auto last = static_cast<std::size_t>(p);
      const double y = with[last][l] - c.dot(chain.mean()), z = with[last][at_once + l] - s.dot(chain.mean());
      const double determinant = a * b - ab * ab;
      const double gain = 0.5 * (b * y * y - 2 * ab * y * z + a * z * z) / determinant -
                          0.5 * elementary::log(determinant / (prior * prior));
      scan.push_back({1 / (least + static_cast<double>(i + l) * step), gain});
    }
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < at_once; ++l) {
        const double cosine = waves[k][l], sine = waves[k][at_once + l];
        waves[k][l] = cosine * turn[k].cosine - sine * turn[k].sine;
        waves[k][at_once + l] = sine * turn[k].cosine + cosine * turn[k].sine;
      }
  }
  std::reverse(scan.begin(), scan.end());
  return scan;
}

std::vector<ScannedWavelength> peaks_of(const std::vector<ScannedWavelength>& scan, std::size_t most) {
  std::vector<ScannedWavelength> peaks;
  for (std::size_t i = 1; i + 1 < scan.size(); ++i)
    if (scan[i].gain >= scan[i - 1].gain && scan[i].gain > scan[i + 1].gain) peaks.push_back(scan[i]);
  std::stable_sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.gain > b.gain; });
  if (peaks.size() > most) peaks.resize(most);
  return peaks;
}

// Minus the second difference of the log_posterior in a hyperparameter, with a step at which it
// falls by one or more on average.
double curvature_of_fall(const FrictionProcess& process, const Mode& mode, Observations& observations,
                         std::size_t hyperparameter) {
  const auto at = [&](double step) {
    Theta theta = mode.theta;
    theta.values[hyperparameter] += step;
    return process.objective_alone(mode, observations, theta);
  };
  const double top = at(0);
  constexpr double first = 2e-4;
  const double last = process.options().last_fall;
  for (double step = first; step < last; step *= 2) {
    const double fall = top - 0.5 * (at(step) + at(-step));
    if (fall >= 1) return 2 * fall / (step * step);
  }
  return 2 / (last * last);
}

// ln p(readings, gaps), with θ integrated out by Laplace's approximation.
Component component_of(const FrictionProcess& process, const Mode& mode) {
  const auto& o = process.options();
  const auto n = static_cast<Index>(mode.theta.size());
  MatrixXd H = MatrixXd::Identity(n, n);
  Observations observations = process.observations_of(mode);
  const auto free = [&](Index i) { return !(mode.kernel == Kernel::none && (i == 2 || i == 3)); };
  for (Index i = 0; i < n; ++i) {
    if (!free(i)) continue;
    // In ln λ the log_posterior may have a flat or uneven top with steep sides; the width is where
    // it has fallen by about one.
    const double curvature = i < 4 || !o.parts.fall_curvature
                                 ? 0
                                 : curvature_of_fall(process, mode, observations, static_cast<std::size_t>(i));
    const double h = i < 4 ? o.difference_step : curvature == 0 ? 2e-4 : 1 / std::sqrt(curvature);
    Theta up = mode.theta, down = mode.theta;
    up.values[static_cast<std::size_t>(i)] += h;
    down.values[static_cast<std::size_t>(i)] -= h;
    const auto a = process.objective(mode, observations, up), b = process.objective(mode, observations, down);
    for (Index j = 0; j < n; ++j)
      if (free(j))
        H(i, j) = -(a.gradient[static_cast<std::size_t>(j)] - b.gradient[static_cast<std::size_t>(j)]) / (2 * h);
    H(i, i) = std::max(H(i, i), 0.5 * curvature);
  }
  H = (0.5 * (H + H.transpose())).eval();
  // In units of the individual deviations, because the deviations of ln λ are much smaller.
  constexpr double min_curvature = 0.3;  // the priors limit the logarithm of a hyperparameter to 1.8 or better
  const Eigen::VectorXd unit = H.diagonal().cwiseMax(min_curvature).cwiseSqrt().cwiseInverse();
  const auto [curvatures, vectors] = eigen_of(MatrixXd(unit.asDiagonal() * H * unit.asDiagonal()));
  const Eigen::VectorXd values = curvatures.cwiseMax(o.min_eigenvalue);
  double log_evidence = mode.log_posterior + process.prior_of_theta().log_scale(mode.kernel);
  for (Index i = 0; i < n; ++i) log_evidence += elementary::log(unit[i]) - 0.5 * elementary::log(values[i]);
  const auto dimensions = static_cast<double>(n - (mode.kernel == Kernel::none ? 2 : 0));
  log_evidence += 0.5 * dimensions * elementary::log(2 * std::numbers::pi);
  // Each ln λ has a uniform prior; the order of waves is arbitrary.
  for (std::size_t wave = 0; wave < mode.theta.waves; ++wave)
    log_evidence += elementary::log(static_cast<double>(wave + 1)) -
                    elementary::log(elementary::log(process.max_wavelength() / process.min_wavelength()));
  const MatrixXd root = unit.asDiagonal() * vectors * values.cwiseSqrt().cwiseInverse().asDiagonal();
  Component component{.mode = mode, .log_evidence = log_evidence, .spread = product(root, MatrixXd(root.transpose()))};
  for (std::size_t wave = 0; wave < mode.theta.waves; ++wave) {
    const auto at = static_cast<Index>(Theta::first_wave + wave);
    component.wavelength_deviation[wave] = std::sqrt(component.spread(at, at));
  }
  return component;
}

bool better(const Mode& a, const Mode& b) { return a.log_posterior > b.log_posterior; }

class Search {
 public:
  Search(const FrictionProcess& process, const Hypotheses& asked)
      : process_(process),
        asked_(asked),
        o_(process.options()),
        rises_(rises_of(process.passages())),
        run_(process.passages()) {}

  ProcessSearch run() {
    ProcessSearch result;
    Stages stages;
    stages.enter("friction without a wave", 0.08);
    Mode plain = without_wave(first_kernel());
    if (!std::isfinite(plain.log_posterior)) return result;
    result.scan = scan_of(process_, plain);
    const std::size_t asked = asked_.waves.value_or(1);
    stages.enter("friction with a wave", 0.48);
    std::optional<Mode> wave;
    for (std::size_t count = 1; count <= asked; ++count) {
      auto more =
          count == 1 ? with_one_more_wave(plain, result.scan) : with_one_more_wave(*wave, scan_of(process_, *wave));
      if (!more) break;
      wave = std::move(more);
    }
    const bool with_plain = !asked_.waves || !wave;
    stages.enter("friction without a wave", 0.12);
    if (o_.parts.polish_plain) process_.polish(plain, o_.plain);
    auto& components = result.components;
    if (wave) components.push_back(component_of(process_, *wave));
    if (with_plain) components.push_back(component_of(process_, plain));
    const double gain = with_plain ? components.front().log_evidence - components.back().log_evidence : claiming_gain;
    stages.enter("a second wave", 0.03);
    if (o_.parts.second_wave && !asked_.waves && gain > claiming_gain) add_second_wave(*wave, components);
    stages.enter("how rough friction is", 0.29);
    for (const Kernel kernel : asked_.kernels) {
      if (kernel == Kernel::none && plain.kernel != kernel && !o_.parts.no_kernel) continue;
      if (kernel == Kernel::exponential && !o_.parts.exponential_kernel) continue;
      if (kernel == Kernel::matern_9_2 && !o_.parts.smooth_kernel) continue;
      if (with_plain && kernel != plain.kernel)
        components.push_back(component_of(process_, without_wave(kernel, plain)));
      // A wave that is improbable with its kernel is not continued to the others.
      if (o_.parts.waves_of_kernels && wave && gain > o_.out_of_question && kernel != wave->kernel)
        components.push_back(component_of(process_, continued(*wave, kernel)));
    }
    const auto rank = [&] {
      std::stable_sort(components.begin(), components.end(),
                       [](const auto& a, const auto& b) { return a.log_evidence > b.log_evidence; });
    };
    rank();
    const double best = components.front().log_evidence;
    for (Component& component : components)
      if (o_.parts.converge && component.log_evidence > best - o_.far_below) converge(component);
    rank();
    move_along_valley(components);
    rank();
    if (o_.parts.plain_from_wave && with_plain) {
      add_without_waves(components);
      rank();
    }
    return result;
  }

 private:
  // A second wave, if it is detected, replaces the mode with one.
  void add_second_wave(Mode& wave, std::vector<Component>& components) const {
    auto two = with_one_more_wave(wave, scan_of(process_, wave));
    if (!two) return;
    const Component with_two = component_of(process_, *two);
    if (with_two.log_evidence < components.front().log_evidence + claiming_gain) return;
    components.front() = with_two;
    wave = std::move(*two);
  }

  // Search without waves near the best mode with waves, whose waves become roughness.
  void add_without_waves(std::vector<Component>& components) const {
    const Mode& with = components.front().mode;
    if (with.theta.waves == 0) return;
    for (const Kernel kernel : asked_.kernels) {
      if (kernel == Kernel::none) continue;
      const Component without = component_of(process_, waves_as_roughness(with, kernel));
      const auto alone = std::find_if(components.begin(), components.end(), [&](const Component& each) {
        return each.mode.theta.waves == 0 && each.mode.kernel == kernel;
      });
      if (alone != components.end() && without.log_evidence > alone->log_evidence) *alone = without;
    }
  }

  // Linearise until consistent with its own estimate of the rig.
  void converge(Component& component) const {
    Mode mode = component.mode;
    process_.burst(mode, o_.settle);
    if (!(mode.log_posterior > component.mode.log_posterior - o_.ran_away)) return;
    component.log_evidence += mode.log_posterior - component.mode.log_posterior;
    component.mode = std::move(mode);
  }

  // [rad] φ of each wave, R cos(2πx/λ − φ).
  std::array<double, max_waves> angles_of(const Mode& mode) const {
    const Observations observations = process_.observations_of(mode);
    const Coefficients beta = Chain(observations, mode.kernel, hyperparameters_of(mode.theta)).mean();
    std::array<double, max_waves> angles{};
    for (std::size_t wave = 0; wave < mode.theta.waves; ++wave) {
      const Index at = process_.columns().waves + 2 * static_cast<Index>(wave);
      angles[wave] = elementary::angle(beta[at + 1], beta[at]);
    }
    return angles;
  }

  // Waves of a mode stretched along the valley that they share with the errors of the rig.
  struct Stretched {
    double by;                             // [ln λ] of all waves
    Mode mode;                             // optimised for these lengths
    std::array<double, max_waves> turned;  // [rad] of each wave, on the way from the top
  };

  // The valley from its top in steps that double, down to one in the log posterior or to
  // `last_fall` in ln λ. A step whose optimisation runs away is halved.
  std::vector<Stretched> walk_valley(const Mode& top, double first) const {
    constexpr double too_short = 1.0 / 32;  // [first]
    std::vector<Stretched> steps{{.by = 0, .mode = top, .turned = {}}};
    for (double step = first;
         std::abs(steps.back().by) < o_.last_fall && std::abs(step) > too_short * std::abs(first);) {
      const Stretched& last = steps.back();
      if (last.mode.log_posterior <= top.log_posterior - 1) break;
      Stretched next{.by = last.by + step, .mode = last.mode, .turned = last.turned};
      stretch(next.mode, step);
      if (!(next.mode.log_posterior > top.log_posterior - o_.ran_away)) {
        step /= 2;
        continue;
      }
      step *= 2;
      const auto before = angles_of(last.mode), after = angles_of(next.mode);
      for (std::size_t wave = 0; wave < top.theta.waves; ++wave)
        next.turned[wave] += elementary::wrapped_angle(after[wave] - before[wave]);
      steps.push_back(std::move(next));
    }
    return steps;
  }

  void stretch(Mode& mode, double by) const {
    for (std::size_t wave = 0; wave < mode.theta.waves; ++wave) mode.theta.values[Theta::first_wave + wave] += by;
    process_.burst(mode, o_.settle);
  }

  // Move the most probable waves to the joint optimum of their lengths and the errors of the rig,
  // which stretch all waves alike. The resulting error of the lengths serves for all other modes
  // with as many waves. A parabola through the top and both ends of the valley gives mean and error.
  void move_along_valley(std::vector<Component>& components) const {
    Component& component = components.front();
    const std::size_t waves = component.mode.theta.waves;
    if (waves == 0) return;
    const auto begin = component.wavelength_deviation.begin(), end = begin + static_cast<std::ptrdiff_t>(waves);
    const double first = o_.valley_step * *std::min_element(begin, end), top = component.mode.log_posterior;
    const std::vector<Stretched> longer = walk_valley(component.mode, first),
                                 shorter = walk_valley(component.mode, -first);
    const double up = longer.back().by, down = -shorter.back().by;
    if (!(up > 0 && down > 0)) return;
    const double rise = (top - shorter.back().mode.log_posterior) / down,
                 fall = (top - longer.back().mode.log_posterior) / up;
    const double curvature = 2 * (rise + fall) / (up + down);
    if (!(curvature > 0)) return;
    std::array<double, max_waves> turn{};
    for (std::size_t wave = 0; wave < waves; ++wave)
      turn[wave] = (longer.back().turned[wave] - shorter.back().turned[wave]) / (up + down);
    for (Component& each : components) {
      if (each.mode.theta.waves != waves || !o_.parts.valley_width) continue;
      each.turn = turn;
      for (std::size_t wave = 0; wave < waves; ++wave)
        each.wavelength_deviation[wave] = std::max(each.wavelength_deviation[wave], 1 / std::sqrt(curvature));
    }
    if (!o_.parts.valley_move) return;
    const double goal = std::clamp((rise - 0.5 * curvature * down) / curvature, -down, up);
    const std::vector<Stretched>& way = goal > 0 ? longer : shorter;
    const Stretched& nearest = *std::min_element(way.begin(), way.end(), [&](const Stretched& a, const Stretched& b) {
      return std::abs(a.by - goal) < std::abs(b.by - goal);
    });
    Mode moved = nearest.mode;
    stretch(moved, goal - nearest.by);
    if (!(moved.log_posterior > top)) return;
    component.log_evidence += moved.log_posterior - top;
    component.mode = std::move(moved);
  }

  // matern_3_2 if available: it approximates rougher and smoother processes best.
  Kernel first_kernel() const {
    const auto& kernels = asked_.kernels;
    const bool asked = std::find(kernels.begin(), kernels.end(), Kernel::matern_3_2) != kernels.end();
    return asked ? Kernel::matern_3_2 : kernels.front();
  }

  // A settled mode, after a burst if that is much better.
  Mode settled(Mode mode, const Schedule& schedule) const {
    process_.settle(mode);
    Mode moved = mode;
    process_.burst(moved, 2 * schedule.steps, schedule.fraction);
    return moved.log_posterior > mode.log_posterior + o_.much_better ? moved : mode;
  }

  Mode without_wave(Kernel kernel) const {
    Mode mode = settled(process_.start(kernel, process_.prior_of_theta().usual(), rises_), o_.from_rises);
    process_.polish(mode, o_.from_rises);
    process_.burst(mode, o_.from_rises);
    return mode;
  }

  // Decrease the noise from a level that hides everything to the observed one; otherwise steps of
  // jerky friction diverge.
  Mode annealed(double eta) const {
    const ThetaPrior& prior = process_.prior_of_theta();
    Theta theta = prior.usual();
    theta.values[Theta::log_roughness] = elementary::log(o_.anneal_roughness);
    theta.values[Theta::log_length] = elementary::log(process_.passages().range * o_.anneal_length);
    Mode mode = process_.start(Kernel::exponential, theta, rises_);
    mode.at.eta = eta;
    complete(mode.at, process_.passages());
    const double first = prior.max[Theta::log_noise],
                 last = std::max(elementary::log(process_.passages().noise), prior.min[Theta::log_noise]);
    for (int step = 1; step <= o_.anneal.steps; ++step) {
      mode.theta.values[Theta::log_noise] = first + (last - first) * step / o_.anneal.steps;
      process_.burst(mode, 1, o_.anneal.fraction);
    }
    return mode;
  }

  // The best mode without a wave: continued from another kernel, or annealed from several bending
  // stiffnesses.
  Mode without_wave(Kernel kernel, const Mode& plain) const {
    Mode best = continued(plain, kernel);
    if (kernel != Kernel::exponential || !o_.parts.anneal) return best;
    const double error = process_.passages().stiffness_error;
    Mode cooled = annealed(0);
    for (const double eta : {-error, error})
      if (Mode mode = annealed(eta); better(mode, cooled)) cooled = std::move(mode);
    for (const bool polished : {false, true}) {
      if (polished) process_.polish(cooled, o_.annealed);
      if (better(cooled, best)) best = cooled;
    }
    return best;
  }

  // A mode whose waves become roughness.
  Mode waves_as_roughness(Mode mode, Kernel kernel) const {
    double squares = 0;
    const Observations observations = process_.observations_of(mode);
    const Coefficients beta = Chain(observations, mode.kernel, hyperparameters_of(mode.theta)).mean();
    for (Index j = process_.columns().waves; j < beta.size(); ++j) squares += 0.5 * beta[j] * beta[j];
    const double roughness = elementary::exp(mode.theta.values[Theta::log_roughness]);
    mode.theta.values[Theta::log_roughness] = 0.5 * elementary::log(squares + roughness * roughness);
    mode.theta.waves = 0;
    mode.kernel = kernel;
    process_.prior_of_theta().bound(mode.theta);
    process_.polish(mode, o_.annealed);
    return mode;
  }

  std::vector<double> candidates(const Mode& plain, Mode raw, const std::vector<ScannedWavelength>& scan) const {
    std::vector<double> found;
    const auto add = [&](const std::vector<ScannedWavelength>& in) {
      for (const auto& peak : peaks_of(in, static_cast<std::size_t>(o_.scan_peaks))) {
        if (!is_resolved(peak.wavelength, plain.theta, plain.theta.waves)) continue;
        const bool known = std::any_of(found.begin(), found.end(), [&](double other) {
          return std::abs(elementary::log(peak.wavelength / other)) <
                 o_.peak_apart * peak.wavelength / process_.passages().range;
        });
        if (!known) found.push_back(peak.wavelength);
      }
    };
    add(scan);
    if (!is_blurred(plain)) return found;
    raw.theta.values[Theta::log_length] = elementary::log(process_.passages().range / o_.scan_length);
    if (o_.parts.raw_scan) add(scan_of(process_, raw));
    return found;
  }

  // True if the observed length resolves a wavelength from the existing ones: they differ by at
  // least a period over it.
  bool is_resolved(double wavelength, const Theta& theta, std::size_t waves) const {
    for (std::size_t wave = 0; wave < waves; ++wave)
      if (std::abs(1 / wavelength - elementary::exp(-theta.log_wavelength(wave))) * process_.passages().range < 1)
        return false;
    return true;
  }

  // A quick mode with one wave more than `theta`.
  Mode tried(const Mode& from, Theta theta, double log_wavelength) const {
    theta.values[Theta::log_roughness] = elementary::log(o_.smooth_roughness);
    theta.values[Theta::log_length] = elementary::log(process_.passages().range / o_.trial_length);
    theta.add_wave(log_wavelength);
    Mode mode = process_.start(from.kernel, theta, from.at);
    mode.sites = from.sites;
    mode = settled(std::move(mode), o_.trial);
    process_.polish(mode, o_.trial);
    return mode;
  }

  std::optional<Mode> with_one_more_wave(const Mode& plain, const std::vector<ScannedWavelength>& scan) const {
    const Theta usual =
        process_.prior_of_theta().usual(std::span(plain.theta.values).subspan(Theta::first_wave, plain.theta.waves));
    const Mode raw = process_.start(plain.kernel, usual, rises_);
    const std::size_t last = plain.theta.waves;  // the new wave
    std::vector<std::pair<Mode, double>> found;  // and the starting wavelength
    const auto rank = [&] {
      std::stable_sort(found.begin(), found.end(),
                       [](const auto& a, const auto& b) { return better(a.first, b.first); });
    };
    const auto try_from = [&](const Mode& from, double wavelength) {
      found.emplace_back(tried(from, from.theta, elementary::log(wavelength)), wavelength);
      return found.back().first.log_posterior;
    };
    const std::vector<double> wavelengths = candidates(plain, raw, scan);
    double best = -infinity;
    for (const double wavelength : wavelengths) best = std::max(best, try_from(plain, wavelength));
    // If noise blurs the order of the readings, also start from the rises: the first peak, or all
    // peaks if a wave gains.
    const bool blurred = is_blurred(plain);
    for (std::size_t i = 0; o_.parts.trials_from_rises && blurred && i < wavelengths.size(); ++i)
      if (i == 0 || best > plain.log_posterior) best = std::max(best, try_from(raw, wavelengths[i]));
    rank();
    // Also start the two best from their simulated loadings, unless none reaches the mode without a
    // wave.
    const bool promising = !found.empty() && better(found.front().first, plain);
    const std::size_t trials = o_.parts.trials_forward && blurred && promising ? found.size() : 0;
    std::vector<double> done;
    for (std::size_t i = 0; i < trials && done.size() < 2; ++i) {
      const double wavelength = found[i].second;
      if (std::find(done.begin(), done.end(), wavelength) != done.end()) continue;
      done.push_back(wavelength);
      Mode mode = fitted_forward(process_, run_, found[i].first);
      process_.settle(mode);
      process_.burst(mode, o_.trial_forward);
      process_.polish(mode, o_.trial_forward);
      found.emplace_back(std::move(mode), wavelength);
    }
    rank();
    for (const auto& [trial, wavelength] : found) {
      if (!std::isfinite(trial.log_posterior)) break;
      Mode mode = trial;
      process_.polish(mode, o_.wave);
      if (trial.log_posterior > mode.log_posterior) mode = trial;
      if (is_resolved(elementary::exp(mode.theta.log_wavelength(last)), mode.theta, last)) return mode;
    }
    return std::nullopt;
  }

  // True if the noise of places reaches the resolution of waves.
  bool is_blurred(const Mode& mode) const {
    std::vector<double> blur;
    const double noise = elementary::exp(mode.theta.values[Theta::log_noise]);
    for (const double by_force : mode.at.S_force)
      blur.push_back(process_.passages().share * std::abs(by_force) * noise);
    return median_of(std::move(blur)) > process_.passages().range / o_.blur;
  }

  Mode continued(const Mode& mode, Kernel kernel) const {
    if (kernel == mode.kernel) return mode;
    Mode other = mode;
    other.kernel = kernel;
    process_.polish(other, o_.follow);
    // Without roughness, nothing compensates for a wave that is too small.
    if (o_.parts.smooth_forward && kernel == Kernel::none && mode.theta.waves > 0) {
      Mode forward = fitted_forward(process_, run_, other);
      process_.burst(forward, o_.smooth_forward);
      process_.polish(forward, o_.smooth_forward);
      if (forward.log_posterior > other.log_posterior) other = std::move(forward);
    }
    return other;
  }

  const FrictionProcess& process_;
  const Hypotheses& asked_;
  const SearchOptions& o_;
  Linearisation rises_;
  ForwardRun run_;
};

}  // namespace

ProcessSearch search(const FrictionProcess& process, const Hypotheses& asked) { return Search(process, asked).run(); }

}  // namespace flexslip
