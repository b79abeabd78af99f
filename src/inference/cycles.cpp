#include "inference/cycles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Dense>

#include "data/order.h"
#include "fibre/elastica.h"
#include "fibre/elementary.h"
#include "fibre/limits.h"
#include "inference/mirror.h"
#include "inference/profile.h"

namespace flexslip {
namespace {

using namespace loops;
constexpr std::size_t least_points = 20;
constexpr std::size_t settling = 5;  // iterations after which it is fixed which points slide
constexpr std::size_t most_iterations = 40;

void require(bool holds, const char* what, double value) {
  if (!holds) throw std::invalid_argument(std::string(what) + ": " + std::to_string(value));
}

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Estimate root_mean_square(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  const double rms = std::sqrt(sum / static_cast<double>(values.size()));
  return normal_estimate(rms, rms / std::sqrt(2 * effective_count(values, values)));
}

// What the covariance of ln EI and a contact makes of an error.
double systematic(const std::array<double, 2>& slopes, const Eigen::Matrix2d& covariance) {
  const Eigen::Vector2d g(slopes[0], slopes[1]);
  return g.dot(covariance * g);
}

LoopCorner corner(const Point& point) { return {point.index, point.S, point.q}; }

void describe_corners(FrictionLoop& loop, std::span<const Point> points, std::size_t legs) {
  const auto starts = leg_starts(points, legs);
  loop.stick_advance = not_a_number;
  if (loop.loading) {
    const std::size_t first = starts[*loop.loading];
    const std::size_t last = starts[*loop.loading + 1];
    for (std::size_t i = first; i < last && !loop.start; ++i)
      if (points[i].slides) loop.start = corner(points[i]);
    if (last > first) loop.turn = corner(points[last - 1]);
  }
  if (!loop.unloading) return;
  const std::size_t first = starts[*loop.unloading];
  const std::size_t last = starts[*loop.unloading + 1];
  for (std::size_t i = first; i < last && !loop.slides_back; ++i)
    if (points[i].slides) loop.slides_back = corner(points[i]);
  if (!loop.slides_back) return;
  loop.end = corner(points[last - 1]);
  if (!loop.turn) return;
  const double half = 0.5 * (loop.turn->q + loop.slides_back->q);
  for (std::size_t i = first; i < last; ++i)
    if (points[i].q <= half) {
      loop.stick_advance = points[i].S - loop.turn->S;
      break;
    }
}

void describe_directions(FrictionLoop& loop, const Block& block, const Noise& noise,
                         const Eigen::Matrix2d& covariance) {
  const auto pairs = pair_directions(block);
  loop.places = pairs.S.size() >= least_pairs ? pairs.S.size() : 0;
  loop.correlation = {not_a_number, not_a_number, not_a_number, 0};
  if (loop.places == 0) return;
  const auto n = static_cast<double>(loop.places);
  const auto mean_with_error = [&](std::span<const double> values, std::span<const std::array<double, 2>> slopes) {
    std::array<double, 2> mean{};
    for (const auto& slope : slopes)
      for (std::size_t j = 0; j < 2; ++j) mean[j] += slope[j] / n;
    const double reading = noise.force * noise.force * mean_of(pairs.noise_of_unit) / (2 * n);
    return normal_estimate(mean_of(values), std::sqrt(systematic(mean, covariance) + reading));
  };
  loop.mu_in = mean_with_error(pairs.in, pairs.in_slopes);
  loop.mu_out = mean_with_error(pairs.out, pairs.out_slopes);
  std::vector<double> difference(loop.places);
  for (std::size_t i = 0; i < loop.places; ++i) difference[i] = pairs.in[i] - pairs.out[i];
  loop.rms_difference = root_mean_square(difference);
  const double mean = mean_of(difference);
  for (double& value : difference) value -= mean;
  const double spread = root_mean_square(difference).value;
  loop.mean_difference = normal_estimate(mean, spread / std::sqrt(effective_count(difference, difference)));
  std::vector<double> variance;
  variance.reserve(loop.places);
  for (const double unit : pairs.noise_of_unit) variance.push_back(noise.force * noise.force * unit);
  loop.correlation = correlate_bumps(pairs.S, pairs.in, pairs.out, variance);
}

// Lengths closer than what a measurement resolves would make a table steep for nothing.
void describe_table(FrictionLoop& loop, const Block& block, const Noise& noise, const Eigen::Matrix2d& covariance,
                    const Fibre& fibre) {
  const auto smoothed = smooth(block, noise);
  const double least_distance = std::max(block.range / 1000, 2e-6);
  for (std::size_t i = 0; i < block.rows.size(); ++i) {
    const double S = block.rows[i].S;
    if (!loop.table.S.empty() && S - loop.table.S.back() < least_distance) continue;
    loop.table.S.push_back(S);
    loop.table.mu.push_back(held_friction(fibre, smoothed.mu[i][0]));
    loop.error.push_back(
        std::sqrt(smoothed.variance[i] + systematic({smoothed.mu[i][1], smoothed.mu[i][2]}, covariance)));
  }
}

// The mean of the tables that reach a length.
FrictionTable common_table(std::span<const FrictionLoop> loops) {
  std::vector<Friction> frictions;
  std::vector<const FrictionTable*> tables;
  FrictionTable common;
  for (const auto& loop : loops) {
    if (loop.table.S.empty()) continue;
    frictions.push_back(Friction::table(loop.table));
    tables.push_back(&loop.table);
    common.S.insert(common.S.end(), loop.table.S.begin(), loop.table.S.end());
  }
  if (tables.empty()) return {};
  if (tables.size() == 1) return *tables.front();
  std::sort(common.S.begin(), common.S.end());
  const double least_distance = std::max((common.S.back() - common.S.front()) / 1000, 2e-6);
  std::vector<double> lengths;
  for (const double S : common.S)
    if (lengths.empty() || S - lengths.back() >= least_distance) lengths.push_back(S);
  common.S = lengths;
  common.mu.reserve(lengths.size());
  for (const double S : lengths) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < tables.size(); ++i) {
      if (S < tables[i]->S.front() || S > tables[i]->S.back()) continue;
      sum += frictions[i].at(S).mu;
      ++count;
    }
    common.mu.push_back(sum / count);
  }
  return common;
}

// Gives each mirrored loop a column for its contact, and the others that of the mirrored loop before (or else after) them.
std::size_t assign_contacts(std::span<LoopLegs> loops, const std::vector<bool>& mirrored) {
  std::size_t columns = 0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (mirrored[i]) ++columns;
    loops[i].column = columns > 0 ? columns - 1 : 0;
  }
  return std::max<std::size_t>(columns, 1);
}

std::vector<std::size_t> columns_of_legs(std::span<const LoopLegs> loops, std::size_t legs) {
  std::vector<std::size_t> columns(legs, 0);
  for (const auto& loop : loops) {
    if (loop.loading) columns[*loop.loading] = loop.column;
    if (loop.unloading) columns[*loop.unloading] = loop.column;
  }
  return columns;
}

std::vector<bool> find_mirrors(std::span<const Block> blocks) {
  std::vector<bool> mirrored;
  mirrored.reserve(blocks.size());
  for (const auto& block : blocks) mirrored.push_back(pair_directions(block).S.size() >= least_pairs);
  return mirrored;
}

LegMotion motion_of(const Point& point, Direction direction) {
  if (!point.slides) return LegMotion::stuck;
  return direction == Direction::loading ? LegMotion::in : LegMotion::out;
}

// A record calibrated by its mirrored loops, if it has any.
struct Fit {
  CyclesStatus status;
  Calibration calibration;
  Eigen::MatrixXd covariance;  // of ln EI and the contacts
  Noise noise;
  Estimate asymmetry;
  std::vector<Point> points;
  std::vector<Block> blocks;  // of each loop
};

std::vector<Mirror> select_mirrors(std::span<const Block> blocks, const std::vector<bool>& mirrored) {
  std::vector<Mirror> mirrors;
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (mirrored[i]) mirrors.push_back({pair_directions(blocks[i]), blocks[i].column, blocks[i].range});
  return mirrors;
}

// Takes the step of an estimate, shortened where it is too long for its linearisation; the step in standard errors.
double advance(Calibration& calibration, const NormalStep& estimate) {
  const auto unknowns = static_cast<Eigen::Index>(1 + calibration.contact.size());
  double shortening = std::min(1.0, 0.1 / std::abs(estimate.step[0]));
  for (Eigen::Index i = 1; i < unknowns; ++i) shortening = std::min(shortening, 0.01 / std::abs(estimate.step[i]));
  double largest = 0;
  for (Eigen::Index i = 0; i < unknowns; ++i) {
    double& unknown = i == 0 ? calibration.log_stiffness : calibration.contact[static_cast<std::size_t>(i - 1)];
    unknown += shortening * estimate.step[i];
    largest = std::max(largest, std::abs(estimate.step[i]) / std::sqrt(estimate.covariance(i, i)));
  }
  return largest;
}

// Far out, the loops shrink to a line in q, and any noise would make that look like symmetry.
bool is_far_out(const Calibration& calibration, const CyclesOptions& options) {
  return !(std::abs(calibration.log_stiffness) < 5 * options.stiffness_error) ||
         std::any_of(calibration.contact.begin(), calibration.contact.end(),
                     [&](double contact) { return !(std::abs(contact) < 5 * options.contact_error); });
}

// Also gives each loop the column of its contact.
Fit calibrate(const ReducedRecord& record, const Rig& rig, const CyclesOptions& options, std::span<const Leg> legs,
              std::vector<LoopLegs>& loops) {
  const double reading = reading_noise(record, legs);
  Fit fit{
      .status = CyclesStatus::too_few_points,
      .calibration = {0, {0}},
      .covariance = {},
      .noise = {reading, 1e-5, 0.01},  // no difference: nothing tells one without a mirror
      .asymmetry = normal_estimate(not_a_number, not_a_number),
      .points = locate(record, rig, options.least_deflection, legs, {0, {0}}, std::vector<std::size_t>(legs.size(), 0)),
      .blocks = {}};

  // As the record stands: which loops have a mirror, and is there anything to measure?
  mark_stuck(fit.points, legs, reading);
  const auto sliding =
      std::count_if(fit.points.begin(), fit.points.end(), [](const Point& point) { return point.slides; });
  if (static_cast<std::size_t>(sliding) < least_points) return fit;
  fit.blocks = make_blocks(fit.points, loops, legs.size(), reading);
  const auto mirrored = find_mirrors(fit.blocks);
  fit.calibration.contact.assign(assign_contacts(loops, mirrored), 0.0);
  const auto unknowns = static_cast<Eigen::Index>(1 + fit.calibration.contact.size());
  fit.covariance = Eigen::MatrixXd::Zero(unknowns, unknowns);
  fit.covariance.diagonal().setConstant(options.contact_error * options.contact_error);
  fit.covariance(0, 0) = options.stiffness_error * options.stiffness_error;
  fit.status = CyclesStatus::no_mirror;
  if (std::find(mirrored.begin(), mirrored.end(), true) == mirrored.end()) return fit;

  const auto columns = columns_of_legs(loops, legs.size());
  fit.status = CyclesStatus::not_converged;
  fit.noise.difference = 0.05;                  // a start at which neither noise nor bumps are ignored
  std::vector<bool> used(record.force.size());  // which points count, and which of them slide, once that is settled
  std::vector<bool> slides(record.force.size());
  for (std::size_t iteration = 0; iteration < most_iterations; ++iteration) {
    fit.points = locate(record, rig, options.least_deflection, legs, fit.calibration, columns);
    if (iteration < settling) {
      mark_stuck(fit.points, legs, reading);
      std::fill(used.begin(), used.end(), false);
      for (const auto& point : fit.points) {
        used[point.index] = true;
        slides[point.index] = point.slides;
      }
    } else {
      fit.points.erase(
          std::remove_if(fit.points.begin(), fit.points.end(), [&](const Point& point) { return !used[point.index]; }),
          fit.points.end());
      for (auto& point : fit.points) point.slides = slides[point.index];
    }
    fit.blocks = make_blocks(fit.points, loops, legs.size(), reading);
    const auto mirrors = select_mirrors(fit.blocks, mirrored);
    double range = std::numeric_limits<double>::max();
    for (const auto& mirror : mirrors) range = std::min(range, mirror.range);
    if (!(range > 0)) return fit;
    const Estimator estimator(mirrors, fit.calibration, options);
    // Far from symmetry, all of the difference would be taken for roughness: so not at once. And no longer than a quarter of
    // a loop, where it would be a trend, and EI and contact explain trends.
    if (iteration >= 3 && iteration < settling + 3)
      fit.noise = likely_noise(estimator, fit.noise, reading, range / 100, range / 4);
    const auto estimate = estimator.estimate(fit.noise, 0);
    if (!estimate.step.allFinite()) return fit;
    const auto with_asymmetry = estimator.estimate(fit.noise, 1);
    const double largest = advance(fit.calibration, estimate);
    if (is_far_out(fit.calibration, options)) return fit;
    // Points that fall to one place or its neighbour in turn may keep the steps from going below a fraction of an error.
    if ((iteration > settling + 2 && largest < 1e-3) || (iteration > settling + 10 && largest < 0.3)) {
      fit.status = CyclesStatus::ok;
      fit.covariance = estimate.covariance;
      fit.asymmetry =
          normal_estimate(with_asymmetry.step[unknowns], std::sqrt(with_asymmetry.covariance(unknowns, unknowns)));
      return fit;
    }
  }
  return fit;
}

}  // namespace

DirectionMeans direction_means(const CyclicFriction& friction) {
  double places = 0, in = 0, out = 0, square = 0;
  for (const FrictionLoop& loop : friction.loops) {
    if (loop.places == 0) continue;
    const auto weight = static_cast<double>(loop.places);
    places += weight;
    in += weight * loop.mu_in.value;
    out += weight * loop.mu_out.value;
    square += weight * loop.rms_difference.value * loop.rms_difference.value;
  }
  return {in / places, out / places, std::sqrt(square / places)};
}

bool is_beyond_friction(const CyclicFriction& friction) {
  constexpr double two_sided = 1.96;  // standard errors to the ends of a 95 % interval
  const auto [in, out, rms] = direction_means(friction);
  const auto& [value, error, low, high] = friction.asymmetry;
  return std::abs(value) > 0.5 * (in + out) && std::abs(value) > two_sided * error;
}

CyclicFriction measure_cycles(const ReducedRecord& record, const Rig& rig, const CyclesOptions& options) {
  const std::size_t n = record.force.size();
  if (record.stage.size() != n || record.deflection.size() != n)
    throw std::invalid_argument(
        "the columns of a record must be of one length: " + std::to_string(record.stage.size()) + ", " +
        std::to_string(record.deflection.size()) + " and " + std::to_string(n));
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(record.deflection[i]) || !std::isfinite(record.force[i]))
      throw std::invalid_argument("point " + std::to_string(i) + " of the record is not finite");
  require(rig.stiffness > 0, "the stiffness of the load train must be > 0", rig.stiffness);
  require(options.stiffness_error > 0, "the error of ln EI must be > 0", options.stiffness_error);
  require(options.contact_error > 0, "the error of the contact must be > 0", options.contact_error);
  require(options.least_deflection > 0, "the least deflection must be > 0", options.least_deflection);

  CyclicFriction result{.status = CyclesStatus::too_few_points,
                        .legs = find_legs(record.stage, options.legs),
                        .points = {},
                        .loops = {},
                        .log_stiffness = normal_estimate(0, options.stiffness_error),
                        .asymmetry = normal_estimate(not_a_number, not_a_number),
                        .correlation = {not_a_number, not_a_number, not_a_number, 0},
                        .force_noise = 0,
                        .roughness_noise = 0,
                        .roughness_length = 0,
                        .table = {}};
  const auto& legs = result.legs;
  auto loops = pair_legs(legs);
  const auto fit = calibrate(record, rig, options, legs, loops);
  if (fit.status == CyclesStatus::too_few_points || fit.status == CyclesStatus::not_converged) {
    result.status = fit.status;
    return result;
  }

  const bool calibrated = fit.status == CyclesStatus::ok;
  const auto& covariance = fit.covariance;
  result.status = fit.status;
  result.log_stiffness = normal_estimate(fit.calibration.log_stiffness, std::sqrt(covariance(0, 0)));
  result.asymmetry = fit.asymmetry;
  result.force_noise = fit.noise.force;
  result.roughness_noise = calibrated ? fit.noise.difference : not_a_number;
  result.roughness_length = calibrated ? fit.noise.length : not_a_number;
  const auto covariance_with = [&](std::size_t column) {
    const auto at = static_cast<Eigen::Index>(column) + 1;
    Eigen::Matrix2d block;
    block << covariance(0, 0), covariance(0, at), covariance(at, 0), covariance(at, at);
    return block;
  };
  const auto columns = columns_of_legs(loops, legs.size());
  result.points.reserve(fit.points.size());
  for (const auto& point : fit.points)
    result.points.push_back({.index = point.index,
                             .leg = point.leg,
                             .S = point.S,
                             .q = point.q,
                             .standard_error = std::sqrt(std::pow(fit.noise.force * point.q_force, 2) +
                                                         systematic({point.q_log_stiffness, point.q_contact},
                                                                    covariance_with(columns[point.leg]))),
                             .motion = motion_of(point, legs[point.leg].direction)});
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(loops[i].column) + 1;
    FrictionLoop loop{
        .loading = loops[i].loading,
        .unloading = loops[i].unloading,
        .contact = normal_estimate(fit.calibration.contact[loops[i].column], std::sqrt(covariance(at, at))),
        .start = {},
        .turn = {},
        .slides_back = {},
        .end = {},
        .stick_advance = not_a_number,
        .places = 0,
        .mu_in = normal_estimate(not_a_number, not_a_number),
        .mu_out = normal_estimate(not_a_number, not_a_number),
        .mean_difference = normal_estimate(not_a_number, not_a_number),
        .rms_difference = normal_estimate(not_a_number, not_a_number),
        .correlation = {},
        .table = {},
        .error = {}};
    const auto errors = covariance_with(loops[i].column);
    describe_corners(loop, fit.points, legs.size());
    describe_directions(loop, fit.blocks[i], fit.noise, errors);
    describe_table(loop, fit.blocks[i], fit.noise, errors, rig.fibre);
    result.loops.push_back(std::move(loop));
  }
  std::vector<BumpCorrelation> correlations;
  for (const FrictionLoop& loop : result.loops) correlations.push_back(loop.correlation);
  result.correlation = together(correlations);
  result.table = common_table(result.loops);
  return result;
}

}  // namespace flexslip
