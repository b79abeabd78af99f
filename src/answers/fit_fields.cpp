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
#include "case/analysis_fields.h"
#include "finding/answer.h"
#include "finding/fit_findings.h"
#include "data/names.h"
#include "result/mechanics.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

bool is_not_explained(T test) { return test.analysis.status == AnalysisStatus::not_explained; }

Fields<ImagedPoint> imaged_point_fields() {
  return Fields<ImagedPoint>()
      .row("row", "row of the file", &ImagedPoint::index)
      .number("pulled_in", kind::length, "length drawn in, from the force", &ImagedPoint::inferred)
      .number("imaged", kind::length, "likewise, as imaged", &ImagedPoint::imaged);
}

Fields<ImagedLength> imaged_fields() {
  return Fields<ImagedLength>()
      .number("offset", kind::length, "what the force says less what was imaged, median",
              [](const ImagedLength& imaged) { return imaged.offset.value; })
      .number("standard_error", kind::length, "of offset, if the points erred independently",
              [](const ImagedLength& imaged) { return imaged.offset.standard_error; })
      .number("scatter", kind::length, "about it, 1.48 times the median absolute deviation", &ImagedLength::scatter)
      .list("points", "that were imaged", imaged_point_fields(), &ImagedLength::points);
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
      .words("standing", "sound, doubtful, suspect or untrusted, by the weightiest finding",
             [](T test) { return name_of(standing_of(findings_of(test))); })
      .words("drops", "not_by_cracks_alone, cracks or cannot_be_told, by the rises and by a reload; null without drops",
             [](T test) {
               return test.analysis.drops.drops.empty() ? std::nullopt : std::optional(name_of(test.judgement->drops));
             })
      .number("stiffness_lost", "share lost, that the last comparable reload shows",
              [](T test) { return test.judgement->loss; })
      .number("stiffness_lost_error", "its standard error", [](T test) { return test.judgement->loss_error; })
      .number("stiffness_loss_needed", "share that cracks alone would need to make the drops; null without a reload",
              [](T test) { return test.judgement->loss_needed; })
      .number("stiffness_for_no_snap", kind::stiffness,
              "of a rig on which the mean of the fit does not snap; null where less than half of the length passed in slips",
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
      .number("greatest_strain", "of the surface at midspan; null without a section", bent(&SurfaceStrain::strain))
      .own("greatest_stress", kind::pressure,
           "of the surface at midspan, at the modulus fitted; null without a section", bent(&SurfaceStrain::stress))
      .yes_no("wraps_nose", "it was bent more sharply than the nose", [](T test) {
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
      .number("friction_share", "of it that went into friction and snaps", &MeasuredEnergy::friction_share)
      .number("remaining", kind::energy, "of it without friction and snaps", [](const MeasuredEnergy& energy) {
        return energy.work_of_fracture - energy.account.friction - energy.account.snaps;
      });
}

Fields<FittedTest> measurement_fields() {
  using M = const Measurement&;
  const auto of = [](auto get) { return [get](T test) { return get(test.measurement); }; };
  return Fields<FittedTest>()
      .count("rows", "of the file", of([](M m) { return m.rows; }))
      .count("first_row", "of the file that is evaluated", [](T test) { return file_row(test, 0); })
      .count("last_row", "of the file that is evaluated", [](T test) { return last_row(test); })
      .count("rows_repeated", "rows that say what the row before says", of([](M m) { return m.sampling.repeated; }))
      .count("rows_held", "rows whose force is held while the displacement moves on",
             of([](M m) { return m.sampling.held; }))
      .count("rows_interpolated", "rows between readings", of([](M m) { return m.sampling.interpolated; }))
      .count("rows_per_point", "of the rest one in so many counts", of([](M m) { return m.sampling.stride; }))
      .words("ends_with", "what ends the loading that is evaluated: last_row, until, failure or turn", of([](M m) {
               return name_in_order<MeasurementEnd::turn>(m.end, {"last_row", "until", "failure", "turn"});
             }));
}

Fields<FittedTest> contact_fields() {
  const auto found = [](auto part) { return [part](T test) { return test.analysis.contact.*part; }; };
  return Fields<FittedTest>()
      .words("source", "stated, found, or the first_point of the file",
             [](T test) {
               return name_in_order<ContactSource::first_point>(test.measurement.contact,
                                                                {"stated", "found", "first_point"});
             })
      .own("taken_off", kind::length, "from stage and deflection",
           [](T test) { return test.measurement.contact_offset; })
      .only_where([](T test) { return test.analysis.contact.status == ContactStatus::found; })
      .own_estimate("line_offset", kind::length,
                    "where a line through the first part of the curve meets zero force, from there",
                    found(&Contact::offset))
      .own_estimate("initial_slope", kind::stiffness, "of that line", found(&Contact::slope));
}

Fields<FittedTest> nominal_stiffness_fields() {
  return Fields<FittedTest>()
      .own("nominal", kind::bending_stiffness, "EI as used beforehand",
           [](T test) { return test.analysis.scales.bending_stiffness(); })
      .number("relative_error", "its standard deviation", [](T test) { return test.analysis.bending_stiffness_error; })
      .words("source", "stated, stated_without_uncertainty, initial_slope or mirror_symmetry",
             [](T test) { return name_of(test.stiffness); });
}

Fields<FittedTest> replay_fields() {
  return Fields<FittedTest>()
      .number("residual_rms", kind::force, "by which the measured profile, run forward as a table, misses the force",
              [](T test) { return test.analysis.replay.residual_rms; })
      .count("drops", "of the record", [](T test) { return test.analysis.drops.drops.size(); })
      .count("drops_reproduced", "of these at the same point",
             [](T test) { return test.analysis.replay.drops_reproduced; });
}

Fields<InputFile> input_fields() {
  const auto known = [](auto part) {
    return [part](const InputFile& file) { return file.sha256.empty() ? std::nullopt : std::optional(file.*part); };
  };
  return Fields<InputFile>()
      .words("name", "as it was given", &InputFile::name)
      .count("bytes", "null of standard input", known(&InputFile::bytes))
      .words("sha256", "null of standard input", known(&InputFile::sha256));
}

Fields<Provenance> provenance_fields() {
  return Fields<Provenance>()
      .words("program", "flexslip", [](const Provenance&) { return "flexslip"; })
      .words("version", "its version", &Provenance::version)
      .list("inputs", "files that were read", input_fields(), &Provenance::inputs)
      .group("options", "of the analysis", analysis_fields(), &Provenance::options)
      .words("case", "as TOML, also where it was given by flags", &Provenance::test);
}

Fields<FittedTest> every_fit_field() {
  const auto analysis = [](auto part) { return [part](T test) { return test.analysis.*part; }; };
  return Fields<FittedTest>()
      .words("status", "ok, or why there is no answer: too_few_points, not_explained, no_initial_slope",
             [](T test) { return status_of(test); })
      .words("name", "of the test", &FittedTest::name)
      .group("units", "of plain numbers", units_of_numbers<FittedTest>())
      .only_where(is_fitted)
      .words("model", "of friction: roughness, constant, drift, sinusoid or sinusoids",
             [](T test) { return name_of(test.analysis.fit.model); })
      .anywhere()
      .group("verdict", "what the test comes to", verdict_of_fit_fields(), [](T test) { return answer_of(test).verdict; })
      .list("answer", "the rows of the screen", answer_row_fields(), [](T test) { return answer_of(test).rows; })
      .list("findings", "all that was found out, the weightiest first", finding_fields(), findings_of)
      .words("next", "the one step that would tell most; empty where there is none",
             [](T test) { return answer_of(test).next; })
      .words("category", "of the sawtooth: clear, nominal or none",
             [](T test) { return name_of(test.analysis.category); })
      .yes_no("suspect", "its standing is suspect or untrusted, or no sliding explains it",
              [](T test) {
                return standing_of(findings_of(test)) >= Standing::suspect;
              })
      .number("stiffness_over_initial_slope", "bending stiffness used over that of the initial slope",
              analysis(&TestAnalysis::stiffness_over_slope))
      .group(
          "force_over_frictionless",
          "the force over that without friction, past a tenth of the span; below 1, no friction explains it",
          Fields<OverFrictionless>()
              .number("median", "over the points", &OverFrictionless::median)
              .number("least", "of them", &OverFrictionless::least),
          [](T test) -> const auto& { return test.analysis.over_frictionless; })
      .yes_no("model_implausible", "no sliding with friction gives such a record",
              [](T test) { return is_not_explained(test) || test.analysis.model_implausible; })
      .yes_no("stiffness_implausible",
              "the bending stiffness is not that of the initial slope, by more than 40 % and twice its error",
              analysis(&TestAnalysis::stiffness_implausible))
      .group("parameters", "what was fitted; those of the model that the fit is of", parameter_fields())
      .group(
          "friction_read",
          "friction read off the curve point by point, at the bending stiffness of the fit: quantiles of mu in profile",
          Fields<FrictionRead>()
              .number("median", "half of the points lie below it", &FrictionRead::median)
              .number("low80", "a tenth of the points lie below it", &FrictionRead::low80)
              .number("high80", "a tenth of the points lie above it", &FrictionRead::high80),
          analysis(&TestAnalysis::friction_read))
      .only_where(is_fitted)
      .number("residual_rms", kind::force, "by which the mean of the fit, run forward, misses the force",
              [](T test) { return test.analysis.fit.residual_rms; })
      .anywhere()
      .list("checks", "what the fit is held against; numbers of a check are those that it has", check_fields(),
            analysis(&TestAnalysis::checks))
      .group("wave", "the likeliest wave, claimed or not; null without one", likeliest_wave_fields(),
             [](T test) { return is_fitted(test) && !test.analysis.fit.waves.empty() ? &test : nullptr; })
      .list("one_side_at_a_time", "lengths along the specimen if it slid over one support at a time",
            Fields<FittedLength>()
                .words("name", "of the parameter", &FittedLength::name)
                .number("value", kind::length, "its value then",
                        [](const FittedLength& length) { return one_side_at_a_time * length.value; }),
            [](T test) { return is_fitted(test) ? lengths_of(test.analysis.fit) : std::vector<FittedLength>(); })
      .list("explanations", "that the answer averages over, likeliest first", explanation_fields(),
            [](T test) { return test.analysis.fit.explanations; })
      .list("snaps", "of the mean of the fit, run forward", snap_fields(),
            [](T test) { return is_fitted(test) ? test.analysis.model.snaps : std::vector<Snap>(); })
      .group("judgement", "what the test comes to when all is weighed", judgement_fields(),
             [](T test) { return test.judgement ? &test : nullptr; })
      .group("surface", "that would explain how friction varies; null where it does not", implied_fields(),
             [](T test) { return test.implied ? &test : nullptr; })
      .group("bending", "how far the specimen was strained", bending_fields())
      .group("imaged_length", "lengths that were imaged, against those read off the force; null without any",
             imaged_fields(), [](T test) { return test.imaged; })
      .group("slip_or_crack", "what the rises between the drops say of them; null where these are too few",
             slip_or_crack_fields(),
             [](T test) { return test.analysis.slip_or_crack.judged ? &test.analysis.slip_or_crack : nullptr; })
      .list("drops", "of the force", drop_fields(),
            [](T test) {
              std::vector<DropOf> drops;
              for (const Slip& slip : test.analysis.slips) drops.push_back({test.analysis.record, slip});
              return drops;
            })
      .group(
          "slips", "the drops that can be slips by the bending stiffness stated, read at that of the fit",
          slips_fields(), [](T test) -> const auto& { return test.analysis; })
      .group("teeth", "whether the specimen sticks or slides between the drops; null where that is not asked",
             teeth_fields(), [](T test) { return is_fitted(test) && test.analysis.teeth ? &test : nullptr; })
      .list("suspects", "points that need more friction than is plausible, at the bending stiffness stated",
            suspect_fields(), suspects_of)
      .group("suspect_criteria", "how these were found", suspect_criteria_fields(), analysis(&TestAnalysis::suspects))
      .only_where(is_fitted)
      .group("energy",
             "where the work went, from contact to failure, by the measured points at the bending stiffness of the fit",
             measured_energy_fields(), analysis(&TestAnalysis::energy))
      .group("replay", "the profile read off the curve, run forward", replay_fields())
      .anywhere()
      .group("cycles", "of a test that was unloaded; null otherwise", cycles_fields(),
             [](T test) { return test.cycles ? &test : nullptr; })
      .group("band", "friction along the specimen, by the fit", band_fields())
      .list("scan", "what a wave of each length would add",
            Fields<ScannedWave>()
                .number("wavelength", kind::length, "of the wave", &ScannedWave::wavelength)
                .number("log_evidence_gain", "ln of the evidence that it adds", &ScannedWave::gain),
            [](T test) { return test.analysis.fit.scan; })
      .group("small_deflection", "the numbers of the bending standards",
             Fields<FittedTest>()
                 .all_of(standard_fields(), [](T test) { return standard_test(test); })
                 .number("over_fit", "bending stiffness of the straight part over that of the fit",
                         [](T test) {
                           const auto beside = small_deflection_beside_fit(test);
                           return beside ? std::optional(beside->ratio) : std::nullopt;
                         })
                 .yes_no("disagrees_with_fit", "their 95 % intervals do not meet",
                         [](T test) {
                           const auto beside = small_deflection_beside_fit(test);
                           return beside ? std::optional(beside->disagrees) : std::nullopt;
                         }))
      .group("measurement", "what of the file is evaluated", measurement_fields())
      .list("preparation", "from the file to the record, step by step", preparation_fields(),
            [](T test) { return test.measurement.preparation.steps; })
      .group("contact", "where the specimen is first touched", contact_fields())
      .group("nominal_bending_stiffness", "what was known of EI beforehand", nominal_stiffness_fields())
      .group("draws", "the profiles that --draws writes",
             Fields<FittedTest>()
                 .numbers("bending_stiffness", kind::bending_stiffness, "EI that goes with each",
                          [](T test) { return test.analysis.fit.draw_stiffness; })
                 .words("unit", "of these",
                        [](T, const Frame& frame) { return unit_of(kind::bending_stiffness, frame.reduced); }))
      .group("noise", "of the force",
             Fields<FittedTest>()
                 .number("force", kind::force, "standard deviation of one reading, by its quietest tenth",
                         analysis(&TestAnalysis::force_noise))
                 .own("force_step", kind::force, "standard deviation of a step from row to row",
                      [](T test) { return test.analysis.drops.step_noise; })
                 .own("smallest_drop", kind::force, "a fall in one step smaller than this counts as noise",
                      [](T test) { return test.analysis.drops.smallest_fall; }))
      .list("profile",
            "friction along the specimen, read off the curve point by point at the bending stiffness of the fit",
            profile_fields(), [](T test) { return points_of(test.analysis.record, profile_of(test)); })
      .group("provenance", "what to give to the same version for the same answer", provenance_fields(),
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
