#include "inference/fitted_point.h"

#include "inference/polar_parameters.h"

namespace flexslip {

ForceModel model_of(const FitProblem& whole) {
  const FitProblem problem = thinned(usable_part(whole));
  return {problem, measure_friction(problem.record, problem.rig, problem.errors, friction_shows_from)};
}

FitPoint fitted_point(const ForceModel& model, const ModelFit& fit) {
  // The constant model has no drift: its layout is that of its parameters.
  const ModelLayout layout{fit.model != ProfileModel::constant, static_cast<Eigen::Index>(fit.waves.size())};
  Eigen::VectorXd q(layout.size());
  q[0] = fit.mu0.value;
  if (layout.drift) q[1] = fit.drift.value;
  for (Eigen::Index i = 0; i < layout.waves; ++i) {
    const auto& wave = fit.waves[static_cast<std::size_t>(i)];
    q.segment(layout.wave(i), 3) << wave.amplitude.value, wave.wavelength.value, wave.phase.value;
  }
  q[layout.stiffness()] = fit.bending_stiffness.value - 1;
  return {layout,
          PolarParameters{model.middle(), 0}.to_cartesian(layout, q),
          {fit.correlation, fit.innovation * fit.innovation},
          fit.log_likelihood,
          fit.status == FitStatus::ok};
}

}  // namespace flexslip
