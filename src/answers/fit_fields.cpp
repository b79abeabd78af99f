#include "answers/fit_fields.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "answers/cycles_fields.h"
#include "answers/profile_fields.h"
#include "answers/standard_fields.h"
#include "data/names.h"
#include "result/mechanics.h"

namespace flexslip {
namespace {

using T = const FittedTest&;
using F = const FrictionFit&;

bool is_fitted(T test) { return test.analysis.status == AnalysisStatus::ok; }

// A part of the fit, where there is one.
template <class Part>
auto of_fit(Part FrictionFit::*part) {
  return [part](T test) { return test.analysis.fit.*part; };
}

Fields<WaveEstimate> wave_fields() {
  return Fields<WaveEstimate>()
      .estimate("amplitude", kind::number, "of the wave of friction, relative to mu0", &WaveEstimate::amplitude)
      .estimate("wavelength", kind::length, "of that wave, along the specimen", &WaveEstimate::wavelength)
      .estimate("phase", kind::angle, "of that wave, at the length 0", &WaveEstimate::phase)
      .estimate("phase_at_middle", kind::angle, "of that wave, at the reference", &WaveEstimate::phase_at_middle);
}

Fields<FittedTest> parameter_fields() {
  const auto wave = [](std::size_t i) {
    return [i](T test) -> const WaveEstimate* {
      const auto& fit = test.analysis.fit;
      return fit.wave_claimed && i < fit.waves.size() ? &fit.waves[i] : nullptr;
    };
  };
  Fields<WaveEstimate> second;
  second.estimate("amplitude_2", kind::number, "of the second wave, relative to mu0", &WaveEstimate::amplitude)
      .estimate("wavelength_2", kind::length, "of the second wave, along the specimen", &WaveEstimate::wavelength)
      .estimate("phase_2", kind::angle, "of the second wave, at the length 0", &WaveEstimate::phase)
      .estimate("phase_at_middle_2", kind::angle, "of the second wave, at the reference",
                &WaveEstimate::phase_at_middle);
  return Fields<FittedTest>()
      .left_out_where_missing()
      .only_where(is_fitted)
      .estimate("mu0", kind::number, "mean friction over the fibre seen", of_fit(&FrictionFit::mu0),
                Fields<FittedTest>().yes_no(
                    "bound", "the record does not tell it from 0: the upper end of its interval is a limit",
                    of_fit(&FrictionFit::mu0_is_bound)))
      .all_of(wave_fields(), wave(0))
      .all_of(second, wave(1))
      .only_where([](T test) { return is_fitted(test) && test.analysis.fit.model != ProfileModel::constant; })
      .estimate("drift", kind::inverse_length, "slope of friction along the specimen", of_fit(&FrictionFit::drift))
      .estimate("force_noise", kind::force, "standard deviation of a force reading", of_fit(&FrictionFit::noise))
      .only_where([](T test) { return is_fitted(test) && test.analysis.fit.model == ProfileModel::roughness; })
      .estimate("roughness", kind::number, "standard deviation of friction about its mean",
                of_fit(&FrictionFit::roughness))
      .estimate("correlation_length", kind::length, "of the roughness along the specimen", of_fit(&FrictionFit::length))
      .only_where(is_fitted)
      .estimate("bending_stiffness", kind::bending_stiffness, "EI of the fit", of_fit(&FrictionFit::bending_stiffness))
      .estimate("reference", kind::length,
                "length between the contacts where phase_at_middle, and mu0 with drift and wave, hold",
                [](T test) { return normal_estimate(test.analysis.fit.S_middle, 0); })
      .anywhere()
      .own_estimate("contact_offset", kind::length, "stage position of the contact in the file, taken off", [](T test) {
        return normal_estimate(test.measurement.contact_offset, test.measurement.contact_error);
      });
}

Fields<FittedTest> likeliest_wave_fields() {
  return Fields<FittedTest>()
      .yes_no("claimed", "by the evidence, and shorter than a quarter of the fibre seen",
              of_fit(&FrictionFit::wave_claimed))
      .number("log_evidence", "ln of the evidence with a wave over that without",
              of_fit(&FrictionFit::log_evidence_of_wave))
      .all_of(wave_fields(), [](T test) { return &test.analysis.fit.waves.front(); });
}

Fields<Explanation> explanation_fields() {
  return Fields<Explanation>()
      .words("kernel", "of the roughness: exponential, matern_3_2, matern_5_2 or none",
             [](const Explanation& each) { return name_of(each.kernel); })
      .numbers("wavelengths", kind::length, "of its waves", [](const Explanation& each) { return each.wavelengths; })
      .number("weight", "of all; they add up to 1", &Explanation::weight)
      .number("log_evidence", "ln of its evidence", &Explanation::log_evidence)
      .number("log_likelihood", "ln of its likelihood where its posterior is greatest", &Explanation::log_likelihood);
}

// All of the fit that is made of the bands along the fibre.
Fields<FittedTest> band_fields() {
  return Fields<FittedTest>()
      .numbers("length", kind::length, "between the contacts",
               [](T test) {
                 std::vector<double> lengths;
                 for (const double S : test.analysis.fit.band.S)
                   lengths.push_back(test.analysis.fit.between_contacts(S));
                 return lengths;
               })
      .numbers("drawn_in", kind::length, "length drawn in over both supports",
               [](T test) {
                 std::vector<double> lengths;
                 for (const double S : test.analysis.fit.band.S) lengths.push_back(S - 1);
                 return lengths;
               })
      .own_numbers("mean", kind::number, "friction there", [](T test) { return test.analysis.fit.band.mean; })
      .own_numbers("deviation", kind::number, "its standard deviation",
                   [](T test) { return test.analysis.fit.band.deviation; });
}

Fields<Check> check_fields() {
  Fields<Check> fields;
  fields
      .words("name", "residuals, drops, whiteness, nesting, friction or stability",
             [](const Check& check) { return name_of(check.kind); })
      .yes_no("passed", "null where it is not possible",
              [](const Check& check) {
                return check.outcome == CheckOutcome::not_possible
                           ? std::nullopt
                           : std::optional(check.outcome == CheckOutcome::passed);
              })
      .left_out_where_missing();
  struct Number {
    std::string_view name;
    const Kind& kind;
    std::string_view meaning;
  };
  for (const auto& [name, kind, meaning] :
       {Number{"residual_rms", kind::force, "by which the mean of the fit, run forward, misses the force"},
        Number{"greatest_force", kind::force, "greatest force measured"},
        Number{"threshold", kind::force, "smallest drop that is counted"},
        Number{"record", kind::number, "drops of the record"},
        Number{"draws_low", kind::number, "fewest drops of a profile drawn from the fit"},
        Number{"draws_median", kind::number, "drops of such profiles, median"},
        Number{"draws_high", kind::number, "most drops of such a profile"},
        Number{"record_fall", kind::force, "mean fall in the drops of the record"},
        Number{"draws_fall", kind::force, "mean fall in the drops of such profiles"},
        Number{"ljung_box", kind::number, "Ljung and Box's statistic of what the fit leaves"},
        Number{"lags", kind::number, "readings over which it is taken"},
        Number{"p_value", kind::number, "probability of as much from noise alone"},
        Number{"most_below", kind::number, "greatest ln L by which the explanation lies below one that it contains"},
        Number{"mu0_high", kind::number, "upper end of the 95 % interval of mu0"},
        Number{"mu0_moved", kind::number, "standard errors that mu0 moves by as the force changes in its ninth digit"},
        Number{"same_explanation", kind::number, "1 if the likeliest explanation stays then, else 0"}})
    fields.number(name, kind, meaning, [name = name](const Check& check) {
      const auto found = std::find_if(check.numbers.begin(), check.numbers.end(),
                                      [&](const CheckNumber& number) { return number.name == name; });
      return found == check.numbers.end() ? std::nullopt : std::optional(found->value);
    });
  return fields;
}

// A drop of the force and the record that it is in.
struct DropOf {
  const Record& record;
  const Slip& slip;
};

Fields<DropOf> drop_fields() {
  using D = const DropOf&;
  const auto before = [](std::vector<double> Record::*column) {
    return [column](D drop) { return (drop.record.*column)[drop.slip.drop.before]; };
  };
  const auto after = [](std::vector<double> Record::*column) {
    return [column](D drop) { return (drop.record.*column)[drop.slip.drop.after]; };
  };
  return Fields<DropOf>()
      .row("row_before", "row of the file before the drop", [](D drop) { return drop.slip.drop.before; })
      .row("row_after", "row of the file after it", [](D drop) { return drop.slip.drop.after; })
      .own("stage", kind::length, "stage position before it", before(&Record::stage))
      .own("deflection_before", kind::length, "deflection before it", before(&Record::deflection))
      .own("deflection_after", kind::length, "deflection after it", after(&Record::deflection))
      .own("force_before", kind::force, "force before it", before(&Record::force))
      .own("force_after", kind::force, "force after it", after(&Record::force))
      .own("force_fall", kind::force, "by which the force falls", [](D drop) { return drop.slip.drop.force_fall; })
      .number("significance", "fall beyond that of the smooth curve, in standard deviations of the noise",
              [](D drop) { return drop.slip.drop.significance; })
      .number("false_alarms", "drops as significant to be expected in a test of this length without slips",
              [](D drop) { return drop.slip.drop.false_alarms; })
      .words("slip",
             "whether it can be a slip: possible, too_short to judge, or why not: unexplained by any friction, "
             "implausible "
             "friction before, negative friction after, moves_out",
             [](D drop) { return name_of(drop.slip.verdict); })
      .number("pulled_in", kind::length, "length that it draws in over both supports, if it is a slip",
              [](D drop) { return drop.slip.S_after - drop.slip.S_before; })
      .number("pulled_in_error", kind::length, "its standard error", [](D drop) { return drop.slip.advance_error; });
}

Fields<Slip> slip_fields() {
  return Fields<Slip>()
      .row("row_before", "row of the file before the slip", [](const Slip& slip) { return slip.drop.before; })
      .row("row_after", "row of the file after it", [](const Slip& slip) { return slip.drop.after; })
      .number("length_before", kind::length, "drawn in before it, and the span", &Slip::S_before)
      .number("length_after", kind::length, "drawn in after it, and the span", &Slip::S_after)
      .number("mu_before", "friction before it", &Slip::mu_before)
      .number("mu_after", "friction after it", &Slip::mu_after);
}

Fields<TestAnalysis> slips_fields() {
  const auto summary = [](auto part) {
    return [part](const TestAnalysis& analysis) { return analysis.slip_summary.*part; };
  };
  return Fields<TestAnalysis>()
      .count("count", "drops that slips can explain", summary(&SlipSummary::count))
      .number("median_spacing", kind::length, "drawn in from the beginning of a slip to that of the next, median",
              summary(&SlipSummary::median_spacing))
      .number("mean_spacing", kind::length, "likewise, mean", summary(&SlipSummary::mean_spacing))
      .number("median_fall_of_mu", "by which friction falls in a slip, median", summary(&SlipSummary::median_fall))
      .list("slips", "those drops", slip_fields(), [](const TestAnalysis& analysis) {
        std::vector<Slip> possible;
        for (const Slip& slip : analysis.slips)
          if (slip.verdict == SlipVerdict::possible) possible.push_back(slip);
        return possible;
      });
}

Fields<RiseExplanation> rise_fields() {
  return Fields<RiseExplanation>()
      .number("bic", "Bayes' information criterion", &RiseExplanation::bic)
      .number("friction", "mean friction", &RiseExplanation::friction)
      .number("stiffness_left", "bending stiffness after the last drop over that before the first",
              &RiseExplanation::left);
}

Fields<SlipOrCrack> slip_or_crack_fields() {
  const Fields<RiseExplanation> rise = rise_fields();
  return Fields<SlipOrCrack>()
      .words("verdict", "not_by_cracks_alone, cracks or cannot_be_told",
             [](const SlipOrCrack& judged) { return name_of(judged.verdict); })
      .number("margin", "D*: BIC of the best of the cracks less that of the best of the slips", &SlipOrCrack::margin)
      .number("margin_arrested", "D: likewise, without cracks that run on within a rise", &SlipOrCrack::margin_arrested)
      .count("rises", "between the drops that are judged", &SlipOrCrack::rises)
      .count("stiffer_rises", "of these, those that grow stiffer towards their end", &SlipOrCrack::stiffer_rises)
      .group("cracks", "cracks that are arrested, friction free", rise, &SlipOrCrack::cracks)
      .group("cracks_constant", "likewise, friction constant", rise, &SlipOrCrack::cracks_constant)
      .group("cracks_running", "cracks that run on within a rise", rise, &SlipOrCrack::cracks_running)
      .group("slip", "slips alone", rise, &SlipOrCrack::slip)
      .group("slip_and_cracks", "both", rise, &SlipOrCrack::slip_and_cracks);
}

Fields<ImagedPoint> imaged_point_fields() {
  return Fields<ImagedPoint>()
      .row("row", "row of the file", &ImagedPoint::index)
      .number("pulled_in", kind::length, "length drawn in, from the force", &ImagedPoint::inferred)
      .number("imaged", kind::length, "likewise, as imaged", &ImagedPoint::imaged);
}

Fields<ImagedLength> imaged_fields() {
  return Fields<ImagedLength>()
      .number("offset", kind::length, "what the force says less what was imaged, median", &ImagedLength::offset)
      .number("standard_error", kind::length, "of offset, if the points erred independently", &ImagedLength::error)
      .number("scatter", kind::length, "about it, 1.48 times the median absolute deviation", &ImagedLength::scatter)
      .list("points", "that were imaged", imaged_point_fields(), &ImagedLength::points);
}

// Domain: judgement is given.
Fields<FittedTest> judgement_fields() {
  return Fields<FittedTest>()
      .words("standing", "sound, doubtful, suspect or untrusted",
             [](T test) { return name_of(test.judgement->standing); })
      .words("drops", "not_by_cracks_alone, cracks or cannot_be_told, by the rises and by a reload; null without drops",
             [](T test) {
               return test.analysis.drops.drops.empty() ? std::nullopt : std::optional(name_of(test.judgement->drops));
             })
      .words(
          "doubts",
          "what stands against the answer, the weightiest first: wrong_stiffness, no_sliding, softer_reload, cracks, "
          "impossible_drops, implausible_friction, failed_check, falling_friction, changed_reload, coarse_force, "
          "undecided_drops, few_rows, settling_contact, unexpected_stiffness",
          [](T test) {
            std::vector<std::string_view> names;
            for (const Doubt doubt : test.judgement->doubts) names.push_back(name_of(doubt));
            return names;
          })
      .words("next_step", "what would tell most: none, check_case, reload, finer_steps, stiffer_rig or image_length",
             [](T test) { return name_of(test.judgement->next); })
      .number("stiffness_lost", "share lost, that the last comparable reload shows",
              [](T test) { return test.judgement->loss; })
      .number("stiffness_lost_error", "its standard error", [](T test) { return test.judgement->loss_error; })
      .number("stiffness_for_no_snap", kind::stiffness, "of a rig on which the mean of the fit does not snap",
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

Fields<Tooth> tooth_fields() {
  return Fields<Tooth>()
      .row("first_row", "first row of the file of the rise", &Tooth::first)
      .row("last_row", "its last row", [](const Tooth& tooth) { return tooth.last - 1; })
      .number("length_before", kind::length, "drawn in where it begins, and the span", &Tooth::S_begin)
      .number("length_after", kind::length, "drawn in where it ends, and the span", &Tooth::S_end)
      .number("q_before", "mobilised friction where it begins", &Tooth::q_begin)
      .number("q_after", "mobilised friction where it ends", &Tooth::q_end)
      .number("slope", kind::stiffness, "force over stage position, mean of the rise", &Tooth::slope)
      .number("slope_error", kind::stiffness, "its standard error", &Tooth::slope_error)
      .number("stick_slope", kind::stiffness, "likewise, of a specimen that is stuck", &Tooth::stick_slope)
      .number("slide_slope", kind::stiffness, "likewise, of one that slides at constant friction", &Tooth::slide_slope)
      .number("position", "p: 1 where the slope is that of sticking, 0 where it is that of sliding", &Tooth::position)
      .number("position_error", "its standard error, from scatter", &Tooth::position_error)
      .number("position_systematic", "its error from EI, contact and load train, common to all rises",
              &Tooth::position_systematic)
      .number("advance", kind::length, "length drawn in over the rise", &Tooth::advance)
      .number("advance_error", kind::length, "its standard error", &Tooth::advance_error)
      .words("verdict", "sliding, as_if_stuck or undecided", [](const Tooth& tooth) { return name_of(tooth.verdict); })
      .number("compliant_position", "p of a stuck specimen on supports that give way as fitted",
              &Tooth::compliant_position)
      .number("compliant_deviation", "of the position from that, in standard errors", &Tooth::compliant_deviation)
      .yes_no("compliant_rejected", "that is too much: it slides all the same", &Tooth::compliant_rejected);
}

Fields<SupportCompliance> compliance_fields() {
  return Fields<SupportCompliance>()
      .words(
          "status", "ok, too_few_teeth or none_fits",
          [](const SupportCompliance& compliance) {
            return name_in_order<ComplianceStatus::none_fits>(compliance.status, {"ok", "too_few_teeth", "none_fits"});
          })
      .only_where([](const SupportCompliance& compliance) { return compliance.status == ComplianceStatus::ok; })
      .number("value", kind::compliance, "of both supports together, if the specimen were stuck",
              &SupportCompliance::value)
      .number("error", kind::compliance, "its standard error, from scatter", &SupportCompliance::error)
      .number("systematic", kind::compliance, "its error from EI, contact and load train",
              &SupportCompliance::systematic)
      .words("unit", "of these",
             [](const SupportCompliance&, const Frame& frame) { return unit_of(kind::compliance, frame.reduced); })
      .number("chi_squared", "of the slopes about it", &SupportCompliance::chi_squared)
      .count("freedom", "degrees of freedom", &SupportCompliance::freedom)
      .number("p_value", "probability of so large a chi_squared of a specimen that is stuck",
              &SupportCompliance::p_value);
}

// Domain: teeth are given.
Fields<FittedTest> teeth_fields() {
  const auto count = [](ToothVerdict verdict) {
    return [verdict](T test) {
      const auto& teeth = test.analysis.teeth->teeth;
      return std::count_if(teeth.begin(), teeth.end(), [&](const Tooth& tooth) { return tooth.verdict == verdict; });
    };
  };
  return Fields<FittedTest>()
      .number("confidence", "of each verdict, one-sided", [](T) { return tooth_confidence; })
      .number("least_share", "of the stage's motion drawn in, below which a specimen is called stuck",
              [](T test) { return test.provenance.options.teeth.least_share; })
      .group("compliance", "of supports that give way", compliance_fields(),
             [](T test) { return &test.analysis.teeth->compliance; })
      .count("sliding", "rises that reject that the specimen is stuck", count(ToothVerdict::sliding))
      .count("as_if_stuck", "rises as steep as if it were stuck", count(ToothVerdict::as_if_stuck))
      .count("undecided", "rises that tell neither", count(ToothVerdict::undecided))
      .count("too_short", "rises of fewer than four rows", [](T test) { return test.analysis.teeth->too_short; })
      .count("unexplained", "rises whose middle no friction explains",
             [](T test) { return test.analysis.teeth->unexplained; })
      .list("teeth", "the rises between drops", tooth_fields(), [](T test) { return test.analysis.teeth->teeth; });
}

// A point that needs more friction than is plausible.
struct SuspectPoint {
  std::size_t index;
  const ProfilePoint* read;  // null where no friction explains it
};

std::vector<SuspectPoint> suspects_of(T test) {
  std::vector<SuspectPoint> all;
  const auto& points = test.analysis.profile.points;
  for (const auto index : test.analysis.suspects.points) {
    const auto found = std::lower_bound(points.begin(), points.end(), index,
                                        [](const ProfilePoint& point, std::size_t i) { return point.index < i; });
    all.push_back({index, found != points.end() && found->index == index ? &*found : nullptr});
  }
  return all;
}

Fields<SuspectPoint> suspect_fields() {
  const auto read = [](auto value) {
    return [value](const SuspectPoint& point) {
      return point.read ? std::optional<double>(std::invoke(value, *point.read)) : std::nullopt;
    };
  };
  return Fields<SuspectPoint>()
      .row("row", "row of the file", &SuspectPoint::index)
      .number("length", kind::length, "drawn in, and the span", read(&ProfilePoint::S))
      .number("mu", "friction that it needs", read(&ProfilePoint::mu))
      .number("mu_error", "its standard error", read(standard_error));
}

Fields<SuspectReport> suspect_criteria_fields() {
  return Fields<SuspectReport>()
      .number("limit", "friction above it is implausible", &SuspectReport::limit)
      .count("points_judged", "past a deflection of a tenth of the span", &SuspectReport::points_judged)
      .count("points_above_limit", "of these", [](const SuspectReport& report) { return report.points.size(); })
      .count("points_above_limit_beyond_error", "of these by more than 1.96 standard errors",
             &SuspectReport::beyond_error)
      .count("points_above_euler_bernoulli", "points past there with a force above 48 EI w/L³: the paper's criterion",
             &SuspectReport::above_euler_bernoulli);
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
      .own("line_offset", kind::length, "where a line through the first part of the curve meets zero force, from there",
           found(&Contact::offset))
      .own("line_offset_error", kind::length, "its standard error", found(&Contact::offset_error))
      .own("initial_slope", kind::stiffness, "of that line", found(&Contact::slope))
      .own("initial_slope_error", kind::stiffness, "its standard error", found(&Contact::slope_error));
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
  const auto option = [](auto get) { return [get](const Provenance& from) { return get(from.options); }; };
  using O = const AnalysisOptions&;
  return Fields<Provenance>()
      .words("program", "flexslip", [](const Provenance&) { return "flexslip"; })
      .words("version", "its version", &Provenance::version)
      .list("inputs", "files that were read", input_fields(), &Provenance::inputs)
      .group(
          "options", "of the analysis",
          Fields<Provenance>()
              .words("model", "of friction", option([](O o) { return name_of(o.fit.model); }))
              .number("false_alarms", "drops to be expected in a test without slips",
                      option([](O o) { return o.drops.false_alarms_per_test; }))
              .number("suspect_limit", "friction above it is implausible", option([](O o) { return o.suspect_limit; }))
              .yes_no("check_stability", "whether it was asked for", option([](O o) { return o.check_stability; })))
      .words("case", "as TOML, also where it was given by flags", &Provenance::test);
}

Fields<FittedTest> all_fields() {
  const auto analysis = [](auto part) { return [part](T test) { return test.analysis.*part; }; };
  return Fields<FittedTest>()
      .words("status", "ok, or why there is no answer: too_few_points, not_explained, no_initial_slope", status_of)
      .words("name", "of the test", &FittedTest::name)
      .group("units", "of plain numbers", units_of_numbers<FittedTest>())
      .only_where(is_fitted)
      .words("model", "of friction: roughness, constant, drift, sinusoid or sinusoids",
             [](T test) { return name_of(test.analysis.fit.model); })
      .anywhere()
      .words("category", "of the sawtooth: clear, nominal or none",
             [](T test) { return name_of(test.analysis.category); })
      .yes_no("suspect", "its standing is suspect or untrusted",
              [](T test) { return test.judgement && test.judgement->standing >= Standing::suspect; })
      .number("stiffness_over_initial_slope", "bending stiffness used over that of the initial slope",
              analysis(&TestAnalysis::stiffness_over_slope))
      .yes_no("model_implausible", "no sliding with friction gives such a record",
              analysis(&TestAnalysis::model_implausible))
      .yes_no("stiffness_implausible", "the bending stiffness is not that of the initial slope, by more than 40 %",
              analysis(&TestAnalysis::stiffness_implausible))
      .group("parameters", "what was fitted; those of the model that the fit is of", parameter_fields())
      .group("friction_read", "friction read off the curve point by point, before any model of it",
             Fields<FrictionRead>()
                 .number("median", "half of the points lie below it", &FrictionRead::median)
                 .number("low80", "a tenth of the points lie below it", &FrictionRead::low80)
                 .number("high80", "a tenth of the points lie above it", &FrictionRead::high80),
             analysis(&TestAnalysis::friction_read))
      .only_where(is_fitted)
      .number("residual_rms", kind::force, "by which the mean of the fit, run forward, misses the force",
              of_fit(&FrictionFit::residual_rms))
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
      .group("slips", "the drops that can be slips", slips_fields(), [](T test) { return &test.analysis; })
      .group("teeth", "whether the specimen sticks or slides between the drops; null where that is not asked",
             teeth_fields(), [](T test) { return is_fitted(test) && test.analysis.teeth ? &test : nullptr; })
      .list("suspects", "points that need more friction than is plausible", suspect_fields(), suspects_of)
      .group("suspect_criteria", "how these were found", suspect_criteria_fields(), analysis(&TestAnalysis::suspects))
      .only_where(is_fitted)
      .group("energy", "where the work went, from contact to failure, by the measured points", measured_energy_fields(),
             analysis(&TestAnalysis::energy))
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
                 .all_of(standard_fields(), standard_test)
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
      .group(
          "noise", "of the force",
          Fields<FittedTest>()
              .number("force", kind::force, "standard deviation of one reading", analysis(&TestAnalysis::force_noise))
              .own("force_step", kind::force, "standard deviation of a step from row to row",
                   [](T test) { return test.analysis.drops.step_noise; })
              .own("smallest_drop", kind::force, "a fall in one step smaller than this counts as noise",
                   [](T test) { return test.analysis.drops.smallest_fall; }))
      .list("profile", "friction along the specimen, read off the curve point by point", profile_fields(),
            [](T test) { return points_of(test.analysis.record, test.analysis.profile); })
      .group("provenance", "what to give to the same version for the same answer", provenance_fields(),
             &FittedTest::provenance);
}

}  // namespace

Frame frame_of(const FittedTest& test) {
  return {.scales = test.analysis.scales, .reduced = test.reduced, .row = [&test](std::size_t point) {
            return file_row(test, point);
          }};
}

const Fields<FittedTest>& fit_fields() {
  static const Fields<FittedTest> fields = all_fields();
  return fields;
}

Json fit_json(const FittedTest& test) { return fit_fields()(test, frame_of(test)); }

}  // namespace flexslip
