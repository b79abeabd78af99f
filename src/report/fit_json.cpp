#include "report/fit_json.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

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

Json parameters_json(const ModelFit& model, const Units& units) {
  Json out = {{"mu0", parameter(model.mu0, 1, "1")}};
  const double span = units.scales.span();
  std::string suffix;
  int number = 1;
  for (const auto& wave : waves_by_size(model)) {
    out["amplitude" + suffix] = parameter(wave.amplitude, 1, "1");
    out["wavelength" + suffix] = parameter(wave.wavelength, span, units.unit("m"));
    out["phase" + suffix] = parameter(wave.phase, 1, units.unit("rad"));
    out["phase_at_middle" + suffix] = parameter(wave.phase_at_middle, 1, units.unit("rad"));
    suffix = "_" + std::to_string(++number);
  }
  if (model.model != ProfileModel::constant) out["drift"] = parameter(model.drift, 1 / span, units.unit("1/m"));
  out["bending_stiffness"] = parameter(model.bending_stiffness, units.scales.bending_stiffness(), units.unit("N m^2"));
  return out;
}

// The other wavelengths of a model's last wave, and the intervals of 95 % about those that the record does not exclude.
Json runners_up_json(const ModelFit& model, const Units& units) {
  Json out = Json::array();
  for (const auto& other : model.runners_up)
    out.push_back({{"wavelength", units.length(other.wavelength)},
                   {"amplitude", other.amplitude},
                   {"phase", other.phase},
                   {"delta_log_likelihood", other.delta_log_likelihood},
                   {"residual_rms", units.force(other.residual_rms)}});
  return out;
}

Json other_wavelengths_json(const ModelFit& model, const Units& units) {
  Json out = Json::array();
  for (const auto& wave : model.waves)
    for (const auto& interval : wave.other_wavelengths)
      out.push_back({units.length(interval.low), units.length(interval.high)});
  return out;
}

Json bootstrap_json(const TestAnalysis& analysis, const Units& units) {
  if (!analysis.bootstrap) return nullptr;
  const auto& bootstrap = *analysis.bootstrap;
  const auto spread = [](const BootstrapEstimate& estimate, double factor) {
    return Json{{"standard_error", estimate.standard_error * factor},
                {"interval95", {estimate.low * factor, estimate.high * factor}}};
  };
  const double span = units.scales.span();
  Json parameters = {{"mu0", spread(bootstrap.mu0, 1)}, {"drift", spread(bootstrap.drift, 1 / span)}};
  std::string suffix;
  int number = 1;
  for (const auto i : order_by_size(analysis.fit.models[analysis.fit.chosen])) {
    const auto& wave = bootstrap.waves[i];
    parameters["amplitude" + suffix] = spread(wave.amplitude, 1);
    parameters["wavelength" + suffix] = spread(wave.wavelength, span);
    parameters["phase" + suffix] = spread(wave.phase, 1);
    suffix = "_" + std::to_string(++number);
  }
  parameters["bending_stiffness"] = spread(bootstrap.bending_stiffness, units.scales.bending_stiffness());
  return {{"count", bootstrap.count}, {"block", bootstrap.block}, {"seed", bootstrap.seed}, {"parameters", parameters}};
}

Json contact_parameter(const FittedTest& test, const Units& units) {
  const double offset = test.measurement.contact_offset;
  const double error = test.measurement.contact_error;
  constexpr double two_sided = 1.96;
  return parameter({offset, error, offset - two_sided * error, offset + two_sided * error}, 1, units.unit("m"));
}

Json statistics_json(const ModelFit& model, const Units& units) {
  return {{"parameters", model.parameters},
          {"log_likelihood", model.log_likelihood},
          {"aic", model.aic},
          {"bic", model.bic},
          {"residual_rms", units.force(model.residual_rms)},
          {"residual_correlation", model.correlation},
          {"innovation", units.force(model.innovation)},
          {"effective_points", model.effective_points}};
}

std::string status_name(FitStatus status) {
  switch (status) {
    case FitStatus::ok:
      return "ok";
    case FitStatus::not_converged:
      return "not_converged";
    case FitStatus::not_found:
      return "not_found";
  }
  return "";
}

Json drops_json(const FittedTest& test) {
  Json out = Json::array();
  for (const auto& drop : test.analysis.drops.drops) {
    const auto& record = test.analysis.record;
    out.push_back({{"row_before", file_row(test, drop.before)},
                   {"row_after", file_row(test, drop.after)},
                   {"stage", record.stage[drop.before]},
                   {"deflection_before", record.deflection[drop.before]},
                   {"deflection_after", record.deflection[drop.after]},
                   {"force_before", record.force[drop.before]},
                   {"force_after", record.force[drop.after]},
                   {"force_fall", drop.force_fall},
                   {"significance", drop.significance},
                   {"false_alarms", drop.false_alarms}});
  }
  return out;
}

Json slips_json(const FittedTest& test, const Units& units) {
  const auto& summary = test.analysis.slip_summary;
  Json each = Json::array();
  for (const auto& slip : test.analysis.slips)
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
                   {"length", units.length(point.S)},
                   {"drawn_in", units.length(point.S - 1)},
                   {"position", units.length(point.S / 2)},
                   {"mu", point.mu},
                   {"standard_error", standard_error(point)},
                   {"from_force", point.from_force},
                   {"from_bending_stiffness", point.from_bending_stiffness},
                   {"from_contact", point.from_contact}});
  return out;
}

Json candidates_json(const WavelengthScan& scan, const Units& units) {
  Json out = Json::array();
  for (const auto& candidate : scan.candidates)
    out.push_back({{"wavelength", units.length(candidate.wavelength)},
                   {"amplitude_of_mu", std::hypot(candidate.cosine, candidate.sine)},
                   {"log_likelihood_gain", candidate.log_likelihood_gain}});
  return out;
}

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

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
  Json models = Json::array();
  for (const auto model : provenance.options.fit.models) models.push_back(name_of(model));
  return {{"program", "flexslip"},
          {"version", provenance.version},
          {"inputs", inputs},
          {"options",
           {{"models", models},
            {"false_alarms", provenance.options.drops.false_alarms_per_test},
            {"suspect_limit", provenance.options.suspect_limit},
            {"bootstrap", provenance.options.bootstrap.count},
            {"held_amplitude", number_or_null(provenance.options.fit.held.amplitude)},
            {"held_wavelength_in_spans", number_or_null(provenance.options.fit.held.wavelength)}}},
          {"case", provenance.test}};
}

Json measurement_json(const FittedTest& test) {
  const auto& measurement = test.measurement;
  const auto end = [&] {
    switch (measurement.end) {
      case MeasurementEnd::last_row:
        return "last_row";
      case MeasurementEnd::until:
        return "until";
      case MeasurementEnd::turn:
        return "turn";
      case MeasurementEnd::failure:
        return "failure";
    }
    return "";
  };
  return {{"rows", measurement.rows},
          {"first_row", file_row(test, 0)},
          {"last_row", last_row(test)},
          {"rows_per_point", measurement.rows_per_point},
          {"ends_with", end()}};
}

Json contact_json(const FittedTest& test) {
  const auto source = [&] {
    switch (test.measurement.contact) {
      case ContactSource::stated:
        return "stated";
      case ContactSource::found:
        return "found";
      case ContactSource::first_point:
        return "first_point";
    }
    return "";
  };
  const auto& found = test.analysis.contact;
  Json out = {{"source", source()},       {"taken_off", test.measurement.contact_offset},
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
  const auto source = [&] {
    switch (test.stiffness) {
      case StiffnessSource::stated:
        return "stated";
      case StiffnessSource::assumed_error:
        return "stated_without_uncertainty";
      case StiffnessSource::initial_slope:
        return "initial_slope";
      case StiffnessSource::mirror:
        return "mirror_symmetry";
    }
    return "";
  };
  return {{"nominal", test.analysis.scales.bending_stiffness()},
          {"relative_error", test.analysis.bending_stiffness_error},
          {"source", source()}};
}

}  // namespace

Json fit_json(const FittedTest& test) {
  const auto& analysis = test.analysis;
  const Units units{analysis.scales, test.reduced};
  const bool fitted = analysis.status == AnalysisStatus::ok;
  const ModelFit* chosen = fitted ? &chosen_model(test) : nullptr;

  Json criteria = Json::object();
  Json models = Json::object();
  if (fitted) {
    for (const auto& model : analysis.fit.models) {
      const std::string name(name_of(model.model));
      Json described = {{"status", status_name(model.status)}};
      if (model.status == FitStatus::not_found) {
        criteria[name] = {{"bic", nullptr}, {"aic", nullptr}, {"log_likelihood", nullptr}, {"parameters", nullptr}};
      } else {
        criteria[name] = {{"bic", model.bic},
                          {"aic", model.aic},
                          {"log_likelihood", model.log_likelihood},
                          {"parameters", model.parameters}};
        described["parameters"] = parameters_json(model, units);
        described["statistics"] = statistics_json(model, units);
        described["runners_up"] = runners_up_json(model, units);
        described["other_wavelengths95"] = other_wavelengths_json(model, units);
      }
      models[name] = described;
    }
  }

  Json parameters = chosen ? parameters_json(*chosen, units) : Json::object();
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
              {"model", chosen ? Json(name_of(chosen->model)) : Json()},
              {"category", name_of(analysis.category)},
              {"suspect", analysis.suspects.suspect},
              {"stiffness_over_initial_slope", analysis.stiffness_over_slope},
              {"model_implausible", analysis.model_implausible},
              {"stiffness_implausible", analysis.stiffness_implausible},
              {"parameters", parameters},
              {"residual_rms", chosen ? Json(units.force(chosen->residual_rms)) : Json()},
              {"criteria", criteria}};
  out["snaps"] = fitted ? snaps_json(analysis.model.snaps, analysis.scales) : Json::array();
  out["drops"] = drops_json(test);
  out["slips"] = slips_json(test, units);
  out["teeth"] = teeth_json(test);
  out["suspects"] = suspects_json(test, units);
  out["suspect_criteria"] = suspect_criteria_json(analysis.suspects);
  out["energy"] = energy;
  out["replay"] = replay;
  out["cycles"] = cycles_json(test);
  out["models"] = models;
  out["runners_up"] = chosen ? runners_up_json(*chosen, units) : Json::array();
  out["other_wavelengths95"] = chosen ? other_wavelengths_json(*chosen, units) : Json::array();
  out["bootstrap"] = bootstrap_json(analysis, units);
  out["middle"] = fitted ? Json(units.length(analysis.fit.S_middle)) : Json();
  out["wavelength_candidates"] = candidates_json(analysis.fit.scan, units);
  out["small_deflection"] = small_deflection_json(test);
  out["measurement"] = measurement_json(test);
  out["preparation"] = preparation_json(test.measurement.preparation);
  out["contact"] = contact_json(test);
  out["nominal_bending_stiffness"] = stiffness_json(test);
  out["noise"] = {{"force", units.force(analysis.force_noise)},
                  {"force_step", analysis.drops.step_noise},
                  {"smallest_drop", analysis.drops.smallest_fall}};
  out["profile"] = profile_json(test, units);
  out["provenance"] = provenance_json(test.provenance);
  return out;
}

}  // namespace flexslip
