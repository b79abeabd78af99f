// What each part and each threshold of the search for friction is worth.
//
// bench/ablation [--tests FIRST COUNT] [--kinds KIND,...] [--thresholds] [--only NAME,...] [CASE...] fits COUNT simulated tests of each kind, whose friction is
// known, and the measured tests of the cases: with all parts of the search, then with one part switched off at a time, or with each threshold at
// half and at double. It prints a line of CSV for each variation:
//   covered        simulated tests whose mean friction lies in its 95 % interval
//   rmse           [1] of the mean friction of the simulated tests
//   roughness      of those with roughness: its standard deviation and its correlation length lie in their intervals, in so many tests
//   waves_right    waves of simulated tests that are claimed, with their wavelength within 3 %
//   waves_covered  of these, those in whose 95 % interval the wavelength lies
//   waves_false    waves that are claimed without one of the truth so near
//   ms             processor time of a fit
//   moved          simulated and measured tests whose friction moves by more than a tenth of its error, or whose claim changes
//   farthest       [standard errors] of these
//   evidence       mean change of the logarithm of the evidence of the likeliest explanation
//   cases_moved    measured tests whose friction moves by more than half of its error, or whose claim changes
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "bench/simulated_tests.h"
#include "case/case_file.h"
#include "case/fitted.h"
#include "inference/fit.h"
#include "io/parallel.h"

namespace flexslip {
namespace {

struct Part {
  std::string_view name;
  bool SearchParts::*at;
};
constexpr std::array parts{
    Part{"rises", &SearchParts::rises},
    Part{"gaps", &SearchParts::gaps},
    Part{"raw_scan", &SearchParts::raw_scan},
    Part{"trials_from_rises", &SearchParts::trials_from_rises},
    Part{"trials_forward", &SearchParts::trials_forward},
    Part{"smooth_forward", &SearchParts::smooth_forward},
    Part{"polish_plain", &SearchParts::polish_plain},
    Part{"plain_from_wave", &SearchParts::plain_from_wave},
    Part{"anneal", &SearchParts::anneal},
    Part{"exponential_kernel", &SearchParts::exponential_kernel},
    Part{"smooth_kernel", &SearchParts::smooth_kernel},
    Part{"no_kernel", &SearchParts::no_kernel},
    Part{"waves_of_kernels", &SearchParts::waves_of_kernels},
    Part{"second_wave", &SearchParts::second_wave},
    Part{"converge", &SearchParts::converge},
    Part{"valley_width", &SearchParts::valley_width},
    Part{"valley_move", &SearchParts::valley_move},
    Part{"fall_curvature", &SearchParts::fall_curvature},
    Part{"scatter", &SearchParts::scatter},
    Part{"rig_score_correction", &SearchParts::rig_score_correction},
    Part{"rig_cost", &SearchParts::rig_cost},
    Part{"hyperparameter_points", &SearchParts::hyperparameter_points},
    Part{"hidden_by_rig", &SearchParts::hidden_by_rig},
};
static_assert(parts.size() * sizeof(bool) == sizeof(SearchParts), "a part is missing");

struct Threshold {
  std::string_view name;
  double SearchOptions::*at;
};
constexpr std::array thresholds{
    Threshold{"max_rig_errors", &SearchOptions::max_rig_errors},
    Threshold{"min_rig_signal", &SearchOptions::min_rig_signal},
    Threshold{"rig_places", &SearchOptions::rig_places},
    Threshold{"beyond_seen", &SearchOptions::beyond_seen},
    Threshold{"min_force_slope", &SearchOptions::min_force_slope},
    Threshold{"min_fold", &SearchOptions::min_fold},
    Threshold{"rises_noise", &SearchOptions::rises_noise},
    Threshold{"rises_deviation", &SearchOptions::rises_deviation},
    Threshold{"rise_cost", &SearchOptions::rise_cost},
    Threshold{"gap_advances", &SearchOptions::gap_advances},
    Threshold{"gap_noise", &SearchOptions::gap_noise},
    Threshold{"gap_spacing", &SearchOptions::gap_spacing},
    Threshold{"min_gap_places", &SearchOptions::min_gap_places},
    Threshold{"max_gap_places", &SearchOptions::max_gap_places},
    Threshold{"gap_margin", &SearchOptions::gap_margin},
    Threshold{"gap_fraction", &SearchOptions::gap_fraction},
    Threshold{"gap_accuracy", &SearchOptions::gap_accuracy},
    Threshold{"stiffness_errors", &SearchOptions::stiffness_errors},
    Threshold{"stiffness_step", &SearchOptions::stiffness_step},
    Threshold{"rig_step", &SearchOptions::rig_step},
    Threshold{"noise_reach", &SearchOptions::noise_reach},
    Threshold{"min_noise_seen", &SearchOptions::min_noise_seen},
    Threshold{"min_noise", &SearchOptions::min_noise},
    Threshold{"theta_step", &SearchOptions::theta_step},
    Threshold{"theta_spread", &SearchOptions::theta_spread},
    Threshold{"wave_step", &SearchOptions::wave_step},
    Threshold{"wave_spread", &SearchOptions::wave_spread},
    Threshold{"wave_box", &SearchOptions::wave_box},
    Threshold{"theta_iterations", &SearchOptions::theta_iterations},
    Threshold{"theta_accuracy", &SearchOptions::theta_accuracy},
    Threshold{"polish_accuracy", &SearchOptions::polish_accuracy},
    Threshold{"anneal_roughness", &SearchOptions::anneal_roughness},
    Threshold{"anneal_length", &SearchOptions::anneal_length},
    Threshold{"min_wave_advances", &SearchOptions::min_wave_advances},
    Threshold{"min_wave_circles", &SearchOptions::min_wave_circles},
    Threshold{"max_wave_share", &SearchOptions::max_wave_share},
    Threshold{"scan_steps", &SearchOptions::scan_steps},
    Threshold{"blur", &SearchOptions::blur},
    Threshold{"smooth_roughness", &SearchOptions::smooth_roughness},
    Threshold{"scan_length", &SearchOptions::scan_length},
    Threshold{"trial_length", &SearchOptions::trial_length},
    Threshold{"scan_peaks", &SearchOptions::scan_peaks},
    Threshold{"peak_apart", &SearchOptions::peak_apart},
    Threshold{"out_of_question", &SearchOptions::out_of_question},
    Threshold{"far_below", &SearchOptions::far_below},
    Threshold{"ran_away", &SearchOptions::ran_away},
    Threshold{"much_better", &SearchOptions::much_better},
    Threshold{"difference_step", &SearchOptions::difference_step},
    Threshold{"last_fall", &SearchOptions::last_fall},
    Threshold{"min_eigenvalue", &SearchOptions::min_eigenvalue},
    Threshold{"valley_step", &SearchOptions::valley_step},
    Threshold{"forward_noise", &SearchOptions::forward_noise},
    Threshold{"weighs_nothing", &SearchOptions::weighs_nothing},
    Threshold{"pull_farthest", &SearchOptions::pull_farthest},
    Threshold{"pull_most", &SearchOptions::pull_most},
    Threshold{"pull_most_step", &SearchOptions::pull_most_step},
};

struct Length {
  std::string_view name;
  Schedule SearchOptions::*at;
};
constexpr std::array lengths{
    Length{"from_rises", &SearchOptions::from_rises},
    Length{"trial", &SearchOptions::trial},
    Length{"trial_forward", &SearchOptions::trial_forward},
    Length{"plain", &SearchOptions::plain},
    Length{"wave", &SearchOptions::wave},
    Length{"follow", &SearchOptions::follow},
    Length{"smooth_forward", &SearchOptions::smooth_forward},
    Length{"pull", &SearchOptions::pull},
    Length{"anneal", &SearchOptions::anneal},
    Length{"annealed", &SearchOptions::annealed},
    Length{"settle", &SearchOptions::settle},
};
constexpr std::size_t padding = (sizeof(double) - sizeof(SearchParts) % sizeof(double)) % sizeof(double);
static_assert(sizeof(SearchParts) + padding + thresholds.size() * sizeof(double) + lengths.size() * sizeof(Schedule) ==
                  sizeof(SearchOptions),
              "a threshold is missing");

struct Variation {
  std::string name;
  SearchOptions options;
};

// A test, and what is known of it beforehand.
struct Subject {
  FitProblem problem;
  bool simulated;
  Truth truth;
};

struct Outcome {
  bool fitted = false, covered = false, claimed = false, wave_covered = false;
  bool roughness_covered = false, length_covered = false;
  double mean = 0, mu0 = 0, error = 0, evidence = 0, ms = 0;
  bool right = false, wrong = false;
};

double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

Outcome outcome_of(const Subject& subject, const SearchOptions& options) {
  Outcome outcome;
  const double begin = thread_ms();
  const FrictionFit fit = fit_friction(subject.problem, {.model = ProfileModel::roughness, .search = options});
  outcome.ms = thread_ms() - begin;
  if (fit.status != FrictionFitStatus::ok) return outcome;
  outcome.fitted = true;
  outcome.mu0 = fit.mu0.value;
  outcome.error = fit.mu0.standard_error;
  outcome.evidence = fit.explanations.front().log_evidence;
  outcome.claimed = fit.wave_claimed;
  if (!subject.simulated) return outcome;
  constexpr int places = 2000;
  for (int i = 0; i < places; ++i)
    outcome.mean += subject.truth.mu(fit.S_begin + (fit.S_end - fit.S_begin) * (i + 0.5) / places) / places;
  outcome.covered = fit.mu0.low <= outcome.mean && outcome.mean <= fit.mu0.high;
  const auto holds = [](const Estimate& e, double truth) { return e.low <= truth && truth <= e.high; };
  if (subject.truth.roughness > 0) {
    outcome.roughness_covered = holds(fit.roughness, subject.truth.roughness);
    outcome.length_covered = holds(fit.length, subject.truth.length / span);
  }
  if (!fit.wave_claimed) return outcome;
  const Estimate& found = fit.waves.front().wavelength;
  constexpr double near = 0.03;  // of ln λ
  for (const Wave& wave : subject.truth.waves) {
    const double wavelength = wave.wavelength / span;
    if (!(std::abs(std::log(found.value / wavelength)) < near)) continue;
    outcome.right = true;
    outcome.wave_covered = found.low <= wavelength && wavelength <= found.high;
  }
  outcome.wrong = !outcome.right;
  return outcome;
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> words(1);
  for (const char c : list)
    if (c == ',')
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

struct Call {
  int first = 0, tests = 12;
  bool of_thresholds = false;
  std::vector<std::string> kinds{kinds_of_tests.begin(), kinds_of_tests.end()};
  std::vector<std::string> only, cases;
};

[[noreturn]] void refuse(const std::string& why) {
  std::fprintf(stderr, "ablation: %s\n", why.c_str());
  std::exit(2);
}

Call read_call(int count, char** arguments) {
  Call call;
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    if (argument == "--tests" && i + 2 < count) {
      call.first = std::atoi(arguments[++i]);
      call.tests = std::atoi(arguments[++i]);
    } else if (argument == "--kinds" && i + 1 < count) {
      call.kinds = split(arguments[++i]);
    } else if (argument == "--only" && i + 1 < count) {
      call.only = split(arguments[++i]);
    } else if (argument == "--thresholds") {
      call.of_thresholds = true;
    } else if (argument.starts_with("--")) {
      refuse(argument + " is no option, or lacks a value: see the head of bench/ablation.cpp");
    } else {
      call.cases.push_back(argument);
    }
  }
  for (const auto& kind : call.kinds)
    if (std::find(kinds_of_tests.begin(), kinds_of_tests.end(), kind) == kinds_of_tests.end())
      refuse(kind + " is no kind of test");
  return call;
}

std::vector<Subject> subjects_of(const Call& call) {
  std::vector<Subject> subjects;
  for (const auto& kind : call.kinds)
    for (int test = call.first; test < call.first + call.tests; ++test) {
      Random random = random_of(kind, test);
      const Truth truth = truth_of(kind, random);
      subjects.push_back({simulated(truth, random), true, truth});
    }
  for (const auto& name : call.cases) {
    if (!std::filesystem::exists(name)) {
      std::fprintf(stderr, "%s is not there, and is left out\n", name.c_str());
      continue;
    }
    const FittedTest fitted = fit_test(read_case(name), {});
    const TestAnalysis& analysis = fitted.analysis;
    subjects.push_back({{analysis.reduced, analysis.rig, analysis.errors}, false, {}});
  }
  return subjects;
}

Schedule longer(Schedule schedule, double factor) {
  const auto times = [&](int count) { return std::max(static_cast<int>(count * factor), 1); };
  return {times(schedule.rounds), times(schedule.steps), schedule.fraction};
}

std::vector<Variation> variations_of(const Call& call) {
  std::vector<Variation> variations{{"all parts", {}}};
  const auto add = [&](std::string_view name, const std::string& words, const auto& change) {
    if (!call.only.empty() && std::find(call.only.begin(), call.only.end(), name) == call.only.end()) return;
    Variation variation{words, {}};
    change(variation.options);
    variations.push_back(variation);
  };
  if (!call.of_thresholds)
    for (const Part& part : parts)
      add(part.name, "without " + std::string(part.name),
          [&](SearchOptions& options) { options.parts.*part.at = false; });
  for (const double factor : call.of_thresholds ? std::vector{0.5, 2.0} : std::vector<double>{}) {
    const std::string at = factor < 1 ? " at half" : " at double";
    for (const Threshold& threshold : thresholds)
      add(threshold.name, std::string(threshold.name) + at,
          [&](SearchOptions& options) { options.*threshold.at *= factor; });
    for (const Length& length : lengths)
      add(length.name, std::string(length.name) + at,
          [&](SearchOptions& options) { options.*length.at = longer(options.*length.at, factor); });
  }
  if (variations.size() == 1) refuse("--only names nothing that can be varied so");
  return variations;
}

// One line of the table.
void print(const std::string& name, const std::vector<Subject>& subjects, const std::vector<Outcome>& outcomes,
           const std::vector<Outcome>& with_all) {
  int tests = 0, covered = 0, roughness = 0, length = 0, right = 0, waves_covered = 0, wrong = 0, moved = 0,
      cases_moved = 0;
  double squares = 0, ms = 0, farthest = 0, evidence = 0;
  const auto count = static_cast<double>(subjects.size());
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const Outcome &now = outcomes[i], &before = with_all[i];
    ms += now.ms / count;
    if (subjects[i].simulated) {
      ++tests;
      covered += now.covered;
      roughness += now.roughness_covered;
      length += now.length_covered;
      right += now.right;
      waves_covered += now.wave_covered;
      wrong += now.wrong;
      squares += (now.mu0 - now.mean) * (now.mu0 - now.mean);
    }
    if (!before.fitted) continue;
    constexpr double lost = 9;  // errors that stand for no answer
    const double errors = now.fitted ? std::abs(now.mu0 - before.mu0) / before.error : lost;
    const bool changed = now.claimed != before.claimed || now.right != before.right;
    farthest = std::max(farthest, errors);
    if (now.fitted) evidence += (now.evidence - before.evidence) / count;
    moved += errors > 0.1 || changed;
    cases_moved += !subjects[i].simulated && (errors > 0.5 || changed);
  }
  std::printf("%s,%d,%d,%.4f,%d,%d,%d,%d,%d,%.1f,%d,%.2f,%.3f,%d\n", name.c_str(), tests, covered,
              std::sqrt(squares / std::max(tests, 1)), roughness, length, right, waves_covered, wrong, ms, moved,
              farthest, evidence, cases_moved);
  std::fflush(stdout);
}

int run(int count, char** arguments) {
  const Call call = read_call(count, arguments);
  const std::vector<Subject> subjects = subjects_of(call);
  std::printf(
      "variation,tests,covered,rmse,roughness,length,waves_right,waves_covered,waves_false,ms,moved,farthest,evidence,"
      "cases_moved\n");
  std::vector<Outcome> with_all;
  for (const Variation& variation : variations_of(call)) {
    std::vector<Outcome> outcomes(subjects.size());
    for_each_index(subjects.size(), std::thread::hardware_concurrency(),
                   [&](std::size_t i) { outcomes[i] = outcome_of(subjects[i], variation.options); });
    if (with_all.empty()) with_all = outcomes;
    print(variation.name, subjects, outcomes, with_all);
  }
  return 0;
}

}  // namespace
}  // namespace flexslip

int main(int count, char** arguments) { return flexslip::run(count, arguments); }
