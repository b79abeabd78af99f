#include "inference/loading_forces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <Eigen/LU>

#include "inference/pass_rows.h"
#include "inference/pass_unknowns.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// [EI/L^2] The mean force of a pass near a deflection [L]; NaN without rows there.
double force_near(const ReducedRecord& record, const Leg& leg, double w, double reach,
                  const std::vector<char>& left_out) {
  double sum = 0, count = 0;
  for (std::size_t i = leg.first; i < leg.last; ++i)
    if (!left_out[i] && std::abs(record.deflection[i] - w) < reach) {
      sum += record.force[i];
      ++count;
    }
  return count > 0 ? sum / count : not_a_number;
}

double deepest_of(const ReducedRecord& record, const Leg& leg) {
  const auto begin = record.deflection.begin();
  return *std::max_element(begin + static_cast<std::ptrdiff_t>(leg.first),
                           begin + static_cast<std::ptrdiff_t>(leg.last));
}

// [1] The share of the loss of the earlier loading that occurs beyond a deflection. It follows from
// the losses that the drops require as cracks; without drops, the loss is proportional to the
// deflection.
class StillToCome {
 public:
  StillToCome(const PassesProblem& problem, const Leg& leg, double deepest) : deepest_(deepest) {
    for (const NeededLoss& drop : losses_needed(problem.record, problem.drops, problem.rig.fibre))
      if (is_in(leg, drop.before)) {
        w_.push_back(problem.record.deflection[drop.before]);
        losses_.push_back(drop.log_loss);
        all_ += drop.log_loss;
      }
  }

  double all() const { return all_; }

  double at(double w) const {
    if (!(all_ > 0)) return std::clamp(1 - w / deepest_, 0.0, 1.0);
    double come = 0;
    for (std::size_t i = 0; i < w_.size(); ++i)
      if (w_[i] < w) come += losses_[i];
    return std::max(1 - come / all_, 0.0);
  }

 private:
  double deepest_;
  std::vector<double> w_, losses_;
  double all_ = 0;
};

// Two loadings at one deflection.
struct Pair {
  double w, before, after;  // [L], [EI/L^2] forces
};

std::vector<Pair> pairs_of(const PassesProblem& problem, const Leg& before, const Leg& after,
                           const std::vector<char>& left_out, double common) {
  constexpr double from = 0.15, up_to = 0.95;  // [common deflection]
  constexpr int places = 40;
  std::vector<Pair> pairs;
  for (int i = 0; i < places; ++i) {
    const double w = common * (from + (up_to - from) * (i + 0.5) / places), reach = common * (up_to - from) / places;
    const Pair pair{w, force_near(problem.record, before, w, reach, left_out),
                    force_near(problem.record, after, w, reach, left_out)};
    if (pair.after / pair.before > 0) pairs.push_back(pair);
  }
  return pairs;
}

using Unknowns = Eigen::Vector<double, 5>;

// The stiffness lost between two loadings, by least squares of
//   ln(F2/F1) = -Λ h - Λ' - d h F_w/F - c F_w/F + v q F_q/F,
// where h is the share still to come. The unknowns are the loss Λ in the loading and Λ' after it,
// the settling d, the change c of the contact and the change v of ln(friction). Where friction
// cannot be determined, F_w/F is 1/w and the last term is omitted.
std::optional<Estimate> loss_between(const PassesProblem& problem, const Leg& before, const Leg& after,
                                     const std::vector<char>& left_out, const StillToCome& still_to_come,
                                     double common) {
  const std::vector<Pair> pairs = pairs_of(problem, before, after, left_out, common);
  constexpr std::size_t independent = 8;
  if (pairs.size() < independent) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(pairs.size());
  Eigen::VectorXd w(count), F(count), y(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Pair& pair = pairs[static_cast<std::size_t>(i)];
    w[i] = pair.w, F[i] = pair.before, y[i] = elementary::log(pair.after / pair.before);
  }
  const PassStates read = states_read(w, F, problem.rig.fibre);
  Eigen::MatrixXd slopes(count, 5);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double still = still_to_come.at(w[i]);
    const double by_w = read.is_read(i) ? read.F_w[i] / F[i] : 1 / w[i];
    const double by_friction = read.is_read(i) ? read.q[i] * read.F_q[i] / F[i] : 0;
    slopes.row(i) << -still, -1, -still * by_w, -by_w, by_friction;
  }
  constexpr double least = 0.003;  // [1] of the scatter
  const PassesOptions& options = problem.options;
  constexpr double any = 100, behind = 0.2;  // prior standard deviations of Λ, which is free, and Λ'
  const double of_gain = elementary::length(options.of_forces, options.stiffening);
  const Unknowns errors(any, behind, options.settling, options.contact_change, options.level_at_bottom);
  double variance = least * least;
  Unknowns solution = Unknowns::Zero();
  Eigen::Matrix<double, 5, 5> covariance;
  for (int again = 0; again < 4; ++again) {
    const double weight = independent / static_cast<double>(count) / variance;
    Unknowns prior = errors;
    for (const Eigen::Index loss : {0, 1})
      if (solution[loss] < 0) prior[loss] = of_gain;  // no specimen stiffens
    Eigen::Matrix<double, 5, 5> precision = weight * slopes.transpose() * slopes;
    precision.diagonal() += prior.array().pow(-2).matrix();
    covariance = precision.inverse();
    solution = covariance * (slopes.transpose() * y) * weight;
    variance = std::max((y - slopes * solution).squaredNorm() / static_cast<double>(count), least * least);
  }
  const double log_loss = solution[0] + solution[1];
  const double log_loss_variance = covariance(0, 0) + covariance(1, 1) + 2 * covariance(0, 1);
  constexpr double alike = 0.1;  // [1] a larger scatter means that the loadings are not comparable
  if (variance > alike * alike) return std::nullopt;
  constexpr double broken = 0.1;  // [1] remaining stiffness below which loadings are not compared
  const double left = elementary::exp(-log_loss);
  if (left < broken) return std::nullopt;
  constexpr double of_loss = 0.25;  // [1] of the loss, because its course is uncertain
  const double error =
      elementary::length(elementary::length(std::sqrt(log_loss_variance), of_loss * log_loss), options.of_forces);
  constexpr double vague = 0.3;  // limit of the error
  if (error > vague) return std::nullopt;
  return normal_estimate(1 - left, left * error);
}

}  // namespace

std::optional<LoadingForces> compare_loading_forces(const PassesProblem& problem, const std::vector<Leg>& legs,
                                                    const std::vector<char>& left_out) {
  constexpr std::size_t enough = 10;  // rows of a loading
  const Leg* evaluated = nullptr;
  const Leg* other = nullptr;
  for (const Leg& leg : legs) {
    if (leg.direction != Direction::loading || leg.last - leg.first < enough) continue;
    if (is_in(leg, problem.first))
      evaluated = &leg;
    else if (evaluated || !other)
      other = &leg;
  }
  if (!evaluated || !other) return std::nullopt;
  const bool is_followed = other->first > evaluated->first;
  const Leg& before = is_followed ? *evaluated : *other;
  const Leg& after = is_followed ? *other : *evaluated;
  const double common = std::min(deepest_of(problem.record, before), deepest_of(problem.record, after));
  const StillToCome still_to_come(problem, before, common);
  const auto loss = loss_between(problem, before, after, left_out, still_to_come, common);
  if (!loss) return std::nullopt;
  return LoadingForces{is_followed, *loss, is_followed ? 1 - elementary::exp(-still_to_come.all()) : 0};
}

}  // namespace flexslip
