#include "inference/passes_solution.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr std::size_t rows_of_a_loading = 10;  // minimum of rows that slide in

using Eigen::Index;
using Eigen::VectorXd;

// A linear functional of all unknowns with its error.
class Told {
 public:
  explicit Told(const PassesSolution& best) : best_(best) {}

  double value(const VectorXd& of) const { return of.dot(best_.solution); }
  double deviation(const VectorXd& of) const { return std::sqrt(std::max(of.dot(best_.covariance * of), 0.0)); }
  Estimate estimate(const VectorXd& of) const { return normal_estimate(value(of), widened * deviation(of)); }

  // The increase of errors by linearisation, outliers and correlations (bench/causes).
  static constexpr double widened = 1.2;

 private:
  const PassesSolution& best_;
};

// [1] The mean friction between two lengths.
VectorXd mean_between(const PassesSolution& best, double S_first, double S_last) {
  VectorXd mean = VectorXd::Zero(best.solution.size());
  double count = 0;
  for (Index j = 0; j < best.nodes.size(); ++j)
    if (best.nodes[j] >= S_first && best.nodes[j] <= S_last) {
      mean[j] = 1;
      ++count;
    }
  return count > 0 ? VectorXd(mean / count) : mean;
}

struct SlidOver {
  double first = infinity, last = 0;  // [L]
  void add(double S) {
    first = std::min(first, S);
    last = std::max(last, S);
  }
};

// [1] Additional relative error of the loss, from its unknown course.
constexpr double loss_of_loss = 0.06;

// The lengths at which the evaluated loading slides, as functionals of the unknowns: their scale and
// their middle.
struct LengthsRead {
  VectorXd scale;   // [1] relative
  VectorXd middle;  // [L]
};

LengthsRead lengths_read(const PassesSolution& best, const PassUnknowns& unknowns, const PassStates& read,
                         const VectorXd& F, const std::vector<std::size_t>& evaluated) {
  const VectorXd theta = best.solution.tail(unknowns.size());
  double middle = 0, spread = 0;
  for (const std::size_t row : evaluated) middle += read.S[index_of(row)] / static_cast<double>(evaluated.size());
  for (const std::size_t row : evaluated) spread += std::pow(read.S[index_of(row)] - middle, 2);
  LengthsRead lengths{VectorXd::Zero(unknowns.size()), VectorXd::Zero(unknowns.size())};
  for (const std::size_t row : evaluated) {
    const Index i = index_of(row);
    const double left = elementary::exp(-unknowns.E.row(i).dot(theta));
    const VectorXd dF = left * unknowns.G.row(i).transpose() - F[i] * unknowns.E.row(i).transpose();
    const VectorXd dw = unknowns.W.row(i).transpose();
    const VectorXd dS = read.S_w[i] * dw + read.S_q[i] / read.F_q[i] * (dF - read.F_w[i] * dw);
    lengths.scale += (read.S[i] - middle) / spread * dS;
    lengths.middle += dS / static_cast<double>(evaluated.size());
  }
  return lengths;
}

RigCorrection correction_of(const PassesProblem& problem, const std::vector<Leg>& legs,
                            const std::vector<NeededLoss>& needed, const VectorXd& theta) {
  const PassRows rows = rows_evaluated(problem, legs);
  const PassUnknowns unknowns(problem, legs, needed, rows, states_read(rows.w, rows.F, problem.rig.fibre));
  const VectorXd moved = unknowns.W * theta, more = unknowns.G * theta;
  const VectorXd lost = unknowns.E * theta;
  const double compliance = 1 / problem.rig.stiffness;
  std::vector<double> stage;
  std::vector<Shift> shift;
  double advanced = 0;
  for (Index i = 0; i < rows.w.size(); ++i) {
    if (!stage.empty() && !(rows.stage[i] > stage.back())) continue;
    const double unharmed = (rows.F[i] + more[i]) * elementary::exp(theta[PassUnknowns::stiffness] - lost[i]);
    Shift at{moved[i], unharmed - rows.F[i]};
    // The stage of the loading only advances, despite errors of the losses.
    advanced = std::max(advanced, rows.stage[i] + at.deflection + compliance * at.force);
    at.deflection = advanced - rows.stage[i] - compliance * at.force;
    stage.push_back(rows.stage[i]);
    shift.push_back(at);
  }
  return {std::move(stage), std::move(shift), compliance};
}

}  // namespace

PassesFit passes_fit_of(const PassesSolution& best, const PassesProblem& problem, const std::vector<Leg>& legs,
                        const std::vector<NeededLoss>& needed, const PassRows& rows, const PassUnknowns& unknowns) {
  PassesFit fit;
  fit.status = PassesStatus::ok;
  const Told told(best);
  const Index nodes = best.nodes.size();
  const Index all = best.solution.size();
  std::vector<SlidOver> slid(legs.size());
  std::vector<std::size_t> sliding(legs.size(), 0);
  SlidOver evaluated;
  std::vector<char> is_used(rows.size(), 0);
  for (const Index i : best.used) {
    const auto row = static_cast<std::size_t>(i);
    const std::size_t pass = rows.pass[row];
    is_used[row] = 1;
    slid[pass].add(best.S[i]);
    ++sliding[pass];
    fit.sliding_out += rows.side[row] < 0;
    if (rows.row[row] >= problem.first && rows.row[row] < problem.last && rows.w[i] > min_friction_deflection)
      evaluated.add(best.S[i]);
  }
  fit.S_first = evaluated.first;
  fit.S_last = evaluated.last;
  const VectorXd mean = mean_between(best, evaluated.first, evaluated.last);
  fit.mean_friction = told.estimate(mean);
  VectorXd stiffness = VectorXd::Zero(all);
  stiffness[nodes + PassUnknowns::stiffness] = 1;
  fit.log_stiffness = told.estimate(stiffness);
  fit.correlation = mean.dot(best.covariance * stiffness) / (told.deviation(mean) * told.deviation(stiffness));
  for (const StatedQuantity quantity : stated_quantities) {
    const Index column = nodes + unknowns.of(quantity);
    const double deviation = unknowns.deviations[quantity];
    const double in_prior = quantity == StatedQuantity::bending_stiffness ? deviation * deviation : deviation;
    fit.friction_by[quantity] = in_prior > 0 ? mean.dot(best.covariance.col(column)) / in_prior : 0;
    fit.log_stiffness_by[quantity] = in_prior > 0 ? stiffness.dot(best.covariance.col(column)) / in_prior : 0;
  }

  const auto of_unknowns = [&](const VectorXd& coefficients) {
    VectorXd functional = VectorXd::Zero(all);
    functional.tail(unknowns.size()) = coefficients;
    return functional;
  };
  std::size_t loadings = 0;
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    const bool slides_in = legs[leg].direction == Direction::loading && sliding[leg] >= rows_of_a_loading;
    loadings += slides_in;
    fit.is_followed = fit.is_followed || (slides_in && legs[leg].first >= problem.last);
  }
  fit.is_reloaded = loadings > 1;
  const Estimate lost = told.estimate(of_unknowns(unknowns.log_loss));
  const double left = elementary::exp(-lost.value);
  fit.loss = normal_estimate(1 - left, left * elementary::length(lost.standard_error, loss_of_loss * lost.value));
  double needs = 0;
  for (const NeededLoss& drop : losses_needed(problem.record, problem.drops, problem.rig.fibre))
    if (drop.before < legs.back().first) needs += drop.log_loss;
  fit.loss_needed = 1 - elementary::exp(-needs);
  fit.settled = told.estimate(of_unknowns(unknowns.settled));

  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    PassFriction pass{.rows = legs[leg], .sliding = sliding[leg], .friction = {}};
    pass.friction.value = pass.friction.standard_error = pass.friction.low = pass.friction.high = not_a_number;
    double level = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (is_used[i] && rows.pass[i] == leg)
        level += unknowns.L.row(index_of(i)).dot(best.solution.tail(unknowns.size()));
    if (sliding[leg] > 2)
      pass.friction = told.estimate(mean_between(best, slid[leg].first, slid[leg].last) *
                                    elementary::exp(level / static_cast<double>(sliding[leg])));
    fit.passes.push_back(pass);
  }
  const VectorXd theta = best.solution.tail(unknowns.size());
  VectorXd reduced = rows.F + unknowns.G * theta;
  const VectorXd log_e = unknowns.E * theta;
  for (Index i = 0; i < reduced.size(); ++i) reduced[i] *= elementary::exp(-log_e[i]);
  const PassStates read = states_read(rows.w + unknowns.W * theta, reduced, problem.rig.fibre);
  std::vector<std::size_t> of_evaluated;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (is_used[i] && read.is_read(index_of(i)) && rows.row[i] >= problem.first && rows.row[i] < problem.last)
      of_evaluated.push_back(i);
  if (of_evaluated.size() >= rows_of_a_loading) {
    const LengthsRead lengths = lengths_read(best, unknowns, read, reduced, of_evaluated);
    fit.stretch = Told::widened * told.deviation(of_unknowns(lengths.scale));
    fit.displaced = Told::widened * told.deviation(of_unknowns(lengths.middle));
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (read.is_read(index_of(i)))
      fit.points.push_back({rows.row[i], rows.pass[i], read.S[index_of(i)], read.q[index_of(i)], is_used[i] != 0});
  fit.correction = correction_of(problem, legs, needed, theta);
  return fit;
}

}  // namespace flexslip
