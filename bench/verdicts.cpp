// How often slips are called cracks, and cracks slips, on simulated tests: bench/verdicts KIND FIRST COUNT prints a line of CSV for each.
// Slipping kinds: smooth (one sinusoid), rough (as the authors' specimens), two_supports (rough, each support on its own). Cracked: cracked.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/simulated_tests.h"
#include "bending_test/history.h"
#include "data/drops.h"
#include "data/scales.h"
#include "inference/slip_or_crack.h"

namespace flexslip {
namespace {

// Noise such as real tests have, white or correlated.
void set_noise(Truth& truth, Random& random) {
  truth.noise = std::exp(random.between(std::log(0.003), std::log(0.03)));
  truth.correlation = random.uniform() < 0.5 ? 0 : 0.7;
}

// What friction along both sides comes to in loading: the weaker side slides.
std::vector<double> weaker_of(const std::vector<double>& left, const std::vector<double>& right) {
  std::vector<double> weaker;
  std::size_t l = 0, r = 0;
  while (l + 1 < left.size() && r + 1 < right.size()) {
    weaker.push_back(std::min(left[l], right[r]));
    ++(left[l] <= right[r] ? l : r);
  }
  return weaker;
}

Truth slipping_truth(const std::string& kind, Random& random) {
  Truth t = truth_of(kind == "smooth" ? "independent" : "measured", random);
  t.k = random.between(18, 60);
  set_noise(t, random);
  if (kind == "smooth") t.waves[0].wavelength = random.between(8, 20);
  if (kind == "two_supports") {
    t.bumps = weaker_of(t.bumps, matern_bumps(t.roughness, t.length, random));
    t.spacing *= 0.5;  // in (S - 1)/2, of which each side that slides alone takes but half
  }
  return t;
}

// Constant friction, and 5 to 25 cracks that leave 40 to 85 % of the bending stiffness.
FitProblem cracked_test(Random& random) {
  Truth t;
  t.mu0 = random.between(0.2, 0.8);
  t.k = random.between(18, 60);
  t.stiffening = std::exp(0.03 * random.normal());
  set_noise(t, random);
  const auto cracks = static_cast<std::size_t>(random.between(5, 26));
  std::vector<double> at, shares;
  for (std::size_t i = 0; i < cracks; ++i) at.push_back(random.between(0.1, 0.38));
  std::sort(at.begin(), at.end());
  const double at_the_end = random.between(0.4, 0.85);
  double total = 0;
  for (std::size_t i = 0; i < cracks; ++i) {
    shares.push_back(-std::log(random.uniform()));
    total += shares.back();
  }
  std::vector<Crack> all;
  for (std::size_t i = 0; i < cracks; ++i)
    all.push_back({at[i], -std::expm1(std::log(at_the_end) * shares[i] / total)});
  std::vector<double> stages;
  for (int i = 1; i < 2000; ++i) stages.push_back(i * 2 / span);
  const History history = follow_in_steps({Friction::constant(t.mu0), {t.k / t.stiffening}}, stages, all);
  std::vector<double> forces;
  for (const PathPoint& point : history.path) forces.push_back(point.F * t.stiffening);
  return measured(stages, forces, t, random);
}

int run(int count, char** arguments) {
  if (count != 4) {
    std::fprintf(stderr, "usage: verdicts KIND FIRST COUNT\n");
    return 2;
  }
  const std::string kind = arguments[1];
  constexpr std::array kinds{"smooth", "rough", "two_supports", "cracked"};
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
    std::fprintf(stderr, "%s is no kind of test\n", kind.c_str());
    return 2;
  }
  const int first = std::atoi(arguments[2]), tests = std::atoi(arguments[3]);
  std::printf("kind,test,k,noise,drops,rises,stiffer_rises,margin_arrested,margin,left_by_cracks,verdict\n");
  for (int test = first; test < first + tests; ++test) {
    Random random = random_of(kind, test);
    const FitProblem problem =
        kind == "cracked" ? cracked_test(random) : simulated(slipping_truth(kind, random), random);
    const auto drops = find_drops(to_physical(problem.record, Scales(1, 1))).drops;
    const SlipOrCrack found = slip_or_crack(problem.record, problem.rig, drops);
    std::printf("%s,%d,%.1f,%.4f,%zu,%zu,%zu,%.1f,%.1f,%.2f,%s\n", kind.c_str(), test, problem.rig.stiffness,
                problem.errors.force, drops.size(), found.rises, found.stiffer_rises, found.margin_arrested,
                found.margin, found.cracks.left,
                found.judged ? std::string(name_of(found.verdict)).c_str() : "not_judged");
  }
  return 0;
}

}  // namespace
}  // namespace flexslip

int main(int count, char** arguments) { return flexslip::run(count, arguments); }
