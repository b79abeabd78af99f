#include "inference/cycles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "bending_test/rig.h"
#include "data/record.h"
#include "fibre/elastica.h"
#include "inference/profile.h"
#include "numerics/dense.h"
#include "numerics/elementary.h"
#include "numerics/require.h"
#include "numerics/state_space.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

// The points of a cyclic record, each as friction at a length of the fibre, for some bending stiffness and contact: which loop they belong
// to, and whether the fibre slides there.

struct Calibration {
  double log_stiffness;
  std::vector<double> contact;  // [L] of each column
};

// A point of the record under a calibration, with the slopes of q.
struct Point {
  std::size_t index, leg;
  double stage, S, q;  // contact taken off; true scales
  double q_log_stiffness, q_contact, q_force;
  double stick_rate;  // dq/d(stage) at fixed S
  bool slides;
};

// A loading and the unloading after it.
struct LoopLegs {
  std::optional<std::size_t> loading, unloading;
  std::size_t column;  // of its contact
};

// The points of a loop that slide, by length: as both directions at the same places, and as one friction that all of them support.

constexpr double min_noise = 1e-9;  // [1] of q: keeps the filter regular for records without noise

// Sorted by S: one loop's points that slide.
struct SlidingRow {
  double side;                 // +1 in, -1 out
  double S, variance_of_unit;  // of y, for force noise 1
  std::array<double, 3> y;     // side q, and its regressors: ln EI, contact
};
struct Block {
  std::vector<SlidingRow> rows;
  std::size_t column;
  double roughness;  // [1/L] variance of μ per length
  double range;      // [L]
};

// Of a force reading [EI/L^2], and of the difference of the directions [1] with its correlation length [L].
struct Noise {
  double force, difference, length;
};

// Both directions at the same places.
struct Pairs {
  std::vector<double> S, in, out;
  std::vector<std::array<double, 2>> in_slopes, out_slopes;  // of μ to ln EI and contact
  std::vector<double> noise_of_unit;                         // variance of in - out, for force noise 1
};

// Bending stiffness and contacts at which loading and unloading are mirror images: by least squares, and the noise by its likelihood.

// A step of the unknowns: ln EI, the contacts, and the mean difference of the directions if that is asked for.
struct NormalStep {
  Eigen::VectorXd step;
  Eigen::MatrixXd covariance;
  double objective;  // -2 log of the restricted likelihood
};

// A loop whose directions passed the same places.
struct Mirror {
  Pairs places;
  std::size_t column;  // of the contact
  double range;        // [L]
};

// Least squares over all mirrored loops in ln EI, the contacts and, with `differences` = 1, the mean difference of the directions.
class Estimator {
 public:
  Estimator(std::span<const Mirror> mirrors, const Calibration& calibration, const CyclesOptions& options)
      : mirrors_(mirrors), calibration_(calibration), options_(options) {}

  NormalStep estimate(const Noise& noise, Eigen::Index differences) const;

 private:
  std::span<const Mirror> mirrors_;
  const Calibration& calibration_;
  const CyclesOptions& options_;
};
// Slope of q on the stage over points [first, last); NaN where the stage stands still.
double slope_of_q(std::span<const Point> points, std::size_t first, std::size_t last) {
  // From the first position on: where the stage stands still, all are zero, and so is their mean.
  const auto travel = [&](std::size_t i) { return points[first + i].stage - points[first].stage; };
  const Line line = line_through(last - first, travel, [&](std::size_t i) { return points[first + i].q; });
  return line.sum_xx > 0 ? line.slope : not_a_number;
}

// That of nothing is 0.
double median_or_zero(std::vector<double> values) { return values.empty() ? 0 : median_of(std::move(values)); }

// Standard deviation of one reading, within the legs: a turn is no noise.
double reading_noise(const ReducedRecord& record, std::span<const Leg> legs) {
  std::vector<double> bends;
  for (const auto& leg : legs) {
    const auto of_leg = second_differences(std::span(record.force).subspan(leg.first, leg.last - leg.first));
    bends.insert(bends.end(), of_leg.begin(), of_leg.end());
  }
  return noise_of_second_differences(std::move(bends));
}

std::vector<LoopLegs> pair_legs(std::span<const Leg> legs) {
  std::vector<LoopLegs> loops;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].direction == Direction::loading)
      loops.push_back({i, std::nullopt, loops.size()});
    else if (loops.empty())
      loops.push_back({std::nullopt, i, 0});
    else
      loops.back().unloading = i;
  }
  return loops;
}

// Where a force shows that the nose is on the specimen: one that was bent far stays drawn in, and the nose leaves it on the way back.
struct Bounds {
  double min_deflection, min_force;  // [L], [EI/L^2]
};

// The points of a record under a calibration; `columns` are the contacts of its legs.
std::vector<Point> locate(const ReducedRecord& record, const Rig& rig, const Bounds& bounds, std::span<const Leg> legs,
                          const Calibration& calibration, std::span<const std::size_t> columns) {
  const double scale = elementary::exp(-calibration.log_stiffness);  // of forces
  const double c = 1 / (rig.stiffness * scale);
  std::vector<Point> points;
  std::vector<double> w, F;
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    const double contact = calibration.contact[columns[leg]];
    for (std::size_t i = legs[leg].first; i < legs[leg].last; ++i) {
      const double deflection = record.deflection[i] - contact;
      if (!(deflection > bounds.min_deflection && record.force[i] > bounds.min_force)) continue;
      Point& point = points.emplace_back();
      point.index = i;
      point.leg = leg;
      point.stage = record.stage[i] - contact;
      point.slides = true;
      w.push_back(deflection);
      F.push_back(record.force[i] * scale);
    }
  }
  const InverseArrays found = rig.fibre.states_from_forces(w, F);
  std::vector<double> S, q, forces;
  std::size_t left = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (std::isnan(found.q[k])) continue;
    points[left++] = points[k];
    S.push_back(found.S[k]);
    q.push_back(found.q[k]);
    forces.push_back(F[k]);
  }
  points.resize(left);
  const SlopeArrays at = rig.fibre.states_slopes({S, q});
  for (std::size_t k = 0; k < points.size(); ++k) {
    // The inverse of the Jacobian of Ψ: its second row.
    const double jacobian = at.w_S[k] * at.F_q[k] - at.w_q[k] * at.F_S[k];
    const double q_F = at.w_S[k] / jacobian;
    const double q_w = -at.F_S[k] / jacobian;
    Point& point = points[k];
    point.S = S[k];
    point.q = q[k];
    point.q_log_stiffness = -forces[k] * q_F;
    point.q_contact = -q_w;
    point.q_force = (q_F - q_w * c) * scale;  // at the stage position imposed
    point.stick_rate = 1 / (at.w_q[k] + c * at.F_q[k]);
  }
  return points;
}

// Of each leg the first point in `points`, and the end.
std::vector<std::size_t> leg_starts(std::span<const Point> points, std::size_t legs) {
  std::vector<std::size_t> starts;
  starts.reserve(legs + 1);
  for (std::size_t leg = 0; leg <= legs; ++leg)
    starts.push_back(static_cast<std::size_t>(
        std::partition_point(points.begin(), points.end(), [&](const Point& point) { return point.leg < leg; }) -
        points.begin()));
  return starts;
}

// Marks the points that stick after the turn at which a leg begins, if the fibre was in contact there. A record that begins by
// unloading begins at a turn.
void mark_stuck(std::vector<Point>& points, std::span<const Leg> legs, double force_noise) {
  const auto starts = leg_starts(points, legs.size());
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    const std::size_t first = starts[leg];
    const std::size_t last = starts[leg + 1];
    if (first == last || points[first].index != legs[leg].first) continue;
    if (leg == 0 && legs[leg].direction == Direction::loading) continue;
    if (leg > 0 && (first == 0 || points[first - 1].index + 1 != legs[leg].first)) continue;
    const Point& turn = points[leg > 0 ? first - 1 : first];
    const double rate = turn.stick_rate;
    std::vector<double> steps;
    for (std::size_t i = first + 1; i < last; ++i) steps.push_back(std::abs(points[i].stage - points[i - 1].stage));
    const double step = median_or_zero(steps);
    // Points in a window whose slope is known to an eighth of the rate: its standard error is σ/step √(12/m³).
    const double ratio = 8 * force_noise * std::abs(turn.q_force) / (rate * step);
    const double needed = std::cbrt(12 * ratio * ratio);
    const auto window =
        step > 0 ? std::max<std::size_t>(4, static_cast<std::size_t>(std::min(std::ceil(needed), 1e4))) : last - first;
    std::size_t slides_from = last;
    for (std::size_t i = first; i + window < last; ++i)
      if (slope_of_q(points, i, i + window + 1) < 0.25 * rate) {
        // By a third of the window it may still stick: there the slope of a bent line falls to a quarter.
        slides_from = i + window / 3 + 1;
        break;
      }
    for (std::size_t i = first; i < slides_from; ++i) points[i].slides = false;
  }
}

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
constexpr std::size_t max_places = 100;  // of a loop: finer than bumps, coarser than readings

std::vector<Block> make_blocks(std::span<const Point> points, std::span<const LoopLegs> loops, std::size_t legs,
                               double force_noise) {
  const auto starts = leg_starts(points, legs);
  std::vector<Block> blocks;
  for (const auto& loop : loops) {
    Block block{.rows = {}, .column = loop.column, .roughness = 0, .range = 0};
    double variation = 0, noise = 0, length = 0;
    const auto add = [&](std::size_t leg, double side) {
      for (std::size_t i = starts[leg]; i < starts[leg + 1]; ++i) {
        const Point& point = points[i];
        if (!point.slides) continue;
        const double unit = point.q_force * point.q_force;
        block.rows.push_back(
            {side, point.S, unit, {side * point.q, -side * point.q_log_stiffness, -side * point.q_contact}});
        if (i == starts[leg] || !points[i - 1].slides) continue;
        variation += std::pow(point.q - points[i - 1].q, 2);
        noise += force_noise * force_noise * (unit + points[i - 1].q_force * points[i - 1].q_force);
        length += std::abs(point.S - points[i - 1].S);
      }
    };
    if (loop.loading) add(*loop.loading, 1);
    if (loop.unloading) add(*loop.unloading, -1);
    std::stable_sort(block.rows.begin(), block.rows.end(),
                     [](const SlidingRow& a, const SlidingRow& b) { return a.S < b.S; });
    if (!block.rows.empty()) block.range = block.rows.back().S - block.rows.front().S;
    // Rather too rough, which only widens the band of μ, than too smooth, which would bend μ.
    if (length > 0) block.roughness = std::max({variation - noise, 0.1 * variation, min_noise * min_noise}) / length;
    blocks.push_back(std::move(block));
  }
  return blocks;
}

// Points sliding out, paired with the points sliding in around them where these leave no gap, averaged over places.
Pairs pair_directions(const Block& block) {
  std::vector<const SlidingRow*> in, out;
  for (const auto& row : block.rows) (row.side > 0 ? in : out).push_back(&row);
  Pairs places;
  if (in.size() < 2 || out.size() < 2) return places;
  std::vector<double> gaps;
  gaps.reserve(in.size());
  for (std::size_t i = 1; i < in.size(); ++i) gaps.push_back(in[i]->S - in[i - 1]->S);
  const double widest = 8 * median_or_zero(gaps);  // wider ones are snaps, within which nothing was measured

  const double low = std::max(in.front()->S, out.front()->S);
  const double high = std::min(in.back()->S, out.back()->S);
  if (!(high > low)) return places;
  const auto count = std::clamp<std::size_t>(std::min(in.size(), out.size()) / 2, 1, max_places);
  const double width = (high - low) / static_cast<double>(count);
  std::size_t place = nowhere;
  double members = 0;
  double brackets = 0;     // of points sliding in
  double in_variance = 0;  // sums over the members
  double out_variance = 0;
  const SlidingRow* bracket = nullptr;
  const auto close = [&] {
    if (place == nowhere) return;
    const auto scale = [&](double& sum) { sum /= members; };
    scale(places.S.back());
    scale(places.in.back());
    scale(places.out.back());
    for (double& sum : places.in_slopes.back()) scale(sum);
    for (double& sum : places.out_slopes.back()) scale(sum);
    places.noise_of_unit.push_back((in_variance / brackets + out_variance / members) / members);
  };
  for (const SlidingRow* row : out) {
    if (row->S < low || row->S > high) continue;
    const auto after =
        std::lower_bound(in.begin(), in.end(), row->S, [](const SlidingRow* a, double S) { return a->S < S; });
    if (after == in.begin() || after == in.end()) continue;
    const SlidingRow& b = **after;
    const SlidingRow& a = **(after - 1);
    if (b.S - a.S > widest || !(b.S > a.S)) continue;
    const double t = (row->S - a.S) / (b.S - a.S);
    const auto between = [&](std::size_t j) { return (1 - t) * a.y[j] + t * b.y[j]; };
    const auto here = std::min(static_cast<std::size_t>((row->S - low) / width), count - 1);
    if (here != place) {
      close();
      place = here;
      members = brackets = in_variance = out_variance = 0;
      bracket = nullptr;
      places.S.push_back(0);
      places.in.push_back(0);
      places.out.push_back(0);
      places.in_slopes.push_back({});
      places.out_slopes.push_back({});
    }
    ++members;
    places.S.back() += row->S;
    places.in.back() += between(0);
    places.out.back() += row->y[0];
    for (std::size_t j = 0; j < 2; ++j) {
      places.in_slopes.back()[j] -= between(j + 1);  // y holds regressors, minus the slopes
      places.out_slopes.back()[j] -= row->y[j + 1];
    }
    out_variance += row->variance_of_unit;
    in_variance += (1 - t) * a.variance_of_unit + t * b.variance_of_unit;
    if (bracket != &a) ++brackets;
    bracket = &a;
  }
  close();
  return places;
}

// Friction μ at the rows of a block as all of them support it, then the difference δ of the directions:
// ±q = μ(S) ± δ(S)/2 + noise, with μ a random walk and δ an Ornstein-Uhlenbeck process.
std::vector<Eigen::Vector2d> smooth(const Block& block, const Noise& noise) {
  constexpr double diffuse = 1e4;  // variance of μ before the first row: friction is below 100
  const double power = noise.difference * noise.difference;
  const std::size_t n = block.rows.size();
  std::vector<FilterStep<2, 1>> passed;
  passed.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const SlidingRow& row = block.rows[i];
    FilterStep<2, 1> here;
    if (i == 0) {
      here.from_before.matrix.setIdentity();
      here.from_before.added.setZero();
      here.prediction.mean.setZero();
      here.prediction.covariance << diffuse, 0, 0, power;
    } else {
      const double distance = row.S - block.rows[i - 1].S;
      const double decay = elementary::exp(-distance / noise.length);
      here.from_before.matrix << 1, 0, 0, decay;
      here.from_before.added << block.roughness * distance, 0, 0, power * (1 - decay * decay);
      here.prediction = predicted(passed.back().state, here.from_before);
    }
    const double variance = noise.force * noise.force * row.variance_of_unit + min_noise * min_noise;
    const Eigen::Matrix<double, 1, 1> y(row.y[0]);
    here.state = updated(here.prediction, Eigen::Vector2d(1, 0.5 * row.side), y, variance).state;
    passed.push_back(here);
  }
  return rts_means(passed);
}

constexpr double lost_degrees = 6;  // of freedom: three for the trend, three of Fisher's transform

std::vector<double> without_trend(std::span<const double> S, std::span<const double> values,
                                  std::span<const double> weights) {
  const auto n = static_cast<Eigen::Index>(S.size());
  const double middle = 0.5 * (S.front() + S.back());
  const double half = 0.5 * (S.back() - S.front());
  Eigen::MatrixXd A(n, 3);
  Eigen::VectorXd b(n);
  Eigen::VectorXd root(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double x = (S[at] - middle) / half;
    A.row(i) << 1, x, x * x;
    b[i] = values[at];
    root[i] = std::sqrt(weights[at]);
  }
  const Eigen::MatrixXd weighted = (root.cwiseAbs2().asDiagonal() * A).transpose();
  const Eigen::VectorXd rest = b - A * Symmetric(product(weighted, A)).solved(product(weighted, b));
  return {rest.data(), rest.data() + n};
}

struct Information {
  Eigen::Matrix4d gram = Eigen::Matrix4d::Zero();
  double log_determinant = 0;
};

// The differences in - out at the places of a loop and their regressors, whitened: an Ornstein-Uhlenbeck process seen through noise.
Information whiten(const Pairs& places, const Noise& noise) {
  using Number = Eigen::Matrix<double, 1, 1>;
  Information information;
  const double power = noise.difference * noise.difference;
  GaussianState<1, 4> known{Eigen::RowVector4d::Zero(), Number(power)};
  for (std::size_t i = 0; i < places.S.size(); ++i) {
    if (i > 0) {
      const double decay = elementary::exp(-(places.S[i] - places.S[i - 1]) / noise.length);
      known = predicted(known, {Number(decay), Number(power * (1 - decay * decay))});
    }
    const auto& in = places.in_slopes[i];
    const auto& out = places.out_slopes[i];
    const Eigen::RowVector4d y(places.in[i] - places.out[i], out[0] - in[0], out[1] - in[1], 1);
    const double variance = noise.force * noise.force * places.noise_of_unit[i] + min_noise * min_noise;
    const auto update = updated(known, Number(1.0), y, variance);
    information.gram.noalias() += update.innovation.transpose() * update.innovation / update.variance;
    information.log_determinant += elementary::log(update.variance);
    known = update.state;
  }
  return information;
}

NormalStep Estimator::estimate(const Noise& noise, Eigen::Index differences) const {
  const auto contacts = static_cast<Eigen::Index>(calibration_.contact.size());
  const Eigen::Index n = 1 + contacts + differences;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  double squares = 0, log_determinant = 0;
  for (const auto& mirror : mirrors_) {
    const auto information = whiten(mirror.places, noise);
    const std::array<Eigen::Index, 3> at{0, 1 + static_cast<Eigen::Index>(mirror.column), 1 + contacts};
    const Eigen::Index used = 2 + differences;
    for (Eigen::Index i = 0; i < used; ++i) {
      b[at[static_cast<std::size_t>(i)]] += information.gram(0, i + 1);
      for (Eigen::Index j = 0; j < used; ++j)
        A(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]) += information.gram(i + 1, j + 1);
    }
    squares += information.gram(0, 0);
    log_determinant += information.log_determinant;
  }
  const auto add_prior = [&](Eigen::Index i, double value, double deviation) {
    A(i, i) += 1 / (deviation * deviation);
    b[i] -= value / (deviation * deviation);
    squares += value * value / (deviation * deviation);
  };
  add_prior(0, calibration_.log_stiffness, options_.stiffness_error);
  for (Eigen::Index i = 0; i < contacts; ++i)
    add_prior(1 + i, calibration_.contact[static_cast<std::size_t>(i)], options_.contact_error);
  if (differences > 0) add_prior(1 + contacts, 0, 1);  // a mean difference beyond 1 is none of friction
  const Symmetric factors(A);
  NormalStep result{.step = factors.solved(b), .covariance = factors.inverse(), .objective = 0};
  result.objective = log_determinant + factors.log_determinant() + squares - b.dot(result.step);
  return result;
}

// Maximises the restricted likelihood over the logarithms of the noise, by steps along each that shrink to 5 %.
Noise likely_noise(const Estimator& estimator, const Noise& start, double reading, double shortest, double longest) {
  const std::array<double, 3> low{elementary::log(reading + 1e-12), elementary::log(1e-5), elementary::log(shortest)};
  const std::array<double, 3> high{elementary::log(1e2 * reading + 1e-9), elementary::log(2.0),
                                   elementary::log(longest)};
  std::array<double, 3> at{elementary::log(start.force + 1e-11), elementary::log(start.difference),
                           elementary::log(start.length)};
  const auto noise_at = [](const std::array<double, 3>& x) {
    return Noise{elementary::exp(x[0]), elementary::exp(x[1]), elementary::exp(x[2])};
  };
  for (std::size_t i = 0; i < 3; ++i) at[i] = std::clamp(at[i], low[i], high[i]);
  double best = estimator.estimate(noise_at(at), 0).objective;
  std::array<double, 3> step{0.5, 0.8, 0.8};
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (std::size_t i = 0; i < 3; ++i) {
      bool moved = false;
      for (const double sign : {1.0, -1.0}) {
        auto trial = at;
        trial[i] = std::clamp(at[i] + sign * step[i], low[i], high[i]);
        if (trial[i] == at[i]) continue;
        const double objective = estimator.estimate(noise_at(trial), 0).objective;
        if (!(objective < best)) continue;
        best = objective;
        at = trial;
        step[i] *= sign;  // go on this way first
        moved = true;
        break;
      }
      step[i] *= moved ? 1.4 : 0.4;
    }
    if (std::all_of(step.begin(), step.end(), [](double s) { return std::abs(s) < 0.05; })) break;
  }
  return noise_at(at);
}

constexpr std::size_t min_sliding = 20;
constexpr std::size_t settling = 5;  // iterations after which it is fixed which points slide
constexpr std::size_t max_iterations = 40;

Estimate rms_with_error(std::span<const double> values) {
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

FrictionLoop with_directions(FrictionLoop loop, const Block& block, const Noise& noise,
                             const Eigen::Matrix2d& covariance) {
  const auto pairs = pair_directions(block);
  loop.places = pairs.S.size() >= min_pairs ? pairs.S.size() : 0;
  loop.correlation = {not_a_number, not_a_number, not_a_number, 0};
  if (loop.places == 0) return loop;
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
  loop.rms_difference = rms_with_error(difference);
  std::vector<double> variance;
  variance.reserve(loop.places);
  for (const double unit : pairs.noise_of_unit) variance.push_back(noise.force * noise.force * unit);
  loop.correlation = correlate_bumps(pairs.S, pairs.in, pairs.out, variance);
  return loop;
}

// Lengths closer than what a measurement resolves would make a table steep for nothing.
FrictionTable table_of(const Block& block, const Noise& noise, const Fibre& fibre) {
  FrictionTable table;
  const auto means = smooth(block, noise);
  const double min_distance = std::max(block.range / 1000, 2e-6);
  for (std::size_t i = 0; i < block.rows.size(); ++i) {
    const double S = block.rows[i].S;
    if (!table.S.empty() && S - table.S.back() < min_distance) continue;
    table.S.push_back(S);
    table.mu.push_back(held_friction(fibre, means[i][0]));
  }
  return table;
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
  const double min_distance = std::max((common.S.back() - common.S.front()) / 1000, 2e-6);
  std::vector<double> lengths;
  for (const double S : common.S)
    if (lengths.empty() || S - lengths.back() >= min_distance) lengths.push_back(S);
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
  for (const auto& block : blocks) mirrored.push_back(pair_directions(block).S.size() >= min_pairs);
  return mirrored;
}

LegMotion motion_of(const Point& point, Direction direction) {
  if (!point.slides) return LegMotion::stuck;
  return direction == Direction::loading ? LegMotion::in : LegMotion::out;
}

// A record calibrated by its mirrored loops, if it has any.
struct Fit {
  CyclesStatus status = CyclesStatus::too_few_points;
  Calibration calibration{0, {0}};
  Eigen::MatrixXd covariance;  // of ln EI and the contacts
  Noise noise{};
  Estimate asymmetry = normal_estimate(not_a_number, not_a_number);
  std::vector<Point> points;
  std::vector<LoopLegs> loops;  // with the columns of their contacts
  std::vector<Block> blocks;    // of each loop
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

Fit calibrate(const ReducedRecord& record, const Rig& rig, const CyclesOptions& options, std::span<const Leg> legs) {
  const double reading = reading_noise(record, legs);
  constexpr double surely = 4;
  const Bounds bounds{options.min_deflection, surely * reading};
  Fit fit;
  fit.noise = {reading, 1e-5, 0.01};  // no difference: nothing tells one without a mirror
  fit.points = locate(record, rig, bounds, legs, fit.calibration, std::vector<std::size_t>(legs.size(), 0));
  fit.loops = pair_legs(legs);

  // As the record stands: which loops have a mirror, and is there anything to measure?
  mark_stuck(fit.points, legs, reading);
  const auto sliding =
      std::count_if(fit.points.begin(), fit.points.end(), [](const Point& point) { return point.slides; });
  if (static_cast<std::size_t>(sliding) < min_sliding) return fit;
  fit.blocks = make_blocks(fit.points, fit.loops, legs.size(), reading);
  const auto mirrored = find_mirrors(fit.blocks);
  fit.calibration.contact.assign(assign_contacts(fit.loops, mirrored), 0.0);
  const auto unknowns = static_cast<Eigen::Index>(1 + fit.calibration.contact.size());
  fit.covariance = Eigen::MatrixXd::Zero(unknowns, unknowns);
  fit.covariance.diagonal().setConstant(options.contact_error * options.contact_error);
  fit.covariance(0, 0) = options.stiffness_error * options.stiffness_error;
  fit.status = CyclesStatus::no_mirror;
  if (std::find(mirrored.begin(), mirrored.end(), true) == mirrored.end()) return fit;

  const auto columns = columns_of_legs(fit.loops, legs.size());
  fit.status = CyclesStatus::not_converged;
  fit.noise.difference = 0.05;                  // a start at which neither noise nor bumps are ignored
  std::vector<bool> used(record.force.size());  // which points count, and which of them slide, once that is settled
  std::vector<bool> slides(record.force.size());
  for (std::size_t iteration = 0; iteration < max_iterations; ++iteration) {
    fit.points = locate(record, rig, bounds, legs, fit.calibration, columns);
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
    fit.blocks = make_blocks(fit.points, fit.loops, legs.size(), reading);
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

double effective_count(std::span<const double> a, std::span<const double> b) {
  const auto autocovariance = [](std::span<const double> x, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = lag; i < x.size(); ++i) sum += x[i] * x[i - lag];
    return sum;
  };
  const double a0 = autocovariance(a, 0);
  const double b0 = autocovariance(b, 0);
  const auto n = static_cast<double>(a.size());
  if (!(a0 > 0 && b0 > 0)) return n;
  double sum = 0;
  for (std::size_t lag = 1; lag < a.size(); ++lag) {
    const double ra = autocovariance(a, lag) / a0;
    const double rb = autocovariance(b, lag) / b0;
    if (ra <= 0 || rb <= 0) break;
    sum += ra * rb;
  }
  return n / (1 + 2 * sum);
}

BumpCorrelation together(std::span<const BumpCorrelation> loops) {
  double sum = 0, weights = 0, points = 0;
  for (const auto& loop : loops) {
    const double weight = loop.effective_points - lost_degrees;
    if (!(weight > 1) || std::isnan(loop.value)) continue;
    sum += weight * std::atanh(loop.value);
    weights += weight;
    points += loop.effective_points;
  }
  if (!(weights > 0)) return {not_a_number, not_a_number, not_a_number, 0};
  const double z = sum / weights;
  const double half = two_sided_95 / std::sqrt(weights);
  return {std::tanh(z), std::tanh(z - half), std::tanh(z + half), points};
}

BumpCorrelation correlate_bumps(std::span<const double> S, std::span<const double> in, std::span<const double> out,
                                std::span<const double> noise) {
  const std::size_t n = S.size();
  if (in.size() != n || out.size() != n || noise.size() != n)
    throw std::invalid_argument(
        "bumps are correlated at places with one length, two values and their noise: there are " + std::to_string(n) +
        ", " + std::to_string(in.size()) + ", " + std::to_string(out.size()) + " and " + std::to_string(noise.size()));
  for (std::size_t i = 0; i < n; ++i) {
    require(i == 0 || S[i] > S[i - 1], "length between the supports after a longer one", S[i]);
    require(noise[i] >= 0, "variance of noise", noise[i]);
  }
  if (n < min_pairs) return {not_a_number, not_a_number, not_a_number, static_cast<double>(n)};
  std::vector<double> weights(n, 1.0);
  auto a = without_trend(S, in, weights);
  auto b = without_trend(S, out, weights);
  // Places count by what they tell: the noise of some, near contact, exceeds all bumps.
  std::vector<double> squares;
  squares.reserve(2 * n);
  for (const double value : a) squares.push_back(value * value);
  for (const double value : b) squares.push_back(value * value);
  const double spread = median_or_zero(squares) / 0.455;  // 0.455 is the median of the square of a standard normal
  if (!(spread > 0)) return {not_a_number, not_a_number, not_a_number, static_cast<double>(n)};
  for (std::size_t i = 0; i < n; ++i) weights[i] = spread / (spread + noise[i]);
  a = without_trend(S, in, weights);
  b = without_trend(S, out, weights);
  double ab = 0, aa = 0, bb = 0, total = 0, total_squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    ab += weights[i] * a[i] * b[i];
    aa += weights[i] * a[i] * a[i];
    bb += weights[i] * b[i] * b[i];
    total += weights[i];
    total_squares += weights[i] * weights[i];
    a[i] *= std::sqrt(weights[i]);
    b[i] *= std::sqrt(weights[i]);
  }
  const double count = effective_count(a, b) * total * total / (total_squares * static_cast<double>(n));
  const double r = aa > 0 && bb > 0 ? std::clamp(ab / std::sqrt(aa * bb), -1.0, 1.0) : 0;
  // With no degree of freedom left, nothing is known: the interval is all of [-1, 1].
  const double half = two_sided_95 / std::sqrt(std::max(count - lost_degrees, std::numeric_limits<double>::min()));
  const double z = std::atanh(r);
  return {r, std::tanh(z - half), std::tanh(z + half), count};
}

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
  const auto [in, out, rms] = direction_means(friction);
  const auto& [value, error, low, high] = friction.asymmetry;
  return std::abs(value) > 0.5 * (in + out) && std::abs(value) > two_sided_95 * error;
}

CyclicFriction measure_cycles(const ReducedRecord& record, const Rig& rig, const CyclesOptions& options) {
  require_readings(record);
  require(rig.stiffness > 0, "load-train stiffness", rig.stiffness);
  require(options.stiffness_error > 0, "error of ln EI", options.stiffness_error);
  require(options.contact_error > 0, "contact error", options.contact_error);
  require(options.min_deflection > 0, "least deflection", options.min_deflection);

  CyclicFriction result{.status = CyclesStatus::too_few_points,
                        .legs = find_legs(record.stage, options.legs),
                        .points = {},
                        .loops = {},
                        .log_stiffness = normal_estimate(0, options.stiffness_error),
                        .asymmetry = normal_estimate(not_a_number, not_a_number),
                        .correlation = {not_a_number, not_a_number, not_a_number, 0},
                        .table = {}};
  const auto& legs = result.legs;
  const auto fit = calibrate(record, rig, options, legs);
  const auto& loops = fit.loops;
  if (fit.status == CyclesStatus::too_few_points || fit.status == CyclesStatus::not_converged) {
    result.status = fit.status;
    return result;
  }

  const auto& covariance = fit.covariance;
  result.status = fit.status;
  result.log_stiffness = normal_estimate(fit.calibration.log_stiffness, std::sqrt(covariance(0, 0)));
  result.asymmetry = fit.asymmetry;
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
        .places = 0,
        .mu_in = normal_estimate(not_a_number, not_a_number),
        .mu_out = normal_estimate(not_a_number, not_a_number),
        .rms_difference = normal_estimate(not_a_number, not_a_number),
        .correlation = {},
        .table = table_of(fit.blocks[i], fit.noise, rig.fibre)};
    loop = with_directions(std::move(loop), fit.blocks[i], fit.noise, covariance_with(loops[i].column));
    result.loops.push_back(std::move(loop));
  }
  std::vector<BumpCorrelation> correlations;
  for (const FrictionLoop& loop : result.loops) correlations.push_back(loop.correlation);
  result.correlation = together(correlations);
  result.table = common_table(result.loops);
  return result;
}

}  // namespace flexslip
