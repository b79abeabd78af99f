// FlexSlip as a library: simulates a bending test, and reads the friction off what it measures.
#include <cstdio>

#include <flexslip/flexslip.h>

using namespace flexslip::v1;

int main() try {
  // 1. A fibre of glass, 34.8 µm thick, on supports 1278 µm apart, with a load train of 90.65 N/m. Its modulus is known to 3 %.
  const Setup setup{.diameter = 34.8e-6, .modulus = {29.6e9, 0.9e9}, .span = 1278e-6, .load_train_stiffness = 90.65};

  // 2. The force at a deflection of 300 µm, without friction and with the friction that slides in.
  std::printf("force: %.2f mN without friction, %.2f mN with a friction of 0.5\n",
              1e3 * state_at(setup, 300e-6, 0).force, 1e3 * state_at(setup, 300e-6, 0.5).force);

  // 3. Friction that repeats every 10.9 µm along the fibre. The stage moves to 700 µm in steps of 2 µm, and the load cell has a noise of 10 µN.
  const Friction friction{.mu0 = 0.5, .waves = {{.amplitude = 0.15, .wavelength = 10.9e-6}}};
  const Simulation test = simulate(setup, friction, {.stages = {0, 700e-6}, .step = 2e-6, .force_noise = 10e-6});
  std::printf("snaps: %zu\n", test.snaps.size());
  std::printf("friction took %.1f %% of the work on the specimen\n",
              100 * (test.energies.friction + test.energies.snaps) / test.energies.work_of_fracture);

  // 4. What the instrument recorded: stage and force.
  Record record;
  for (const PathPoint& point : test.path) {
    record.stage.push_back(point.stage);
    record.force.push_back(point.force);
  }

  // 5. The answer to that record.
  const Fit answer = fit(setup, record);
  std::printf("%s\n", answer.sentence.c_str());
  std::printf("mu0 = %.3f +- %.3f\n", answer.mu0.value, answer.mu0.standard_error);
  for (const FittedWave& wave : answer.waves) std::printf("every %.2f um\n", 1e6 * wave.wavelength.value);
  return 0;
} catch (const Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
