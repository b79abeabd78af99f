#include "inference/rig_score_correction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "inference/chain.h"

namespace flexslip {
namespace {

using Eigen::Index;

// The process with the readings corrected for the rig of a mode.
Passages of_known_rig(const FrictionProcess& process, const Mode& mode) {
  Passages passages = process.passages();
  passages.stage = mode.at.stage;
  passages.force = mode.at.force;
  passages.rig_errors.clear();
  passages.stiffness_error = 0;
  return passages;
}

}  // namespace

Coefficients rig_score_correction(const FrictionProcess& process, const Mode& mode) {
  const Observations all = process.observations_of(mode);
  const auto& columns = process.columns();
  Coefficients pull = Coefficients::Zero(columns.waves);
  if (mode.kernel == Kernel::none || columns.stiffness < 0) return pull;
  const FrictionProcess known(of_known_rig(process, mode));
  Mode middle = mode;
  middle.at.rig.clear();
  complete(middle.at, known.passages());
  const SearchOptions& o = process.options();
  const auto merit_beside = [&](double eta) {
    Mode beside = middle;
    beside.at.eta += eta;
    complete(beside.at, known.passages());
    known.burst(beside, o.settle);  // first the states at this bending stiffness
    known.polish(beside, o.pull);
    return beside.log_posterior;
  };
  known.settle(middle);
  const Observations seen = known.observations_of(middle);
  const Chain chain(seen, middle.kernel, hyperparameters_of(middle.theta));
  const std::vector<double> by_stiffness = known.by_stiffness(middle);
  std::vector<double> whitened(by_stiffness.size());
  chain.whiten(by_stiffness, whitened);
  const auto white = chain.whitened_columns();
  const Eigen::VectorXd unexplained =
      white.row(white.rows() - 1).transpose() - white.topRows(white.rows() - 1).transpose() * chain.mean();
  const Eigen::Map<const Eigen::VectorXd> column(whitened.data(), static_cast<Index>(whitened.size()));
  if (!(column.squaredNorm() > 0)) return pull;  // no effect on any reading
  // Within the resolution of the readings.
  const Eigen::VectorXd with_columns = white.topRows(white.rows() - 1) * column;
  const double information = column.squaredNorm() - with_columns.dot(chain.covariance() * with_columns);
  const double step = std::min(1 / std::sqrt(information), o.pull_most_step);
  const double above = merit_beside(step), below = merit_beside(-step), slope = (above - below) / (2 * step);
  if (!std::isfinite(slope)) return pull;
  // If the values do not form a parabola, or rise too steeply, they belong to several modes and
  // give no slope.
  const double off = above + below - 2 * middle.log_posterior + information * step * step;
  const double most = o.pull_most / process.passages().stiffness_error;  // limits the change of ln EI to three errors
  const double more = slope - column.dot(unexplained), over = std::max(std::abs(more) / most, 1.0);
  const double besides = more / (over * over * over * over * (1 + off * off));

  pull[columns.stiffness] = besides;
  const std::vector<double> by = process.by_stiffness(mode);
  double squares = 0;
  for (std::size_t k = 0; k < by.size(); ++k) {
    if (!all.all[k].is_reading()) continue;
    squares += by[k] * by[k];
    for (Index r = columns.rig; r < columns.waves; ++r) pull[r] += besides * by[k] * all.columns[k][r];
  }
  for (Index r = columns.rig; r < columns.waves; ++r) pull[r] /= squares;
  return pull;
}

}  // namespace flexslip
