#include "answers/fit_fields.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "answers/cycles_fields.h"
#include "answers/drop_fields.h"
#include "answers/friction_fields.h"
#include "answers/implied_fields.h"
#include "answers/profile_fields.h"
#include "answers/standard_fields.h"
#include "case/fitted.h"
#include "data/names.h"
#include "finding/answer.h"
#include "finding/fit_findings.h"
#include "result/mechanics.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

bool is_not_explained(T test) { return test.analysis.status == AnalysisStatus::not_explained; }

Fields<ImagedPoint> imaged_point_fields() {
  return Fields<ImagedPoint>()
      .row("row", "row of the file", &ImagedPoint::index)
      .number("pulled_in", kind::length, "length pulled in (both supports), from the force", &ImagedPoint::inferred)
      .number("imaged", kind::length, "length pulled in (both supports), as imaged", &ImagedPoint::imaged);
}

Fields<ImagedLength> imaged_fields() {
  return Fields<ImagedLength>()
      .number("offset", kind::length, "length from the force minus the imaged length, median over the points",
              [](const ImagedLength& imaged) { return imaged.offset.value; })
      .number("standard_error", kind::length, "standard error of offset, if the points erred independently",
              [](const ImagedLength& imaged) { return imaged.offset.standard_error; })
      .number("scatter", kind::length, "scatter of the points about offset, 1.48 times the median absolute deviation",
              &ImagedLength::scatter)
      .list("points", "points at which the length was imaged", imaged_point_fields(), &ImagedLength::points);
}

Fields<Verdict> verdict_of_fit_fields() {
  return Fields<Verdict>()
      .words("code", "slip, undecided, crack, no_drops, check_input or no_answer",
             [](const Verdict& verdict) { return name_of(verdict.code); })
      .words("sentence", "the verdict and what belongs to it, as the screen has it", sentence_of);
}

Fields<AnswerRow> answer_row_fields() {
  return Fields<AnswerRow>()
      .words("label", "drops, slip or crack, friction, work, reload, stiffness or assumed", &AnswerRow::label)
      .words("words", "what the screen says there", &AnswerRow::words);
}

Fields<FindingNumber> finding_number_fields() {
  return Fields<FindingNumber>()
      .words("name", "what the number is", &FindingNumber::name)
      .number("value", "in SI units, or reduced if the test is", &FindingNumber::value);
}

Fields<Finding> finding_fields() {
  return Fields<Finding>()
      .words("code", "a name that stays", &Finding::code)
      .words("severity", "refusal, suspicion, doubt, note, passed or unjudged",
             [](const Finding& finding) { return name_of(finding.severity); })
      .words("sentence", "what was found, as every door prints it", &Finding::sentence)
      .words("short_form", "a few words, for a table of many tests; empty where nothing speaks against the test",
             &Finding::short_form)
      .words("remedy", "what to do; empty where there is nothing to do", &Finding::remedy)
      .list("numbers", "what the sentence rests on", finding_number_fields(), &Finding::numbers);
}

// Domain: judgement is given.
Fields<FittedTest> judgement_fields() {
  return Fields<FittedTest>()
      .words("standing", "how far the answer can be trusted: sound, doubtful, suspect or untrusted",
             [](T test) { return name_of(standing_of(findings_of(test))); })
      .words("drops",
             "whether cracks alone can make the drops, judged by the rises and by a reload: not_by_cracks_alone, "
             "cracks or cannot_be_told; null without drops",
             [](T test) {
               return test.analysis.drops.drops.empty() ? std::nullopt : std::optional(name_of(test.judgement->drops));
             })
      .number("stiffness_lost", "share of the stiffness lost, as the last comparable reload shows",
              [](T test) { return test.judgement->loss; })
      .number("stiffness_lost_error", "standard error of stiffness_lost",
              [](T test) { return test.judgement->loss_error; })
      .number(
          "stiffness_loss_needed",
          "share of the stiffness that cracks alone would have to take away to make the drops; null without a reload",
          [](T test) { return test.judgement->loss_needed; })
      .number("stiffness_for_no_snap", kind::stiffness,
              "load-train stiffness above which the mean of the fit does not snap; null where less than half of the "
              "length that slid passed in slips",
              [](T test) { return test.judgement->stiffness_for_all; });
}

Fields<FittedTest> bending_fields() {
  const auto bent = [](auto value) {
    return [value](T test) {
      return is_fitted(test) && test.surface ? std::optional(((*test.surface).*value)(greatest_curvature(
                                                   test.analysis.profile_at_fit, test.analysis.rig.fibre)))
                                             : std::nullopt;
    };
  };
  return Fields<FittedTest>()
      .number("greatest_strain", "greatest bending strain of the surface at midspan; null without a section",
              bent(&SurfaceStrain::strain))
      .own("greatest_stress", kind::pressure,
           "greatest bending stress of the surface at midspan, at the fitted modulus; null without a section",
           bent(&SurfaceStrain::stress))
      .yes_no("wraps_nose", "the specimen was bent more sharply than the nose", [](T test) {
        return is_fitted(test) &&
               greatest_curvature(test.analysis.profile_at_fit, test.analysis.rig.fibre) > test.nose_curvature;
      });
}

// Of the whole record up to failure, what friction took off the work under the curve.
Fields<MeasuredEnergy> measured_energy_fields() {
  return Fields<MeasuredEnergy>()
      .all_of(energy_fields(), &MeasuredEnergy::account)
      .number("work_of_fracture", kind::energy, "work on the specimen: area under force over deflection",
              &MeasuredEnergy::work_of_fracture)
      .number("friction_share", "share of the work of fracture that went into friction and snaps",
              &MeasuredEnergy::friction_share)
      .number("remaining", kind::energy, "work of fracture without friction and snaps",
              [](const MeasuredEnergy& energy) {
                return energy.work_of_fracture - energy.account.friction - energy.account.snaps;
              });
}

Fields<FittedTest> measurement_fields() {
  using M = const Measurement&;
  const auto of = [](auto get) { return [get](T test) { return get(test.measurement); }; };
  return Fields<FittedTest>()
      .count("rows", "rows of the file", of([](M m) { return m.rows; }))
      .count("first_row", "first row of the file that is evaluated", [](T test) { return file_row(test, 0); })
      .count("last_row", "last row of the file that is evaluated", [](T test) { return last_row(test); })
      .count("rows_repeated", "rows that repeat the previous row", of([](M m) { return m.sampling.repeated; }))
      .count("rows_held", "rows that repeat the force of the previous row while the displacement moves on",
             of([](M m) { return m.sampling.held; }))
      .count("rows_interpolated", "rows interpolated between readings", of([](M m) { return m.sampling.interpolated; }))
      .count("rows_per_point", "rows per point used: one row in so many of the rest counts",
             of([](M m) { return m.sampling.stride; }))
      .words("ends_with", "what ends the evaluated loading: last_row, until, failure or turn", of([](M m) {
               return name_in_order<MeasurementEnd::turn>(m.end, {"last_row", "until", "failure", "turn"});
             }));
}

Fields<FittedTest> contact_fields() {
  const auto found = [](auto part) { return [part](T test) { return test.analysis.contact.*part; }; };
  return Fields<FittedTest>()
      .words("source", "where the contact comes from: stated, found, or first_point of the file",
             [](T test) {
               return name_in_order<ContactSource::first_point>(test.measurement.contact,
                                                                {"stated", "found", "first_point"});
             })
      .own("taken_off", kind::length, "displacement of the contact, subtracted from stage and deflection",
           [](T test) { return test.measurement.contact_offset; })
      .only_where([](T test) { return test.analysis.contact.status == ContactStatus::found; })
      .own_estimate(
          "line_offset", kind::length,
          "displacement, from the contact, at which a line through the first part of the curve meets zero force",
          found(&Contact::offset))
      .own_estimate("initial_slope", kind::stiffness, "slope of that line, the initial slope of the curve",
                    found(&Contact::slope));
}

Fields<FittedTest> nominal_stiffness_fields() {
  return Fields<FittedTest>()
      .own("nominal", kind::bending_stiffness, "EI known before the fit",
           [](T test) { return test.analysis.scales.bending_stiffness(); })
      .number("relative_error", "relative standard deviation of EI",
              [](T test) { return test.analysis.bending_stiffness_error; })
      .words("source", "where EI comes from: stated, stated_without_uncertainty, initial_slope or mirror_symmetry",
             [](T test) { return name_of(test.stiffness); });
}

Fields<FittedTest> replay_fields() {
  return Fields<FittedTest>()
      .number("residual_rms", kind::force,
              "root mean square difference between the force and the measured profile run forward as a table",
              [](T test) { return test.analysis.replay.residual_rms; })
      .count("drops", "drops of the record", [](T test) { return test.analysis.drops.drops.size(); })
      .count("drops_reproduced", "drops of the record that the replay has at the same point",
             [](T test) { return test.analysis.replay.drops_reproduced; });
}

Fields<InputFile> input_fields() {
  const auto known = [](auto part) {
    return [part](const InputFile& file) { return file.sha256.empty() ? std::nullopt : std::optional(file.*part); };
  };
  return Fields<InputFile>()
      .words("name", "name of the file, as it was given", &InputFile::name)
      .count("bytes", "size of the file; null for standard input", known(&InputFile::bytes))
      .words("sha256", "SHA-256 of the file; null for standard input", known(&InputFile::sha256));
}

Fields<Provenance> provenance_fields() {
  return Fields<Provenance>()
      .words("program", "name of the program, flexslip", [](const Provenance&) { return "flexslip"; })
      .words("version", "version of the program", &Provenance::version)
      .list("inputs", "files that were read", input_fields(), &Provenance::inputs)
      .group("options", "options of the analysis", analysis_fields(), &Provenance::options)
      .words("case", "case as TOML, even if it was given by flags", &Provenance::test);
}

Fields<FittedTest> every_fit_field() {
  const auto analysis = [](auto part) { return [part](T test) { return test.analysis.*part; }; };
  return Fields<FittedTest>()
      .words("status", "ok, or why there is no answer: too_few_points, not_explained, no_initial_slope",
             [](T test) { return status_of(test); })
      .words("name", "name of the test", &FittedTest::name)
      .group("units", "units of plain numbers", units_of_numbers<FittedTest>())
      .only_where(is_fitted)
      .words("model", "fitted friction model: roughness, constant, drift, sinusoid or sinusoids",
             [](T test) { return name_of(test.analysis.fit.model); })
      .anywhere()
      .group("verdict", "what the test comes to", verdict_of_fit_fields(),
             [](T test) { return answer_of(test).verdict; })
      .list("answer", "the rows of the screen", answer_row_fields(), [](T test) { return answer_of(test).rows; })
      .list("findings", "all that was found out, the weightiest first", finding_fields(), findings_of)
      .words("next", "the one step that would tell most; empty where there is none",
             [](T test) { return answer_of(test).next; })
      .words("category", "how clear the sawtooth is: clear, nominal or none",
             [](T test) { return name_of(test.analysis.category); })
      .yes_no("suspect", "judgement.standing is suspect or untrusted, or no sliding explains the record",
              [](T test) { return standing_of(findings_of(test)) >= Standing::suspect; })
      .number("stiffness_over_initial_slope", "bending stiffness used divided by that of the initial slope",
              analysis(&TestAnalysis::stiffness_over_slope))
      .group(
          "force_over_frictionless",
          "measured force divided by the force without friction, beyond a deflection of a tenth of the span; no "
          "friction "
          "explains values below 1",
          Fields<OverFrictionless>()
              .number("median", "median over the points", &OverFrictionless::median)
              .number("least", "smallest of the points", &OverFrictionless::least),
          [](T test) -> const auto& { return test.analysis.over_frictionless; })
      .yes_no("model_implausible", "no sliding with friction explains the record",
              [](T test) { return is_not_explained(test) || test.analysis.model_implausible; })
      .yes_no("stiffness_implausible",
              "the bending stiffness differs from that of the initial slope by more than 40 % and twice its error",
              analysis(&TestAnalysis::stiffness_implausible))
      .group("parameters", "fitted parameters of the friction model", parameter_fields())
      .group(
          "friction_read",
          "friction read off the curve point by point, at the bending stiffness of the fit: quantiles of mu in profile",
          Fields<FrictionRead>()
              .number("median", "friction below which half of the points lie", &FrictionRead::median)
              .number("low80", "friction below which a tenth of the points lie", &FrictionRead::low80)
              .number("high80", "friction above which a tenth of the points lie", &FrictionRead::high80),
          analysis(&TestAnalysis::friction_read))
      .only_where(is_fitted)
      .number("residual_rms", kind::force,
              "root mean square difference between the force and the mean of the fit run forward",
              [](T test) { return test.analysis.fit.residual_rms; })
      .anywhere()
      .list("checks", "checks of the fit; each lists the numbers that it has", check_fields(),
            analysis(&TestAnalysis::checks))
      .group("wave", "likeliest wave of friction, claimed or not; null without one", likeliest_wave_fields(),
             [](T test) { return is_fitted(test) && !test.analysis.fit.waves.empty() ? &test : nullptr; })
      .list("one_side_at_a_time", "lengths along the specimen if it slid over one support at a time",
            Fields<FittedLength>()
                .words("name", "name of the parameter", &FittedLength::name)
                .number("value", kind::length, "value of the parameter if one side slid at a time",
                        [](const FittedLength& length) { return one_side_at_a_time * length.value; }),
            [](T test) { return is_fitted(test) ? lengths_of(test.analysis.fit) : std::vector<FittedLength>(); })
      .list("explanations", "explanations that the answer averages over, the likeliest first", explanation_fields(),
            [](T test) { return test.analysis.fit.explanations; })
      .list("snaps", "snaps of the mean of the fit, run forward", snap_fields(),
            [](T test) { return is_fitted(test) ? test.analysis.model.snaps : std::vector<Snap>(); })
      .group("judgement", "verdict on the test when all is weighed", judgement_fields(),
             [](T test) { return test.judgement ? &test : nullptr; })
      .group("surface", "surface that would explain how friction varies; null if friction does not vary",
             implied_fields(), [](T test) { return test.implied ? &test : nullptr; })
      .group("bending", "how far the specimen was strained", bending_fields())
      .group("imaged_length", "imaged lengths compared with those read off the force; null without any",
             imaged_fields(), [](T test) { return test.imaged; })
      .group("slip_or_crack", "what the rises between the drops say about slips and cracks; null if there are too few",
             slip_or_crack_fields(),
             [](T test) { return test.analysis.slip_or_crack.judged ? &test.analysis.slip_or_crack : nullptr; })
      .list("drops", "drops of the force", drop_fields(),
            [](T test) {
              std::vector<DropOf> drops;
              for (const Slip& slip : test.analysis.slips) drops.push_back({test.analysis.record, slip});
              return drops;
            })
      .group(
          "slips", "drops that can be slips at the stated bending stiffness, read off at that of the fit",
          slips_fields(), [](T test) -> const auto& { return test.analysis; })
      .group("teeth", "whether the specimen sticks or slides between the drops; null if that was not asked",
             teeth_fields(), [](T test) { return is_fitted(test) && test.analysis.teeth ? &test : nullptr; })
      .list("suspects", "points that need implausibly high friction, at the stated bending stiffness", suspect_fields(),
            suspects_of)
      .group("suspect_criteria", "criteria by which suspects were found", suspect_criteria_fields(),
             analysis(&TestAnalysis::suspects))
      .only_where(is_fitted)
      .group("energy",
             "where the work went, from contact to failure, computed from the measured points at the bending stiffness "
             "of the fit",
             measured_energy_fields(), analysis(&TestAnalysis::energy))
      .group("replay", "comparison of the record with the profile read off it, run forward", replay_fields())
      .anywhere()
      .group("cycles", "loading and unloading loops of a test that was unloaded; null otherwise", cycles_fields(),
             [](T test) { return test.cycles ? &test : nullptr; })
      .group("band", "friction along the specimen, from the fit", band_fields())
      .list("scan", "evidence that a wave of each length would add",
            Fields<ScannedWave>()
                .number("wavelength", kind::length, "wavelength of the wave", &ScannedWave::wavelength)
                .number("log_evidence_gain", "ln of the evidence that the wave adds", &ScannedWave::gain),
            [](T test) { return test.analysis.fit.scan; })
      .group("small_deflection", "numbers of the bending standards",
             Fields<FittedTest>()
                 .all_of(standard_fields(), [](T test) { return standard_test(test); })
                 .number("over_fit", "bending stiffness of the straight part divided by that of the fit",
                         [](T test) {
                           const auto beside = small_deflection_beside_fit(test);
                           return beside ? std::optional(beside->ratio) : std::nullopt;
                         })
                 .yes_no("disagrees_with_fit", "95 % intervals of straight part and fit do not overlap",
                         [](T test) {
                           const auto beside = small_deflection_beside_fit(test);
                           return beside ? std::optional(beside->disagrees) : std::nullopt;
                         }))
      .group("measurement", "part of the file that is evaluated", measurement_fields())
      .list("preparation", "steps from the file to the record", preparation_fields(),
            [](T test) { return test.measurement.preparation.steps; })
      .group("contact", "point of first contact with the specimen", contact_fields())
      .group("nominal_bending_stiffness", "what was known about EI before the fit", nominal_stiffness_fields())
      .group("draws", "profiles that --draws writes",
             Fields<FittedTest>()
                 .numbers("bending_stiffness", kind::bending_stiffness, "EI that belongs to each profile",
                          [](T test) { return test.analysis.fit.draw_stiffness; })
                 .words("unit", "unit of these bending stiffnesses",
                        [](T, const Frame& frame) { return unit_of(kind::bending_stiffness, frame.reduced); }))
      .group("noise", "noise of the force",
             Fields<FittedTest>()
                 .number("force", kind::force,
                         "standard deviation of one force reading, from the quietest tenth of the record",
                         analysis(&TestAnalysis::force_noise))
                 .own("force_step", kind::force, "standard deviation of the force step from row to row",
                      [](T test) { return test.analysis.drops.step_noise; })
                 .own("smallest_drop", kind::force, "smallest fall of the force in one step that counts as a drop",
                      [](T test) { return test.analysis.drops.smallest_fall; }))
      .list("profile",
            "friction along the specimen, read off the curve point by point at the bending stiffness of the fit",
            profile_fields(), [](T test) { return points_of(test.analysis.record, profile_of(test)); })
      .group("provenance", "what the same version needs to give the same answer", provenance_fields(),
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
