#include "answers/campaign_fields.h"

#include <optional>
#include <utility>

#include "answers/fit_fields.h"
#include "answers/mechanics_fields.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

Fields<TestSummary> summary_parameter_fields() {
  const auto of_roughness = [](Estimate TestSummary::*estimate) {
    return [estimate](const TestSummary& test) {
      return test.model == ProfileModel::roughness ? std::optional(test.*estimate) : std::nullopt;
    };
  };
  return Fields<TestSummary>()
      .own_estimate(parameter::mu0, &TestSummary::mu0,
                    Fields<TestSummary>().yes_no("bound", parameter::bound, &TestSummary::mu0_is_bound))
      .own_estimate(parameter::roughness, of_roughness(&TestSummary::roughness))
      .own_estimate(parameter::correlation_length, of_roughness(&TestSummary::correlation_length))
      .own_estimate(parameter::amplitude, &TestSummary::amplitude)
      .own_estimate(parameter::wavelength, &TestSummary::wavelength)
      .own_estimate(parameter::phase, &TestSummary::phase)
      .own_estimate(parameter::bending_stiffness, &TestSummary::bending_stiffness);
}

// The name of a test and its verdict.
Fields<CampaignTest> name_fields() {
  return Fields<CampaignTest>()
      .words("name", "name of the test", &CampaignTest::name)
      .titled("test")
      .words("status", "a status of fit, or failed", &CampaignTest::status)
      .words("verdict", "SLIP, SLIP AND DAMAGE, UNDECIDED, CRACK, SETTLED, NO DROPS, CHECK INPUT or NO ANSWER",
             &CampaignTest::verdict);
}

Fields<TestSummary> verdict_fields() {
  return Fields<TestSummary>()
      .words("category", "how clear the sawtooth is: clear, nominal or none",
             [](const TestSummary& test) { return name_of(test.category); })
      .yes_no("suspect", "the answer has a finding of severity refusal or suspicion; means exclude the test",
              &TestSummary::suspect)
      .words("model", "fitted friction model", [](const TestSummary& test) { return name_of(test.model); });
}

Fields<TestSummary> number_fields() {
  const auto of_loss = [](double LostStiffness::*part) {
    return [part](const TestSummary& test) { return test.loss ? std::optional((*test.loss).*part) : std::nullopt; };
  };
  const auto lost = of_loss(&LostStiffness::lost), lost_error = of_loss(&LostStiffness::error),
             needed = of_loss(&LostStiffness::needed);
  return Fields<TestSummary>()
      .own("residual_rms", kind::force,
           "root mean square difference between the measured force and the simulated best-fit profile",
           &TestSummary::residual_rms)
      .count("drops", "number of force drops beyond the noise", &TestSummary::drops)
      .own("spacing", kind::length, "median distance along the specimen between the starts of successive slips",
           &TestSummary::spacing)
      .own("work_of_fracture", kind::energy, "work on the specimen", &TestSummary::work_of_fracture)
      .number("friction_share",
              "share of the work that went into friction and snaps; null if the test is unusable or gives only a limit",
              &TestSummary::friction_share)
      .number("friction_share_error", "standard error of friction_share, with no stiffness lost",
              &TestSummary::friction_share_error)
      .number("stiffness_lost", "share of the stiffness lost before the next loading; null without one", lost)
      .number("stiffness_lost_error", "standard error of stiffness_lost", lost_error)
      .number("loss_needed",
              "stiffness loss, as a share, that the drops require if they are cracks only; null without a reload",
              needed);
}

// The numbers of the bending standards, and the effect of friction at the supports.
Fields<StandardSummary> standard_columns() {
  const auto of = [](ShareRange FrictionGain::*range, double ShareRange::*end) {
    return [range, end](const StandardSummary& standard) {
      return standard.friction ? std::optional((*standard.friction).*range.*end) : std::nullopt;
    };
  };
  constexpr auto least = &ShareRange::least, most = &ShareRange::most;
  return Fields<StandardSummary>()
      .own_estimate("modulus", kind::pressure,
                    "flexural modulus of the bending standards, from the chord or else from the linear region",
                    &StandardSummary::modulus)
      .own("strength", kind::pressure, "flexural stress at the maximum force; nan if the specimen did not break",
           &StandardSummary::strength)
      .number("friction_least",
              "minimum of the friction range at the supports whose effect on modulus and strength is reported",
              of(&FrictionGain::friction, least))
      .number("friction_most", "maximum of this friction range", of(&FrictionGain::friction, most))
      .number("modulus_gain_least", "smallest share that friction in this range adds to the modulus",
              of(&FrictionGain::modulus, least))
      .number("modulus_gain_most", "largest share that friction in this range adds to the modulus",
              of(&FrictionGain::modulus, most))
      .number("strength_gain_least", "smallest share that friction in this range adds to the strength",
              of(&FrictionGain::strength, least))
      .number("strength_gain_most", "largest share that friction in this range adds to the strength",
              of(&FrictionGain::strength, most));
}

Fields<CampaignTest> remark_fields() {
  return Fields<CampaignTest>()
      .words("reason", "reason why the status is not ok",
             [](const CampaignTest& test) { return test.reason.empty() ? std::nullopt : std::optional(test.reason); })
      .words("remarks", "remarks", &CampaignTest::remarks)
      .words("file", "case file or export of the test", &CampaignTest::file);
}

Fields<CampaignTest> cause_fields() {
  using C = const CampaignTest&;
  return Fields<CampaignTest>()
      .number("cracks_alone", "probability that the drops are cracks only; null without drops that are judged",
              [](C test) { return test.causes.cracks; })
      .number("slips_alone", "probability that the drops are slips only; without a reload it is reliable below 0.5",
              [](C test) { return test.causes.slips; });
}

Fields<CampaignTest> test_fields() {
  return name_fields()
      .all_of(cause_fields())
      .all_of(verdict_fields(), &CampaignTest::summary)
      .group("parameters", "fitted parameters; null where the fit has none", summary_parameter_fields(),
             &CampaignTest::summary)
      .group("wave", "most probable wave of friction, and whether it is detected",
             Fields<TestSummary>().yes_no("claimed", "the wave is detected; otherwise it is only indicative",
                                          &TestSummary::wave_claimed),
             &CampaignTest::summary)
      .all_of(number_fields(), &CampaignTest::summary)
      .group("standard", "numbers of the bending standards; null without a section", standard_columns(),
             &CampaignTest::standard)
      .all_of(remark_fields());
}

// The mean, minimum and maximum of a parameter.
Fields<Spread> spread_fields(const Kind& kind) {
  return Fields<Spread>()
      .only_where([](const Spread& spread) { return spread.count > 0; })
      .own("mean", kind, "mean over the tests", &Spread::mean)
      .own("min", kind, "smallest value", &Spread::min)
      .own("max", kind, "largest value", &Spread::max)
      .anywhere()
      .count("n", "number of tests", &Spread::count);
}

Fields<CategorySpread> category_fields() {
  return Fields<CategorySpread>()
      .count("tests", "number of tests in the category", &CategorySpread::tests)
      .group("mu0", "mean friction, excluding tests that give only a limit", spread_fields(kind::number),
             &CategorySpread::mu0)
      .group("mu0_limit", "upper limits of the mean friction from tests that give only a limit",
             spread_fields(kind::number), &CategorySpread::mu0_limit)
      .group("amplitude", "amplitude of the wave of friction, relative to mu0", spread_fields(kind::number),
             &CategorySpread::amplitude)
      .group("wavelength", "wavelength of the wave of friction, along the specimen", spread_fields(kind::length),
             &CategorySpread::wavelength)
      .count("waves_claimed", "number of tests with a detected wave of friction", &CategorySpread::waves_claimed);
}

std::string_view differ_by(const SpecimenLine& line) { return line.by_factors ? "factor" : "standard deviation"; }

Fields<SpecimenLine> between_fields() {
  using L = const SpecimenLine&;
  return Fields<SpecimenLine>()
      .count("tests", "number of tests whose records determine the parameter",
             [](L line) { return line.population.tests; })
      .estimate_in(
          "typical", "value of the typical specimen: the mean for mu0, the median for other parameters",
          [](L line) { return line.population.typical; }, &SpecimenLine::unit)
      .words("differ_by", "meaning of spread: a standard deviation, or a factor in either direction", differ_by)
      .number("spread", "spread between specimens, excluding measurement errors",
              [](L line) { return line.population.spread; })
      .number("spread_low",
              "lower end of its 95 % interval; 0, or a factor of 1, where the records do not distinguish the specimens",
              [](L line) { return line.population.min_spread; })
      .number("spread_high", "upper end of its 95 % interval", [](L line) { return line.population.max_spread; });
}

struct CategoryOf {
  const Campaign& campaign;
  const CategorySummary& category;
};

Fields<CategoryOf> category_answer_fields() {
  using C = const CategoryOf&;
  return Fields<CategoryOf>()
      .all_of(
          category_fields(), [](C of) -> const auto& { return of.category.without_suspects; })
      .group(
          "with_suspects", "the same with suspect tests", category_fields(),
          [](C of) -> const auto& { return of.category.with_suspects; })
      .by_name("between_specimens", "typical value and spread between specimens, by parameter", between_fields(),
               [](C of) {
                 std::vector<std::pair<std::string, SpecimenLine>> lines;
                 for (SpecimenLine& line : specimen_lines(of.campaign))
                   if (line.category == key_of(of.category)) lines.emplace_back(line.parameter, std::move(line));
                 return lines;
               });
}

Fields<CampaignTest> failure_fields() {
  return name_fields()
      .words("reason", "reason why there is no answer, or the answer", &CampaignTest::reason)
      .words("file", "case file or export of the test", &CampaignTest::file);
}

using SomeTests = std::vector<std::reference_wrapper<const CampaignTest>>;

// The tests with a fit, or the tests without one.
SomeTests tests_of(const Campaign& campaign, bool answered) {
  SomeTests some;
  for (const CampaignTest& test : campaign.tests)
    if (test.summary.has_value() == answered) some.emplace_back(test);
  return some;
}
SomeTests answered_of(const Campaign& campaign) { return tests_of(campaign, true); }
SomeTests failures_of(const Campaign& campaign) { return tests_of(campaign, false); }

Fields<CauseShares::Share> share_fields() {
  return Fields<CauseShares::Share>()
      .number("median", "median of the posterior", &CauseShares::Share::median)
      .number("low", "lower end of its 95 % interval", &CauseShares::Share::low)
      .number("high", "upper end of its 95 % interval", &CauseShares::Share::high);
}

Fields<Campaign> all_fields() {
  return Fields<Campaign>()
      .list("tests", "tests with an answer, in the order of the plan", test_fields(), answered_of)
      .by_name("categories", "categories clear, nominal, none and all, excluding suspect tests",
               category_answer_fields(),
               [](const Campaign& campaign) {
                 std::vector<std::pair<std::string, CategoryOf>> categories;
                 for (const CategorySummary& category : campaign.categories)
                   categories.emplace_back(key_of(category), CategoryOf{campaign, category});
                 return categories;
               })
      .group("causes",
             "shares of the specimens whose drops are slips only, cracks only or both; null without any probability",
             Fields<CauseShares>()
                 .count("tests", "number of tests with a probability", &CauseShares::tests)
                 .group("slips", "slips only", share_fields(), &CauseShares::slips)
                 .group("cracks", "cracks only", share_fields(), &CauseShares::cracks)
                 .group("both", "slips and cracks", share_fields(), &CauseShares::both),
             [](const Campaign& campaign) { return campaign.causes.tests > 0 ? &campaign.causes : nullptr; })
      .number("shared_error",
              "standard deviation of the mean friction due to errors of load train, span and force calibration, which "
              "tests on one rig share",
              &Campaign::shared_error)
      .estimate("friction_share", kind::number,
                "mean friction share of the work with no stiffness lost, over the tests that are not suspect; null "
                "without any",
                [](const Campaign& campaign) {
                  return std::isfinite(campaign.friction_share.value) ? std::optional(campaign.friction_share)
                                                                      : std::nullopt;
                })
      .list("failures", "tests without a fit: failed, or with a deflection too small to determine friction",
            failure_fields(), failures_of)
      .words("notes", "omitted files, duplicate records, missing sections", &Campaign::notes)
      .group("units", "units of plain numbers", units_of_numbers<Campaign>());
}

}  // namespace

std::string_view key_of(const CategorySummary& category) {
  return category.category ? name_of(*category.category) : "all";
}

namespace {

Population exponential(Population logarithm) {
  logarithm.typical = exponential(logarithm.typical);
  for (double* spread : {&logarithm.spread, &logarithm.min_spread, &logarithm.max_spread})
    *spread = elementary::exp(*spread);
  return logarithm;
}

}  // namespace

std::vector<SpecimenLine> specimen_lines(const Campaign& campaign) {
  std::vector<SpecimenLine> lines;
  for (const auto& category : campaign.categories) {
    const std::string key(key_of(category));
    if (category.mu0) lines.push_back({key, "mu0", "1", false, *category.mu0});
    if (category.log_roughness) lines.push_back({key, "roughness", "1", true, exponential(*category.log_roughness)});
    if (category.log_length) lines.push_back({key, "correlation_length", "m", true, exponential(*category.log_length)});
  }
  return lines;
}

const Fields<Campaign>& campaign_fields() {
  static const Fields<Campaign> fields = all_fields();
  return fields;
}

Json campaign_json(const Campaign& campaign) { return campaign_fields()(campaign, {}); }

Fields<CampaignTest> test_columns() {
  return name_fields()
      .all_of(cause_fields())
      .all_of(verdict_fields(), &CampaignTest::summary)
      .all_of(summary_parameter_fields(), &CampaignTest::summary)
      .all_of(Fields<TestSummary>()
                  .yes_no("mu0_is_bound", "mu0 cannot be distinguished from 0; mu0_high is its upper limit",
                          &TestSummary::mu0_is_bound)
                  .yes_no("wave_claimed", "the wave is detected; otherwise it is only indicative",
                          [](const TestSummary& test) {
                            return test.wavelength ? std::optional(test.wave_claimed) : std::nullopt;
                          }),
              &CampaignTest::summary)
      .all_of(number_fields(), &CampaignTest::summary)
      .all_of(standard_columns(), &CampaignTest::standard)
      .all_of(remark_fields());
}

Fields<CategoryLine> category_columns() {
  return Fields<CategoryLine>()
      .words("category", "category of the sawtooth", &CategoryLine::key)
      .words("suspects", "suspect tests: without or with", &CategoryLine::suspects)
      .all_of(category_fields(), &CategoryLine::spread);
}

Fields<SpecimenLine> specimen_columns() {
  return Fields<SpecimenLine>()
      .words("category", "category of the sawtooth, excluding suspect tests", &SpecimenLine::category)
      .words("parameter", "parameter of friction", &SpecimenLine::parameter)
      .words("unit", "unit of typical and its interval", &SpecimenLine::unit)
      .all_of(between_fields());
}

ResultTable test_table(const Campaign& campaign) { return tabulated("tests", test_columns(), campaign.tests); }

ResultTable category_table(const Campaign& campaign) {
  std::vector<CategoryLine> lines;
  for (const auto& category : campaign.categories) {
    lines.push_back({key_of(category), "without", &category.without_suspects});
    lines.push_back({key_of(category), "with", &category.with_suspects});
  }
  return tabulated("categories", category_columns(), lines);
}

ResultTable specimen_table(const Campaign& campaign) {
  return tabulated("specimens", specimen_columns(), specimen_lines(campaign));
}

ResultTable failure_table(const Campaign& campaign) {
  return tabulated("failures", failure_fields(), failures_of(campaign));
}

std::vector<std::pair<std::string, ResultTable>> sheets_of(const Campaign& campaign) {
  std::vector<std::pair<std::string, ResultTable>> sheets{{"Tests", in_best_units(test_table(campaign))},
                                                          {"Categories", in_best_units(category_table(campaign))}};
  if (ResultTable specimens = specimen_table(campaign); !specimens.rows.empty())
    sheets.emplace_back("Specimens", in_best_units(std::move(specimens)));
  sheets.emplace_back("Failures", failure_table(campaign));
  return sheets;
}

}  // namespace flexslip
