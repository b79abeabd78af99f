#include "inference/passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "inference/loading_forces.h"
#include "inference/pass_rows.h"
#include "inference/pass_unknowns.h"
#include "inference/passes_solution.h"
#include "numerics/dense.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Friction at nodes along the specimen, and its prior.

// The roughness of friction: standard deviation [1] and correlation length [L] in S.
struct Roughness {
  double size, length;
};
constexpr std::array sizes_of_roughness{0.008, 0.03, 0.07, 0.13};
constexpr std::array lengths_of_roughness{0.006, 0.015, 0.04};

class Nodes {
 public:
  // From the straight specimen to a length [L].
  Nodes(const PassesOptions& options, double longest)
      : options_(options),
        size_(static_cast<Index>(std::clamp(std::ceil((longest - 1) / options.spacing), 30.0, options.max_nodes))),
        spacing_((longest - 1) / static_cast<double>(size_ - 1)) {}

  Index size() const { return size_; }
  double S(Index j) const { return 1 + spacing_ * static_cast<double>(j); }
  double last() const { return S(size() - 1); }

  // The two nodes around a length, and its fraction of their distance.
  struct Place {
    Index first;
    double part;
  };
  Place place(double length) const {
    const double where = std::clamp((length - 1) / spacing_, 0.0, static_cast<double>(size()) - 1.001);
    const auto first = static_cast<Index>(where);
    return {first, where - static_cast<double>(first)};
  }
  static double between(const Place& at, const VectorXd& values) {
    return (1 - at.part) * values[at.first] + at.part * values[at.first + 1];
  }

  VectorXd slopes(const VectorXd& values) const {
    VectorXd slopes(size());
    for (Index j = 0; j < size(); ++j) {
      const Index before = std::max<Index>(j - 1, 0), after = std::min(j + 1, size() - 1);
      slopes[j] = (values[after] - values[before]) / (spacing_ * static_cast<double>(after - before));
    }
    return slopes;
  }

  // The prior of friction: mean, trend, slow variation and roughness.
  MatrixXd covariance(const Roughness& rough) const { return covariance(options_.slow_friction, rough); }
  // The prior of mean and trend only.
  MatrixXd covariance_of_trend() const { return covariance(0, {0, 1}); }

 private:
  MatrixXd covariance(double slow, const Roughness& rough) const {
    constexpr double nugget = 1e-6;  // [variance] neighbouring nodes of a smooth process are almost equal
    const double range = last() - 1;
    const auto matern = [](double distance) {
      const double r = std::sqrt(3.0) * distance;
      return (1 + r) * elementary::exp(-r);
    };
    // Apart from the trend, it depends on the distance of two nodes.
    VectorXd by_distance(size());
    for (Index d = 0; d < size(); ++d) {
      const double apart = spacing_ * static_cast<double>(d);
      by_distance[d] = options_.friction_error * options_.friction_error + slow * slow * matern(3 * apart / range) +
                       rough.size * rough.size * matern(apart / rough.length);
    }
    by_distance[0] += nugget;
    MatrixXd K(size(), size());
    for (Index i = 0; i < size(); ++i)
      for (Index j = 0; j <= i; ++j) {
        const double trend = (2 * (S(i) - 1) / range - 1) * (2 * (S(j) - 1) / range - 1);
        K(i, j) = K(j, i) = by_distance[i - j] + options_.friction_trend * options_.friction_trend * trend;
      }
    return K;
  }

  const PassesOptions& options_;
  Index size_;
  double spacing_;
};

// Rows linearised about a state of all unknowns: force = by_friction μ(place) + by_unknowns θ +
// amplification · noise.
struct Linear {
  std::vector<Index> row;  // of PassRows
  std::vector<Nodes::Place> place;
  VectorXd by_friction, amplification, force;
  MatrixXd by_unknowns;
  MatrixXd log_gain_by;  // d ln(by_friction/amplification)/dθ at the given readings

  Index size() const { return force.size(); }
};

// The normal equations of linearised rows: A x = b, and Σ weight · force².
struct Normal {
  MatrixXd A;
  VectorXd b;
  double square = 0;
};

Normal normal_of(const Linear& at, const VectorXd& weight, Index nodes) {
  const Index unknowns = at.by_unknowns.cols(), size = nodes + unknowns;
  Normal normal{MatrixXd::Zero(size, size), VectorXd::Zero(size)};
  const MatrixXd weighted = weight.asDiagonal() * at.by_unknowns;
  normal.A.bottomRightCorner(unknowns, unknowns) = product(MatrixXd(weighted.transpose()), at.by_unknowns);
  for (Index i = 0; i < at.size(); ++i) {
    const auto [j, part] = at.place[static_cast<std::size_t>(i)];
    const double first = at.by_friction[i] * (1 - part), second = at.by_friction[i] * part, w = weight[i];
    normal.A(j, j) += w * first * first;
    normal.A(j + 1, j) += w * first * second;
    normal.A(j + 1, j + 1) += w * second * second;
    normal.A.col(j).tail(unknowns) += first * weighted.row(i).transpose();
    normal.A.col(j + 1).tail(unknowns) += second * weighted.row(i).transpose();
    normal.b.tail(unknowns) += at.force[i] * weighted.row(i).transpose();
    normal.b[j] += w * first * at.force[i];
    normal.b[j + 1] += w * second * at.force[i];
    normal.square += w * at.force[i] * at.force[i];
  }
  normal.A.triangularView<Eigen::StrictlyUpper>() = normal.A.transpose();
  return normal;
}

// The state of the fit.
class PassesFitter {
 public:
  PassesFitter(const PassesProblem& problem, const std::vector<Leg>& legs, const PassRows& rows,
               const PassUnknowns& unknowns, std::vector<char> stuck, double longest);

  // The result of the last round; empty with too few rows.
  std::optional<PassesSolution> run();

 private:
  bool linearise();
  void choose_roughness(int round);
  void solve(int round);
  void weigh();
  void advance(int round);

  VectorXd pull(const Normal& normal) const;
  VectorXd leverage(const MatrixXd& A, const MatrixXd& prior) const;
  MatrixXd prior_precision(const MatrixXd& covariance_of_friction) const;
  double scatter_of(std::size_t pass, std::size_t least) const;
  // [1] The number of correlated neighbouring rows that count as one.
  double inflation() const {
    constexpr double most = 12;
    return std::min((1 + correlation_) / (1 - correlation_), most);
  }
  std::size_t pass_of(Index k) const {
    return rows_.pass[static_cast<std::size_t>(linear_.row[static_cast<std::size_t>(k)])];
  }

  const PassesProblem& problem_;
  const PassesOptions& options_;
  const std::vector<Leg>& legs_;
  const PassRows& rows_;
  const PassUnknowns& unknowns_;
  const std::vector<char> stuck_;
  const Nodes nodes_;
  const double compliance_, greatest_, least_noise_;

  VectorXd mu_, theta_;                   // the point of linearisation
  double noise_, correlation_ = 0;        // of one row [EI/L^2]; of neighbours
  Roughness rough_{0.06, 0.012};          // the start
  VectorXd prior_mean_, robust_;          // of all unknowns; of all rows
  MatrixXd trend_precision_, precision_;  // of friction without roughness; of all unknowns
  Linear linear_;
  VectorXd weight_, residual_;  // of the linearised rows, over their amplification
  VectorXd solution_, S_, q_;
  MatrixXd covariance_;
};

// [maximum force] The noise decreases in these steps; starting with its true size leads to a wrong
// optimum.
constexpr std::array noise_steps{.03, .02, .012, .008, .005, .004, .003, .002, .0015, .001};
constexpr std::size_t min_rows = 20;

PassesFitter::PassesFitter(const PassesProblem& problem, const std::vector<Leg>& legs, const PassRows& rows,
                           const PassUnknowns& unknowns, std::vector<char> stuck, double longest)
    : problem_(problem),
      options_(problem.options),
      legs_(legs),
      rows_(rows),
      unknowns_(unknowns),
      stuck_(std::move(stuck)),
      nodes_(problem.options, longest),
      compliance_(1 / problem.rig.stiffness),
      greatest_(*std::max_element(problem.record.force.begin(), problem.record.force.end())),
      least_noise_(noise_of_second_differences(second_differences(problem.record.force))),
      mu_(VectorXd::Constant(nodes_.size(), options_.friction)),
      theta_(unknowns.mean),
      noise_(noise_steps[0] * greatest_),
      prior_mean_(nodes_.size() + unknowns.size()),
      robust_(VectorXd::Ones(index_of(rows.size()))),
      trend_precision_(Symmetric(nodes_.covariance_of_trend()).inverse()) {
  prior_mean_ << mu_, unknowns.mean;
}

std::optional<PassesSolution> PassesFitter::run() {
  for (int round = 0; round < options_.rounds; ++round) {
    if (!linearise()) return std::nullopt;
    weigh();
    choose_roughness(round);
    solve(round);
    advance(round);
  }
  if (!solution_.allFinite()) return std::nullopt;
  VectorXd lengths(nodes_.size());
  for (Index j = 0; j < nodes_.size(); ++j) lengths[j] = nodes_.S(j);
  return PassesSolution{lengths, solution_, covariance_, noise_, S_, linear_.row};
}

bool PassesFitter::linearise() {
  const Index n = index_of(rows_.size());
  const Fibre& fibre = problem_.rig.fibre;
  const VectorXd w = rows_.w + unknowns_.W * theta_, F = rows_.F + unknowns_.G * theta_;
  VectorXd e(n), times(n);
  const VectorXd log_e = unknowns_.E * theta_, level = unknowns_.L * theta_;
  for (Index i = 0; i < n; ++i) {
    e[i] = elementary::exp(log_e[i]);
    times[i] = rows_.side[static_cast<std::size_t>(i)] * elementary::exp(level[i]);
  }
  const VectorXd reduced = F.cwiseQuotient(e);
  const PassStates read = states_read(w, reduced, fibre);

  // The place of each row: from the readings, or from the fit at small deflections.
  constexpr double by_fit_up_to = 0.04, by_reading_from = 0.08;  // [L] of deflection
  constexpr double wrong_way = -0.2;                             // [1] no sliding has this friction
  S_.resize(n);
  q_.resize(n);
  for (Index i = 0; i < n; ++i) {
    S_[i] = read.S[i];
    q_[i] = times[i] * Nodes::between(nodes_.place(S_[i]), mu_);
    if (!read.is_read(i)) continue;
    const double by_reading = rows_.side[static_cast<std::size_t>(i)] * read.q[i] > wrong_way
                                  ? std::clamp((w[i] - by_fit_up_to) / (by_reading_from - by_fit_up_to), 0.0, 1.0)
                                  : 0;
    for (int again = 0; again < 3; ++again) {
      const double here = by_reading * read.q[i] + (1 - by_reading) * q_[i];
      S_[i] = std::max(read.S[i] + read.S_q[i] * (here - read.q[i]), 1.0);
      q_[i] = times[i] * Nodes::between(nodes_.place(S_[i]), mu_);
    }
  }
  const PassForces modelled = forces_modelled(w, q_, read, fibre);
  linear_ = {};
  for (Index i = 0; i < n; ++i)
    if (!stuck_[static_cast<std::size_t>(i)] && read.is_read(i) && std::isfinite(modelled.F[i]) &&
        S_[i] < nodes_.last())
      linear_.row.push_back(i);
  if (linear_.row.size() < min_rows) return false;

  const auto [W, G] = unknowns_.at(w, modelled.F.cwiseProduct(e));
  const VectorXd slope = nodes_.slopes(mu_);
  // The derivative of friction at slightly larger deflections and forces.
  constexpr double dw = 1e-5, dF = 2e-4;
  const PassStates deeper = states_read(w.array() + dw, reduced, fibre);
  const PassStates stronger = states_read(w, reduced.array() + dF, fibre);
  const auto log_gain = [&](const PassStates& at, Index i) {
    constexpr double least = 1e-6;
    return elementary::log(std::max(at.F_q[i], least) / std::max(1 + e[i] * at.F_w[i] * compliance_, least));
  };
  const Index m = index_of(linear_.row.size());
  for (VectorXd* column : {&linear_.by_friction, &linear_.amplification, &linear_.force}) column->resize(m);
  linear_.by_unknowns.resize(m, unknowns_.size());
  linear_.log_gain_by.setZero(m, unknowns_.size());
  for (Index k = 0; k < m; ++k) {
    const Index i = linear_.row[static_cast<std::size_t>(k)];
    const double F_q = e[i] * modelled.F_q[i], F_w = e[i] * modelled.F_w[i];
    const Nodes::Place place = nodes_.place(S_[i]);
    linear_.place.push_back(place);
    linear_.by_friction[k] = F_q * times[i];
    // An error of the rig or the force also shifts the inverted place, along which friction
    // changes.
    constexpr double max_ratio = 6;  // of the uncertainty to that at constant friction; beyond, the place is a crest
    const double plain = 1 + F_w * compliance_;
    const double moved = std::max(F_q * modelled.S_w[i] * compliance_ - plain * modelled.S_q[i], 1e-9);
    const double rise =
        std::clamp(times[i] * Nodes::between(place, slope), 0.0, std::max((max_ratio - 1) * plain / moved, 0.0));
    const double held = 1 - rise * modelled.S_q[i];
    linear_.amplification[k] = plain * held + F_q * rise * modelled.S_w[i] * compliance_;
    linear_.by_unknowns.row(k) = -held * G.row(i) + (held * F_w + F_q * rise * modelled.S_w[i]) * W.row(i) +
                                 held * e[i] * modelled.F[i] * unknowns_.E.row(i) + F_q * q_[i] * unknowns_.L.row(i);
    linear_.force[k] = F[i] - e[i] * modelled.F[i] + linear_.by_friction[k] * Nodes::between(place, mu_) +
                       linear_.by_unknowns.row(k).dot(theta_);
    const double here = log_gain(read, i);
    const double by_w = (log_gain(deeper, i) - here) / dw, by_F = (log_gain(stronger, i) - here) / dF;
    if (std::isfinite(by_w) && std::isfinite(by_F))
      linear_.log_gain_by.row(k) =
          by_w * W.row(i) + by_F / e[i] * G.row(i) + (1 - by_F * reduced[i]) * unknowns_.E.row(i) + unknowns_.L.row(i);
  }
  return true;
}

MatrixXd PassesFitter::prior_precision(const MatrixXd& covariance_of_friction) const {
  constexpr double exact = 1e-9;  // a smaller deviation means exact
  MatrixXd precision = MatrixXd::Zero(prior_mean_.size(), prior_mean_.size());
  precision.topLeftCorner(nodes_.size(), nodes_.size()) = Symmetric(covariance_of_friction).inverse();
  const VectorXd deviation = (theta_.array() < 0).select(unknowns_.below_zero, unknowns_.deviation).cwiseMax(exact);
  precision.diagonal().tail(unknowns_.size()) = deviation.cwiseAbs2().cwiseInverse();
  return precision;
}

// Correlated neighbouring rows count less.
void PassesFitter::weigh() {
  weight_.resize(linear_.size());
  for (Index k = 0; k < linear_.size(); ++k)
    weight_[k] = robust_[linear_.row[static_cast<std::size_t>(k)]] /
                 (std::pow(noise_ * linear_.amplification[k], 2) * inflation());
}

// Chooses noise and roughness by the evidence: first on a grid, then the size of the roughness
// alone, on which `pull` depends.
void PassesFitter::choose_roughness(int round) {
  VectorXd plain(linear_.size());
  double count = 0;
  for (Index k = 0; k < linear_.size(); ++k) {
    const double robust = robust_[linear_.row[static_cast<std::size_t>(k)]];
    plain[k] = robust / std::pow(linear_.amplification[k], 2);
    count += robust;
  }
  const Normal normal = normal_of(linear_, plain, nodes_.size());
  const auto evidence = [&](const Roughness& rough, std::span<const double> noises) {
    const MatrixXd K = nodes_.covariance(rough), precision = prior_precision(K);
    const VectorXd from_prior = precision * prior_mean_;
    const double of_prior = prior_mean_.dot(from_prior) + Positive(K).log_determinant();
    std::pair<double, double> best{-infinity, noise_};
    for (const double noise : noises) {
      const double weight = 1 / (noise * noise);
      const Positive A(MatrixXd(weight * normal.A + precision));
      const VectorXd b = weight * normal.b + from_prior;
      const double value = 0.5 * (b.dot(A.solved(b)) - weight * normal.square - of_prior - A.log_determinant()) -
                           count * elementary::log(noise);
      best = std::max(best, std::pair(value, noise));
    }
    return best;
  };
  constexpr int among_some = 5, again = 8;
  if (round == among_some || round == again) {
    constexpr double least = 0.001;  // [maximum force] of the noise
    std::vector<double> noises;
    for (double noise = std::max(least_noise_, least * greatest_);
         noise < 1.5 * std::max(noise_, 1.1 * least * greatest_); noise *= 2)
      noises.push_back(noise);
    std::pair<double, double> most{-infinity, noise_};
    for (const double size : sizes_of_roughness)
      for (const double length : lengths_of_roughness)
        if (const auto here = evidence({size, length}, noises); here > most) {
          most = here;
          rough_ = {size, length};
        }
    weight_ *= noise_ * noise_ / (most.second * most.second);
    noise_ = most.second;
  }
  if (round < among_some) return;
  constexpr double factor = 1.4, smallest = 0.002, largest = 0.3;
  const std::array noise{noise_};
  const auto at = [&](double times) { return evidence({times * rough_.size, rough_.length}, noise).first; };
  const double below = at(1 / factor), here = at(1), above = at(factor);
  const double curvature = 2 * here - below - above;
  const double steps = curvature > 0   ? std::clamp(0.5 * (above - below) / curvature, -2.0, 2.0)
                       : above > below ? 2
                                       : -2;
  rough_.size = std::clamp(rough_.size * elementary::exp(steps * elementary::log(factor)), smallest, largest);
}

// The share of each friction that its own row determines.
VectorXd PassesFitter::leverage(const MatrixXd& A, const MatrixXd& prior) const {
  const MatrixXd inverse = Symmetric(MatrixXd(A.topLeftCorner(nodes_.size(), nodes_.size()) + prior)).inverse();
  VectorXd leverage(linear_.size());
  for (Index k = 0; k < leverage.size(); ++k) {
    const auto [j, part] = linear_.place[static_cast<std::size_t>(k)];
    const double first = 1 - part, gain = linear_.by_friction[k];
    leverage[k] =
        weight_[k] * gain * gain *
        (first * first * inverse(j, j) + 2 * first * part * inverse(j + 1, j) + part * part * inverse(j + 1, j + 1));
  }
  return leverage;
}

// The joint density of friction and rig always favours a rig that needs less roughness, because the
// volume of suitable frictions shrinks. Therefore the density of the rig alone counts, integrated
// over friction.
VectorXd PassesFitter::pull(const Normal& normal) const {
  const Index n = nodes_.size();
  return -(linear_.log_gain_by.transpose() *
           (leverage(normal.A, precision_.topLeftCorner(n, n)) - leverage(normal.A, trend_precision_)));
}

// [EI/L^2] The scatter of a pass, from the median; 0 with too few rows.
double PassesFitter::scatter_of(std::size_t pass, std::size_t least) const {
  std::vector<double> sizes;
  for (Index k = 0; k < linear_.size(); ++k)
    if (pass_of(k) == pass) sizes.push_back(std::abs(residual_[k]));
  return sizes.size() > least ? deviation_by_median * median_of(std::move(sizes)) : 0;
}

void PassesFitter::solve(int round) {
  precision_ = prior_precision(nodes_.covariance(rough_));
  const Index unknowns = unknowns_.size();
  const VectorXd from_prior = precision_ * prior_mean_, plain = weight_;
  const auto solve_once = [&] {
    const Normal normal = normal_of(linear_, weight_, nodes_.size());
    const Symmetric A(MatrixXd(normal.A + precision_));
    VectorXd b = normal.b + from_prior;
    b.tail(unknowns) += pull(normal);
    covariance_ = A.inverse();
    solution_ = A.solved(b);
    residual_.resize(linear_.size());
    for (Index k = 0; k < linear_.size(); ++k)
      residual_[k] = (linear_.force[k] - linear_.by_unknowns.row(k).dot(solution_.tail(unknowns)) -
                      linear_.by_friction[k] * Nodes::between(linear_.place[static_cast<std::size_t>(k)], solution_)) /
                     linear_.amplification[k];
  };
  solve_once();
  // Robust weights from the scatter of each pass. A common scatter would exclude a pass that
  // initially fits badly.
  constexpr double linear_beyond = 2;  // [scatter] larger residuals count linearly
  constexpr int often = 3, early = 5;
  for (int again = 0; again < (round < early ? often : 1); ++again) {
    std::vector<double> scatter;
    for (std::size_t pass = 0; pass < legs_.size(); ++pass) scatter.push_back(std::max(scatter_of(pass, 4), noise_));
    for (Index k = 0; k < linear_.size(); ++k)
      weight_[k] =
          plain[k] * std::min(1.0, linear_beyond * scatter[pass_of(k)] / std::max(std::abs(residual_[k]), 1e-12));
    solve_once();
  }
}

void PassesFitter::advance(int round) {
  const Index nodes = nodes_.size(), unknowns = unknowns_.size();
  constexpr int early = 6;
  const double step = round == 0 ? 1 : round < early ? 0.8 : 0.6;
  constexpr double max_friction = 2, farthest = 3.5;  // [1]; [prior deviations]
  for (Index j = 0; j < nodes; ++j) mu_[j] = std::clamp(mu_[j] + step * (solution_[j] - mu_[j]), 0.0, max_friction);
  for (Index j = 0; j < unknowns; ++j) {
    const double deviation = unknowns_.deviation[j], longest = 0.3 * std::max(1.0, deviation);
    theta_[j] += step * std::clamp(solution_[nodes + j] - theta_[j], -longest, longest);
    theta_[j] =
        std::clamp(theta_[j], unknowns_.mean[j] - farthest * deviation, unknowns_.mean[j] + farthest * deviation);
  }

  double widest = 0;
  for (std::size_t pass = 0; pass < legs_.size(); ++pass) widest = std::max(widest, scatter_of(pass, 8));
  const auto next = std::min(static_cast<std::size_t>(round) + 1, noise_steps.size() - 1);
  noise_ = std::max({widest, 0.8 * least_noise_, noise_steps[next] * greatest_});
  constexpr int robust_from = 4;
  constexpr Index reach = 4;
  if (round >= robust_from)
    for (Index k = 0; k < linear_.size(); ++k) {
      std::vector<double> near;
      for (Index l = std::max<Index>(k - reach, 0); l <= std::min(k + reach, linear_.size() - 1); ++l)
        near.push_back(residual_[l]);
      const double away = (residual_[k] - median_of(std::move(near))) / (4 * noise_);
      robust_[linear_.row[static_cast<std::size_t>(k)]] = 1 / (1 + away * away);
    }
  double squares = 0, products = 0, before = 0;
  for (Index k = 0; k < linear_.size(); ++k) {
    const double here = std::clamp(residual_[k], -4 * noise_, 4 * noise_);
    squares += here * here;
    products += here * before;
    before = here;
  }
  constexpr double most_correlated = 0.9;
  correlation_ = std::clamp(products / std::max(squares, 1e-300), 0.0, most_correlated);
}

double greatest_of(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

double noise_of(const std::vector<double>& force) { return noise_of_second_differences(second_differences(force)); }

// [L] The length up to which more than one pass slides.
double length_passed_twice(const PassRows& rows, const PassStates& read, std::size_t passes) {
  constexpr double beside = 1.04, least = 0.005;  // [1], [L] margin
  std::vector<double> farthest(passes, 1);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (read.is_read(index_of(i))) farthest[rows.pass[i]] = std::max(farthest[rows.pass[i]], read.S[index_of(i)]);
  std::nth_element(farthest.begin(), farthest.begin() + 1, farthest.end(), std::greater<>());
  return 1 + std::max(beside * (farthest[1] - 1), least);
}

// [1] The mean from one length [L] to another; of all places if none is between them.
double mean_of_band(const ProfileBand& band, double S_first, double S_last) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < band.S.size(); ++i)
    if (band.S[i] >= S_first && band.S[i] <= S_last) {
      sum += band.mean[i];
      ++count;
    }
  return count > 0 ? sum / count : mean_of(band.mean);
}

// [EI/L^2] The forces of the specimen without a loss in the evaluated loading. After a large loss,
// the measured forces would look like sticking while the specimen slides.
VectorXd unharmed_forces(const PassRows& rows, std::size_t after, double loss) {
  VectorXd forces = rows.F;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows.row[i] + 1 >= after) forces[index_of(i)] /= 1 - loss;
  return forces;
}

// The rows of all passes, and their states at the nominal EI.
struct ReadPasses {
  PassRows rows;
  PassStates states;
  std::vector<char> stuck;
};

ReadPasses read_passes(const PassesProblem& problem, const std::vector<Leg>& legs) {
  PassRows rows = rows_of(problem, legs);
  PassStates states = states_read(rows.w, rows.F, problem.rig.fibre);
  std::vector<char> stuck = stuck_rows(rows, states, 1 / problem.rig.stiffness, noise_of(problem.record.force));
  return {std::move(rows), std::move(states), std::move(stuck)};
}

// The loss from the forces of two loadings.
PassesFit told_by_forces(const PassesProblem& problem, const std::vector<Leg>& legs) {
  const ReducedRecord& record = problem.record;
  const double least = problem.options.min_force * greatest_of(record.force);
  std::vector<char> left_out;  // no contact, or sticking
  for (const double force : record.force) left_out.push_back(force < least);
  if (greatest_of(record.deflection) >
      min_judged_deflection) {  // at smaller deflections, friction barely changes the force
    const ReadPasses read = read_passes(problem, legs);
    if (read.rows.size() >= min_rows)
      for (std::size_t i = 0; i < read.rows.size(); ++i) left_out[read.rows.row[i]] = read.stuck[i];
  }
  PassesFit fit;
  const std::optional<LoadingForces> forces = compare_loading_forces(problem, legs, left_out);
  if (!forces) return fit;
  fit.is_reloaded = true;
  fit.is_followed = forces->is_followed;
  fit.loss = forces->loss;
  fit.loss_needed = forces->loss_needed;
  return fit;
}

// The problem with a wrong contact in each pass, restricted to deep rows.
PassesProblem bedding_down(PassesProblem problem) {
  PassesOptions& options = problem.options;
  options.min_deflection =
      std::max(options.min_deflection, options.bedded_from * greatest_of(problem.record.deflection));
  options.contact_change = options.contact_change_at_top = options.bedding;
  problem.errors.contact = std::max(problem.errors.contact, options.bedding);
  return problem;
}

// Cracks do not repeat. Slips do, because friction belongs to the place.
std::size_t drops_again(const PassesProblem& problem) {
  const std::vector<double>& w = problem.record.deflection;
  const auto begin = w.begin();
  const double deepest = *std::max_element(begin + static_cast<std::ptrdiff_t>(problem.first),
                                           begin + static_cast<std::ptrdiff_t>(problem.last));
  return static_cast<std::size_t>(std::count_if(problem.drops.begin(), problem.drops.end(), [&](const Drop& drop) {
    return drop.before >= problem.last && w[drop.before] < deepest;
  }));
}

// Improves the fit if the residuals are within five times the noise or this part of the maximum
// force.
PassesFit fit_together(PassesFit fit, const PassesProblem& problem, const std::vector<Leg>& legs, double left_over) {
  fit.status = PassesStatus::not_sliding_out;
  ReadPasses read = read_passes(problem, legs);
  const PassRows& rows = read.rows;
  if (rows.size() < min_rows) return fit;
  const double force_noise = noise_of(problem.record.force);
  if (fit.is_followed && fit.loss.low > 0) {
    read.states = states_read(rows.w, unharmed_forces(rows, problem.last, fit.loss.low), problem.rig.fibre);
    const std::vector<char> still = stuck_rows(rows, read.states, 1 / problem.rig.stiffness, force_noise);
    for (std::size_t i = 0; i < rows.size(); ++i) read.stuck[i] = read.stuck[i] && still[i];
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    fit.sliding_out += !read.stuck[i] && rows.side[i] < 0 && read.states.is_read(index_of(i));
  if (fit.sliding_out < min_rows) return fit;
  fit.status = PassesStatus::not_explained;
  const auto needed =
      losses_needed(problem.record, with_breaks(problem.drops, problem.record, legs), problem.rig.fibre);
  const PassUnknowns unknowns(problem, legs, needed, rows, read.states);
  const double longest = length_passed_twice(rows, read.states, legs.size());
  const auto best = PassesFitter(problem, legs, rows, unknowns, read.stuck, longest).run();
  constexpr double explained = 5;  // [noise]
  if (!best || best->noise > std::max(explained * force_noise, left_over * greatest_of(problem.record.force)))
    return fit;
  return passes_fit_of(*best, problem, legs, needed, rows, unknowns);
}

// A mean friction with its own error and one shared with the bending stiffness.
std::vector<Correlation> with_common_error(std::vector<Correlation> all, double own, double common,
                                           double correlation) {
  const std::string_view mean = JointPart::parameter_names[JointPart::mu0];
  const std::string_view stiffness = JointPart::parameter_names[JointPart::bending_stiffness];
  const double whole = elementary::length(own, common);
  std::erase_if(all, [&](const Correlation& each) { return each.of == stiffness || each.with == stiffness; });
  for (Correlation& each : all)
    if (each.of == mean || each.with == mean) each.value *= own / whole;
  all.push_back({mean, stiffness, correlation * common / whole});
  return all;
}

}  // namespace

double sliding_out_force(const Fibre& fibre, double S, double friction) {
  const FibreState state = fibre.state(S, -friction);
  return std::isfinite(state.F) ? std::max(state.F, 0.0) : 0;
}

PassesFit fit_passes(const PassesProblem& problem) {
  require_readings(problem.record);
  if (!(problem.rig.stiffness > 0))
    throw std::invalid_argument("rig stiffness must be positive, not " + std::to_string(problem.rig.stiffness));
  const std::vector<Leg> legs = find_legs(problem.record.stage);
  if (legs.size() < 2) throw std::invalid_argument("a record of one pass has none to be compared with");
  const PassesFit by_forces = told_by_forces(problem, legs);
  constexpr double beside_noise = 0.005, of_bedding = 0.04;  // [maximum force]
  PassesFit fit = fit_together(by_forces, problem, legs, beside_noise);
  if (fit.status == PassesStatus::not_explained) {
    PassesFit bedded = fit_together(by_forces, bedding_down(problem), legs, of_bedding);
    if (bedded.status == PassesStatus::ok) fit = std::move(bedded);
  }
  fit.drops_again = drops_again(problem);
  return fit;
}

namespace {

// The wave of nearly the same length; nullptr without one.
const WaveEstimate* same_wave(const std::vector<WaveEstimate>& waves, const WaveEstimate& wave) {
  constexpr double near = 0.05;
  for (const WaveEstimate& each : waves)
    if (std::abs(each.wavelength.value / wave.wavelength.value - 1) < near) return &each;
  return nullptr;
}

// An estimate with another independent error.
Estimate with_error(const Estimate& estimate, double deviation) {
  const double more = two_sided_95 * deviation;
  return {estimate.value, elementary::length(estimate.standard_error, deviation),
          estimate.value - elementary::length(estimate.value - estimate.low, more),
          estimate.value + elementary::length(estimate.high - estimate.value, more)};
}

}  // namespace

FrictionFit fit_evaluated(const FitProblem& whole, const PassesFit& passes, const FitOptions& options) {
  if (passes.status != PassesStatus::ok) throw std::invalid_argument("no passes were fitted");
  const double stiffening = elementary::exp(passes.log_stiffness.value);
  FitProblem known = whole;
  known.record = passes.correction.corrected(std::move(known.record));
  known.record.stage = advancing(known.record.stage);
  known = restated(std::move(known), StatedQuantity::bending_stiffness, stiffening - 1);
  known.errors.force /= stiffening;
  known.errors.bending_stiffness = known.errors.contact = 0;
  known.rig_errors = {0, 0, 0, 0, 0, 0, 0};
  FrictionFit fit = fit_friction(known, options);
  if (fit.status != FrictionFitStatus::ok) return fit;

  const auto scaled = [](Estimate estimate, double by) {
    return Estimate{by * estimate.value, by * estimate.standard_error, by * estimate.low, by * estimate.high};
  };
  fit.bending_stiffness = exponential(passes.log_stiffness);
  fit.noise = scaled(fit.noise, stiffening);
  fit.residual_rms *= stiffening;
  fit.correction = passes.correction;
  for (std::size_t i = 0; i < fit.force.size(); ++i)
    fit.force[i] = stiffening * fit.force[i] - fit.correction.at(whole.record.stage[i]).force;
  for (double& each : fit.draw_stiffness) each *= stiffening;
  fit.friction_by = passes.friction_by;
  fit.log_stiffness_by = passes.log_stiffness_by;
  const double common = passes.mean_friction.standard_error;  // common to all places
  const double beside = passes.mean_friction.value - mean_of_band(fit.band, passes.S_first, passes.S_last);
  for (NormalPart& part : fit.of_mu0.posterior) part.mean += beside;
  fit.of_mu0.posterior = widened(std::move(fit.of_mu0.posterior), common);
  const double alone_mu0 = fit.mu0.standard_error;
  const MeanFriction mean = mean_friction(fit.of_mu0.posterior);
  fit.mu0 = mean.estimate;
  fit.mu0_is_bound = mean.is_bound;
  for (double& each : fit.band.deviation) each = elementary::length(each, common);
  fit.correlations = with_common_error(std::move(fit.correlations), alone_mu0, common, passes.correlation);
  // The passes determine friction better than lengths along the specimen: on an exact rig their
  // wavelengths are 0.1 to 1 % too long (bench/reload_lengths.py). The error of a length includes its
  // difference from the length that the evaluated loading alone shows.
  const FrictionFit alone = fit.waves.empty() ? FrictionFit{} : fit_friction(whole, options);
  for (WaveEstimate& wave : fit.waves) {
    const WaveEstimate* same = same_wave(alone.waves, wave);
    const double differs = same ? std::abs(same->wavelength.value / wave.wavelength.value - 1) : 0;
    const double stretch = elementary::length(passes.stretch, differs);
    const double turn = 2 * std::numbers::pi * fit.share / wave.wavelength.value;
    const double middle = 0.5 * (passes.S_first + passes.S_last);
    wave.wavelength = with_error(wave.wavelength, wave.wavelength.value * stretch);
    wave.phase_at_middle = with_error(wave.phase_at_middle, turn * passes.displaced);
    wave.phase = with_error(wave.phase, turn * elementary::length(passes.displaced, middle * stretch));
    wave.correlations = with_common_error(std::move(wave.correlations), alone_mu0, common, passes.correlation);
  }
  return fit;
}

}  // namespace flexslip
