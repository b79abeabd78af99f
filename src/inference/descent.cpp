#include "inference/descent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Loss {
  double variance;
  double cap;
  double operator()(double r2) const {
    return cap == Descent::least_squares ? r2 / variance : r2 / variance / (1 + r2 / (cap * cap * variance));
  }
  double weight(double r2) const {
    if (cap == Descent::least_squares) return 1;
    const double t = 1 + r2 / (cap * cap * variance);
    return 1 / (t * t);
  }
};

}  // namespace

Descent::Descent(const ForceModel& model, const ModelLayout& layout, Freedom freedom)
    : model_(model), layout_(layout), freedom_(std::move(freedom)) {}

double Descent::cost(const VectorXd& p, const CorrelatedNoise& noise, double cap) const {
  if (!model_.permits(layout_, p)) return std::numeric_limits<double>::infinity();
  const VectorXd residuals = whitened(VectorXd(model_.measured_force() - model_.force(layout_, p)), noise.correlation);
  const Loss loss{noise.variance, cap};
  const double eta = p[layout_.stiffness()] - model_.prior_mean();
  double cost = eta * eta / model_.prior_variance();
  for (const double r : residuals) cost += loss(r * r);
  return cost;
}

Descent::Step Descent::descend(const VectorXd& start, const CorrelatedNoise& noise, double cap,
                               int most_evaluations) const {
  constexpr double negligible = 1e-2;  // of the cost, twice the log likelihood: a hundredth of what would matter
  Step result{freedom_.permitted(start), 0, false};
  result.cost = cost(result.p, noise, cap);
  if (result.cost == std::numeric_limits<double>::infinity()) return result;
  const Index last = layout_.stiffness();
  const Loss loss{noise.variance, cap};
  double damping = 1e-3;
  for (int evaluations = 0; evaluations < most_evaluations;) {
    const auto model = model_.response(layout_, result.p);
    const VectorXd r = whitened(VectorXd(model_.measured_force() - model.force), noise.correlation);
    const MatrixXd J = whitened(model.slopes, noise.correlation);
    VectorXd weights(r.size());
    for (Index i = 0; i < r.size(); ++i) weights[i] = loss.weight(r[i] * r[i]) / noise.variance;
    MatrixXd H = J.transpose() * weights.asDiagonal() * J;
    VectorXd g = J.transpose() * weights.cwiseProduct(r);
    H(last, last) += 1 / model_.prior_variance();
    g[last] -= (result.p[last] - model_.prior_mean()) / model_.prior_variance();
    const MatrixXd T = freedom_.directions(result.p);
    H = (T.transpose() * H * T).eval();
    g = (T.transpose() * g).eval();
    double gained = -1;
    while (damping < 1e5 && evaluations < most_evaluations) {
      ++evaluations;
      MatrixXd damped = H;
      damped.diagonal() += damping * H.diagonal() + VectorXd::Constant(H.rows(), 1e-12);
      const VectorXd p = freedom_.moved(result.p, damped.ldlt().solve(g));
      const double next = cost(p, noise, cap);
      if (next < result.cost) {
        gained = result.cost - next;
        result.p = p;
        result.cost = next;
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

FitPoint Descent::at(const VectorXd& p, bool converged) const {
  const VectorXd residuals = model_.measured_force() - model_.force(layout_, p);
  const auto noise = noise_of(residuals, layout_.size());
  const double eta = p[layout_.stiffness()] - model_.prior_mean();
  const double value = log_likelihood(residuals, noise.correlation) - 0.5 * eta * eta / model_.prior_variance();
  return {layout_, p, noise, value, converged};
}

FitPoint Descent::refined(VectorXd p, double cap, int rounds) const {
  p = freedom_.permitted(p);
  bool converged = false;
  for (int round = 0; round < rounds; ++round) {
    const auto noise = noise_of(model_.measured_force() - model_.force(layout_, p), layout_.size());
    const auto step = descend(p, noise, cap);
    cap = least_squares;
    p = step.p;
    converged = step.converged;
  }
  return at(p, converged);
}

MatrixXd Descent::covariance(const FitPoint& point) const {
  const MatrixXd T = freedom_.directions(point.p);
  return MatrixXd(T.transpose() * information(model_, point) * T).inverse();
}

Descent::Step Descent::searched(Step from, const CorrelatedNoise& noise, const MatrixXd& errors,
                                std::span<const double> scales) const {
  const VectorXd deviations = errors.diagonal().cwiseMax(0).cwiseSqrt();
  const VectorXd inverse = deviations.cwiseMax(1e-300).cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> ellipsoid(inverse.asDiagonal() * errors * inverse.asDiagonal());
  for (const double scale : scales)
    for (Index axis = 0; axis < deviations.size(); ++axis) {
      const double length = std::sqrt(std::max(ellipsoid.eigenvalues()[axis], 0.0));
      for (const double sign : {-1.0, 1.0}) {
        const VectorXd step = sign * scale * length * deviations.cwiseProduct(ellipsoid.eigenvectors().col(axis));
        for (int i = 0; i < 10; ++i) {
          const VectorXd p = freedom_.moved(from.p, step);
          const double next = cost(p, noise);
          if (!(next < from.cost)) break;
          from.cost = next;
          from.p = p;
        }
      }
    }
  return from;
}

FitPoint Descent::polished(FitPoint point) const {
  Step best{point.p, cost(point.p, point.noise), point.converged};
  constexpr std::array scales{8.0, 4.0, 2.0, 1.0, 0.5, 0.25};
  for (int round = 0; round < 6; ++round) {
    const double before = best.cost;
    point.p = best.p;
    best = searched(best, point.noise, covariance(point), scales);
    const Step step = descend(best.p, point.noise, least_squares);
    if (step.cost < best.cost) best = step;
    constexpr double worthwhile = 0.1;  // of twice the log likelihood: a third of a standard error
    if (!(before - best.cost > worthwhile)) break;
  }
  return refined(best.p, least_squares, 1);
}

VectorXd levelled(const ForceModel& model, const FitPoint& point) {
  if (point.noise.correlation == 0) return point.p;
  const VectorXd residuals = model.measured_force() - model.force(point.layout, point.p);
  const CorrelatedNoise white{0, residuals.squaredNorm() / static_cast<double>(residuals.size())};
  return Descent(model, point.layout, Freedom::of_the_mean(point.layout)).descend(point.p, white, 3).p;
}

MatrixXd information(const ForceModel& model, const FitPoint& point) {
  const auto response = model.response(point.layout, point.p);
  const MatrixXd J = whitened(response.slopes, point.noise.correlation);
  MatrixXd H = J.transpose() * J / point.noise.variance;
  const Index last = point.layout.stiffness();
  H(last, last) += 1 / model.prior_variance();
  return H;
}

}  // namespace flexslip
