#include "inference/fit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include <Eigen/Dense>

#include "inference/sliding_map.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

// The parameters of a model as one vector: mean, [slope], then cosine, sine and wavelength of each wave, then the relative
// change of the bending stiffness.
struct Layout {
  bool drift;
  Index waves;
  Index wave(Index i) const { return (drift ? 2 : 1) + 3 * i; }
  Index stiffness() const { return wave(waves); }
  Index size() const { return stiffness() + 1; }
};

// Residuals r_i - ρ r_{i-1}, of unit weight: an AR(1) process made white.
template <class Matrix>
Matrix whitened(const Matrix& residuals, double rho) {
  Matrix result = residuals;
  const auto n = residuals.rows();
  result.bottomRows(n - 1) = residuals.bottomRows(n - 1) - rho * residuals.topRows(n - 1);
  result.row(0) = std::sqrt(1 - rho * rho) * residuals.row(0);
  return result;
}

struct Noise {
  double rho;       // correlation of neighbouring residuals
  double variance;  // of the innovations
};

Noise noise_of(const VectorXd& residuals, Index parameters) {
  const auto n = residuals.size();
  double rho = residuals.head(n - 1).dot(residuals.tail(n - 1)) / std::max(residuals.squaredNorm(), 1e-300);
  rho = std::clamp(rho, 0.0, 0.99);
  if (rho < 2 / std::sqrt(static_cast<double>(n))) rho = 0;  // not significant
  const VectorXd white = whitened(residuals, rho);
  return {rho, std::max(white.squaredNorm() / static_cast<double>(n - parameters), 1e-14)};
}

// A loss that grows as r^2 at first and is capped at cap^2 standard deviations: residuals that a drop shifts past do not decide.
struct Loss {
  double variance;
  double cap;  // infinite: least squares
  double operator()(double r2) const {
    return cap == infinity ? r2 / variance : r2 / variance / (1 + r2 / (cap * cap * variance));
  }
  double weight(double r2) const {
    if (cap == infinity) return 1;
    const double t = 1 + r2 / (cap * cap * variance);
    return 1 / (t * t);
  }
};

class Fitter {
 public:
  Fitter(const FitProblem& problem, const FrictionProfile& profile)
      : problem_(problem), profile_(profile), map_(make_map(problem, profile)) {
    const auto [least, greatest] = std::minmax_element(profile.points.begin(), profile.points.end(),
                                                       [](const auto& a, const auto& b) { return a.S < b.S; });
    S_middle_ = 0.5 * (least->S + greatest->S);
    length_seen_ = 0.5 * (greatest->S - least->S);
    least_wavelength_ = least_wavelength_of(profile);
    force_ = Eigen::Map<const VectorXd>(problem.record.force.data(), static_cast<Index>(problem.record.force.size()));
  }

  double middle_length() const { return S_middle_; }
  double least_wavelength() const { return least_wavelength_; }
  Index observations() const { return force_.size(); }

  struct Solution {
    Layout layout;
    VectorXd p;
    Noise noise;
    double log_likelihood;
    bool converged;
  };

  // Mean and drift anew by least squares in F itself. Strong correlation makes the likelihood nearly blind to the level of
  // the curve; the waves are known from the differences, but the mean is what the level says.
  VectorXd levelled(const Solution& solution) const {
    if (solution.noise.rho == 0) return solution.p;
    const VectorXd residuals = force_ - model_force(solution.layout, solution.p);
    const Noise white{0, residuals.squaredNorm() / static_cast<double>(residuals.size())};
    return descend(solution.layout, solution.p, white, 3, solution.layout.wave(0)).p;
  }

  // A model without waves.
  Solution fit_mean(bool drift) const {
    const Layout layout{drift, 0};
    VectorXd p = VectorXd::Zero(layout.size());
    p[0] = 0.5;
    p = descend(layout, p, {0, 0.15 * 0.15}, 3).p;  // 0.15: coarse agreement in F, to begin with
    return refined(layout, p, infinity, 4);
  }

  // A wave added to a solution, from a candidate of the scan.
  Solution add_wave(const Solution& base, const WaveCandidate& candidate, double S_reference,
                    double amplification) const {
    const Layout layout{base.layout.drift, base.layout.waves + 1};
    const Index at = layout.wave(layout.waves - 1);
    const double turn = pi * (S_middle_ - S_reference) / candidate.wavelength;
    const double a = amplification * (candidate.cosine * std::cos(turn) + candidate.sine * std::sin(turn));
    const double b = amplification * (candidate.sine * std::cos(turn) - candidate.cosine * std::sin(turn));
    VectorXd p(layout.size());
    p.head(at) = base.p.head(at);
    p.segment(at, 3) << a, b, candidate.wavelength;
    p[layout.stiffness()] = std::clamp(base.p[base.layout.stiffness()], -0.1, 0.1);
    const bool correlated = base.noise.rho > 0.3 && candidate.walk > 0;
    const double first = 16 * std::max(problem_.errors.force * problem_.errors.force, 1e-6);
    const Noise start = correlated ? Noise{base.noise.rho, std::max(first, base.noise.variance)} : Noise{0, first};
    if (!correlated) linear_start(layout, p, amplification);
    p = descend(layout, p, start, 3).p;
    return refined(layout, p, 4, 3);
  }

  // The residuals jump where a drop passes a point, and a descent stops at such steps. Searches along the axes of the error
  // ellipsoid cross them: a step of some standard errors, taken as long as it gains.
  Solution polished(Solution solution) const {
    double cost = cost_of(solution.layout, solution.p, solution.noise, infinity);
    for (int round = 0; round < 6; ++round) {
      const double before = cost;
      const MatrixXd errors = covariance(solution);
      const VectorXd deviations = errors.diagonal().cwiseMax(0).cwiseSqrt();
      const VectorXd inverse = deviations.cwiseMax(1e-300).cwiseInverse();
      const Eigen::SelfAdjointEigenSolver<MatrixXd> ellipsoid(inverse.asDiagonal() * errors * inverse.asDiagonal());
      for (const double scale : {8.0, 4.0, 2.0, 1.0, 0.5, 0.25})
        for (Index axis = 0; axis < solution.p.size(); ++axis) {
          const double length = std::sqrt(std::max(ellipsoid.eigenvalues()[axis], 0.0));
          for (const double sign : {-1.0, 1.0}) {
            const VectorXd step = sign * scale * length * deviations.cwiseProduct(ellipsoid.eigenvectors().col(axis));
            for (int i = 0; i < 10; ++i) {
              const double next = cost_of(solution.layout, solution.p + step, solution.noise, infinity);
              if (!(next < cost)) break;
              cost = next;
              solution.p += step;
            }
          }
        }
      const auto descended = descend(solution.layout, solution.p, solution.noise, infinity);
      if (descended.cost < cost) {
        solution.p = descended.p;
        cost = descended.cost;
      }
      constexpr double worthwhile = 0.1;  // of twice the log likelihood: a third of a standard error
      if (!(before - cost > worthwhile)) break;
    }
    return refined(solution.layout, solution.p, infinity, 1);
  }

  // The force of a model at stage positions other than those fitted.
  std::vector<double> force_at(const Layout& layout, const VectorXd& p, std::span<const double> stages) const {
    const auto curve = map_.curve(friction_on_map(layout, p));
    const double stiffening = 1 + p[layout.stiffness()];
    auto force = measured_curve(curve.w, curve.F, stiffening / problem_.rig.stiffness, stages).F;
    for (auto& value : force) value *= stiffening;
    return force;
  }

  VectorXd model_force(const Layout& layout, const VectorXd& p) const { return evaluate(layout, p, false).force; }

  // Of the parameters, by Gauss and Newton on the whitened residuals, with the prior of the bending stiffness.
  MatrixXd covariance(const Solution& solution) const {
    const auto model = evaluate(solution.layout, solution.p, true);
    const MatrixXd J = whitened(model.jacobian, solution.noise.rho);
    MatrixXd H = J.transpose() * J / solution.noise.variance;
    const Index last = solution.layout.stiffness();
    H(last, last) += 1 / prior_variance();
    return H.inverse();
  }

 private:
  static double least_wavelength_of(const FrictionProfile& profile) {
    const auto [least, greatest] = std::minmax_element(profile.points.begin(), profile.points.end(),
                                                       [](const auto& a, const auto& b) { return a.S < b.S; });
    constexpr double least_points_per_wave = 6;  // fewer do not show a wave between its jumps
    constexpr double most_waves = 200;           // of more there would be hundreds of drops in a test
    const double points_per_wave =
        std::max(least_points_per_wave, static_cast<double>(profile.points.size()) / most_waves);
    return points_per_wave * 0.5 * (greatest->S - least->S) / static_cast<double>(profile.points.size());
  }

  static SlidingMap make_map(const FitProblem& problem, const FrictionProfile& profile) {
    double S_max = 1;
    double mu_max = 0;
    for (const auto& point : profile.points) {
      S_max = std::max(S_max, point.S);
      if (problem.record.deflection[point.index] > 0.1) mu_max = std::max(mu_max, point.mu);
    }
    constexpr double lengths_per_period = 8;  // at the end of the ladder, where they are farthest apart
    return {std::min(1 + 1.15 * (S_max - 1), 2.1), 2 * least_wavelength_of(profile) / lengths_per_period,
            std::clamp(1.3 * mu_max + 0.3, 0.5, 5.0)};
  }

  double prior_variance() const {
    const double deviation = std::max(problem_.errors.bending_stiffness, 1e-9);  // exact: practically no freedom
    return deviation * deviation;
  }

  // Friction at the lengths of the map. The phase of a wave is quadratic in their number, so that it is advanced by two
  // rotations a step instead of a cosine each; the rounding of a thousand steps stays below 1e-12.
  std::vector<double> friction_on_map(const Layout& layout, const VectorXd& p) const {
    const auto lengths = map_.lengths();
    std::vector<double> mu(lengths.size());
    for (std::size_t i = 0; i < mu.size(); ++i) mu[i] = p[0] + (layout.drift ? p[1] * (lengths[i] - S_middle_) : 0);
    for (Index wave = 0; wave < layout.waves; ++wave) {
      const Index at = layout.wave(wave);
      const double wavenumber = pi / p[at + 2];
      const double step = wavenumber * map_.sigma_step() * map_.sigma_step();
      std::complex<double> phase = std::polar(1.0, wavenumber * (1 - S_middle_));
      std::complex<double> turn = std::polar(1.0, step);
      const std::complex<double> more = std::polar(1.0, 2 * step);
      const auto product = [](std::complex<double> a, std::complex<double> b) {
        return std::complex<double>(a.real() * b.real() - a.imag() * b.imag(),
                                    a.real() * b.imag() + a.imag() * b.real());
      };
      for (auto& value : mu) {
        value += p[at] * phase.real() + p[at + 1] * phase.imag();
        phase = product(phase, turn);
        turn = product(turn, more);
      }
    }
    return mu;
  }

  struct Model {
    VectorXd force;     // at each stage position, in units of the nominal bending stiffness
    MatrixXd jacobian;  // of it, if asked for
  };

  Model evaluate(const Layout& layout, const VectorXd& p, bool with_slopes) const {
    const auto mu = friction_on_map(layout, p);
    const auto curve = map_.curve(mu);
    const double stiffening = 1 + p[layout.stiffness()];
    const double compliance = stiffening / problem_.rig.stiffness;
    const auto measured = measured_curve(curve.w, curve.F, compliance, problem_.record.stage);
    const Index n = observations();
    Model model{stiffening * Eigen::Map<const VectorXd>(measured.F.data(), n), {}};
    if (!with_slopes) return model;

    const auto slopes = map_.slopes(mu);
    model.jacobian.resize(n, layout.size());
    for (Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const std::size_t cell = measured.cell[k];
      const double x = measured.fraction[k];
      const double sigma = map_.sigma_step() * (static_cast<double>(cell) + x);
      const double S = 1 + sigma * sigma;
      const double F_q = slopes.F[cell] + x * (slopes.F[cell + 1] - slopes.F[cell]);
      const double w_q = slopes.w[cell] + x * (slopes.w[cell + 1] - slopes.w[cell]);
      // At a fold G' vanishes and the force responds without limit, but only until the fibre snaps: the response is that of
      // a curve at least a twentieth as steep as that of rigid loading.
      const double rigid = curve.w[cell + 1] - curve.w[cell];
      const double follow = measured.F_slope[k] / std::max(measured.G_slope[k], 0.05 * rigid);
      const double F_mu = mu[cell] > 0 ? stiffening * (F_q - follow * (w_q + compliance * F_q)) : 0;
      model.jacobian(i, 0) = F_mu;
      if (layout.drift) model.jacobian(i, 1) = F_mu * (S - S_middle_);
      for (Index wave = 0; wave < layout.waves; ++wave) {
        const Index at = layout.wave(wave);
        const double angle = pi * (S - S_middle_) / p[at + 2];
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        model.jacobian(i, at) = F_mu * c;
        model.jacobian(i, at + 1) = F_mu * s;
        model.jacobian(i, at + 2) = F_mu * (p[at] * s - p[at + 1] * c) * angle / p[at + 2];
      }
      model.jacobian(i, layout.stiffness()) =
          measured.F[k] - stiffening * follow * measured.F[k] / problem_.rig.stiffness;
    }
    return model;
  }

  bool permitted(const Layout& layout, const VectorXd& p) const {
    if (!(std::abs(p[layout.stiffness()]) < 0.3)) return false;  // beyond that it would be another specimen
    if (!(p[0] > 0) || !p.allFinite()) return false;
    double total = 0;
    for (Index i = 0; i < layout.waves; ++i) {
      const Index at = layout.wave(i);
      const double wavelength = p[at + 2];
      if (!(wavelength > 0.75 * least_wavelength_ && wavelength < 1)) return false;
      total += std::hypot(p[at], p[at + 1]);
      // Two waves closer than the length seen can resolve are one wave, or beats that nothing in the data demands.
      for (Index j = 0; j < i; ++j)
        if (std::abs(1 / wavelength - 1 / p[layout.wave(j) + 2]) < 0.75 / length_seen_) return false;
    }
    return total <= p[0];  // the amplitudes add up to at most 1
  }

  double cost_of(const Layout& layout, const VectorXd& p, const Noise& noise, double cap) const {
    if (!permitted(layout, p)) return infinity;
    const VectorXd residuals = whitened(VectorXd(force_ - evaluate(layout, p, false).force), noise.rho);
    const Loss loss{noise.variance, cap};
    double cost = p[layout.stiffness()] * p[layout.stiffness()] / prior_variance();
    for (const double r : residuals) cost += loss(r * r);
    return cost;
  }

  struct Descent {
    VectorXd p;
    double cost;
    bool converged;
  };

  // Levenberg-Marquardt in the first `free` parameters.
  Descent descend(const Layout& layout, const VectorXd& start, const Noise& noise, double cap, Index free) const {
    constexpr int most_evaluations = 25;
    constexpr double negligible = 1e-2;  // of the cost, twice the log likelihood: a hundredth of what would matter
    Descent result{start, cost_of(layout, start, noise, cap), false};
    if (result.cost == infinity) return result;
    const Index last = layout.stiffness();
    const Loss loss{noise.variance, cap};
    double damping = 1e-3;
    for (int evaluations = 0; evaluations < most_evaluations;) {
      const auto model = evaluate(layout, result.p, true);
      const VectorXd r = whitened(VectorXd(force_ - model.force), noise.rho);
      const MatrixXd J = whitened(model.jacobian, noise.rho);
      VectorXd weights(r.size());
      for (Index i = 0; i < r.size(); ++i) weights[i] = loss.weight(r[i] * r[i]) / noise.variance;
      MatrixXd H = J.transpose() * weights.asDiagonal() * J;
      VectorXd g = J.transpose() * weights.cwiseProduct(r);
      H(last, last) += 1 / prior_variance();
      g[last] -= result.p[last] / prior_variance();
      const Index fixed = layout.size() - free;
      H.bottomRows(fixed).setZero();
      H.rightCols(fixed).setZero();
      H.diagonal().tail(fixed).setOnes();
      g.tail(fixed).setZero();
      double gained = -1;
      while (damping < 1e5 && evaluations < most_evaluations) {
        ++evaluations;
        MatrixXd damped = H;
        damped.diagonal() += damping * H.diagonal() + VectorXd::Constant(H.rows(), 1e-12);
        const VectorXd p = result.p + damped.ldlt().solve(g);
        const double cost = cost_of(layout, p, noise, cap);
        if (cost < result.cost) {
          gained = result.cost - cost;
          result.p = p;
          result.cost = cost;
          break;
        }
        damping *= 5;
      }
      if (gained < negligible) {
        result.converged = true;
        break;
      }
      damping = std::max(damping / 8, 1e-6);
    }
    return result;
  }

  Descent descend(const Layout& layout, const VectorXd& start, const Noise& noise, double cap) const {
    return descend(layout, start, noise, cap, layout.size());
  }

  // Rounds of estimating the noise and descending; the cap applies to the first of them.
  Solution refined(const Layout& layout, VectorXd p, double cap, int rounds) const {
    bool converged = false;
    for (int round = 0; round < rounds; ++round) {
      const Noise noise = noise_of(force_ - model_force(layout, p), layout.size());
      double round_cap = infinity;
      if (round == 0) round_cap = cap;
      const auto descent = descend(layout, p, noise, round_cap);
      p = descent.p;
      converged = descent.converged;
    }
    const VectorXd residuals = force_ - model_force(layout, p);
    const Noise noise = noise_of(residuals, layout.size());
    const auto n = static_cast<double>(residuals.size());
    const double rss = whitened(residuals, noise.rho).squaredNorm();
    const double eta = p[layout.stiffness()];
    const double log_likelihood = -0.5 * (n * std::log(std::max(rss / n, 1e-14)) - std::log(1 - noise.rho * noise.rho) +
                                          eta * eta / prior_variance());
    return {layout, p, noise, log_likelihood, converged};
  }

  // Mean, drift, wave and bending stiffness by weighted linear least squares on the profile, for the wavelengths in p.
  void linear_start(const Layout& layout, VectorXd& p, double amplification) const {
    const auto rows = static_cast<Index>(profile_.points.size());
    const Index columns = (layout.drift ? 2 : 1) + 2 * layout.waves + 1;
    MatrixXd A = MatrixXd::Zero(rows + 1, columns);
    VectorXd y = VectorXd::Zero(rows + 1);
    const double sigma = std::max(problem_.errors.force, 1e-4);
    for (Index i = 0; i < rows; ++i) {
      const auto& point = profile_.points[static_cast<std::size_t>(i)];
      const double weight = 1 / (sigma * std::abs(point.mu_force));
      Index column = 0;
      A(i, column++) = weight;
      if (layout.drift) A(i, column++) = weight * (point.S - S_middle_);
      for (Index wave = 0; wave < layout.waves; ++wave) {
        const double angle = pi * (point.S - S_middle_) / p[layout.wave(wave) + 2];
        A(i, column++) = weight * std::cos(angle);
        A(i, column++) = weight * std::sin(angle);
      }
      A(i, column) = -weight * point.mu_log_stiffness;
      y[i] = weight * point.mu;
    }
    A(rows, columns - 1) = 1 / std::sqrt(prior_variance());
    const VectorXd solution = A.colPivHouseholderQr().solve(y);
    const Index head = layout.drift ? 2 : 1;
    p.head(head) = solution.head(head);
    for (Index wave = 0; wave < layout.waves; ++wave)
      p.segment(layout.wave(wave), 2) = amplification * solution.segment(head + 2 * wave, 2);
    p[layout.stiffness()] = std::clamp(solution[columns - 1], -0.06, 0.06);
  }

  const FitProblem& problem_;
  const FrictionProfile& profile_;
  SlidingMap map_;
  double S_middle_;
  double length_seen_;       // [L] of fibre, over one support
  double least_wavelength_;  // [L]
  VectorXd force_;
};

ParameterEstimate estimate(double value, double standard_error) {
  return {value, standard_error, value - 1.96 * standard_error, value + 1.96 * standard_error};
}

double wrapped(double angle) { return angle - 2 * pi * std::round(angle / (2 * pi)); }

// The drops let a fit choose which points to put on either side of a snap, a freedom that the Jacobian does not count: simulated
// estimates scatter by a tenth more than it says. Empirical; docs/validation.md has the coverage that it leads to.
constexpr double jump_inflation = 1.1;

ModelFit describe(ProfileModel model, const Fitter& fitter, const Fitter::Solution& solution,
                  const FitProblem& problem) {
  const Layout layout = solution.layout;
  const Noise noise = solution.noise;
  const double log_likelihood = solution.log_likelihood;
  const VectorXd p = fitter.levelled(solution);
  const MatrixXd covariance = jump_inflation * jump_inflation * fitter.covariance(solution);
  const auto error = [&](const VectorXd& gradient) {
    return std::sqrt(std::max(gradient.dot(covariance * gradient), 0.0));
  };
  const auto unit = [&](Index i) { return VectorXd(VectorXd::Unit(layout.size(), i)); };
  const Index last = layout.stiffness();

  ModelFit fit{};
  fit.model = model;
  fit.status = solution.converged ? FitStatus::ok : FitStatus::not_converged;
  fit.mu0 = estimate(p[0], error(unit(0)));
  fit.drift = layout.drift ? estimate(p[1], error(unit(1))) : ParameterEstimate{};
  fit.bending_stiffness = estimate(1 + p[last], error(unit(last)));
  fit.friction = {.mu0 = p[0], .drift = fit.drift.value, .terms = {}, .S_reference = fitter.middle_length()};
  for (Index i = 0; i < layout.waves; ++i) {
    const Index at = layout.wave(i);
    const double a = p[at];
    const double b = p[at + 1];
    const double wavelength = p[at + 2];
    const double height = std::hypot(a, b);
    VectorXd of_amplitude = (a * unit(at) + b * unit(at + 1)) / (height * p[0]) - height / (p[0] * p[0]) * unit(0);
    // a cos x + b sin x = height cos(x + phase), x = π (S - S_middle)/λ
    const double phase_at_middle = std::atan2(-b, a);
    const VectorXd of_phase = (b * unit(at) - a * unit(at + 1)) / (height * height);
    const VectorXd of_origin = of_phase + pi * fitter.middle_length() / (wavelength * wavelength) * unit(at + 2);
    fit.waves.push_back(
        {.amplitude = estimate(height / p[0], error(of_amplitude)),
         .wavelength = estimate(wavelength, error(unit(at + 2))),
         .phase = estimate(wrapped(phase_at_middle - pi * fitter.middle_length() / wavelength), error(of_origin)),
         .phase_at_middle = estimate(phase_at_middle, error(of_phase))});
    fit.friction.terms.push_back({height / p[0], wavelength, fit.waves.back().phase.value});
  }
  fit.force = fitter.force_at(layout, p, problem.record.stage);
  double sum = 0;
  for (std::size_t i = 0; i < fit.force.size(); ++i)
    sum += (fit.force[i] - problem.record.force[i]) * (fit.force[i] - problem.record.force[i]);
  fit.residual_rms = std::sqrt(sum / static_cast<double>(fit.force.size()));
  const auto n = static_cast<double>(fitter.observations());
  fit.correlation = noise.rho;
  fit.innovation = std::sqrt(noise.variance);
  fit.effective_points = n * (1 - noise.rho) / (1 + noise.rho);
  fit.parameters = static_cast<int>(layout.size()) - 1;
  fit.log_likelihood = log_likelihood;
  fit.aic = 2 * fit.parameters - 2 * log_likelihood;
  fit.bic = fit.parameters * std::log(n) - 2 * log_likelihood;
  return fit;
}

// Constant friction by least squares in the force at the measured deflections.
struct ConstantFit {
  double mu;
  double from_residuals;  // standard error, allowing for their correlation
};

ConstantFit fit_constant(const ReducedRecord& record, double stiffening, const SlidingMap& map) {
  std::vector<std::size_t> order(record.deflection.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return record.deflection[a] < record.deflection[b]; });
  std::vector<double> w;
  w.reserve(order.size());
  for (const auto i : order) w.push_back(record.deflection[i]);
  const auto n = static_cast<Index>(w.size());
  const auto force_at = [&](double mu) {
    const auto curve = map.curve(std::vector<double>(map.lengths().size(), mu));
    const auto at_deflection = measured_curve(curve.w, curve.F, 0, w);
    VectorXd force(n);
    for (std::size_t i = 0; i < w.size(); ++i) force[static_cast<Index>(order[i])] = stiffening * at_deflection.F[i];
    return force;
  };
  const VectorXd data = Eigen::Map<const VectorXd>(record.force.data(), n);
  double mu = 0.5;
  VectorXd slope;
  VectorXd residuals;
  for (int iteration = 0; iteration < 20; ++iteration) {
    constexpr double h = 1e-4;  // F is smooth in μ on a scale of 1
    const VectorXd force = force_at(mu);
    slope = (force_at(mu + h) - force) / h;
    residuals = data - force;
    const double next = std::clamp(mu + slope.dot(residuals) / slope.squaredNorm(), 0.0, map.mu_max());
    const bool done = std::abs(next - mu) < 1e-8;
    mu = next;
    if (done) break;
  }
  // Sandwich with the autocovariance of the scores, tapered (Newey & West) over a tenth of the record.
  const VectorXd scores = slope.cwiseProduct(residuals);
  const Index reach = std::max<Index>(n / 10, 1);
  double variance = scores.squaredNorm();
  for (Index lag = 1; lag < std::min(reach, n); ++lag) {
    const double taper = 1 - static_cast<double>(lag) / static_cast<double>(reach);
    variance += 2 * taper * scores.head(n - lag).dot(scores.tail(n - lag));
  }
  return {mu, std::sqrt(std::max(variance, 0.0)) / slope.squaredNorm()};
}

// The model `constant` is judged by its likelihood as the others are, but estimated at the nominal bending stiffness.
void estimate_constant(ModelFit& fit, const FitProblem& problem) {
  const auto& record = problem.record;
  const double w_max = *std::max_element(record.deflection.begin(), record.deflection.end());
  const SlidingMap map(std::min(1 + 2.5 * w_max * w_max, 2.1), 0.002, 3.0);
  const auto nominal = fit_constant(record, 1, map);
  const double deviation = problem.errors.bending_stiffness;
  const double shift =
      0.5 * (fit_constant(record, 1 + deviation, map).mu - fit_constant(record, 1 - deviation, map).mu);
  fit.mu0 = estimate(nominal.mu, std::hypot(nominal.from_residuals, shift));
  fit.mu0.low = std::max(fit.mu0.low, 0.0);
  fit.bending_stiffness = estimate(1, deviation);
  fit.friction = {.mu0 = nominal.mu, .drift = 0, .terms = {}};
  const auto curve = map.curve(std::vector<double>(map.lengths().size(), nominal.mu));
  fit.force = measured_curve(curve.w, curve.F, 1 / problem.rig.stiffness, record.stage).F;
  double sum = 0;
  for (std::size_t i = 0; i < fit.force.size(); ++i)
    sum += (fit.force[i] - record.force[i]) * (fit.force[i] - record.force[i]);
  fit.residual_rms = std::sqrt(sum / static_cast<double>(fit.force.size()));
}

ReducedRecord usable_part(const ReducedRecord& record) {
  ReducedRecord part;
  for (std::size_t i = 0; i < record.stage.size() && record.deflection[i] <= 0.8; ++i) {
    part.stage.push_back(record.stage[i]);
    part.deflection.push_back(record.deflection[i]);
    part.force.push_back(record.force[i]);
  }
  return part;
}

// Every so many points of a record, so that it has at most 600: the number for which starts and searches are made.
ReducedRecord thinned(const ReducedRecord& record) {
  constexpr std::size_t most_points = 600;
  const std::size_t every = (record.stage.size() + most_points - 1) / most_points;
  ReducedRecord part;
  for (std::size_t i = 0; i < record.stage.size(); i += every) {
    part.stage.push_back(record.stage[i]);
    part.deflection.push_back(record.deflection[i]);
    part.force.push_back(record.force[i]);
  }
  return part;
}

void require_faultless(const FitProblem& problem) {
  const auto& [stage, deflection, force] = problem.record;
  if (stage.size() != force.size() || deflection.size() != force.size())
    throw std::invalid_argument("the columns of the record are not of one length: " + std::to_string(stage.size()) +
                                ", " + std::to_string(deflection.size()) + ", " + std::to_string(force.size()));
  for (std::size_t i = 0; i < force.size(); ++i)
    if (!std::isfinite(stage[i] + deflection[i] + force[i]) || (i > 0 && stage[i] < stage[i - 1]))
      throw std::invalid_argument("point " + std::to_string(i) + " of the record is not finite or runs back");
  const auto& errors = problem.errors;
  if (!(errors.force >= 0 && errors.bending_stiffness >= 0 && errors.contact >= 0))
    throw std::invalid_argument("measurement errors must not be negative");
  constexpr double most_error = 0.3;  // of EI: beyond it the fit would be that of another specimen
  if (errors.bending_stiffness > most_error)
    throw std::invalid_argument("the bending stiffness must be known to 30 %, not " +
                                std::to_string(errors.bending_stiffness));
}

}  // namespace

std::string_view name_of(ProfileModel model) {
  switch (model) {
    case ProfileModel::constant:
      return "constant";
    case ProfileModel::drift:
      return "drift";
    case ProfileModel::sinusoid:
      return "sinusoid";
    case ProfileModel::sinusoids:
      return "sinusoids";
  }
  return "";
}

FrictionFit fit_friction(const FitProblem& whole, const FitOptions& options) {
  if (!(whole.rig.stiffness > 0))
    throw std::invalid_argument("rig stiffness must be positive, not " + std::to_string(whole.rig.stiffness));
  require_faultless(whole);
  if (options.models.empty()) throw std::invalid_argument("no friction model to fit");
  constexpr double measurable_from = 0.05;
  const FitProblem usable{usable_part(whole.record), whole.rig, whole.errors};
  const FitProblem problem{thinned(usable.record), whole.rig, whole.errors};
  const auto profile = measure_friction(problem.record, problem.rig, problem.errors, measurable_from);
  FrictionFit result{};
  if (profile.points.size() < 20) {
    result.status = FrictionFitStatus::too_few_points;
    return result;
  }
  const Fitter fitter(problem, profile);
  result.S_middle = fitter.middle_length();
  const double prior = std::max(problem.errors.bending_stiffness, 1e-9);
  const auto asked = [&](ProfileModel model) {
    return std::find(options.models.begin(), options.models.end(), model) != options.models.end();
  };

  const auto drifting = fitter.fit_mean(true);
  std::optional<Fitter::Solution> one;
  std::optional<Fitter::Solution> many;
  if (asked(ProfileModel::sinusoid) || asked(ProfileModel::sinusoids)) {
    ScanOptions scan{.least_wavelength = fitter.least_wavelength(), .stiffness_error = prior};
    result.scan = scan_wavelengths(profile.points, scan);
    const auto best_wave = [&](const Fitter::Solution& base, const WavelengthScan& waves, std::size_t most) {
      std::optional<Fitter::Solution> best;
      for (std::size_t i = 0; i < std::min(most, waves.candidates.size()); ++i) {
        // A candidate far less likely on the profile than the first is not going to win on the curve.
        if (waves.candidates[i].log_likelihood_gain < waves.candidates.front().log_likelihood_gain - 50) continue;
        for (const double amplification : {1.0, 1.5}) {
          auto solution = fitter.add_wave(base, waves.candidates[i], waves.S_reference, amplification);
          if (!best || solution.log_likelihood > best->log_likelihood) best = std::move(solution);
        }
      }
      if (best) {
        auto polished = fitter.polished(*best);
        if (polished.log_likelihood >= best->log_likelihood) best = std::move(polished);
      }
      return best;
    };
    one = best_wave(drifting, result.scan, 4);
    if (one && asked(ProfileModel::sinusoids)) {
      Fitter::Solution current = *one;
      for (int waves = 2; waves <= 3; ++waves) {
        auto rest = profile.points;
        for (auto& point : rest)
          for (Index i = 0; i < current.layout.waves; ++i) {
            const Index at = current.layout.wave(i);
            const double angle = pi * (point.S - fitter.middle_length()) / current.p[at + 2];
            point.mu -= current.p[at] * std::cos(angle) + current.p[at + 1] * std::sin(angle);
          }
        auto next = best_wave(current, scan_wavelengths(rest, scan), 2);
        if (!next) break;
        const double penalty = 3 * std::log(static_cast<double>(fitter.observations()));
        const bool better = 2 * (next->log_likelihood - current.log_likelihood) > penalty;
        if (!many || better) many = *next;
        if (!better) break;
        current = *next;
      }
    }
  }

  for (const auto model : options.models) {
    switch (model) {
      case ProfileModel::constant:
        result.models.push_back(describe(model, fitter, fitter.fit_mean(false), usable));
        estimate_constant(result.models.back(), usable);
        break;
      case ProfileModel::drift:
        result.models.push_back(describe(model, fitter, drifting, usable));
        break;
      case ProfileModel::sinusoid:
      case ProfileModel::sinusoids: {
        const auto& solution = model == ProfileModel::sinusoid ? one : many;
        if (solution) {
          result.models.push_back(describe(model, fitter, *solution, usable));
        } else {
          ModelFit missing{};
          missing.model = model;
          missing.status = FitStatus::not_found;
          missing.bic = infinity;
          result.models.push_back(missing);
        }
        break;
      }
    }
  }
  const auto best = std::min_element(result.models.begin(), result.models.end(),
                                     [](const auto& a, const auto& b) { return a.bic < b.bic; });
  result.chosen = static_cast<std::size_t>(best - result.models.begin());
  return result;
}

}  // namespace flexslip
