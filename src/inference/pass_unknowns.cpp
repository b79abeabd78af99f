#include "inference/pass_unknowns.h"

#include <algorithm>
#include <cmath>

#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A column with a number for each row.
template <class Value>
VectorXd column_of(const PassRows& rows, const Value& value) {
  VectorXd column(index_of(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) column[index_of(i)] = value(i);
  return column;
}

bool is_inwards(const Leg& leg) { return leg.direction == Direction::loading; }

// The friction at which thickness and supports act.
double usual_friction(const PassStates& read) {
  constexpr double least = 0, most = 1.5, unknown = 0.4;
  std::vector<double> sizes;
  for (Index i = 0; i < read.q.size(); ++i)
    if (read.is_read(i)) sizes.push_back(std::abs(read.q[i]));
  return sizes.empty() ? unknown : std::clamp(median_of(std::move(sizes)), least, most);
}

FitProblem as_fit_problem(const PassesProblem& problem) {
  return {problem.record, problem.rig, problem.errors, problem.rig_errors};
}

// [1] For each row, the reached share of the deflections that a leg adds to all previous ones;
// empty if it adds none.
std::vector<double> fresh_part(const ReducedRecord& record, const Leg& leg, double farthest, double reached) {
  constexpr double worth_it = 0.02;    // [L] added deflection
  constexpr double shows_from = 0.06;  // [L] smaller deflections barely show a loss
  if (!is_inwards(leg) || !(reached > farthest + worth_it)) return {};
  const double from = std::max(farthest, std::min(shows_from, 0.5 * reached));
  std::vector<double> part(record.deflection.size(), 0);
  double most = farthest;
  for (std::size_t i = leg.first; i < part.size(); ++i) {
    if (i < leg.last) most = std::max(most, record.deflection[i]);
    part[i] = std::clamp((most - from) / (reached - from), 0.0, 1.0);
  }
  return part;
}

}  // namespace

std::vector<NeededLoss> losses_needed(const ReducedRecord& record, const std::vector<Drop>& drops, const Fibre& fibre) {
  constexpr double shows_from = 0.04;  // [L] smaller deflections carry almost no information
  constexpr double broken = 0.02;      // [1] remaining stiffness below which a drop is a failure
  std::vector<NeededLoss> needed;
  double left = 1;
  for (const Drop& drop : drops) {
    const Eigen::Vector2d w(record.deflection[drop.before], record.deflection[drop.after]);
    const Eigen::Vector2d F(record.force[drop.before], record.force[drop.after]);
    if (!(w[0] > shows_from)) continue;
    const PassStates read = states_read(w, F, fibre);
    if (!read.is_read(0) || !read.is_read(1)) continue;
    const double friction = read.q[0] + (1 / left - 1) * F[0] / read.F_q[0];
    const double after = std::min(F[1] / (F[1] + read.F_q[1] * (friction - read.q[1])), left);
    if (!(after > broken)) continue;
    needed.push_back({drop.before, drop.after, elementary::log(left / after)});
    left = after;
  }
  return needed;
}

std::vector<Drop> with_breaks(std::vector<Drop> drops, const ReducedRecord& record, const std::vector<Leg>& legs) {
  constexpr double beyond = 4;        // [noise of a step] 3.3 determines friction no better
  constexpr double least = 0.003;     // [maximum force] uncertainty of the trend itself
  constexpr std::size_t enough = 30;  // rows of a loading, to determine its noise
  const std::vector<Drop> known = drops;
  const auto is_known = [&](std::size_t row) {
    return std::any_of(known.begin(), known.end(),
                       [&](const Drop& drop) { return row + 1 >= drop.before && row <= drop.after; });
  };
  const double least_fall = least * *std::max_element(record.force.begin(), record.force.end());
  for (const Leg& leg : legs) {
    if (!is_inwards(leg) || leg.last - leg.first < enough) continue;
    Record loading = points_between({record.stage, record.deflection, record.force}, leg.first, leg.last);
    loading.stage = advancing(loading.stage);
    const std::vector<double> course = smooth_steps(loading);
    const double enough_fall = std::max(beyond * StepNoise(loading, course).over(1), least_fall);
    for (std::size_t i = 0; i < course.size(); ++i) {
      const std::size_t row = leg.first + i;
      const double fall = record.force[row] - record.force[row + 1];
      if (course[i] + fall > enough_fall && !is_known(row))
        drops.push_back({.before = row, .after = row + 1, .force_fall = fall, .advance = 0, .significance = 0});
    }
  }
  std::sort(drops.begin(), drops.end(), [](const Drop& a, const Drop& b) { return a.before < b.before; });
  return drops;
}

PassUnknowns::PassUnknowns(const PassesProblem& problem, const std::vector<Leg>& legs,
                           const std::vector<NeededLoss>& needed, const PassRows& rows, const PassStates& read)
    : in_(as_fit_problem(problem), usual_friction(read)),
      out_(as_fit_problem(problem), -usual_friction(read)),
      side_(rows.side) {
  for (MatrixXd* map : {&W, &G, &E, &L}) map->resize(index_of(rows.size()), 0);
  deviations = prior_deviations(problem.errors, problem.rig_errors, problem.rig.fibre.supports());
  E.col(add(0, problem.errors.bending_stiffness)).setOnes();
  add_rig(rows);
  add_zero(problem, rows);
  add_wear(problem.options, legs, rows, read);
  add_losses(problem, legs, needed, rows);
}

Index PassUnknowns::add(double prior_mean, double prior_deviation) {
  const Index column = size();
  for (VectorXd* each : {&mean, &deviation, &below_zero, &log_loss, &settled}) each->conservativeResize(column + 1);
  mean[column] = prior_mean;
  deviation[column] = below_zero[column] = prior_deviation;
  log_loss[column] = settled[column] = 0;
  for (MatrixXd* map : {&W, &G, &E, &L}) {
    map->conservativeResize(Eigen::NoChange, column + 1);
    map->col(column).setZero();
  }
  return column;
}

// Adds an unknown that is almost certainly positive.
Index PassUnknowns::add_one_sided(double prior_deviation, double below) {
  const Index column = add(0, prior_deviation);
  below_zero[column] = std::min(below, prior_deviation);
  return column;
}

void PassUnknowns::add_rig(const PassRows& rows) {
  const std::size_t count = in_.deviations(0, 0).size();
  for (std::size_t i = 0; i < count; ++i) add(0, 1);
  auto [moved_w, moved_F] = at(rows.w, rows.F);
  W = std::move(moved_w);
  G = std::move(moved_F);
}

PassUnknowns::Moved PassUnknowns::at(const VectorXd& w, const VectorXd& F) const {
  Moved moved{W, G};
  for (Index i = 0; i < w.size(); ++i) {
    if (!(F[i] == F[i])) continue;
    Index column = 1;
    for (const Shift& shift : (side_[static_cast<std::size_t>(i)] > 0 ? in_ : out_).deviations(w[i], F[i])) {
      moved.W(i, column) = shift.deflection;
      moved.G(i, column++) = shift.force;
    }
  }
  return moved;
}

// An error of the force also changes the deflection of the load train.
void PassUnknowns::add_zero(const PassesProblem& problem, const PassRows& rows) {
  const PassesOptions& options = problem.options;
  const double compliance = 1 / problem.rig.stiffness;
  const double greatest = *std::max_element(problem.record.force.begin(), problem.record.force.end());
  const auto last = static_cast<double>(problem.record.force.size());
  const auto add_force = [&](double prior_deviation, const auto& part) {
    const Index column = add(0, prior_deviation);
    G.col(column) =
        column_of(rows, [&](std::size_t i) { return greatest * part(static_cast<double>(rows.row[i]) / last); });
    W.col(column) = -compliance * G.col(column);
  };
  add_force(options.zero, [](double) { return 1.0; });
  add_force(options.drift, [](double time) { return time; });
  constexpr int ramps = 8;
  for (int j = 0; j < ramps; ++j)
    add_force(options.wander / std::sqrt(static_cast<double>(ramps)),
              [j](double time) { return std::clamp(ramps * time - j, 0.0, 1.0); });
}

void PassUnknowns::add_wear(const PassesOptions& options, const std::vector<Leg>& legs, const PassRows& rows,
                            const PassStates& read) {
  double longest = 1;
  for (Index i = 0; i < read.S.size(); ++i)
    if (read.is_read(i)) longest = std::max(longest, read.S[i]);
  const auto along = [&](std::size_t i) {  // from -1 to 1 over the sliding length
    return std::clamp(2 * (read.S[index_of(i)] - 1) / std::max(longest - 1, 1e-9) - 1, -1.0, 1.0);
  };
  for (std::size_t leg = 1; leg < legs.size(); ++leg) {
    const auto after = [&](std::size_t i) { return rows.pass[i] >= leg ? 1.0 : 0.0; };
    L.col(add(0, is_inwards(legs[leg]) ? options.level_at_bottom : options.level_at_top)) = column_of(rows, after);
    L.col(add(0, options.level_trend)) = column_of(rows, [&](std::size_t i) { return after(i) * along(i); });
  }
}

void PassUnknowns::add_losses(const PassesProblem& problem, const std::vector<Leg>& legs,
                              const std::vector<NeededLoss>& needed, const PassRows& rows) {
  const PassesOptions& options = problem.options;
  constexpr double least_drop = 0.003;  // minimum prior deviation of the loss in a drop
  double farthest = 0;
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    double reached = farthest;
    for (std::size_t i = legs[leg].first; i < legs[leg].last; ++i)
      reached = std::max(reached, problem.record.deflection[i]);
    const double is_followed = leg + 1 < legs.size() ? 1 : 0;  // a later pass measures the loss
    const std::vector<double> fresh = fresh_part(problem.record, legs[leg], farthest, reached);
    farthest = reached;
    if (!fresh.empty() && is_followed > 0) {
      const VectorXd gradually = column_of(rows, [&](std::size_t i) { return fresh[rows.row[i]]; });
      double whole = 0;
      VectorXd in_drops = VectorXd::Zero(gradually.size());
      for (const NeededLoss& drop : needed) {
        if (!is_in(legs[leg], drop.before)) continue;
        const VectorXd after = column_of(rows, [&](std::size_t i) { return rows.row[i] >= drop.after ? 1.0 : 0.0; });
        const Index column = add(0, elementary::length(options.each_drop * drop.log_loss, least_drop));
        E.col(column) = -after;
        log_loss[column] = is_followed;
        in_drops += drop.log_loss * after;
        whole += drop.log_loss;
      }
      if (whole > 0) {
        const Index column = add(options.share_of_drops, options.share_of_drops);
        E.col(column) = -in_drops;
        log_loss[column] = is_followed * whole;
      }
      const Index slowly = add_one_sided(options.gradual_loss, options.stiffening);
      E.col(slowly) = -gradually;
      log_loss[slowly] = is_followed;
      E.col(add(0, options.course_of_loss)) = -4 * gradually.cwiseProduct((1 - gradually.array()).matrix());
      const Index settles = add_one_sided(options.settling, options.rising);
      W.col(settles) = -gradually;
      settled[settles] = is_followed;
    }
    if (leg == 0) continue;
    const VectorXd after = column_of(rows, [&](std::size_t i) { return rows.pass[i] >= leg ? 1.0 : 0.0; });
    const bool at_bottom = is_inwards(legs[leg]);
    const Index at_turn =
        add_one_sided(at_bottom && is_followed > 0 ? options.loss_at_reload : options.loss_at_turn, options.stiffening);
    E.col(at_turn) = -after;
    log_loss[at_turn] = 1;
    const double contact_change = at_bottom ? options.contact_change : options.contact_change_at_top;
    if (contact_change > 0) W.col(add(0, contact_change)) = -after;
  }
}

}  // namespace flexslip
