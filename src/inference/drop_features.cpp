#include "inference/drop_features.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <Eigen/Core>

#include "numerics/dense.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr double usual_q = 0.5;
constexpr double min_slope_friction = -0.5, max_slope_friction = 1.6;  // range of friction for slopes of the map
constexpr double deepest = 0.515;                                      // [L] beyond, the specimen slips through

// States for given deflections and frictions, with derivatives in w and q.
struct States {
  std::vector<double> S, F, S_w, S_q, F_w, F_q;

  void add(double length, double force, double length_w, double length_q, double force_w, double force_q) {
    S.push_back(length), F.push_back(force);
    S_w.push_back(length_w), S_q.push_back(length_q), F_w.push_back(force_w), F_q.push_back(force_q);
  }
};

States states_on_supports(std::span<const double> w, std::span<const double> q, const Fibre& fibre) {
  States states;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const Fibre::DeflectionState at = fibre.at_deflection_without_contacts(w[i], q[i]);
    states.add(at.state.S, at.state.F, at.S_w, at.S_q, at.F_w, at.F_q);
  }
  return states;
}

// Newton's method in w², which is nearly linear in S.
States states_on_edges(std::span<const double> w, std::span<const double> q, const Fibre& fibre) {
  constexpr int iterations = 8;
  std::vector<double> S;
  for (const double each : w) S.push_back(1 + 2.4 * each * each);
  SlopeArrays at(w.size());
  for (int iteration = 0; iteration < iterations; ++iteration) {
    at = fibre.tabulated_states_slopes({S, q});
    for (std::size_t i = 0; i < w.size() && iteration + 1 < iterations; ++i) {
      const double step = (w[i] * w[i] - at.w[i] * at.w[i]) / (2 * at.w[i] * at.w_S[i]);
      if (std::isfinite(step)) S[i] += std::clamp(step, -0.5 * (S[i] - 1), 0.1);
    }
  }
  States states;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double S_w = 1 / at.w_S[i], S_q = -at.w_q[i] * S_w;
    states.add(S[i], at.F[i], S_w, S_q, at.F_S[i] * S_w, at.F_q[i] + at.F_S[i] * S_q);
  }
  return states;
}

States states_at(std::span<const double> w, std::span<const double> q, const Fibre& fibre) {
  return fibre.on_edges() ? states_on_edges(w, q, fibre) : states_on_supports(w, q, fibre);
}

// [EI/L^2] The derivative of the force in friction, with a lower limit. The surface of a bar slides
// outwards at small deflections, where the force does not depend on friction.
double sensitivity(double F_q, double F) {
  constexpr double least = 0.01;  // [1] of the force
  return std::max(F_q, least * std::abs(F));
}

double snap_length_of(const States& states, std::size_t i, double k) {
  return states.S_w[i] * states.F_q[i] / (k + states.F_w[i]) - states.S_q[i];
}

// The rows of a loading with information on friction and with states of the map.
class Rows {
 public:
  Rows(const ReducedRecord& record, const Rig& rig, const LoadingErrors& errors) {
    constexpr double from = 0.12;  // [maximum deflection]
    const double greatest = *std::max_element(record.deflection.begin(), record.deflection.end());
    first = static_cast<std::size_t>(std::find_if(record.deflection.begin(), record.deflection.end(),
                                                  [&](double at) { return at > from * greatest; }) -
                                     record.deflection.begin());
    std::size_t last = first;
    while (last < record.deflection.size() && record.deflection[last] < deepest && record.deflection[last] > 0) ++last;
    w.assign(record.deflection.begin() + static_cast<std::ptrdiff_t>(first),
             record.deflection.begin() + static_cast<std::ptrdiff_t>(last));
    F.assign(record.force.begin() + static_cast<std::ptrdiff_t>(first),
             record.force.begin() + static_cast<std::ptrdiff_t>(last));
    const States usual = states_at(w, std::vector<double>(w.size(), usual_q), rig.fibre);
    std::vector<double> pressed = F;
    for (double& each : pressed) each = std::max(each, 0.0);
    q = rig.fibre.tabulated_states_from_forces(w, pressed).q;
    std::vector<double> held = q;  // within the range of slopes; beyond, friction is extrapolated linearly
    for (std::size_t i = 0; i < w.size(); ++i) {
      if (std::isnan(held[i])) held[i] = usual_q + (F[i] - usual.F[i]) / sensitivity(usual.F_q[i], usual.F[i]);
      held[i] = std::clamp(held[i], min_slope_friction, max_slope_friction);
    }
    const States states = states_at(w, held, rig.fibre);
    S = states.S, F_q = states.F_q, F_w = states.F_w;
    for (std::size_t i = 0; i < w.size(); ++i) {
      F_q[i] = sensitivity(F_q[i], states.F[i]);
      if (held[i] != q[i]) q[i] = held[i] + (F[i] - states.F[i]) / F_q[i];
      c.push_back(snap_length_of(states, i, rig.stiffness));
      const bool is_read = std::isfinite(q[i]) && std::isfinite(S[i]) && F_q[i] > 0 && c[i] > 0;
      if (!is_read) {  // the value of the previous row, or 0
        if (i == 0) {
          q[i] = 0, S[i] = 1, F_q[i] = F_w[i] = 1, c[i] = 1e-9;
        } else {
          q[i] = q[i - 1], S[i] = S[i - 1], F_q[i] = F_q[i - 1], F_w[i] = F_w[i - 1], c[i] = c[i - 1];
        }
      }
      y.push_back(elementary::log(std::max(F[i], 1e-9) / usual.F[i]));
      q_noise.push_back(errors.force / F_q[i]);
      q_by_stiffness.push_back(errors.bending_stiffness * F[i] / F_q[i]);
    }
  }

  std::size_t size() const { return w.size(); }
  double slid() const { return std::max(S.back() - S.front(), 1e-9); }

  std::size_t first = 0;  // in the record
  std::vector<double> w, F, q, S, c, F_q, F_w;
  std::vector<double> y;                        // ln of the apparent stiffness: F / force at the median friction
  std::vector<double> q_noise, q_by_stiffness;  // errors of q due to noise and EI
};

double median_between(const std::vector<double>& values, std::size_t first, std::size_t last) {
  return median_of(
      {values.begin() + static_cast<std::ptrdiff_t>(first), values.begin() + static_cast<std::ptrdiff_t>(last)});
}

// A drop and the rise after it.
struct Tooth {
  std::size_t before, after;    // the rows around the drop
  std::size_t last;             // of the rise
  double q_before, fall;        // of friction
  double y_fall;                // of the apparent stiffness
  bool rises = false;           // the rise is long enough
  double rise = 0, length = 0;  // of friction; [L] sliding length
  double snap = 0;              // [L] per unit of friction, in the rise
};

std::vector<Tooth> teeth_of(const Rows& rows, std::span<const Drop> drops, double greatest_force) {
  constexpr double shows_from = 0.15, least_w = 0.006,
                   least_fall = 0.002;  // [maximum deflection], [L], [greatest force]
  const double greatest = *std::max_element(rows.w.begin(), rows.w.end());
  std::vector<Tooth> teeth;
  for (const Drop& drop : drops) {
    if (drop.before < rows.first + 1 || drop.after + 1 >= rows.first + rows.size()) continue;
    const std::size_t b = drop.before - rows.first, a = drop.after - rows.first;
    if (!(rows.w[b] > std::max(shows_from * greatest, least_w) && rows.F[b] - rows.F[a] > least_fall * greatest_force))
      continue;
    const double q_before = std::midpoint(rows.q[b - 1], rows.q[b]);
    const double q_after = std::midpoint(rows.q[a], rows.q[std::min(a + 1, rows.size() - 1)]);
    teeth.push_back({.before = b,
                     .after = a,
                     .last = rows.size() - 1,
                     .q_before = q_before,
                     .fall = std::max(q_before - q_after, 1e-4),
                     .y_fall = std::max(rows.y[b] - rows.y[a], 1e-5)});
  }
  for (std::size_t j = 0; j + 1 < teeth.size(); ++j) teeth[j].last = teeth[j + 1].before;
  for (Tooth& tooth : teeth) {
    const std::size_t a = tooth.after, b = tooth.last;
    if (b < a + 2) continue;
    constexpr std::size_t long_enough = 6;
    const bool is_long = b - a > long_enough;
    tooth.rises = true;
    tooth.rise = (is_long ? median_between(rows.q, b - 2, b + 1) : rows.q[b]) -
                 (is_long ? median_between(rows.q, a, a + 3) : rows.q[a]);
    tooth.length = std::max(rows.S[b] - rows.S[a], 1e-9);
    tooth.snap = median_between(rows.c, a, b + 1);
  }
  return teeth;
}

// The slope of friction along the length before the first drop.
double trend_before(const Rows& rows, std::size_t first_drop) {
  constexpr std::size_t enough = 8;
  if (first_drop <= enough) return 0;
  return line_through(
             first_drop + 1, [&](std::size_t i) { return rows.S[i]; }, [&](std::size_t i) { return rows.q[i]; })
      .slope;
}

// [1] The share of the drop of friction that recovers within `lengths` snap lengths, minus the
// trend.
double recovery(const Rows& rows, const Tooth& tooth, double lengths, double trend) {
  const double target = rows.S[tooth.after] + lengths * tooth.snap * tooth.fall;
  std::size_t i = tooth.after + 1;
  while (i < tooth.last && rows.S[i] < target) ++i;
  const double back = rows.q[i] - rows.q[tooth.after] - trend * (rows.S[i] - rows.S[tooth.after]);
  return std::clamp(back / tooth.fall, -1.0, 2.0);
}

void add_rises(DropFeatures& features, const Rows& rows, const std::vector<Tooth>& teeth) {
  constexpr double near = 3, far = 12;
  const double trend = trend_before(rows, teeth.front().before);
  double weights = 0, falls = 0, rises = 0;
  for (const Tooth& tooth : teeth) {
    falls += tooth.fall;
    if (!tooth.rises) continue;
    const double weight = tooth.fall / (tooth.fall + 2 * rows.q_noise[tooth.after]);
    const double steepness =
        tooth.snap * tooth.rise / std::max(tooth.snap * std::abs(tooth.rise) + tooth.length, 1e-12);
    features.max_steepness = weights == 0 ? steepness : std::max(features.max_steepness, steepness);
    weights += weight;
    features.recovery_near += weight * recovery(rows, tooth, near, trend);
    features.recovery_far += weight * recovery(rows, tooth, far, trend);
    rises += tooth.rise;
  }
  if (weights > 0) features.recovery_near /= weights, features.recovery_far /= weights;
  features.stiffness_recovery = rises / falls;
}

// The friction at the end if the drops are cracks only.
void add_needed(DropFeatures& features, const Rows& rows, const std::vector<Tooth>& teeth) {
  constexpr double broken = 0.02;  // [1] of the stiffness
  double left = 1;
  const auto needed = [&](std::size_t i) { return rows.q[i] + (1 / left - 1) * rows.F[i] / rows.F_q[i]; };
  for (const Tooth& tooth : teeth) {
    const std::size_t b = tooth.before, a = tooth.after;
    const double friction = needed(b);
    left =
        std::max(std::min(rows.F[a] / std::max(rows.F[a] + rows.F_q[a] * (friction - rows.q[a]), 1e-6), left), broken);
  }
  const std::size_t n = rows.size();
  features.needed_at_end = median_of({needed(n - 3), needed(n - 2), needed(n - 1)});
  features.loss_needed = 1 - left;
  features.loss_recovered = features.loss_needed * std::clamp(features.recovery_far, 0.0, 1.0);
}

// y = a + b (S - S_first)/slid - β Σ falls of y, at both ends of each rise; b ~ N(0, (.15
// F_q/F)^2), β ~ N(.5, .7^2).
void add_following(DropFeatures& features, const Rows& rows, const std::vector<Tooth>& teeth, double relative_noise) {
  constexpr double of_trend = 0.15, middle = 0.5, spread = 0.7;
  std::vector<Eigen::Vector3d> inputs;
  std::vector<double> y;
  double fallen = 0;
  for (std::size_t j = 0; j <= teeth.size(); ++j) {
    const std::size_t a = j == 0 ? 0 : teeth[j - 1].after, b = j < teeth.size() ? teeth[j].before : rows.size() - 1;
    if (j > 0) fallen += teeth[j - 1].y_fall;
    const auto add = [&](std::size_t i) {
      inputs.emplace_back(1, (rows.S[i] - rows.S.front()) / rows.slid(), -fallen);
      y.push_back(rows.y[i]);
    };
    add(a);
    if (b > a + 3) add(b);
  }
  std::vector<double> relative;
  for (std::size_t i = 0; i < rows.size(); ++i) relative.push_back(rows.F_q[i] / std::max(rows.F[i], 1e-9));
  const double trend = of_trend * median_of(relative);
  const Eigen::Vector3d prior(0, 1 / (trend * trend), 1 / (spread * spread));
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < y.size(); ++i) {
    A += inputs[i] * inputs[i].transpose();
    b += y[i] * inputs[i];
  }
  const double start = of_trend * fallen / std::sqrt(static_cast<double>(teeth.size()) + 1);
  double variance = std::max(start * start, 1e-10);
  Eigen::Vector3d solution;
  const auto precision = [&] {
    Eigen::Matrix3d P = A / variance;
    P.diagonal() += prior;
    return P;
  };
  for (int again = 0; again < 4; ++again) {
    Eigen::Vector3d right = b / variance;
    right[2] += prior[2] * middle;
    solution = Positive(precision()).solved(right);
    double squares = 0;
    for (std::size_t i = 0; i < y.size(); ++i) squares += std::pow(y[i] - inputs[i].dot(solution), 2);
    variance = std::max({squares / static_cast<double>(y.size()), std::pow(1.5 * relative_noise, 2), 1e-8});
  }
  features.follows_drops = solution[2];
  features.follows_drops_error = std::sqrt(Positive(precision()).solved(Eigen::Vector3d(0, 0, 1))[2]);
}

// The roughness of friction about a parabola along each long rise, relative to the median drop; a
// default without long rises.
double roughness_of(const Rows& rows, const std::vector<Tooth>& teeth, double usual_fall) {
  constexpr std::size_t long_enough = 12;
  constexpr double usual = 0.3, of_medians = 0.35;  // the variance of noise after medians of five
  std::vector<double> squares;
  for (std::size_t j = 0; j <= teeth.size(); ++j) {
    const std::size_t a = j == 0 ? 0 : teeth[j - 1].after, b = j < teeth.size() ? teeth[j].before : rows.size() - 1;
    if (b <= a + long_enough) continue;
    const double middle = std::midpoint(rows.S[a], rows.S[b]), half = std::max(0.5 * (rows.S[b] - rows.S[a]), 1e-12);
    Eigen::Matrix3d A = Eigen::Matrix3d::Identity() * 1e-9;
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    const auto powers = [&](std::size_t i) {
      const double x = (rows.S[i] - middle) / half;
      return Eigen::Vector3d(1, x, x * x);
    };
    double noise = 0;
    for (std::size_t i = a; i <= b; ++i) {
      A += powers(i) * powers(i).transpose();
      right += rows.q[i] * powers(i);
      noise += rows.q_noise[i] * rows.q_noise[i];
    }
    const Eigen::Vector3d parabola = Positive(A).solved(right);
    std::vector<double> left;
    for (std::size_t i = a; i <= b; ++i) left.push_back(rows.q[i] - powers(i).dot(parabola));
    double sum = 0;
    for (const double each : medians_of_five(left)) sum += each * each;
    squares.push_back(std::max((sum - of_medians * noise) / static_cast<double>(left.size()), 0.0));
  }
  return squares.empty() ? usual : std::sqrt(mean_of(squares)) / usual_fall;
}

// Minimum errors.
constexpr double of_friction = 0.05, of_deflection = 0.003;  // [1], [L]

void add_anywhere(DropFeatures& features, const Rows& rows, std::span<const std::size_t> halts) {
  double highest = -infinity;
  const auto q_of = [&](std::size_t i) { return median_of({rows.q[i - 1], rows.q[i], rows.q[i + 1]}); };
  for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
    const double q = q_of(i);
    const double error = elementary::length(elementary::length(rows.q_by_stiffness[i], 2 * rows.q_noise[i]),
                                            elementary::length(of_deflection * rows.F_w[i] / rows.F_q[i], of_friction));
    const bool has_halted = std::binary_search(halts.begin(), halts.end(), rows.first + i - 1);
    highest = has_halted ? q : std::max(highest, q);
    features.least_anywhere = std::min(features.least_anywhere, q / error);
    features.fall_anywhere = std::max(features.fall_anywhere, highest - q);
  }
}

}  // namespace

double snap_length(const Fibre& fibre, double w, double q, double k) {
  return snap_length_of(states_at(std::vector{w}, std::vector{q}, fibre), 0, k);
}

DropFeatures drop_features(const ReducedRecord& record, const Rig& rig, const LoadingErrors& errors,
                           std::span<const Drop> drops) {
  DropFeatures features;
  const Rows rows(record, rig, errors);
  constexpr std::size_t enough = 5;
  if (rows.size() < enough) return features;
  add_anywhere(features, rows, errors.halts);
  const double greatest = *std::max_element(record.force.begin(), record.force.end());
  const std::vector<Tooth> teeth = teeth_of(rows, drops, greatest);
  if (teeth.empty()) return features;
  features.drops = teeth.size();
  std::vector<double> falls;
  for (const Tooth& tooth : teeth) falls.push_back(tooth.fall);
  const double usual_fall = median_of(falls);
  add_rises(features, rows, teeth);
  add_needed(features, rows, teeth);
  add_following(features, rows, teeth, errors.force / greatest);
  features.roughness = roughness_of(rows, teeth, usual_fall);
  features.least_after_drop = infinity;
  for (const Tooth& tooth : teeth) {
    const std::size_t a = tooth.after;
    const double error =
        elementary::length(elementary::length(rows.q_by_stiffness[a], 2 * rows.q_noise[a]), of_friction);
    features.least_after_drop = std::min(features.least_after_drop, (tooth.q_before - tooth.fall) / error);
    features.slid_in += rows.c[tooth.before] * tooth.fall / rows.slid();
  }
  return features;
}

bool is_loss_without_friction(const DropFeatures& features) {
  constexpr double errors = 4, fall = 0.8;
  return features.least_anywhere < -errors && features.fall_anywhere > fall;
}

}  // namespace flexslip
