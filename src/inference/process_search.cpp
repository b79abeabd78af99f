#include "inference/process_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <Eigen/Dense>

#include "data/order.h"
#include "fibre/elementary.h"
#include "inference/process_forward.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double near_best = 12;  // of the merit: modes farther below weigh nothing

// The gain of a wave at many wavelengths, its amplitude integrated out, everything else as in a mode.
std::vector<ScannedWavelength> scan_of(const FrictionProcess& process, const Mode& mode) {
  const Looks looks = process.looks_of(mode);
  const Chain chain(looks, mode.kernel, hyperparameters_of(mode.theta));
  const std::size_t n = looks.looks.size();
  const auto& white = chain.whitened_columns();
  const auto p = white.rows() - 1;
  const double range = process.passages().range;
  const double least = 1 / process.greatest_wavelength(), most = 1 / process.least_wavelength(), step = 1 / (8 * range);
  const std::size_t count = most > least ? static_cast<std::size_t>((most - least) / step) + 1 : 0;
  // cos and sin of 2π f x for rising f, by turning.
  std::vector<double> cosine(n), sine(n), turn_cosine(n), turn_sine(n), white_cosine(n), white_sine(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double x = 2 * std::numbers::pi * looks.looks[k].place;
    const auto begin = elementary::sine_and_cosine(least * x), turn = elementary::sine_and_cosine(step * x);
    cosine[k] = begin.cosine;
    sine[k] = begin.sine;
    turn_cosine[k] = turn.cosine;
    turn_sine[k] = turn.sine;
  }
  const auto vector = [n](std::vector<double>& v) {
    return Eigen::Map<Eigen::VectorXd>(v.data(), static_cast<Index>(n));
  };
  std::vector<ScannedWavelength> scan;
  constexpr double prior = 1 / (FrictionProcess::wave_deviation * FrictionProcess::wave_deviation);
  for (std::size_t i = 0; i < count; ++i) {
    chain.whiten(cosine, white_cosine);
    chain.whiten(sine, white_sine);
    // The columns of the mode take their part: with them β ~ N(mean, covariance) and the rest is orthogonal.
    const Eigen::VectorXd with_cosine = white * vector(white_cosine), with_sine = white * vector(white_sine);
    const Coefficients c = with_cosine.tail(p), s = with_sine.tail(p);
    const Coefficients cc = chain.covariance() * c, cs = chain.covariance() * s;
    const double a = vector(white_cosine).squaredNorm() - c.dot(cc) + prior;
    const double b = vector(white_sine).squaredNorm() - s.dot(cs) + prior;
    const double ab = vector(white_cosine).dot(vector(white_sine)) - c.dot(cs);
    const double y = with_cosine[0] - c.dot(chain.mean()), z = with_sine[0] - s.dot(chain.mean());
    const double determinant = a * b - ab * ab;
    const double gain = 0.5 * (b * y * y - 2 * ab * y * z + a * z * z) / determinant -
                        0.5 * elementary::log(determinant / (prior * prior));
    scan.push_back({1 / (least + static_cast<double>(i) * step), gain});
    for (std::size_t k = 0; k < n; ++k) {
      const double next = cosine[k] * turn_cosine[k] - sine[k] * turn_sine[k];
      sine[k] = sine[k] * turn_cosine[k] + cosine[k] * turn_sine[k];
      cosine[k] = next;
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

// Minus the second difference of the merit in a hyperparameter, over the step at which it falls by one or more on the average of both sides.
double curvature_of_fall(const FrictionProcess& process, const Mode& mode, Looks& looks, std::size_t hyperparameter) {
  const auto at = [&](double step) {
    Theta theta = mode.theta;
    theta.values[hyperparameter] += step;
    return process.objective(mode, looks, theta).value;
  };
  const double top = at(0);
  constexpr double first = 2e-4, last = 0.1;
  for (double step = first; step < last; step *= 2) {
    const double fall = top - 0.5 * (at(step) + at(-step));
    if (fall >= 1) return 2 * fall / (step * step);
  }
  return 2 / (last * last);
}

// ln p(readings, gaps), θ integrated out by the curvature of the merit at the mode.
Component component_of(const FrictionProcess& process, const Mode& mode) {
  const auto n = static_cast<Index>(mode.theta.size());
  MatrixXd H = MatrixXd::Identity(n, n);
  Looks looks = process.looks_of(mode);
  const auto free = [&](Index i) { return !(mode.kernel == Kernel::none && (i == 2 || i == 3)); };
  for (Index i = 0; i < n; ++i) {
    if (!free(i)) continue;
    const double h = i < 4 ? 0.02 : 2e-4;
    Theta up = mode.theta, down = mode.theta;
    up.values[static_cast<std::size_t>(i)] += h;
    down.values[static_cast<std::size_t>(i)] -= h;
    const auto a = process.objective(mode, looks, up), b = process.objective(mode, looks, down);
    for (Index j = 0; j < n; ++j)
      if (free(j))
        H(i, j) = -(a.gradient[static_cast<std::size_t>(j)] - b.gradient[static_cast<std::size_t>(j)]) / (2 * h);
  }
  H = (0.5 * (H + H.transpose())).eval();
  // The merit may be flat at its top in ln λ, or dented, and steep beside it: then the curvature is that of where it has fallen by one.
  for (Index i = 4; i < n; ++i) {
    const double curvature = curvature_of_fall(process, mode, looks, static_cast<std::size_t>(i));
    if (H(i, i) > 0.5 * curvature) continue;
    H.row(i).setZero();
    H.col(i).setZero();
    H(i, i) = curvature;
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(H);
  constexpr double least_curvature = 0.3;  // a standard deviation of at most 1.8 in the logarithm of a hyperparameter
  const Eigen::VectorXd values = eigen.eigenvalues().cwiseMax(least_curvature);
  double log_evidence = mode.merit + process.prior_of_theta().log_scale(mode.kernel);
  for (Index i = 0; i < n; ++i) log_evidence -= 0.5 * elementary::log(values[i]);
  const auto dimensions = static_cast<double>(n - (mode.kernel == Kernel::none ? 2 : 0));
  log_evidence += 0.5 * dimensions * elementary::log(2 * std::numbers::pi);
  // Of waves, each ln λ is uniform, and which is called the first says nothing.
  for (std::size_t wave = 0; wave < mode.theta.waves; ++wave)
    log_evidence += elementary::log(static_cast<double>(wave + 1)) -
                    elementary::log(elementary::log(process.greatest_wavelength() / process.least_wavelength()));
  return {.mode = mode,
          .log_evidence = log_evidence,
          .spread = eigen.eigenvectors() * values.cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose()};
}

bool better(const Mode& a, const Mode& b) { return a.merit > b.merit; }

class Search {
 public:
  Search(const FrictionProcess& process, const SearchOptions& options)
      : process_(process), options_(options), rises_(rises_of(process.passages())), run_(process.passages()) {}

  ProcessSearch run() {
    ProcessSearch result;
    Mode plain = without_wave(first_kernel());
    if (!std::isfinite(plain.merit)) return result;
    result.scan = scan_of(process_, plain);
    const std::size_t asked = options_.waves.value_or(1);
    std::vector<Mode> waves;
    for (std::size_t count = 1; count <= asked; ++count) {
      auto more = count == 1 ? with_one_more_wave(plain, result.scan)
                             : with_one_more_wave(waves.front(), scan_of(process_, waves.front()));
      if (more.empty()) break;
      waves = std::move(more);
    }
    const bool with_plain = !options_.waves || waves.empty();
    if (with_plain && !waves.empty()) improve(plain, waves.front());
    mend(plain);
    process_.polish(plain, 6, 10, 0.3);
    auto& components = result.components;
    for (const Mode& wave : waves) components.push_back(component_of(process_, wave));
    if (with_plain) components.push_back(component_of(process_, plain));
    const double gain = with_plain ? components.front().log_evidence - components.back().log_evidence : claiming_gain;
    if (!options_.waves && !waves.empty() && gain > claiming_gain) add_second_wave(waves, components);
    const std::size_t with_first = components.size();
    // Where a wave is out of the question with its kernel, it is not asked for with the others; nor are waves far below the best.
    constexpr double out_of_question = -2, far_below = 3;
    for (const Kernel kernel : options_.kernels) {
      if (with_plain && kernel != plain.kernel) components.push_back(component_of(process_, continued(plain, kernel)));
      for (const Mode& wave : waves)
        if (gain > out_of_question && kernel != wave.kernel && wave.merit > waves.front().merit - far_below)
          components.push_back(component_of(process_, continued(wave, kernel)));
    }
    double best = components.front().log_evidence;
    for (const auto& component : components) best = std::max(best, component.log_evidence);
    for (std::size_t i = with_first; i < components.size(); ++i) {
      Mode mode = components[i].mode;
      if (mode.theta.waves > 0 || components[i].log_evidence < best - far_below) continue;
      mend(mode);
      components[i] = component_of(process_, mode);
    }
    std::stable_sort(result.components.begin(), result.components.end(),
                     [](const auto& a, const auto& b) { return a.log_evidence > b.log_evidence; });
    return result;
  }

 private:
  // Modes with two waves, where the second is claimed as well: they take the place of those with one.
  void add_second_wave(std::vector<Mode>& waves, std::vector<Component>& components) const {
    const auto two = with_one_more_wave(waves.front(), scan_of(process_, waves.front()));
    if (two.empty()) return;
    const Component best = component_of(process_, two.front());
    if (best.log_evidence < components.front().log_evidence + claiming_gain) return;
    std::erase_if(components, [](const Component& component) { return component.mode.theta.waves == 1; });
    components.insert(components.begin(), best);
    for (std::size_t i = 1; i < two.size(); ++i) components.push_back(component_of(process_, two[i]));
    waves = two;
  }

  Kernel first_kernel() const {
    for (const Kernel kernel : options_.kernels)
      if (kernel == Kernel::matern_3_2) return kernel;
    return options_.kernels.front();
  }

  // The mode from readings past a fold moved back, and from where its own mean runs: kept where that is better.
  void mend(Mode& mode) const {
    if (!std::isfinite(mode.merit)) return;
    // Where noise blurs the places of readings, a polish makes up for more.
    const double hopeless = mode.theta.waves > 0 && is_blurred(mode) ? 3 : 0;
    const auto better_from = [&](Mode other) {
      process_.burst(other, 8, 0.3);
      if (other.merit < mode.merit - hopeless) return false;
      process_.polish(other, 2, 6, 0.2);
      if (!(other.merit > mode.merit + 0.1)) return false;
      mode = std::move(other);
      return true;
    };
    for (int attempt = 0; attempt < 2; ++attempt) {
      const bool past_folds = is_past_a_fold(mode);
      if (!(past_folds && better_from(projected(process_, run_, mode))) &&
          !better_from(run_forward(process_, run_, mode)))
        return;
    }
  }

  // A mode settled, and moved by a burst where that is much better.
  Mode settled(Mode mode, int rounds) const {
    process_.settle(mode);
    Mode moved = mode;
    process_.burst(moved, rounds, 0.3);
    return moved.merit > mode.merit + 5 ? moved : mode;
  }

  Mode without_wave(Kernel kernel) const {
    Mode mode = settled(process_.start(kernel, process_.prior_of_theta().usual(), rises_), 8);
    process_.polish(mode, 3, 4, 0.3);
    process_.burst(mode, 4, 0.3);
    return mode;
  }

  std::vector<double> candidates(const Mode& plain, Mode raw, const std::vector<ScannedWavelength>& scan) const {
    std::vector<double> found;
    const auto add = [&](const std::vector<ScannedWavelength>& in) {
      for (const auto& peak : peaks_of(in, 2)) {
        const bool known = std::any_of(found.begin(), found.end(), [&](double other) {
          return std::abs(elementary::log(peak.wavelength / other)) < 0.5 * peak.wavelength / process_.passages().range;
        });
        if (!known) found.push_back(peak.wavelength);
      }
    };
    add(scan);
    Mode smooth = plain;
    const double range = process_.passages().range;
    smooth.theta.values[2] = elementary::log(0.03);
    smooth.theta.values[3] = elementary::log(range / 5);
    add(scan_of(process_, smooth));
    raw.theta.values[3] = elementary::log(range / 5);
    add(scan_of(process_, raw));
    return found;
  }

  // A mode with one more wave than `theta` has, quickly.
  Mode tried(const Mode& from, Theta theta, double log_wavelength) const {
    theta.values[2] = elementary::log(0.03);
    theta.values[3] = elementary::log(process_.passages().range / 10);
    theta.values[4 + theta.waves++] = log_wavelength;
    Mode mode = process_.start(from.kernel, theta, from.at);
    mode.sites = from.sites;
    mode = settled(std::move(mode), 12);
    process_.polish(mode, 1, 4, 0.3);
    return mode;
  }

  std::vector<Mode> with_one_more_wave(const Mode& plain, const std::vector<ScannedWavelength>& scan) const {
    const double range = process_.passages().range;
    const Theta usual = process_.prior_of_theta().usual(std::span(plain.theta.values).subspan(4, plain.theta.waves));
    const Mode raw = process_.start(plain.kernel, usual, rises_);
    const std::size_t last = plain.theta.waves;  // the wave that is sought
    std::vector<std::pair<Mode, double>> found;  // and the wavelength that it started from
    // Where noise blurs the places of readings, their order along the fibre is in doubt, and with it where to begin.
    const bool blurred = is_blurred(plain);
    for (const double wavelength : candidates(plain, raw, scan)) {
      const double log_wavelength = elementary::log(wavelength);
      found.emplace_back(tried(plain, plain.theta, log_wavelength), wavelength);
      if (blurred) found.emplace_back(tried(raw, raw.theta, log_wavelength), wavelength);
    }
    const auto rank = [&] {
      std::stable_sort(found.begin(), found.end(),
                       [](const auto& a, const auto& b) { return better(a.first, b.first); });
    };
    rank();
    const auto for_the_best_two = [&](auto&& add_to) {
      std::vector<double> done;
      const std::size_t so_far = blurred ? found.size() : 0;
      for (std::size_t i = 0; i < so_far && done.size() < 2; ++i) {
        const double wavelength = found[i].second;
        if (found[i].first.merit < found.front().first.merit - 40 ||
            std::find(done.begin(), done.end(), wavelength) != done.end())
          continue;
        done.push_back(wavelength);
        add_to(i, wavelength);
      }
      rank();
    };
    // From beside their wavelength: on soft rigs neighbouring peaks hide each other.
    for_the_best_two([&](std::size_t, double wavelength) {
      for (const double beside : {0.25, -0.25})
        found.emplace_back(tried(raw, raw.theta, elementary::log(wavelength * (1 + beside * wavelength / range))),
                           wavelength);
    });
    for_the_best_two([&](std::size_t i, double wavelength) {
      Mode mode = fitted_forward(process_, run_, found[i].first);
      process_.settle(mode);
      process_.burst(mode, 4, 0.3);
      process_.polish(mode, 1, 4, 0.3);
      found.emplace_back(std::move(mode), wavelength);
    });
    std::vector<Mode> polished;
    for (auto& each : found) {
      Mode& mode = each.first;
      // Where the best gains nothing, no other does.
      const bool gains = polished.empty() || polished.front().merit > plain.merit;
      if (polished.size() == 3 || !gains || mode.merit < found.front().first.merit - near_best) break;
      const bool known = std::any_of(polished.begin(), polished.end(), [&](const Mode& other) {
        return std::abs(mode.theta.log_wavelength(last) - other.theta.log_wavelength(last)) < 0.003 &&
               mode.merit < other.merit + 0.5;
      });
      if (known) continue;
      if (!std::isfinite(mode.merit)) break;
      const Mode before = mode;
      process_.polish(mode, polished.empty() ? 4 : 2, 8, 0.2);
      if (before.merit > mode.merit) mode = before;
      mend(mode);
      polished.push_back(mode);
    }
    std::stable_sort(polished.begin(), polished.end(), better);
    std::vector<Mode> different;
    for (auto& mode : polished)
      if (std::none_of(different.begin(), different.end(), [&](const Mode& other) {
            return std::abs(mode.theta.log_wavelength(last) - other.theta.log_wavelength(last)) < 0.002;
          }))
        different.push_back(std::move(mode));
    return different;
  }

  // Whether noise moves the place of a reading by as much as tells waves apart.
  bool is_blurred(const Mode& mode) const {
    std::vector<double> blur;
    const double noise = elementary::exp(mode.theta.values[0]);
    for (const double by_force : mode.at.S_force) blur.push_back(0.5 * std::abs(by_force) * noise);
    return median_of(std::move(blur)) > process_.passages().range / 1000;
  }

  // The mode without a wave also from where the best with one ended.
  void improve(Mode& plain, const Mode& wave) const {
    Mode other = process_.start(plain.kernel, plain.theta, wave.at);
    other.sites = wave.sites;
    process_.polish(other, 2, 6, 0.3);
    if (other.merit > plain.merit + 0.1) plain = std::move(other);
  }

  Mode continued(const Mode& mode, Kernel kernel) const {
    if (kernel == mode.kernel) return mode;
    Mode other = mode;
    other.kernel = kernel;
    process_.polish(other, 2, 6, 0.3);
    if (kernel == Kernel::none &&
        mode.theta.waves > 0) {  // smooth friction has no roughness to make up for a wave too small
      Mode forward = fitted_forward(process_, run_, other);
      process_.burst(forward, 4, 0.3);
      process_.polish(forward, 3, 6, 0.3);
      if (forward.merit > other.merit) other = std::move(forward);
    }
    return other;
  }

  const FrictionProcess& process_;
  const SearchOptions& options_;
  Linearisation rises_;
  ForwardRun run_;
};

}  // namespace

ProcessSearch search(const FrictionProcess& process, const SearchOptions& options) {
  return Search(process, options).run();
}

}  // namespace flexslip
