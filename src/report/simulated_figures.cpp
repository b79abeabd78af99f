#include "report/simulated_figures.h"

#include "report/model_figures.h"

namespace flexslip {

Figure simulated_figure(const SimulatedTest& test, const std::vector<Crack>& cracks) {
  const FollowedTest& followed = test.followed.value();
  const History drawn =
      followed.in_steps ? follow_continuously(followed.bending_test, followed.stages, 2, cracks) : followed.history;
  return measured_figure(followed.bending_test, drawn, legs_of(drawn, followed.legs),
                         {test.scales, test.reduced, test.in_inches});
}

Figure equilibria_figure(const SimulatedTest& test, std::span<const double> stages) {
  const BendingTest& bending_test = test.followed.value().bending_test;
  return overall_equilibria_figure(bending_test.friction.kinetic, bending_test.rig, stages,
                                   {test.scales, test.reduced, test.in_inches});
}

}  // namespace flexslip
