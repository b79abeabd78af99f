#include "inference/first_passages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Core>

#include "bending_test/equilibrium.h"
#include "fibre/batch_inverse.h"
#include "fibre/state_table.h"
#include "inference/chain.h"
#include "inference/profile.h"
#include "inference/snap_rests.h"
#include "numerics/dense.h"
#include "numerics/elementary.h"
#include "numerics/root.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr double min_S = 1.0005, max_S = 2.05;
constexpr double min_mu = -0.5, max_mu = 1.8;
constexpr double min_q = -1.5, max_q = 2.2;
constexpr double max_w = 0.8;

// Of a run of decreasing readings only the last shows where the specimen stopped.
std::vector<char> within_drops(std::span<const double> force, double noise) {
  std::vector<char> within(force.size(), 0);
  for (std::size_t i = 1; i + 1 < force.size(); ++i)
    within[i] = force[i] - force[i - 1] < -3 * noise && force[i + 1] - force[i] < -3 * noise ? 1 : 0;
  return within;
}

// The derivatives of the inverse of Ψ at states.
struct InverseSlopes {
  std::vector<double> F, S_w, S_F, q_w, q_F;
};

InverseSlopes inverse_slopes(const SlopeArrays& s) {
  const std::size_t n = s.F.size();
  InverseSlopes slopes{s.F, std::vector<double>(n), std::vector<double>(n), std::vector<double>(n),
                       std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    const double jacobian = s.w_S[i] * s.F_q[i] - s.w_q[i] * s.F_S[i];
    // Positive for S < 1.6. Beyond and at the end of the branch, deflection and force do not
    // determine S and q; the slopes are set to 0.
    if (!(jacobian > 1e-9)) {
      slopes.F[i] = 0;
      continue;
    }
    slopes.S_w[i] = s.F_q[i] / jacobian;
    slopes.S_F[i] = -s.w_q[i] / jacobian;
    slopes.q_w[i] = -s.F_S[i] / jacobian;
    slopes.q_F[i] = s.w_S[i] / jacobian;
  }
  return slopes;
}

// [1/L] The rms of dμ/dS between readings with distinct places, which turns an error of the place
// into one of friction.
double steepness_of(const Passages& passages, const Eigen::VectorXd& noise_place) {
  double squares = 0;
  int count = 0;
  for (std::size_t i = 0; i < passages.size(); ++i) {
    const double apart = 3 * passages.noise * std::abs(noise_place[static_cast<Eigen::Index>(i)]);
    std::size_t next = i + 1;
    while (next < passages.size() && !(std::abs(passages.S[next] - passages.S[i]) > apart)) ++next;
    if (next == passages.size()) break;
    const double slope = (passages.q[next] - passages.q[i]) / (passages.S[next] - passages.S[i]);
    squares += slope * slope;
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

// The effects of errors of EI and the rig on the readings. Errors of the rig are combined in order
// of their signal in friction or place; combinations below the noise are left out.
void add_errors(Passages& passages, const FitProblem& problem, double from) {
  const int points = static_cast<int>(passages.options.rig_places);
  const double friction = std::clamp(median_of(passages.q), 0.0, 1.5);
  const double deepest = *std::max_element(problem.record.deflection.begin(), problem.record.deflection.end());
  std::vector<double> stage, w, S, F;
  for (const auto& point : sliding_up_to(deepest, friction, points, passages.fibre)) {
    if (!(point.w > 0.9 * from)) continue;
    stage.push_back(point.w + point.F * passages.compliance);
    w.push_back(point.w);
    S.push_back(point.S);
    F.push_back(point.F);
  }
  if (w.size() < 2) {  // no sliding: with this friction the specimen does not bend so far
    passages.row.clear();
    return;
  }
  const auto slopes =
      inverse_slopes(passages.fibre.states_slopes_before_branch_end({S, std::vector<double>(S.size(), friction)}));

  // One column each along the curve: the quantities, ln EI first, then the slow deviations.
  using Eigen::Index;
  using Eigen::MatrixXd;
  using Eigen::VectorXd;
  const RigErrorEffects rig(problem, friction);
  constexpr auto alone = static_cast<Index>(stated_quantities.size());
  MatrixXd shift_w, shift_F, of_friction, of_place;
  for (std::size_t k = 0; k < w.size(); ++k) {
    std::vector<Shift> shifts;
    for (const StatedQuantity quantity : stated_quantities) shifts.push_back(rig.by(quantity, w[k], F[k]));
    const auto deviations = rig.deviations(w[k], F[k]);
    shifts.insert(shifts.end(), deviations.begin(), deviations.end());
    if (k == 0)
      for (MatrixXd* each : {&shift_w, &shift_F, &of_friction, &of_place})
        each->resize(static_cast<Index>(w.size()), static_cast<Index>(shifts.size()));
    for (std::size_t r = 0; r < shifts.size(); ++r) {
      const auto row = static_cast<Index>(k), column = static_cast<Index>(r);
      const Shift& shift = shifts[r];
      shift_w(row, column) = shift.deflection;
      shift_F(row, column) = shift.force;
      of_friction(row, column) = -(slopes.q_w[k] * shift.deflection + slopes.q_F[k] * shift.force);
      of_place(row, column) = slopes.S_w[k] * shift.deflection + slopes.S_F[k] * shift.force + shift.length;
    }
  }
  // Evaluated by the stage, which has no noise. With the measured deflection, noise would look like
  // an error of the rig.
  const auto at_readings = [&](const MatrixXd& along) {
    MatrixXd at(static_cast<Index>(passages.size()), along.cols());
    for (std::size_t i = 0; i < passages.size(); ++i) {
      const auto beyond = std::upper_bound(stage.begin(), stage.end(), passages.stage[i]) - stage.begin();
      const auto next = std::clamp<std::ptrdiff_t>(beyond, 1, static_cast<std::ptrdiff_t>(stage.size()) - 1);
      const double before = stage[static_cast<std::size_t>(next - 1)];
      const double part =
          std::clamp((passages.stage[i] - before) / (stage[static_cast<std::size_t>(next)] - before), 0.0, 1.0);
      at.row(static_cast<Index>(i)) = (1 - part) * along.row(next - 1) + part * along.row(next);
    }
    return at;
  };

  const auto along_it = [&](const std::vector<double>& values) -> VectorXd {
    return at_readings(Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size())));
  };
  const VectorXd noise_gain = along_it(slopes.q_F), noise_place = along_it(slopes.S_F);
  const double steepness = steepness_of(passages, noise_place);
  const Index errors = of_friction.cols() - alone;
  MatrixXd over_noise(2 * static_cast<Index>(passages.size()), errors);
  over_noise << at_readings(of_friction.rightCols(errors)), steepness * at_readings(of_place.rightCols(errors));
  for (Index i = 0; i < noise_gain.size(); ++i) {
    const double noise = elementary::length(noise_gain[i] * passages.noise, nugget);
    over_noise.row(i) /= noise;
    over_noise.row(noise_gain.size() + i) /= noise;
  }
  const auto [values, vectors] = eigen_of(product(MatrixXd(over_noise.transpose()), over_noise));
  const auto at_most =
      std::min(static_cast<Index>(passages.options.max_rig_errors), static_cast<Index>(rig_error_capacity));
  const Index count = values.size();
  Index kept = 0;
  while (kept < std::min(count, at_most) && values[count - 1 - kept] > passages.options.min_rig_signal) ++kept;
  MatrixXd combine = MatrixXd::Zero(alone + count, 1 + kept);
  combine(0, 0) = 1;
  combine.bottomRightCorner(count, kept) = vectors.rightCols(kept).rowwise().reverse();
  const MatrixXd moved_w = at_readings(product(shift_w, combine)), moved_F = at_readings(product(shift_F, combine));
  const MatrixXd more_friction = at_readings(product(of_friction, combine)),
                 moved_place = at_readings(product(of_place, combine));
  passages.rig_errors.resize(static_cast<std::size_t>(kept));
  for (Index r = 0; r <= kept; ++r) {
    RigError& error = r == 0 ? passages.stiffness : passages.rig_errors[static_cast<std::size_t>(r - 1)];
    for (Index i = 0; i < moved_w.rows(); ++i) {
      error.shift.push_back({moved_w(i, r), moved_F(i, r)});
      error.friction.push_back(more_friction(i, r));
      error.place.push_back(moved_place(i, r));
    }
  }
  const std::array<MatrixXd, 4> each{at_readings(shift_w.leftCols(alone)), at_readings(shift_F.leftCols(alone)),
                                     at_readings(of_friction.leftCols(alone)), at_readings(of_place.leftCols(alone))};
  for (const StatedQuantity quantity : stated_quantities) {
    const auto column = static_cast<Index>(quantity);
    RigError& error = passages.quantities[quantity];
    for (Index i = 0; i < each[0].rows(); ++i) {
      error.shift.push_back({each[0](i, column), each[1](i, column)});
      error.friction.push_back(each[2](i, column));
      error.place.push_back(each[3](i, column));
    }
  }
}

double deflection_judged_from(const ReducedRecord& record, const Fibre& fibre) {
  return min_fit_deflection(*std::max_element(record.deflection.begin(), record.deflection.end()), fibre);
}

}  // namespace

double min_fit_deflection(double greatest_deflection, const Fibre& fibre) {
  constexpr double usually = 0.08;  // at smaller deflections, 1 % in EI is more than 0.06 in μ
  return std::max(std::min(usually, 0.5 * greatest_deflection), min_informative_deflection(fibre));
}

std::vector<std::size_t> readings_judged(const ReducedRecord& record, const Fibre& fibre) {
  const double from = deflection_judged_from(record, fibre);
  const auto within = within_drops(record.force, noise_of_second_differences(second_differences(record.force)));
  std::vector<std::size_t> rows;
  double stage = -infinity;
  for (std::size_t i = 0; i < record.force.size(); ++i) {
    constexpr double min_step = 1e-6;  // [L] a stage at rest passes no new place
    if (!(record.deflection[i] > from && record.deflection[i] < max_w && record.force[i] > 0) || within[i] ||
        !(record.stage[i] > stage + min_step))
      continue;
    stage = record.stage[i];
    rows.push_back(i);
  }
  return rows;
}

namespace {

// Removes the readings at which the specimen sticks after a snap.
void take_out(const std::vector<StuckReadings>& stuck, std::span<const double> S_force, Passages& p) {
  std::vector<std::size_t> slides;
  std::size_t next = 0;
  for (const auto& [first, beyond] : stuck) {
    for (; next < first; ++next) slides.push_back(next);
    Rest& rest = p.rests.emplace_back();
    rest.jump = p.S[first] - p.S[first - 1];
    double S = 0;
    for (; next < beyond; ++next) {
      S += p.S[next] / static_cast<double>(beyond - first);
      rest.S.push_back(p.S[next]);
      rest.S_force.push_back(S_force[next]);
    }
    if (!p.stuck.empty() && p.stuck.back().reading == slides.size()) p.stuck.pop_back();  // it snapped again
    if (!slides.empty())
      p.stuck.push_back({.reading = slides.size(), .S = S, .landing = p.stage[first], .last = p.stage[beyond - 1]});
  }
  for (; next < p.size(); ++next) slides.push_back(next);
  p.judged -= p.size() - slides.size();
  for (std::size_t k = 0; k < slides.size(); ++k) p.row[k] = p.row[slides[k]];
  p.row.resize(slides.size());
  for (auto* column : {&p.stage, &p.force, &p.S, &p.q, &p.advance}) {
    for (std::size_t k = 0; k < slides.size(); ++k) (*column)[k] = (*column)[slides[k]];
    column->resize(slides.size());
  }
}

}  // namespace

Passages passages_of(const FitProblem& problem, const SearchOptions& options) {
  const auto& record = problem.record;
  Passages p{};
  p.options = options;
  p.fibre = problem.rig.fibre;
  p.noise = noise_of_second_differences(second_differences(record.force));
  p.compliance = 1 / problem.rig.stiffness;
  p.share = share_of_sliding(problem.nose);
  p.stiffness_error = problem.errors.bending_stiffness;
  const std::vector<std::size_t> rows = readings_judged(record, p.fibre);
  p.judged = rows.size();
  std::vector<double> w, F;
  for (const std::size_t row : rows) {
    w.push_back(record.deflection[row]);
    F.push_back(record.force[row]);
  }
  const auto states = p.fibre.tabulated_states_from_forces(w, F);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!(states.q[k] > min_q && states.q[k] < max_q && states.S[k] > min_S && states.S[k] < max_S)) continue;
    p.row.push_back(rows[k]);
    p.stage.push_back(record.stage[rows[k]]);
    p.force.push_back(F[k]);
    p.S.push_back(states.S[k]);
    p.q.push_back(states.q[k]);
  }
  if (p.size() == 0) return p;
  const auto slopes = p.fibre.tabulated_states_slopes({p.S, p.q});
  const auto inverse = inverse_slopes(slopes);
  p.advance.assign(p.size(), 0);
  std::vector<double> S_force, noise_of_S;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (i > 0) p.advance[i] = (p.stage[i] - p.stage[i - 1]) / (slopes.w_S[i] + slopes.F_S[i] * p.compliance);
    S_force.push_back(inverse.S_F[i] - inverse.S_w[i] * p.compliance);
    noise_of_S.push_back(std::abs(S_force[i]) * p.noise);
  }
  const SnapRests rests =
      rests_of_snaps({p.stage, p.force, p.S, p.advance, noise_of_S}, options.gap_advances, options.gap_noise);
  p.overshoots = problem.snaps == SnapRest::overshoot;
  p.may_overshoot = !problem.snaps && rests.log_evidence > claiming_gain;
  if (p.overshoots) take_out(rests.stuck, S_force, p);
  add_errors(p, problem, deflection_judged_from(record, p.fibre));
  if (p.size() == 0) return p;
  const auto [least, most] = std::minmax_element(p.S.begin(), p.S.end());
  const double beyond = 0.1 * (*most - *least);
  p.along = ContactPath(p.fibre, median_of(p.q), std::max(*least - beyond, min_S), *most + beyond);
  p.S_middle = 0.5 * (p.along.at(p.S.front()) + p.along.at(p.S.back()));
  p.range = p.share * (p.along.at(*most) - p.along.at(*least));
  return p;
}

double log_density_of_rests(const Passages& passages, double noise, double correlation) {
  const double innovation = std::sqrt(1 - correlation * correlation);
  const auto deviation_at = [&](const Rest& rest, std::size_t k) {
    return elementary::length(noise * rest.S_force[k], passages.options.rises_deviation);
  };
  double sum = 0;
  for (const Rest& rest : passages.rests) {
    double vv = 0, uv = 0, uu = 0;  // products of whitened lengths and ones
    elementary::LogProduct scales;
    for (std::size_t k = 0; k < rest.S.size(); ++k) {
      const double deviation = deviation_at(rest, k);
      double u = (rest.S[k] - rest.S[0]) / deviation, v = 1 / deviation;
      if (k > 0) {
        const double before = deviation_at(rest, k - 1);
        u = (u - correlation * (rest.S[k - 1] - rest.S[0]) / before) / innovation;
        v = (v - correlation / before) / innovation;
      }
      vv += v * v;
      uv += u * v;
      uu += u * u;
      scales.multiply(std::sqrt(2 * std::numbers::pi) * deviation * (k > 0 ? innovation : 1) /
                      std::max(std::abs(rest.S_force[k]), 1e-9));  // per force
    }
    sum += -scales.value() - 0.5 * (uu - uv * uv / vv) +
           elementary::log(std::sqrt(2 * std::numbers::pi / vv) / (2 * rest.jump));
  }
  return sum;
}

namespace {

// The frictions of friction_at_stage, and their states.
struct Levels {
  std::vector<double> mu;
  SlopeArrays states;
};

// Solves from approximate frictions `mu` between two bounds; compliance in [L^3/EI] with the fitted
// EI.
Levels levels_between(double least, double most, std::span<const double> S, std::span<const double> stage,
                      std::vector<double> mu, const Fibre& fibre, double compliance) {
  SlopeArrays states(S.size());
  const auto columns = states.columns();
  std::vector<std::size_t> moving(S.size());  // readings that have not converged
  std::iota(moving.begin(), moving.end(), 0);
  std::vector<Bracket> ends(S.size(),
                            {-infinity, infinity});  // at the end of the branch: frictions without and with a state
  constexpr int iterations = 12;
  for (int iteration = 0; iteration < iterations && !moving.empty(); ++iteration) {
    std::vector<double> S_here, mu_here;
    for (const std::size_t i : moving) {
      S_here.push_back(S[i]);
      mu_here.push_back(mu[i]);
    }
    SlopeArrays here = fibre.states_slopes_before_branch_end({S_here, mu_here});
    const auto from = here.columns();
    std::size_t left = 0;
    for (std::size_t j = 0; j < mu_here.size(); ++j) {
      const std::size_t i = moving[j];
      const double miss = here.w[j] + here.F[j] * compliance - stage[i];
      double next = mu[i] - miss / (here.w_q[j] + here.F_q[j] * compliance);
      const bool exists = std::isfinite(next);
      (exists ? ends[i].high : ends[i].low) = mu[i];
      if (exists || ends[i].high == infinity)
        for (std::size_t k = 0; k < columns.size(); ++k) columns[k][i] = from[k][j];
      if (!exists && ends[i].high == infinity)
        next = mu[i] + 0.25;
      else if (!exists || next <= ends[i].low)
        next = ends[i].middle();
      next = std::clamp(next, least, most);
      const double move = next - mu[i];
      mu[i] = next;
      constexpr double negligible =
          1e-6;  // of μ, compared with the softness of bounds, 0.003; convergence is quadratic
      if (std::abs(move) >= negligible)
        moving[left++] = i;
      else if (exists)
        states.F[i] += here.F_q[j] * move;
    }
    moving.resize(left);
  }
  for (const std::size_t i : moving)
    if (ends[i].high < infinity) mu[i] = ends[i].high;
  return {std::move(mu), std::move(states)};
}

// μ extrapolated to other lengths, stage positions and EI.
std::vector<double> levels_ahead(const Linearisation& at, double compliance) {
  std::vector<double> mu = at.mu;
  for (std::size_t i = 0; i < at.found.size(); ++i) {
    const LevelFound& found = at.found[i];
    const double ahead =
        (at.stage[i] - found.stage - found.stage_S * (at.S[i] - found.S) - found.F * (compliance - found.compliance)) /
        found.stage_mu;
    if (std::isfinite(ahead)) mu[i] += ahead;
  }
  for (double& value : mu) value = std::clamp(value, min_mu, max_mu);
  return mu;
}

}  // namespace

void complete(Linearisation& at, const Passages& passages) {
  const std::size_t n = passages.size();
  at.rig.resize(passages.rig_errors.size(), 0.0);
  at.wave_slope.resize(n, 0.0);
  at.stage = passages.stage;
  at.force = passages.force;
  for (std::size_t r = 0; r < at.rig.size(); ++r)
    for (std::size_t i = 0; i < n; ++i) {
      const Shift& shift = passages.rig_errors[r].shift[i];
      at.stage[i] += at.rig[r] * (shift.deflection + passages.compliance * shift.force);
      at.force[i] += at.rig[r] * shift.force;
    }
  // Fitted states lie within the observed lengths, or slightly outside.
  const auto [least, greatest] = std::minmax_element(passages.S.begin(), passages.S.end());
  const auto& options = passages.options;
  const double beyond = options.beyond_seen * (*greatest - *least);
  const double low = std::max(*least - beyond, min_S), high = std::min(*greatest + beyond, max_S);
  for (double& S : at.S) S = std::clamp(S, low, high);
  at.S = non_falling(at.S);
  // The friction at which the specimen passes this length, from the stage alone. The measured force
  // then gives the residual.
  const double compliance = passages.compliance * elementary::exp(at.eta);
  auto [mu, states] =
      levels_between(min_mu, max_mu, at.S, at.stage, levels_ahead(at, compliance), passages.fibre, compliance);
  at.mu = std::move(mu);
  at.found.clear();
  for (std::size_t i = 0; i < n; ++i)
    at.found.push_back({.S = at.S[i],
                        .stage = at.stage[i],
                        .compliance = compliance,
                        .F = states.F[i],
                        .stage_S = states.w_S[i] + states.F_S[i] * compliance,
                        .stage_mu = states.w_q[i] + states.F_q[i] * compliance});
  const auto slopes = inverse_slopes(states);
  const double softer = elementary::exp(-at.eta), stiffer = elementary::exp(at.eta);
  for (auto* column : {&at.S_seen, &at.S_force, &at.S_eta, &at.noise_gain, &at.y}) column->resize(n);
  elementary::LogProduct gains;
  for (std::size_t i = 0; i < n; ++i) {
    at.S_force[i] = slopes.S_F[i] * softer - slopes.S_w[i] * passages.compliance;
    const double q_force =
        std::max(slopes.q_F[i] * softer - slopes.q_w[i] * passages.compliance, options.min_force_slope);
    at.S_eta[i] = -slopes.F[i] * slopes.S_F[i];
    const double fold = 1 - at.slope[i] * at.S_force[i] / q_force;  // G'/G_S: 0 at a fold
    at.noise_gain[i] = q_force * std::max(fold, options.min_fold);
    const double error = slopes.F[i] > 0 ? at.force[i] - stiffer * slopes.F[i] : 0;
    at.S_seen[i] = at.S[i] + at.S_force[i] * error;
    at.y[i] = at.mu[i] + at.noise_gain[i] * error;
    gains.multiply(at.noise_gain[i]);
  }
  at.log_jacobian = gains.value();
}

std::vector<double> friction_at_stage(std::span<const double> S, std::span<const double> stage,
                                      std::span<const double> near, const Fibre& fibre, double compliance, double eta) {
  return levels_between(min_q, max_q, S, stage, {near.begin(), near.end()}, fibre, compliance * elementary::exp(eta))
      .mu;
}

Linearisation rises_of(const Passages& passages) {
  const auto& options = passages.options;
  const std::size_t n = passages.size();
  Linearisation at;
  at.mu = passages.q;
  at.S = non_falling(passages.S);
  at.slope.assign(n, 0);
  complete(at, passages);
  if (!options.parts.rises) return at;

  const double noise = std::max(noise_of_second_differences(second_differences(passages.force)), options.rises_noise);
  // Cumulative sums of the weights and of their moments with the stage x and the length y.
  struct Sums {
    double w = 0, x = 0, xx = 0, y = 0, xy = 0, yy = 0;
  };
  std::vector<Sums> sums(n + 1);
  const double S_middle = 0.5 * (passages.S.front() + passages.S.back());
  const double begin = passages.stage.front(), travel = passages.stage.back() - begin;
  for (std::size_t i = 0; i < n; ++i) {
    const double s = std::max(std::abs(at.S_force[i]) * noise, options.rises_deviation);
    const double w = 1 / (s * s), x = (passages.stage[i] - begin) / travel, y = passages.S[i] - S_middle;
    const Sums& b = sums[i];
    sums[i + 1] = {b.w + w, b.x + w * x, b.xx + w * x * x, b.y + w * y, b.xy + w * x * y, b.yy + w * y * y};
  }
  struct Piece {
    double w, x, y, slope, cost;
  };
  const auto piece = [&](std::size_t i, std::size_t j) {
    const Sums &a = sums[i], &b = sums[j];
    const double w = b.w - a.w, x = b.x - a.x, y = b.y - a.y;
    const double xx = std::max(b.xx - a.xx - x * x / w, 0.0), xy = b.xy - a.xy - x * y / w;
    const double yy = std::max(b.yy - a.yy - y * y / w, 0.0);
    const double slope = xx > 1e-12 * (b.xx - a.xx) ? std::max(xy, 0.0) / xx : 0;
    return Piece{w, x / w, y / w, slope, 0.5 * (yy - 2 * slope * xy + slope * slope * xx)};
  };
  const double penalty = options.rise_cost * elementary::log(static_cast<double>(n));
  constexpr std::size_t longest = 200;
  std::vector<double> best(n + 1, 0);
  std::vector<std::size_t> from(n + 1, 0);
  for (std::size_t j = 1; j <= n; ++j) {
    best[j] = infinity;
    for (std::size_t i = j > longest ? j - longest : 0; i < j; ++i)
      if (const double cost = best[i] + piece(i, j).cost + penalty; cost < best[j]) {
        best[j] = cost;
        from[j] = i;
      }
  }
  for (std::size_t j = n; j > 0; j = from[j]) {
    const Piece fitted = piece(from[j], j);
    for (std::size_t i = from[j]; i < j; ++i)
      at.S[i] = S_middle + fitted.y + fitted.slope * ((passages.stage[i] - begin) / travel - fitted.x);
  }
  at.S = non_falling(at.S);
  complete(at, passages);
  return at;
}

double landing_of(const Stuck& stuck, std::span<const double> S) {
  return std::clamp(stuck.S, S[stuck.reading - 1], stuck.reading < S.size() ? S[stuck.reading] : infinity);
}

std::vector<SkippedPoint> skipped_segments(const Passages& passages, const Linearisation& at, double noise,
                                           const std::vector<SkippedPoint>& before) {
  const auto& options = passages.options;
  const auto& S = at.S;
  std::vector<SkippedPoint> sites;
  if (!options.parts.gaps) return sites;
  auto kept = before.begin();
  auto stuck = passages.stuck.begin();
  const auto keep = [&](SkippedPoint site) {
    const auto place = [](const SkippedPoint& each) { return std::pair{each.reading, each.node}; };
    while (kept != before.end() && place(*kept) < place(site)) ++kept;
    const bool was_there = kept != before.end() && place(*kept) == place(site) && kept->nodes == site.nodes;
    sites.push_back(was_there ? *kept : site);
  };
  for (std::size_t i = 1; i <= S.size(); ++i) {
    std::optional<Stuck> rest;
    if (stuck != passages.stuck.end() && stuck->reading == i) rest = *stuck++;
    if (i == S.size() && !rest) break;
    const double jump = (rest ? landing_of(*rest, S) : S[i]) - S[i - 1];
    const double blur = std::abs(at.S_force[std::min(i, S.size() - 1)]) * noise;
    if (!rest && !(jump > options.gap_advances * passages.advance[i] + options.gap_noise * blur)) continue;
    const double spacing =
        0.5 * passages.range / passages.share / options.gap_spacing;  // [L] in S, for a few nodes per jump
    const auto count = static_cast<std::size_t>(std::clamp(std::ceil(jump / spacing), options.min_gap_places,
                                                           std::max(options.min_gap_places, options.max_gap_places)));
    for (std::size_t node = 1; node <= count; ++node) {
      if (jump * static_cast<double>(count + 1 - node) < options.gap_margin * blur * static_cast<double>(count + 1))
        break;
      keep({.reading = i, .node = node, .nodes = count, .stuck = rest});
    }
    if (rest) keep({.reading = i, .node = count + 1, .nodes = count, .stuck = rest, .held = true});
  }
  return sites;
}

double log_weight(const SkippedPoint& site, double mean, double variance) {
  const double precision = 1 / std::max(variance, 1e-12) - site.precision;
  if (!(precision > 1e-10)) return 0;
  const double cavity_variance = 1 / precision;
  const double cavity = (mean / std::max(variance, 1e-12) - site.precision_mean) * cavity_variance;
  const double z = cavity / std::sqrt(cavity_variance + bound_softness * bound_softness);
  double weight = elementary::gaussian_below(z).log_probability;
  if (site.precision > 0) {
    const double spread = cavity_variance + 1 / site.precision;
    const double away = site.precision_mean / site.precision - cavity;
    weight += 0.5 * (elementary::log(2 * std::numbers::pi * spread) + away * away / spread);
  }
  return weight;
}

}  // namespace flexslip
