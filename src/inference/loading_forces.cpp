#include "inference/loading_forces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include "inference/pass_rows.h"
#include "inference/pass_unknowns.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// [EI/L^2] The mean force of a pass near a deflection [L]; NaN where it has no row there.
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

// The loss between two loadings by their forces at the same deflections, friction being what it was: ln(F2/F1) = ln(1 - loss) + c/w, c being the
// difference of the contacts and what settled.
std::optional<Estimate> loss_between(const PassesProblem& problem, const Leg& before, const Leg& after,
                                     const std::vector<char>& left_out) {
  const ReducedRecord& record = problem.record;
  const auto deepest = [&](const Leg& leg) {
    const auto begin = record.deflection.begin();
    return *std::max_element(begin + static_cast<std::ptrdiff_t>(leg.first),
                             begin + static_cast<std::ptrdiff_t>(leg.last));
  };
  const double common = std::min(deepest(before), deepest(after));
  constexpr double from = 0.3, up_to = 0.95;  // [common deflection]
  constexpr int places = 30, independent = 8;
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  double squares = 0, count = 0;
  for (int i = 0; i < places; ++i) {
    const double w = common * (from + (up_to - from) * (i + 0.5) / places), reach = common * (up_to - from) / places;
    const double ratio = force_near(record, after, w, reach, left_out) / force_near(record, before, w, reach, left_out);
    if (!(ratio > 0)) continue;
    const Eigen::Vector2d of_row(1, 1 / w);
    const double y = elementary::log(ratio);
    A += of_row * of_row.transpose();
    b += y * of_row;
    squares += y * y;
    ++count;
  }
  if (count < independent) return std::nullopt;
  constexpr double least = 0.003;  // [1] of the scatter
  const double of_contact = elementary::length(problem.options.contact_change, problem.options.settling);
  const double of_gain = elementary::length(problem.options.of_forces, problem.options.stiffening);
  double variance = least * least;
  Eigen::Vector2d solution(0, 0);
  Eigen::Matrix2d covariance;
  for (int again = 0; again < 4; ++again) {
    Eigen::Matrix2d precision = A * (independent / count / variance);
    precision(1, 1) += 1 / (of_contact * of_contact);
    if (solution[0] > 0) precision(0, 0) += 1 / (of_gain * of_gain);
    const double determinant = precision(0, 0) * precision(1, 1) - precision(0, 1) * precision(1, 0);
    covariance << precision(1, 1), -precision(0, 1), -precision(1, 0), precision(0, 0);
    covariance /= determinant;
    solution = covariance * b * (independent / count / variance);
    const double left_over = squares - 2 * solution.dot(b) + solution.dot(A * solution);
    variance = std::max(left_over / count, least * least);
  }
  constexpr double alike = 0.1;  // [1] loadings that scatter by more about a loss and a shift are not of one friction
  if (variance > alike * alike) return std::nullopt;
  constexpr double broken = 0.1;  // [1] of the stiffness: with less left there is nothing to compare
  const double left = elementary::exp(solution[0]);
  if (left < broken) return std::nullopt;
  return normal_estimate(1 - left, left * elementary::length(std::sqrt(covariance(0, 0)), problem.options.of_forces));
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
  const auto loss = is_followed ? loss_between(problem, *evaluated, *other, left_out)
                                : loss_between(problem, *other, *evaluated, left_out);
  if (!loss) return std::nullopt;
  double needs = 0;
  for (const NeededLoss& drop : losses_needed(problem.record, problem.drops, problem.rig.fibre))
    if (is_in(*evaluated, drop.before)) needs += drop.log_loss;
  return LoadingForces{is_followed, *loss, is_followed ? 1 - elementary::exp(-needs) : 0};
}

}  // namespace flexslip
