#include "report/fit_json.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "data/names.h"
#include "report/cycles_json.h"
#include "report/fit_words.h"
#include "report/preparation_json.h"
#include "report/small_deflection_json.h"
#include "report/teeth_json.h"

namespace flexslip {
namespace {

// How the numbers of one test pass from the core into its units.
struct Units {
  const Scales& scales;
  bool reduced;

  double length(double value) const { return scales.physical_length(value); }
  double force(double value) const { return scales.physical_force(value); }
  std::string unit(const char* name) const { return reduced ? "1" : name; }
};

Json parameter(const ParameterEstimate& estimate, double factor, const std::string& unit) {
  return {{"value", estimate.value * factor},
          {"standard_error", estimate.standard_error * factor},
          {"interval95", {estimate.low * factor, estimate.high * factor}},
          {"unit", unit}};
}

// A wave of the fit under the names of its parameters; `suffix` tells the second from the first.
void add_wave(Json& out, const WaveEstimate& wave, const Units& units, const std::string& suffix) {
  out["amplitude" + suffix] = parameter(wave.amplitude, 1, "1");
  out["wavelength" + suffix] = parameter(wave.wavelength, units.scales.span(), units.unit("m"));
  out["phase" + suffix] = parameter(wave.phase, 1, units.unit("rad"));
  out["phase_at_middle" + suffix] = parameter(wave.phase_at_middle, 1, units.unit("rad"));
}

Json parameters_json(const FrictionFit& fit, const Units& units) {
  const double span = units.scales.span();
  Json out = {{"mu0", parameter(fit.mu0, 1, "1")}};
  out["mu0"]["bound"] = fit.mu0_is_bound;
  if (fit.wave_claimed)
    for (std::size_t i = 0; i < fit.waves.size(); ++i)
      add_wave(out, fit.waves[i], units, i == 0 ? "" : fmt::format("_{}", i + 1));
  if (fit.model != ProfileModel::constant) {
    out["drift"] = parameter(fit.drift, 1 / span, units.unit("1/m"));
    out["force_noise"] = parameter(fit.noise, units.force(1), units.unit("N"));
  }
  if (fit.model == ProfileModel::roughness) {
    out["roughness"] = parameter(fit.roughness, 1, "1");
    out["correlation_length"] = parameter(fit.length, span, units.unit("m"));
  }
  out["bending_stiffness"] = parameter(fit.bending_stiffness, units.scales.bending_stiffness(), units.unit("N m^2"));
  return out;
}

// The likeliest wave, where nothing claims it: what it would be, and how far from a claim it is. Null without one.
Json wave_json(const FrictionFit& fit, const Units& units) {
  if (fit.waves.empty()) return nullptr;
  Json out = {{"claimed", fit.wave_claimed}, {"log_evidence", fit.log_evidence_of_wave}};
  add_wave(out, fit.waves.front(), units, "");
  return out;
}

// The lengths along the specimen if it slid over one support at a time.
Json one_sided_json(const FrictionFit& fit, const Units& units) {
  Json out = Json::array();
  for (const auto& [name, value] : lengths_of(fit))
    out.push_back({{"name", name}, {"value", units.length(one_side_at_a_time * value)}});
  return out;
}

Json explanations_json(const FrictionFit& fit, const Units& units) {
  Json out = Json::array();
  for (const auto& each : fit.explanations) {
    Json wavelengths = Json::array();
    for (const double wavelength : each.wavelengths) wavelengths.push_back(units.length(wavelength));
    out.push_back({{"kernel", name_of(each.kernel)},
                   {"wavelengths", wavelengths},
                   {"weight", each.weight},
                   {"log_evidence", each.log_evidence},
                   {"log_likelihood", each.log_likelihood}});
  }
  return out;
}

Json scan_json(const FrictionFit& fit, const Units& units) {
  Json out = Json::array();
  for (const auto& each : fit.scan)
    out.push_back({{"wavelength", units.length(each.wavelength)}, {"log_evidence_gain", each.gain}});
  return out;
}

Json band_json(const FrictionFit& fit, const Units& units) {
  Json lengths = Json::array(), drawn_in = Json::array();
  for (const double S : fit.band.S) {
    lengths.push_back(units.length(fit.between_contacts(S)));
    drawn_in.push_back(units.length(S - 1));
  }
  return {{"length", lengths}, {"drawn_in", drawn_in}, {"mean", fit.band.mean}, {"deviation", fit.band.deviation}};
}

// The bending stiffness that goes with each profile drawn (`fit --draws`).
Json draws_json(const FrictionFit& fit, const Units& units) {
  Json stiffness = Json::array();
  for (const double relative : fit.draw_stiffness) stiffness.push_back(relative * units.scales.bending_stiffness());
  return {{"bending_stiffness", stiffness}, {"unit", units.unit("N m^2")}};
}

Json checks_json(const std::vector<Check>& checks, const Units& units) {
  Json out = Json::array();
  for (const auto& check : checks) {
    Json each = {
        {"name", name_of(check.kind)},
        {"passed", check.outcome == CheckOutcome::not_possible ? Json() : Json(check.outcome == CheckOutcome::passed)}};
    for (const auto& number : check.numbers)
      each[std::string(number.name)] = number.is_force ? units.force(number.value) : number.value;
    out.push_back(each);
  }
  return out;
}

// A number that is no estimate but says where others hold.
Json held_parameter(double value, double factor, const std::string& unit) {
  return parameter({value, 0, value, value}, factor, unit);
}

Json contact_parameter(const FittedTest& test, const Units& units) {
  const double offset = test.measurement.contact_offset;
  const double error = test.measurement.contact_error;
  constexpr double two_sided = 1.96;
  return parameter({offset, error, offset - two_sided * error, offset + two_sided * error}, 1, units.unit("m"));
}

Json drops_json(const FittedTest& test, const Units& units) {
  Json out = Json::array();
  for (const auto& slip : test.analysis.slips) {
    const auto& record = test.analysis.record;
    const Drop& drop = slip.drop;
    out.push_back({{"row_before", file_row(test, drop.before)},
                   {"row_after", file_row(test, drop.after)},
                   {"stage", record.stage[drop.before]},
                   {"deflection_before", record.deflection[drop.before]},
                   {"deflection_after", record.deflection[drop.after]},
                   {"force_before", record.force[drop.before]},
                   {"force_after", record.force[drop.after]},
                   {"force_fall", drop.force_fall},
                   {"significance", drop.significance},
                   {"false_alarms", drop.false_alarms},
                   {"slip", name_of(slip.verdict)},
                   {"pulled_in", units.length(slip.S_after - slip.S_before)},
                   {"pulled_in_error", units.length(slip.advance_error)}});
  }
  return out;
}

Json rise_explanation_json(const RiseExplanation& explanation) {
  return {{"bic", explanation.bic}, {"friction", explanation.friction}, {"stiffness_left", explanation.left}};
}

// Null where there are too few drops.
Json slip_or_crack_json(const SlipOrCrack& judged) {
  if (!judged.judged) return nullptr;
  return {{"verdict", name_of(judged.verdict)},
          {"margin", judged.margin},
          {"margin_arrested", judged.margin_arrested},
          {"rises", judged.rises},
          {"stiffer_rises", judged.stiffer_rises},
          {"cracks", rise_explanation_json(judged.cracks)},
          {"cracks_constant", rise_explanation_json(judged.cracks_constant)},
          {"cracks_running", rise_explanation_json(judged.cracks_running)},
          {"slip", rise_explanation_json(judged.slip)},
          {"slip_and_cracks", rise_explanation_json(judged.slip_and_cracks)}};
}

// Null where no length was imaged.
Json imaged_json(const FittedTest& test, const Units& units) {
  if (!test.imaged) return nullptr;
  Json points = Json::array();
  for (const auto& point : test.imaged->points)
    points.push_back({{"row", file_row(test, point.index)},
                      {"pulled_in", units.length(point.inferred)},
                      {"imaged", units.length(point.imaged)}});
  return {{"offset", units.length(test.imaged->offset)},
          {"standard_error", units.length(test.imaged->error)},
          {"scatter", units.length(test.imaged->scatter)},
          {"points", points}};
}

Json judgement_json(const FittedTest& test) {
  if (!test.judgement) return nullptr;
  const Judgement& judgement = *test.judgement;
  Json doubts = Json::array();
  for (const Doubt doubt : judgement.doubts) doubts.push_back(name_of(doubt));
  return {{"standing", name_of(judgement.standing)},
          {"drops", test.analysis.drops.drops.empty() ? Json() : Json(name_of(judgement.drops))},
          {"doubts", doubts},
          {"next_step", name_of(judgement.next)},
          {"stiffness_lost", judgement.loss},
          {"stiffness_lost_error", judgement.loss_error},
          {"stiffness_for_no_snap", test.analysis.scales.physical_stiffness(judgement.stiffness_for_all)}};
}

Json slips_json(const FittedTest& test, const Units& units) {
  const auto& summary = test.analysis.slip_summary;
  Json each = Json::array();
  for (const auto& slip : test.analysis.slips)
    if (slip.verdict == SlipVerdict::possible)
      each.push_back({{"row_before", file_row(test, slip.drop.before)},
                      {"row_after", file_row(test, slip.drop.after)},
                      {"length_before", units.length(slip.S_before)},
                      {"length_after", units.length(slip.S_after)},
                      {"mu_before", slip.mu_before},
                      {"mu_after", slip.mu_after}});
  return {{"count", summary.count},
          {"median_spacing", units.length(summary.median_spacing)},
          {"mean_spacing", units.length(summary.mean_spacing)},
          {"median_fall_of_mu", summary.median_fall},
          {"slips", each}};
}

Json suspects_json(const FittedTest& test, const Units& units) {
  Json out = Json::array();
  std::size_t k = 0;
  const auto& points = test.analysis.profile.points;
  for (const auto index : test.analysis.suspects.points) {
    while (k < points.size() && points[k].index < index) ++k;
    Json suspect = {{"row", file_row(test, index)}, {"length", nullptr}, {"mu", nullptr}, {"standard_error", nullptr}};
    if (k < points.size() && points[k].index == index) {
      suspect["length"] = units.length(points[k].S);
      suspect["mu"] = points[k].mu;
      suspect["standard_error"] = standard_error(points[k]);
    }
    out.push_back(suspect);
  }
  return out;
}

Json suspect_criteria_json(const SuspectReport& report) {
  return {{"limit", report.limit},
          {"points_judged", report.points_judged},
          {"points_above_limit", report.points.size()},
          {"points_above_limit_beyond_error", report.beyond_error},
          {"points_above_euler_bernoulli", report.above_euler_bernoulli}};
}

Json profile_json(const FittedTest& test, const Units& units) {
  Json out = Json::array();
  for (const auto& point : test.analysis.profile.points)
    out.push_back({{"row", file_row(test, point.index)},
                   {"length", units.length(point.length)},
                   {"drawn_in", units.length(point.S - 1)},
                   {"position", units.length(point.length / 2)},
                   {"mu", point.mu},
                   {"standard_error", standard_error(point)},
                   {"from_force", point.from_force},
                   {"from_bending_stiffness", point.from_bending_stiffness},
                   {"from_contact", point.from_contact}});
  return out;
}

Json provenance_json(const Provenance& provenance) {
  Json inputs = Json::array();
  for (const auto& file : provenance.inputs) {
    Json input = {{"name", file.name}, {"bytes", nullptr}, {"sha256", nullptr}};
    if (!file.sha256.empty()) {
      input["bytes"] = file.bytes;
      input["sha256"] = file.sha256;
    }
    inputs.push_back(input);
  }
  return {{"program", "flexslip"},
          {"version", provenance.version},
          {"inputs", inputs},
          {"options",
           {{"model", name_of(provenance.options.fit.model)},
            {"false_alarms", provenance.options.drops.false_alarms_per_test},
            {"suspect_limit", provenance.options.suspect_limit},
            {"check_stability", provenance.options.check_stability}}},
          {"case", provenance.test}};
}

Json measurement_json(const FittedTest& test) {
  const auto& measurement = test.measurement;
  const auto end = name_in_order<MeasurementEnd::turn>(measurement.end, {"last_row", "until", "failure", "turn"});
  return {{"rows", measurement.rows},
          {"first_row", file_row(test, 0)},
          {"last_row", last_row(test)},
          {"rows_repeated", measurement.sampling.repeated},
          {"rows_held", measurement.sampling.held},
          {"rows_interpolated", measurement.sampling.interpolated},
          {"rows_per_point", measurement.sampling.stride},
          {"ends_with", end}};
}

Json contact_json(const FittedTest& test) {
  const auto source =
      name_in_order<ContactSource::first_point>(test.measurement.contact, {"stated", "found", "first_point"});
  const auto& found = test.analysis.contact;
  Json out = {{"source", source},         {"taken_off", test.measurement.contact_offset},
              {"line_offset", nullptr},   {"line_offset_error", nullptr},
              {"initial_slope", nullptr}, {"initial_slope_error", nullptr}};
  if (found.status == ContactStatus::found) {
    out["line_offset"] = found.offset;  // of what is left
    out["line_offset_error"] = found.offset_error;
    out["initial_slope"] = found.slope;
    out["initial_slope_error"] = found.slope_error;
  }
  return out;
}

Json stiffness_json(const FittedTest& test) {
  const auto source = name_in_order<StiffnessSource::mirror>(
      test.stiffness, {"stated", "stated_without_uncertainty", "initial_slope", "mirror_symmetry"});
  return {{"nominal", test.analysis.scales.bending_stiffness()},
          {"relative_error", test.analysis.bending_stiffness_error},
          {"source", source}};
}

}  // namespace

Json fit_json(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const Units units{analysis.scales, test.reduced};
  const bool fitted = analysis.status == AnalysisStatus::ok;
  const FrictionFit& fit = analysis.fit;
  Json parameters = fitted ? parameters_json(fit, units) : Json::object();
  if (fitted) parameters["reference"] = held_parameter(fit.S_middle, analysis.scales.span(), units.unit("m"));
  parameters["contact_offset"] = contact_parameter(test, units);
  Json energy = nullptr;
  if (fitted) {
    energy = energy_json(analysis.energy.account, analysis.scales);
    energy["work_of_fracture"] = analysis.scales.physical_energy(analysis.energy.work_of_fracture);
    energy["friction_share"] = analysis.energy.friction_share;
    const auto& account = analysis.energy.account;
    energy["remaining"] =
        analysis.scales.physical_energy(analysis.energy.work_of_fracture - account.friction - account.snaps);
  }
  Json replay = nullptr;
  if (fitted)
    replay = {{"residual_rms", units.force(analysis.replay.residual_rms)},
              {"drops", analysis.drops.drops.size()},
              {"drops_reproduced", analysis.replay.drops_reproduced}};

  Json out = {{"status", status_of(test)},
              {"name", test.name},
              {"units", units_json(test.reduced)},
              {"model", fitted ? Json(name_of(fit.model)) : Json()},
              {"category", name_of(analysis.category)},
              {"suspect", test.judgement && test.judgement->standing >= Standing::suspect},
              {"stiffness_over_initial_slope", analysis.stiffness_over_slope},
              {"model_implausible", analysis.model_implausible},
              {"stiffness_implausible", analysis.stiffness_implausible},
              {"parameters", parameters},
              {"friction_read",
               {{"median", analysis.friction_read.median},
                {"low80", analysis.friction_read.low80},
                {"high80", analysis.friction_read.high80}}},
              {"residual_rms", fitted ? Json(units.force(fit.residual_rms)) : Json()},
              {"checks", checks_json(analysis.checks, units)}};
  out["wave"] = fitted ? wave_json(fit, units) : Json();
  out["one_side_at_a_time"] = fitted ? one_sided_json(fit, units) : Json::array();
  out["explanations"] = explanations_json(fit, units);
  out["snaps"] = fitted ? snaps_json(analysis.model.snaps, analysis.scales) : Json::array();
  out["judgement"] = judgement_json(test);
  const double curvature = fitted ? greatest_curvature(analysis.profile_at_fit, analysis.rig.fibre) : 0;
  const auto bent = [&](auto value) {
    return fitted && test.surface ? Json(((*test.surface).*value)(curvature)) : Json();
  };
  out["bending"] = {{"greatest_strain", bent(&SurfaceStrain::strain)},
                    {"greatest_stress", bent(&SurfaceStrain::stress)},
                    {"wraps_nose", fitted && curvature > test.nose_curvature}};
  out["imaged_length"] = imaged_json(test, units);
  out["slip_or_crack"] = slip_or_crack_json(analysis.slip_or_crack);
  out["drops"] = drops_json(test, units);
  out["slips"] = slips_json(test, units);
  out["teeth"] = teeth_json(test);
  out["suspects"] = suspects_json(test, units);
  out["suspect_criteria"] = suspect_criteria_json(analysis.suspects);
  out["energy"] = energy;
  out["replay"] = replay;
  out["cycles"] = cycles_json(test);
  out["band"] = band_json(fit, units);
  out["scan"] = scan_json(fit, units);
  out["small_deflection"] = small_deflection_json(test);
  out["measurement"] = measurement_json(test);
  out["preparation"] = preparation_json(test.measurement.preparation);
  out["contact"] = contact_json(test);
  out["nominal_bending_stiffness"] = stiffness_json(test);
  out["draws"] = draws_json(fit, units);
  out["noise"] = {{"force", units.force(analysis.force_noise)},
                  {"force_step", analysis.drops.step_noise},
                  {"smallest_drop", analysis.drops.smallest_fall}};
  out["profile"] = profile_json(test, units);
  out["provenance"] = provenance_json(test.provenance);
  return out;
}

}  // namespace flexslip
