// Tests of which each finding that there is is found: the example that slips, changed.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case/case_file.h"
#include "finding/answer.h"
#include "finding/findings.h"

namespace flexslip {

inline FittedTest example(const std::string& name) {
  return fit_test(read_case(FLEXSLIP_SOURCE_DIR "/examples/" + name + "/case.toml"), {});
}

inline const FittedTest& slipping() {
  static const FittedTest test = example("simulated");
  return test;
}

// The example that slips, changed so.
template <class Change>
FittedTest changed(const Change& change) {
  FittedTest test = slipping();
  change(test);
  return test;
}

// The example on supports that it does not state, and what it would be on rollers, changed so.
template <class Change>
FittedTest on_unknown_supports(const Change& change) {
  FittedTest rollers = slipping();
  rollers.analysis.rig.fibre = Fibre({.radius = 0.05, .half_depth = 0.01});
  rollers.measurement.test.rig->roller_radius = 0.05 * rollers.analysis.scales.span();
  change(rollers);
  return changed([&](FittedTest& test) {
    test.measurement.test.rig->supports = std::nullopt;
    test.on_rollers = std::make_shared<const FittedTest>(std::move(rollers));
  });
}

inline Check& check_of(FittedTest& test, CheckKind kind) {
  return *std::find_if(test.analysis.checks.begin(), test.analysis.checks.end(),
                       [&](const Check& check) { return check.kind == kind; });
}

inline const Finding* found(const Answer& answer, std::string_view code) {
  const auto at = std::find_if(answer.findings.begin(), answer.findings.end(),
                               [&](const Finding& finding) { return finding.code == code; });
  return at == answer.findings.end() ? nullptr : &*at;
}

// Each a test of which that is found which it is named by.
struct Situation {
  std::string_view code;
  Severity severity;
  FittedTest test;
};

inline std::vector<Situation> situations() {
  std::vector<Situation> all;
  const auto add = [&](std::string_view code, Severity severity, const auto& change) {
    all.push_back({code, severity, changed(change)});
  };
  add("not_bent", Severity::refusal, [](FittedTest& test) {
    test.analysis.status = AnalysisStatus::deflection_too_small;
    for (double& force : test.analysis.record.force) force = -1;
  });
  add("not_bent", Severity::refusal, [](FittedTest& test) {
    test.analysis.status = AnalysisStatus::deflection_too_small;
    for (double& deflection : test.analysis.reduced.deflection) deflection = -0.1;
  });
  add("not_bent", Severity::refusal, [](FittedTest& test) {
    test.analysis.status = AnalysisStatus::deflection_too_small;
    test.analysis.reduced.deflection.back() = 3.9;
  });
  const auto bar = [](FittedTest& test) {
    test.analysis.status = AnalysisStatus::deflection_too_small;
    test.analysis.rig.fibre = Fibre({.radius = 0, .half_depth = 0.05});
  };
  add("sinks", Severity::doubt, [&](FittedTest& test) {
    bar(test);
    test.analysis.drops = {};
    test.analysis.slips.clear();
    test.analysis.drop_features = {};
    test.analysis.statistics.sinking = {.from = 200, .share = 0.4};
    test.judgement = judge(test.analysis);
  });
  add("too_few_points", Severity::refusal, [&](FittedTest& test) {
    bar(test);
    test.judgement = {};
  });
  add("deflection_for_stage", Severity::refusal, [](FittedTest& test) {
    test.analysis.statistics.train.leap = 0.9;
    test.analysis.statistics.train.leap_error = 0.01;
  });
  add("wrong_load_train", Severity::refusal, [](FittedTest& test) {
    test.analysis.rig.stiffness = std::numeric_limits<double>::infinity();
    test.analysis.stiffness_implausible = true;
    test.analysis.stiffness_to_slope_ratio = 1.5;
  });
  add("wrong_stiffness", Severity::refusal, [](FittedTest& test) {
    test.analysis.stiffness_implausible = true;
    test.analysis.stiffness_to_slope_ratio = 16;
  });
  add("impossible_modulus", Severity::refusal, [](FittedTest& test) {
    test.section_moment = test.analysis.fit.bending_stiffness.value * test.analysis.scales.bending_stiffness() / 1.3e12;
  });
  add("not_explained", Severity::refusal,
      [](FittedTest& test) { test.analysis.status = AnalysisStatus::not_explained; });
  const auto reloaded = [](double loss, double settled) {
    return [=](FittedTest& test) {
      PassesFit passes{};
      passes.status = PassesStatus::ok;
      passes.is_reloaded = passes.is_followed = true;
      passes.loss = normal_estimate(loss, 0.01);
      passes.settled = normal_estimate(settled, 0.0001);
      test.passes = test.analysis.passes = passes;
      test.judgement = judge(test.analysis);
    };
  };
  add("changed_reload", Severity::note, reloaded(0.2, 0));
  add("changed_reload", Severity::note, reloaded(0, 0.01));
  add("cracks", Severity::suspicion, [](FittedTest& test) {
    test.judgement = {.conclusion = Conclusion::cracks, .causes = {.slips = 0.01, .cracks = 0.78, .both = 0.21}};
  });
  add("not_explained", Severity::refusal, [](FittedTest& test) { test.analysis.model_implausible = true; });
  add("implausible_friction", Severity::suspicion, [](FittedTest& test) { test.analysis.fit.mu0.low = 1.01; });
  for (const auto& [code, kind] :
       {std::pair{"misses_force", CheckKind::residuals}, std::pair{"drops_differ", CheckKind::drops},
        std::pair{"unexpected_stiffness", CheckKind::stiffness}})
    add(code, Severity::doubt,
        [kind = kind](FittedTest& test) { check_of(test, kind).outcome = CheckOutcome::failed; });
  add("changing_friction", Severity::doubt, [](FittedTest& test) { test.judgement.friction_falls = true; });
  add("changed_reload", Severity::doubt, reloaded(-0.2, 0));
  add("drops_elsewhere", Severity::doubt, [](FittedTest& test) {
    test.analysis.drops.drops.clear();
    test.analysis.slips.clear();
    test.judgement.conclusion = Conclusion::no_drops;
    test.drops_elsewhere = {6, {10, 120}};
  });
  add("passes_apart", Severity::condition,
      [](FittedTest& test) { test.passes = PassesFit{.status = PassesStatus::not_sliding_out, .sliding_out = 7}; });
  add("passes_apart", Severity::condition,
      [](FittedTest& test) { test.passes = PassesFit{.status = PassesStatus::not_explained}; });
  add("filtered_force", Severity::doubt, [](FittedTest& test) { test.analysis.statistics.rounded.lag = 1.2; });
  add("filtered_force", Severity::doubt, [](FittedTest& test) { test.analysis.statistics.rounded.spread = 4.5; });
  add("gap_in_stage", Severity::doubt, [](FittedTest& test) {
    test.analysis.statistics.widest_step = {.behind = 100, .length = 1e-4, .usual = 2e-6, .share_of_travel = 0.2};
  });
  add("undecided_drops", Severity::condition, [](FittedTest& test) {
    test.judgement.conclusion = Conclusion::undecided;
    test.judgement.causes = {.slips = 0.4, .cracks = 0.35, .both = 0.25};
  });
  add("few_rows", Severity::doubt, [](FittedTest& test) { test.analysis.statistics.rows_between_drops = 4; });
  add("implausible_friction", Severity::doubt,
      [](FittedTest& test) { test.analysis.pointwise_friction.median = -0.3; });
  add("sloping_baseline", Severity::doubt,
      [](FittedTest& test) { test.measurement.baseline = {.points = 50, .change = 2e-4, .error = 1e-5}; });
  add("other_contact", Severity::doubt, [](FittedTest& test) {
    test.measurement.own_contact = {.status = ContactStatus::found, .offset = normal_estimate(4e-6, 4e-7)};
  });
  add("begins_under_force", Severity::doubt, [](FittedTest& test) {
    test.measurement.contact = ContactSource::found;
    test.measurement.begins_under = 2e-4;
  });
  add("coloured_noise", Severity::note,
      [](FittedTest& test) { check_of(test, CheckKind::whiteness).outcome = CheckOutcome::failed; });
  add("only_a_limit", Severity::condition, [](FittedTest& test) {
    check_of(test, CheckKind::friction).outcome = CheckOutcome::failed;
    test.analysis.fit.mu0_is_bound = true;
  });
  add("no_reload", Severity::condition, [](FittedTest&) {});
  add("known_roughly", Severity::condition,
      [](FittedTest& test) { test.analysis.fit.mu0 = normal_estimate(0.5, 0.15); });
  all.push_back({"supports_not_stated", Severity::condition, on_unknown_supports([](FittedTest&) {})});
  all.push_back({"supports_not_stated", Severity::doubt, on_unknown_supports([](FittedTest& rollers) {
                   rollers.analysis.fit.mu0 = normal_estimate(0.09, 0.02);
                 })});
  add("thickness_not_stated", Severity::condition, [](FittedTest& test) {
    test.analysis.rig.fibre = Fibre();
    test.measurement.test.rig->friction_at = FrictionAt::surface;
  });
  add("changing_friction", Severity::condition, [](FittedTest& test) {
    for (auto& each : test.analysis.fit.explanations) each.kernel = Kernel::none;
    test.analysis.fit.drift = normal_estimate(0.5, 0.2);
  });
  add("hidden_waves", Severity::condition, [](FittedTest& test) {
    for (auto& each : test.analysis.fit.explanations) each.kernel = Kernel::none;
    test.analysis.fit.wave_claimed = false;
    test.analysis.fit.shortest_wave = 0.1;
  });
  add("hidden_waves", Severity::condition, [](FittedTest& test) { test.analysis.fit.hidden_by_rig = 0.1; });
  add("contradicts_file", Severity::doubt,
      [](FittedTest& test) { test.measurement.contradictions = {"The file states span 1 mm, not span 2 mm."}; });
  add("relaxes", Severity::condition, [](FittedTest& test) {
    test.analysis.rig_errors.slow_force = 0.1;
    test.measurement.relaxation =
        Relaxation{.rests = 2, .rows = 80, .share = normal_estimate(0.02, 0.001), .over_loading = 0.1};
  });
  return all;
}

}  // namespace flexslip
