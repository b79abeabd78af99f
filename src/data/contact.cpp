#include "data/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

// The line through the points between two fractions of the maximum force, on the first rise.
InitialLine line_between(const Record& record, double from, double up_to) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Estimate unknown{nan, nan, nan, nan};
  const auto failed = [=](ContactStatus status) { return InitialLine{status, unknown, unknown, 0, 0, false}; };
  if (record.force.size() < 5) return failed(ContactStatus::too_few_points);

  const double max_force = *std::max_element(record.force.begin(), record.force.end());
  if (!(max_force > 0)) return failed(ContactStatus::not_rising);
  std::size_t last = 0;
  while (last < record.force.size() && record.force[last] <= up_to * max_force) ++last;
  std::size_t first = last;
  while (first > 0 && record.force[first - 1] >= from * max_force) --first;
  const std::size_t n = last - first;
  if (n < 5) return failed(ContactStatus::too_few_points);

  const auto stage = std::span(record.stage).subspan(first, n);
  const auto deflection = std::span(record.deflection).subspan(first, n);
  const auto force = std::span(record.force).subspan(first, n);
  const CommonLine line = common_line(stage, force, deflection);
  if (std::isnan(line.slope)) return failed(ContactStatus::not_rising);

  constexpr double max_correlation = 0.95;  // beyond it the region is too short
  // Residuals of force = a (stage - offset) give the error of the offset. Residuals of force =
  // slope (deflection - offset) give the error of the slope.
  const Line& by_stage = line.y;
  std::vector<double> off_stage(n);
  for (std::size_t i = 0; i < n; ++i)
    off_stage[i] = force[i] - by_stage.mean_y - by_stage.slope * (stage[i] - by_stage.mean_x);
  // [m] from the contact to the middle of the points
  const double lever = by_stage.mean_y / by_stage.slope;
  const double offset = by_stage.mean_x - lever;
  const auto freedom = static_cast<double>(n - 2);
  return {.status = ContactStatus::found,
          .offset = student_estimate(offset,
                                     effective_deviation(off_stage, 2, 0, max_correlation) / by_stage.slope *
                                         std::sqrt(1 / static_cast<double>(n) + lever * lever / by_stage.sum_xx),
                                     freedom),
          .slope = student_estimate(line.slope, slope_error(line, 0, max_correlation), freedom),
          .first = first,
          .last = last,
          .settles = false};
}

}  // namespace

InitialLine initial_line(const Record& record) {
  constexpr double from = 0.02;  // [maximum force]
  double up_to = 0.15;
  InitialLine contact = line_between(record, from, up_to);
  for (const double farther : {0.2, 0.25, 0.3}) {
    if (contact.status != ContactStatus::too_few_points) break;
    up_to = farther;
    contact = line_between(record, from, up_to);
  }
  if (contact.status != ContactStatus::found) return contact;
  // A settling contact stiffens: the upper half of the line extrapolates to zero force later.
  const double middle = 0.5 * (from + up_to);
  const InitialLine lower = line_between(record, from, middle), upper = line_between(record, middle, up_to);
  if (lower.status != ContactStatus::found || upper.status != ContactStatus::found) return contact;
  constexpr double min_errors = 4;  // standard errors
  if (upper.offset.value - lower.offset.value <
      min_errors * elementary::length(lower.offset.standard_error, upper.offset.standard_error))
    return contact;
  const double above = 2 * up_to - from;
  InitialLine settled = line_between(record, middle, above);
  const InitialLine farther = line_between(record, up_to, above);
  if (settled.status != ContactStatus::found || farther.status != ContactStatus::found) return contact;
  const double choice = std::max(std::abs(farther.offset.value - settled.offset.value),
                                 std::abs(settled.offset.value - contact.offset.value));
  settled.offset = student_estimate(settled.offset.value, elementary::length(settled.offset.standard_error, choice),
                                    static_cast<double>(settled.last - settled.first - 2));
  settled.settles = true;
  return settled;
}

namespace {

// [noise] exceeded by one in 16,000 rows of a constant force
constexpr double band = 4;
constexpr std::size_t min_before_contact = 10;  // [rows] needed for an offset and its error
// between neighbouring rows, to determine the error of a mean
constexpr double max_correlation = 0.95;

// The number of first rows with a force within the band about the mean of the rows before.
std::size_t level_rows(std::span<const double> force, double noise) {
  double sum = force.front();
  for (std::size_t n = 1; n < force.size(); ++n) {
    const auto before = static_cast<double>(n);
    if (std::abs(force[n] - sum / before) > band * noise * std::sqrt(1 + 1 / before)) return n;
    sum += force[n];
  }
  return force.size();
}

}  // namespace

ForceZero find_force_zero(std::span<const double> displacement, std::span<const double> force, double noise) {
  if (displacement.size() != force.size())
    throw std::invalid_argument("columns of " + std::to_string(displacement.size()) + " and " +
                                std::to_string(force.size()) + " points");
  if (!(noise >= 0)) throw std::invalid_argument("noise = " + std::to_string(noise) + " N is negative");
  const ForceZero none{ForceZeroStatus::no_free_rows, 0, 0, 0};
  if (force.size() < min_before_contact) return none;

  const std::size_t level = level_rows(force, noise);
  if (level < min_before_contact || level == force.size()) return none;
  // The force that the travel of these rows would have added at the mean slope after them.
  const auto greatest = static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
  const double free_way = displacement[level - 1] - displacement.front();
  const double rising_way = displacement[greatest] - displacement[level - 1];
  if (!(greatest >= level && free_way > 0 && rising_way > 0)) return none;
  const double rise = (force[greatest] - force[level - 1]) * free_way / rising_way;
  if (!(rise > 2 * band * noise)) return none;

  const double half = displacement.front() + 0.5 * free_way;
  const auto points = std::max<std::size_t>(
      min_before_contact / 2, static_cast<std::size_t>(std::find_if(displacement.begin(), displacement.end(),
                                                                    [=](double x) { return x > half; }) -
                                                       displacement.begin()));
  const auto free = force.first(std::min(points, level));
  const auto n = static_cast<double>(free.size());
  const double mean = mean_of(free);
  std::vector<double> residuals(free.begin(), free.end());
  for (double& residual : residuals) residual -= mean;
  const double scatter = effective_deviation(residuals, 1, 1 / n, max_correlation);
  return {ForceZeroStatus::found, mean, std::max(scatter, noise) / std::sqrt(n), free.size()};
}

double Baseline::at(double displacement) const {
  const double way = displacement - begin;
  return level + slope * way + settles_by * elementary::exp(-std::max(way, 0.0) / settling);
}

namespace {

// The number of rows before contact.
std::size_t rows_before_contact(std::span<const double> displacement, std::span<const double> force) {
  const double max_force = *std::max_element(force.begin(), force.end());
  Line level{.mean_x = 0, .mean_y = force.front(), .slope = 0, .sum_xx = 0};
  std::size_t before = 0;
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    constexpr double from = 0.05, up_to = 0.2;
    const auto over = [&](std::size_t i) {
      return force[i] - level.mean_y - level.slope * (displacement[i] - level.mean_x);
    };
    std::size_t last = 0;
    while (last < force.size() && over(last) <= up_to * max_force) ++last;
    std::size_t first = last;
    while (first > 0 && over(first - 1) >= from * max_force) --first;
    if (last - first < 3 || first < min_before_contact) return 0;
    const Line rise = line_through(
        last - first, [&](std::size_t i) { return displacement[first + i]; },
        [&](std::size_t i) { return over(first + i); });
    if (!(rise.slope > 0)) return 0;
    const double contact = rise.mean_x - rise.mean_y / rise.slope;
    const double margin = 0.5 * (displacement[first] - contact);  // the curve bends at contact
    before = static_cast<std::size_t>(std::lower_bound(displacement.begin(), displacement.end(), contact - margin) -
                                      displacement.begin());
    if (before < min_before_contact) return 0;
    level = line_through(displacement.first(before), force.first(before));
  }
  return before;
}

}  // namespace

Baseline find_baseline(std::span<const double> displacement, std::span<const double> force) {
  const std::size_t n = rows_before_contact(displacement, force);
  if (n == 0) return {};
  const double begin = displacement.front(), way = displacement[n - 1] - begin;
  Baseline best;
  double smallest = infinity;
  const auto try_it = [&](const auto& shape, double settling) {
    const Line line = line_through(
        n, [&](std::size_t i) { return shape(displacement[i] - begin); }, [&](std::size_t i) { return force[i]; });
    std::vector<double> residuals(n);
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) {
      residuals[i] = force[i] - line.mean_y - line.slope * (shape(displacement[i] - begin) - line.mean_x);
      squares += residuals[i] * residuals[i];
    }
    constexpr double max_ratio = 0.97;  // an exponential must fit better than a line
    if (!(squares < max_ratio * smallest)) return;
    smallest = squares;
    const double lost = correlation_lost_to_line(residuals);
    const double range = shape(way) - shape(0);
    const bool is_line = settling == 0;
    best = {
        .points = n,
        .begin = begin,
        .level = line.mean_y - line.slope * line.mean_x,
        .slope = is_line ? line.slope : 0,
        .settles_by = is_line ? 0 : line.slope,
        .settling = is_line ? 1 : settling,
        .change = line.slope * range,
        .error = std::abs(range) * effective_deviation(residuals, 2, lost, max_correlation) / std::sqrt(line.sum_xx)};
  };
  try_it([](double x) { return x; }, 0);
  for (const double share : {0.03, 0.06, 0.12, 0.25, 0.5}) {
    const double settling = share * way;
    try_it([=](double x) { return elementary::exp(-x / settling); }, settling);
  }
  constexpr double min_errors = 6;
  return std::abs(best.change) > min_errors * best.error ? best : Baseline{};
}

bool is_significant(const ForceZero& zero) {
  return zero.status == ForceZeroStatus::found && std::abs(zero.offset) > 4 * zero.error;
}

}  // namespace flexslip
