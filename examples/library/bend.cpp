// FlexSlip as a library: simulates a bending test, and reads the friction off what it measures.
#include <cmath>
#include <cstdio>
#include <vector>

#include "bending_test/history.h"
#include "data/scales.h"
#include "inference/analysis.h"

using namespace flexslip;

int main() {
  // 1. A fibre of glass, 34.8 µm thick, on supports 1278 µm apart. The library computes in spans L and in forces EI/L².
  const double span = 1278e-6, diameter = 34.8e-6, modulus = 29.6e9;
  const Scales scales(span, modulus * round_section_moment(diameter));

  // 2. Friction that repeats every 10.9 µm along the fibre, and a load train of 90.65 N/m.
  const BendingTest test{.friction = Friction::sinusoid(0.5, 0.15, scales.reduced_length(10.9e-6), 0),
                         .rig = {scales.reduced_stiffness(90.65)}};

  // 3. The stage moves to 700 µm in steps of 2 µm: the path, with its snaps and energies.
  std::vector<double> stages;
  for (int i = 0; i <= 350; ++i) stages.push_back(scales.reduced_length(2e-6 * i));
  const History history = follow_in_steps(test, stages);
  std::printf("snaps: %zu\n", history.snaps.size());
  std::printf("friction took %.1f %% of the work on the specimen\n",
              100 * (history.energy.friction + history.energy.snaps) / work_of_fracture(history.energy));

  // 4. What an instrument would record, with noise of 10 µN, in SI.
  Record record;
  for (std::size_t i = 0; i < history.path.size(); ++i) {
    const double noise = 10e-6 * std::sin(1e4 * std::sin(static_cast<double>(i)));
    record.stage.push_back(scales.physical_length(history.path[i].stage));
    record.force.push_back(scales.physical_force(history.path[i].F) + noise);
    record.deflection.push_back(record.stage.back() - record.force.back() / 90.65);
  }

  // 5. The friction of that record. A status says which fields are valid.
  const TestAnalysis analysis = analyse(record, {.span = span,
                                                 .load_train_stiffness = 90.65,
                                                 .bending_stiffness = scales.bending_stiffness(),
                                                 .bending_stiffness_error = 0.03});
  if (analysis.status != AnalysisStatus::ok) return 1;
  std::printf("mu0 = %.3f +- %.3f\n", analysis.fit.mu0.value, analysis.fit.mu0.standard_error);
  for (const WaveEstimate& wave : analysis.fit.waves)
    std::printf("every %.2f um\n", 1e6 * scales.physical_length(wave.wavelength.value));
}
