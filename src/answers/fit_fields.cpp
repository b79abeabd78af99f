#include "answers/fit_fields.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "answers/mechanics_fields.h"
#include "answers/profile_fields.h"
#include "answers/standard_fields.h"
#include "case/fitted.h"
#include "data/names.h"
#include "finding/answer.h"
#include "finding/finding.h"
#include "finding/findings.h"
#include "finding/sensitivities.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

// ---- The drops of the force and the rises between them

// A force drop with its record.
struct DropOf {
  const Record& record;
  const Slip& slip;
};

Fields<Slip> slip_fields() {
  return Fields<Slip>()
      .number("length_before", kind::length, "span plus sliding length before the slip", &Slip::S_before)
      .number("length_after", kind::length, "span plus sliding length after the slip", &Slip::S_after);
}

Fields<DropOf> drop_fields() {
  using D = const DropOf&;
  const auto before = [](std::vector<double> Record::*column) {
    return [column](D drop) { return (drop.record.*column)[drop.slip.drop.before]; };
  };
  return Fields<DropOf>()
      .row("row_before", "row of the file before the drop", [](D drop) { return drop.slip.drop.before; })
      .row("row_after", "row of the file after the drop", [](D drop) { return drop.slip.drop.after; })
      .own("stage", kind::length, "stage position before the drop", before(&Record::stage))
      .own("deflection_before", kind::length, "deflection before the drop", before(&Record::deflection))
      .own("force_before", kind::force, "force before the drop", before(&Record::force))
      .own("force_fall", kind::force, "force drop", [](D drop) { return drop.slip.drop.force_fall; })
      .words("slip",
             "whether the drop can be a slip: possible or too_short; otherwise unexplained, implausible, negative or "
             "moves_out",
             [](D drop) { return name_of(drop.slip.verdict); })
      .words("reading", "what the drop can be, as in tables and on the page: slip, crack, either or neither",
             [](D drop) { return reading_of(drop.slip); })
      .number("pulled_in", kind::length, "length that slides in over both supports if the drop is a slip",
              [](D drop) { return drop.slip.S_after - drop.slip.S_before; })
      .number("mu_before", "friction before the drop, if it is a slip", [](D drop) { return drop.slip.mu_before; })
      .number("mu_after", "friction after the drop, if it is a slip", [](D drop) { return drop.slip.mu_after; });
}

Fields<TestAnalysis> slips_fields() {
  const auto summary = [](auto part) {
    return [part](const TestAnalysis& analysis) { return analysis.slip_summary.*part; };
  };
  return Fields<TestAnalysis>()
      .number("median_spacing", kind::length,
              "median distance along the specimen between the starts of successive slips",
              summary(&SlipSummary::median_spacing))
      .number("median_fall_of_mu", "median decrease of friction in a slip", summary(&SlipSummary::median_fall))
      .list("slips", "drops that can be slips, in the order of `drops`", slip_fields(),
            [](const TestAnalysis& analysis) {
              std::vector<Slip> possible;
              for (const Slip& slip : analysis.slips)
                if (slip.verdict == SlipVerdict::possible) possible.push_back(slip);
              return possible;
            });
}

// ---- Friction: parameters, waves, explanations, checks

// A getter of a member of the fit.
template <class Part>
auto of_fit(Part FrictionFit::*part) {
  return [part](T test) { return test.analysis.fit.*part; };
}

Fields<WaveEstimate> wave_fields() {
  return Fields<WaveEstimate>()
      .estimate(parameter::amplitude, &WaveEstimate::amplitude)
      .estimate(parameter::wavelength, &WaveEstimate::wavelength);
}

// True if drift is a separate parameter. With rough friction it is part of the roughness.
bool has_drift(ProfileModel model) { return model != ProfileModel::roughness && model != ProfileModel::constant; }

Fields<FittedTest> parameter_fields() {
  const auto wave = [](std::size_t i) {
    return [i](T test) -> const WaveEstimate* {
      const auto& fit = test.analysis.fit;
      return fit.wave_claimed && i < fit.waves.size() ? &fit.waves[i] : nullptr;
    };
  };
  Fields<WaveEstimate> second;
  second
      .estimate("amplitude_2", kind::number, "amplitude of the second wave, relative to mu0", &WaveEstimate::amplitude)
      .estimate("wavelength_2", kind::length, "wavelength of the second wave, along the specimen",
                &WaveEstimate::wavelength)
      .estimate("phase_2", kind::angle, "phase of the second wave at length 0", &WaveEstimate::phase);
  return Fields<FittedTest>()
      .left_out_where_missing()
      .only_where(is_fitted)
      .estimate(parameter::mu0.name, parameter::mu0.kind, parameter::mu0.meaning, of_fit(&FrictionFit::mu0),
                Fields<FittedTest>().yes_no("bound", parameter::bound, of_fit(&FrictionFit::mu0_is_bound)))
      .all_of(wave_fields().estimate(parameter::phase, &WaveEstimate::phase), wave(0))
      .all_of(second, wave(1))
      .only_where([](T test) { return is_fitted(test) && has_drift(test.analysis.fit.model); })
      .estimate("drift", kind::inverse_length, "slope of friction along the specimen", of_fit(&FrictionFit::drift))
      .estimate("reference", kind::length, "length between the contacts at which friction is mu0",
                [](T test) { return normal_estimate(test.analysis.fit.S_middle, 0); })
      .only_where([](T test) {
        const FrictionFit& fit = test.analysis.fit;
        return is_fitted(test) && fit.model == ProfileModel::roughness && determines_variation(fit);
      })
      .estimate(parameter::roughness, of_fit(&FrictionFit::roughness))
      .estimate(parameter::correlation_length, of_fit(&FrictionFit::length))
      .only_where(is_fitted)
      .estimate(parameter::bending_stiffness, of_fit(&FrictionFit::bending_stiffness))
      .anywhere()
      .own_estimate(
          "contact_offset", kind::length, "stage position of the contact point in the file; it is subtracted",
          [](T test) { return normal_estimate(test.measurement.contact_offset, test.measurement.contact_error); });
}

Fields<FittedTest> most_probable_wave_fields() {
  return Fields<FittedTest>()
      .yes_no("claimed", "the evidence supports the wave, and its length is below a quarter of the observed length",
              of_fit(&FrictionFit::wave_claimed))
      .number("log_evidence", "log Bayes factor of a wave against none", of_fit(&FrictionFit::log_evidence_of_wave))
      .all_of(
          wave_fields(), [](T test) -> const auto& { return test.analysis.fit.waves.front(); });
}

// The fitted friction along the specimen.
Fields<FittedTest> band_fields() {
  return Fields<FittedTest>()
      .numbers("length", kind::length, "length between the contacts",
               [](T test) {
                 std::vector<double> lengths;
                 for (const double S : test.analysis.fit.band.S)
                   lengths.push_back(test.analysis.fit.between_contacts(S));
                 return lengths;
               })
      .own_numbers("mean", kind::number, "mean friction at this length",
                   [](T test) { return test.analysis.fit.band.mean; })
      .own_numbers("deviation", kind::number, "standard deviation of friction at this length",
                   [](T test) { return test.analysis.fit.band.deviation; });
}

// ---- Passes

// A pass with its points of the record.
struct RecordOfPass {
  const PassFriction& pass;
  Record record;
  std::vector<PassPoint> points;  // of the joint fit
};

std::vector<RecordOfPass> records_of_passes(T test) {
  std::vector<RecordOfPass> all;
  for (const PassFriction& pass : test.passes->passes) all.push_back({pass, record_of(test, pass), {}});
  for (const PassPoint& point : test.passes->points) all[point.pass].points.push_back(point);
  return all;
}

std::string_view name_of(PassesStatus status) {
  return name_in_order<PassesStatus::not_explained>(status, {"ok", "not_sliding_out", "not_explained"});
}

Fields<PassFriction> pass_fields() {
  return Fields<PassFriction>()
      .words("direction", "in (the stage advances) or out",
             [](const PassFriction& pass) {
               return std::string_view(pass.rows.direction == Direction::loading ? "in" : "out");
             })
      .own_numbers("rows", kind::number, "first and last row of the pass in the file",
                   [](const PassFriction& pass, const Frame& frame) {
                     return std::optional(std::vector{frame.row(pass.rows.first), frame.row(pass.rows.last - 1)});
                   })
      .count("sliding_rows", "fitted rows in which the specimen slides", &PassFriction::sliding)
      .only_where([](const PassFriction& pass) { return std::isfinite(pass.friction.value); })
      .estimate("friction", kind::number, "mean friction over the sliding length of the pass", &PassFriction::friction);
}

// The points of the joint fit in a pass.
Fields<RecordOfPass> fitted_pass_fields() {
  const auto each = [](auto value) {
    return [value](const RecordOfPass& of) {
      std::vector<double> values;
      for (const PassPoint& point : of.points) values.push_back(value(point));
      return values;
    };
  };
  return Fields<RecordOfPass>()
      .numbers("drawn_in", kind::length, "length that has slid in over both supports, at the rows that the fit takes",
               each([](const PassPoint& point) { return point.S - 1; }))
      .own_numbers("q", kind::number, "mobilised friction at these rows",
                   each([](const PassPoint& point) { return point.q; }))
      .own_numbers("slides", kind::number, "1 where the specimen slides there, 0 where it sticks or only one pass came",
                   each([](const PassPoint& point) { return point.slides ? 1.0 : 0.0; }));
}

Fields<FittedTest> passes_fields() {
  const auto is_ok = [](T test) { return test.passes->status == PassesStatus::ok; };
  return Fields<FittedTest>()
      .in_frame([](T test) {
        return Frame{.scales = test.analysis.scales,
                     .reduced = test.reduced,
                     .in_inches = is_in_inches(test.measurement.test),
                     .row = [&test](std::size_t point) { return cyclic_file_row(test.measurement, point); }};
      })
      .words("status",
             "whether the joint fit of all passes succeeded: ok, not_sliding_out (not unloaded far enough) or "
             "not_explained",
             [](T test) { return name_of(test.passes->status); })
      .only_where(is_ok)
      .count("sliding_out_rows", "fitted rows in which the specimen slides outwards",
             [](T test) { return test.passes->sliding_out; })
      .estimate("settled", kind::length, "permanent deflection after the loadings that another pass follows",
                [](T test) { return test.passes->settled; })
      .number("loss_needed",
              "stiffness loss, as a share, that the drops of these loadings require if they are cracks only",
              [](T test) { return test.passes->loss_needed; })
      .anywhere()
      .count("drops_again",
             "drops of later loadings below the maximum deflection of this one; slips recur, cracks do not",
             [](T test) { return test.passes->drops_again; })
      .list("passes", "the passes in order of time",
            Fields<RecordOfPass>()
                .all_of(
                    pass_fields(), [](const RecordOfPass& of) -> const auto& { return of.pass; })
                .own_numbers("deflection", kind::length,
                             "deflection of the points of the pass, from the reversal before it",
                             [](const RecordOfPass& of) { return of.record.deflection; })
                .own_numbers("force", kind::force, "force at these points",
                             [](const RecordOfPass& of) { return of.record.force; })
                .all_of(fitted_pass_fields()),
            records_of_passes);
}

// ---- The whole answer

Fields<Verdict> verdict_of_fit_fields() {
  return Fields<Verdict>()
      .words("code", "slip, slip_and_damage, undecided, crack, settled, no_drops, check_input or no_answer",
             [](const Verdict& verdict) { return name_of(verdict.code); })
      .words("sentence", "the verdict, its meaning and its evidence, in whole sentences", sentence_of);
}

Fields<AnswerRow> answer_row_fields() {
  return Fields<AnswerRow>()
      .words("label",
             "friction, work, spacing, reload, stiffness, strain, sensitivity, assumed, record, drops, profile, imaged "
             "length, steepest part or model",
             &AnswerRow::label)
      .words("words", "the row, as --full prints it; the screen prints the clauses that fit", &AnswerRow::words);
}

Fields<FindingNumber> finding_number_fields() {
  return Fields<FindingNumber>()
      .words("name", "meaning of the number", &FindingNumber::name)
      .number("value", "value in SI units; in reduced variables if the test is reduced", &FindingNumber::value);
}

// What a finding says.
Fields<Finding> doubt_fields() {
  return Fields<Finding>()
      .words("code", "a name that never changes", &Finding::code)
      .words("severity", "refusal, suspicion, doubt, condition, note, passed or unjudged",
             [](const Finding& finding) { return name_of(finding.severity); })
      .words("sentence", "the finding, as printed everywhere", &Finding::sentence)
      .words("short_form", "a short phrase for tables and rows; may be empty", &Finding::short_form)
      .words("remedy", "suggested action; empty if there is none", &Finding::remedy);
}

Fields<Finding> finding_fields() {
  return doubt_fields().list("numbers", "the numbers behind the sentence", finding_number_fields(), &Finding::numbers);
}

Fields<Answer> answer_fields() {
  return Fields<Answer>()
      .group("verdict", "overall verdict on the test", verdict_of_fit_fields(), &Answer::verdict)
      .list("answer", "the rows of the screen, then those of --full", answer_row_fields(), all_rows)
      .list("doubts", "findings that cast doubt on the answer and that the verdict does not say itself, as printed",
            doubt_fields(), doubts_of)
      .words("checks", "number of checks of the fit that passed, in a sentence; empty without checks", checks_in_words)
      .list("findings", "all findings, most serious first", finding_fields(), &Answer::findings)
      .words("next", "the most informative next step; empty if there is none", &Answer::next);
}

// Domain: judgement is given.
Fields<FittedTest> judgement_fields() {
  return Fields<FittedTest>()
      .number("cracks_alone", "probability that the drops are cracks only: causes.cracks",
              [](T test) { return test.judgement.causes.cracks; })
      .group(
          "causes", "probabilities of the causes of the drops; null if no drops are judged",
          Fields<Causes>()
              .number("slips", "slips only; without a reload it is reliable below 0.5", &Causes::slips)
              .number("cracks", "cracks only", &Causes::cracks)
              .number(
                  "both",
                  "slips and cracks; null without a reload, because only a reload distinguishes this from slips only",
                  &Causes::both),
          [](T test) {
            Causes causes = test.judgement.causes;
            if (!is_reloaded(test.analysis)) causes.both = not_a_number;
            return causes;
          })
      .only_where([](T test) { return test.passes && test.passes->is_reloaded; })
      .number("stiffness_lost", "share of the stiffness lost from the first loading to the last pass",
              [](T test) { return test.passes->loss.value; })
      .number("stiffness_lost_error", "standard error of stiffness_lost",
              [](T test) { return test.passes->loss.standard_error; })
      .anywhere();
}

bool has_friction_share(const MeasuredEnergy& energy) { return std::isfinite(energy.friction_share); }

// The energy account of the record up to failure.
Fields<MeasuredEnergy> measured_energy_fields() {
  const auto part = [](double EnergyAccount::*of) {
    return [of](const MeasuredEnergy& energy) { return energy.account.*of; };
  };
  return with_work<MeasuredEnergy>(
             Fields<MeasuredEnergy>()
                 .number("bending", kind::energy, "bending energy of the specimen", part(&EnergyAccount::bending))
                 .only_where(has_friction_share)
                 .number("friction", kind::energy, "heat of friction at the supports", part(&EnergyAccount::friction))
                 .number("snaps", kind::energy, "energy lost in drops in excess of friction",
                         part(&EnergyAccount::snaps))
                 .anywhere(),
             &MeasuredEnergy::work_of_fracture, &MeasuredEnergy::friction_share)
      .numbers(
          "friction_share_interval95", kind::number,
          "95 % interval of friction_share, from the uncertainties of the inputs, with no stiffness lost",
          [](const MeasuredEnergy& energy) {
            const Estimate share = energy.share();
            return std::isfinite(share.standard_error) ? std::vector{share.low, share.high} : std::vector<double>();
          });
}

Fields<Sensitivity> sensitivity_fields() {
  return Fields<Sensitivity>()
      .words("quantity",
             "bending_stiffness, load_train, span, force_gain, contact, preload, thickness or support_radius",
             &Sensitivity::quantity)
      .words("title", "title of the quantity", &Sensitivity::title)
      .words("stated", "value stated in the case, or the assumed value", &Sensitivity::stated)
      .words("may_be_off",
             "uncertainty, as one standard deviation; for a quantity assumed to be absent, the amount for which the "
             "effects are given",
             &Sensitivity::may_be_off)
      .number("friction",
              "derivative of the mean friction with respect to the relative error of the quantity, or to its error in "
              "metres or spans",
              &Sensitivity::friction)
      .number("friction_moves", "increase in the mean friction if the stated value were larger by its uncertainty",
              &Sensitivity::friction_moves)
      .number("work_moves", "increase in the friction share of the work for the same change", &Sensitivity::work_moves);
}

Fields<Correlation> parameter_correlation_fields() {
  return Fields<Correlation>()
      .words("of", "parameter", [](const Correlation& each) { return std::string(each.of); })
      .words("with", "another parameter", [](const Correlation& each) { return std::string(each.with); })
      .number("correlation",
              "correlation of their errors; for bending_stiffness, roughness and correlation_length, of the errors of "
              "their logarithms",
              &Correlation::value);
}

// The correlations between the parameters in the answer.
std::vector<Correlation> correlations_of(T test) {
  if (!is_fitted(test)) return {};
  std::vector<Correlation> correlations = test.analysis.fit.correlations;
  if (!has_drift(test.analysis.fit.model))
    std::erase_if(correlations, [](const Correlation& each) { return each.of == "drift" || each.with == "drift"; });
  return correlations;
}

Fields<FittedTest> measurement_fields() {
  using M = const Measurement&;
  const auto of = [](auto get) { return [get](T test) { return get(test.measurement); }; };
  return Fields<FittedTest>()
      .count("rows", "rows of the file", of([](M m) { return m.rows; }))
      .count("first_row", "first evaluated row of the file", [](T test) { return file_row(test, 0); })
      .count("last_row", "last evaluated row of the file", [](T test) { return last_row(test); })
      .words(
          "ends_with",
          "reason for the end of the evaluated loading: last_row, until, failure, turn or overload (of the load cell)",
          of([](M m) {
            return name_in_order<MeasurementEnd::overload>(m.end, {"last_row", "until", "failure", "turn", "overload"});
          }))
      .only_where(of([](M m) { return m.relaxation.has_value(); }))
      .estimate("relaxation", kind::number, "share of the force lost while the stage is stationary, over all stops",
                of([](M m) { return m.relaxation->share; }))
      .anywhere();
}

Fields<FittedTest> contact_fields() {
  return Fields<FittedTest>().words(
      "source", "source of the contact point: stated, found, or first_point of the file", [](T test) {
        return name_in_order<ContactSource::first_point>(test.measurement.contact, {"stated", "found", "first_point"});
      });
}

Fields<FittedTest> nominal_stiffness_fields() {
  return Fields<FittedTest>()
      .own("nominal", kind::bending_stiffness, "nominal EI, before the fit",
           [](T test) { return test.analysis.scales.bending_stiffness(); })
      .number("relative_error", "relative standard deviation of EI",
              [](T test) { return test.analysis.bending_stiffness_error; })
      .words("source", "source of EI: stated, stated_without_uncertainty or initial_slope",
             [](T test) { return name_of(test.stiffness); });
}

Fields<InputFile> input_fields() {
  return Fields<InputFile>()
      .words("name", "name of the file, as given", &InputFile::name)
      .words("sha256", "SHA-256 of the file; null for standard input",
             [](const InputFile& file) { return file.sha256.empty() ? std::nullopt : std::optional(file.sha256); });
}

Fields<Provenance> provenance_fields() {
  return Fields<Provenance>()
      .words("version", "version of the program", &Provenance::version)
      .list("inputs", "input files", input_fields(), &Provenance::inputs)
      .group("options", "options of the analysis", analysis_fields(), &Provenance::options)
      .words("case", "the case as TOML, including values given by options", &Provenance::test);
}

Fields<FittedTest> every_fit_field() {
  const auto analysis = [](auto part) { return [part](T test) { return test.analysis.*part; }; };
  return Fields<FittedTest>()
      .words("status", "ok; without an answer too_few_points (deflection too small) or not_explained",
             [](T test) { return status_of(test); })
      .words("name", "name of the test", &FittedTest::name)
      .only_where(is_fitted)
      .words("model", "fitted friction model: roughness, constant, drift, sinusoid or sinusoids",
             [](T test) { return name_of(test.analysis.fit.model); })
      .anywhere()
      .all_of(answer_fields(), [](T test) { return answer_of(test); })
      .words("category", "how clear the sawtooth is: clear, nominal or none",
             [](T test) { return name_of(test.analysis.category); })
      .yes_no("suspect", "the answer has a finding of severity refusal or suspicion",
              [](T test) { return is_suspect(findings_of(test)); })
      .group("parameters", "fitted parameters of the friction model", parameter_fields())
      .only_where(is_fitted)
      .yes_no("snaps_overshoot",
              "snaps carry the specimen past the nearest stable state, as stated or as determined from the record",
              [](T test) { return test.analysis.fit.overshoots; })
      .number("residual_rms", kind::force,
              "root mean square difference between the measured force and the simulated best-fit profile",
              [](T test) { return test.analysis.fit.residual_rms; })
      .anywhere()
      .list("sensitivities",
            "first-order sensitivity of the answer to each input, largest effect on friction first; empty without an "
            "answer, or with a constant friction",
            sensitivity_fields(), sensitivities_of)
      .list("correlations",
            "correlations between pairs of parameters; empty without an answer, or with a constant friction",
            parameter_correlation_fields(), correlations_of)
      .group("wave", "most probable wave of friction, detected or not; null without one", most_probable_wave_fields(),
             [](T test) {
               const FrictionFit& fit = test.analysis.fit;
               return is_fitted(test) && !fit.waves.empty() && determines_variation(fit) ? &test : nullptr;
             })
      .group(
          "judgement", "probability that the drops are cracks only, and the stiffness loss shown by a reload",
          judgement_fields(), [](T test) -> const auto& { return test; })
      .list("drops", "drops of the force", drop_fields(),
            [](T test) {
              std::vector<DropOf> drops;
              for (const Slip& slip : test.analysis.slips) drops.push_back({test.analysis.record, slip});
              return drops;
            })
      .group(
          "slips", "drops that can be slips at the stated bending stiffness, evaluated at the fitted one",
          slips_fields(), [](T test) -> const auto& { return test.analysis; })
      .only_where(is_fitted)
      .group("energy",
             "energy account from contact to failure, from the measured points at the fitted bending stiffness",
             measured_energy_fields(), analysis(&TestAnalysis::energy))
      .anywhere()
      .group("passes", "joint fit of all passes of a test with unloading; null otherwise", passes_fields(),
             [](T test) { return test.passes ? &test : nullptr; })
      .group("band", "fitted friction along the specimen", band_fields())
      .group("small_deflection", "comparison of the linear region with the fit",
             Fields<FittedTest>().number(
                 "over_fit", "bending stiffness of the linear region divided by the fitted bending stiffness",
                 [](T test) {
                   const auto comparison = compare_stiffness(test);
                   return comparison ? std::optional(comparison->ratio) : std::nullopt;
                 }))
      .group("measurement", "evaluated part of the file", measurement_fields())
      .list("preparation", "steps from the file to the record", preparation_fields(),
            [](T test) { return test.measurement.preparation; })
      .group("contact", "point of first contact with the specimen", contact_fields())
      .group("nominal_bending_stiffness", "bending stiffness EI before the fit", nominal_stiffness_fields())
      .group("draws", "posterior samples of the profile, written by --draws",
             Fields<FittedTest>().numbers("bending_stiffness", kind::bending_stiffness,
                                          "EI of each sample, in the unit of parameters.bending_stiffness",
                                          [](T test) { return test.analysis.fit.draw_stiffness; }))
      .list("profile", "friction along the specimen, inverted point by point at the fitted bending stiffness",
            pointwise_friction_fields(), [](T test) { return points_of(test.analysis.record, profile_of(test)); })
      .group("provenance", "inputs that reproduce the answer with the same version", provenance_fields(),
             &FittedTest::provenance);
}

}  // namespace

Frame frame_of(const FittedTest& test) {
  return {.scales = test.analysis.scales,
          .reduced = test.reduced,
          .in_inches = is_in_inches(test.measurement.test),
          .row = [&test](std::size_t point) { return file_row(test, point); }};
}

const Fields<FittedTest>& fit_fields() {
  static const Fields<FittedTest> fields = every_fit_field();
  return fields;
}

Json fit_json(const FittedTest& test) { return fit_fields()(test, frame_of(test)); }

}  // namespace flexslip
