#include "report/fit_document.h"

#include <utility>

#include <fmt/format.h>

#include "finding/answer.h"
#include "report/cycles_words.h"
#include "report/figures.h"
#include "report/fit_screen.h"
#include "report/fit_words.h"
#include "report/implied_words.h"
#include "report/plain_text.h"
#include "report/small_deflection_words.h"
#include "report/teeth_words.h"

namespace flexslip {
namespace {

// Two texts, of which either may be empty.
std::string joined(const std::string& first, const std::string& second) {
  return first + (first.empty() || second.empty() ? "" : " ") + second;
}

Picture picture(Plot (*drawn)(const FittedTest&), const FittedTest& test) {
  return {[drawn, &test] { return drawn(test); }};
}

// What a reader of numbers should know that are given all the same; empty where there is nothing.
std::string caution_of(const FittedTest& test, const Answer& answer) {
  if (lost_stiffness(test.judgement.value()))
    return "The numbers below assume that the specimen kept its stiffness; the record speaks against that.";
  return is_trusted(answer.standing)
             ? ""
             : "The fit is not to be used: it tells no friction. What is drawn of it shows where it fails.";
}

Chapter friction_chapter(const FittedTest& test, const Answer& answer) {
  Chapter chapter{"Friction"};
  if (!is_trusted(answer.standing)) return chapter.say(caution_of(test, answer));
  chapter.say(joined(caution_of(test, answer), friction_in_words(test)))
      .say(fmt::format("The parameters of the model, {}:", model_in_words(test.analysis.fit.model)))
      .show(parameter_rows(test))
      .say(joined(strain_in_words(test), friction_in_literature(test)));
  return chapter;
}

Chapter wave_chapter(const FittedTest& test) {
  Chapter chapter{"Does it repeat along the specimen?"};
  chapter.say(joined(joined(wave_in_words(test), sides_in_words(test)), smoothing_in_words(test)))
      .say(implied_in_words(test));
  if (has_waves(test)) chapter.show(picture(wavelength_figure, test));
  if (test.analysis.fit.explanations.size() > 1)
    chapter.say("The answer is an average over these explanations, weighted as listed:").show(explanation_table(test));
  return chapter;
}

Chapter findings_chapter(const Answer& answer) {
  Bullets bullets;
  for (const Finding& finding : answer.findings)
    bullets.items.push_back(joined(fmt::format("{}: {}", name_of(finding.severity), finding.sentence), finding.remedy));
  return Chapter{"What was checked"}.show(std::move(bullets));
}

std::vector<Chapter> slip_chapters(const FittedTest& test, const Answer& answer) {
  const auto& analysis = test.analysis;
  if (!is_trusted(answer.standing)) return {Chapter{"Drops"}.show(drop_table(test))};
  std::vector<Chapter> chapters{Chapter{"Drops and slips"}.say(slips_in_words(test)).show(drop_table(test))};
  if (!analysis.drops.drops.empty() || !analysis.model.snaps.empty())
    chapters.push_back(Chapter{"Snaps of the fit's mean"}.say(snaps_in_words(test)).show(snap_table(test)));
  Chapter teeth{"Stick or slide"};
  teeth.say(teeth_in_words(test));
  if (has_judged_teeth(test)) teeth.show(picture(teeth_figure, test));
  if (analysis.teeth && !analysis.teeth->teeth.empty()) teeth.show(tooth_table(test));
  chapters.push_back(std::move(teeth));
  return chapters;
}

Chapter cycles_chapter(const FittedTest& test) {
  Chapter chapter{"Load and unload"};
  if (has_loops(test)) chapter.show(picture(loops_figure, test)).show(picture(boxes_figure, test));
  chapter.say(cycles_in_words(test));
  chapter.show(loop_table(test)).show(loop_energy_table(test));
  return chapter.say(reloading_in_words(test)).show(loading_table(test));
}

Chapter energy_chapter(const FittedTest& test, const Answer& answer) {
  Chapter chapter{test.cycles ? "Where the work of the first loading went" : "Where the work went"};
  return chapter.say(caution_of(test, answer)).show(energy_table(test));
}

Chapter provenance_chapter(const FittedTest& test) {
  const auto& provenance = test.provenance;
  Chapter chapter{"Provenance"};
  return chapter
      .say(fmt::format("FlexSlip {}. Options: model {}; {:g} false alarms a test; friction suspect above {:g}.",
                       provenance.version, name_of(provenance.options.fit.model),
                       provenance.options.drops.false_alarms_per_test, provenance.options.suspect_limit))
      .show(Files{provenance.inputs})
      .show(Verbatim{provenance.test});
}

Chapter preparation_chapter(const FittedTest& test) {
  Chapter chapter{"From the file to the record"};
  return chapter.show(preparation_rows(test.measurement.preparation));
}

}  // namespace

std::vector<Chapter> document_of(const FittedTest& test) {
  const AnalysisStatus status = test.analysis.status;
  if (status != AnalysisStatus::ok) {
    std::vector<Chapter> chapters;
    if (status == AnalysisStatus::not_explained) chapters.push_back(Chapter{""}.show(picture(record_figure, test)));
    chapters.push_back(preparation_chapter(test));
    chapters.push_back(provenance_chapter(test));
    return chapters;
  }
  const Answer answer = answer_of(test);
  const bool trusted = is_trusted(answer.standing);
  std::vector<Chapter> chapters{Chapter{""}.show(picture(force_figure, test)).show(picture(profile_figure, test)),
                                friction_chapter(test, answer)};
  if (trusted) chapters.push_back(wave_chapter(test));
  chapters.push_back(findings_chapter(answer));
  for (Chapter& chapter : slip_chapters(test, answer)) chapters.push_back(std::move(chapter));
  if (test.cycles) chapters.push_back(cycles_chapter(test));
  if (trusted) chapters.push_back(energy_chapter(test, answer));
  chapters.push_back(
      Chapter{"Can it be trusted?"}.say(suspicion_in_words(test)).say(trusted ? replay_in_words(test) : ""));
  const StandardTest standard = standard_test(test);
  chapters.push_back(Chapter{"Small deflection, as the standards have it"}
                         .show(small_deflection_table(standard))
                         .say(small_deflection_in_words(standard))
                         .say(trusted ? small_deflection_and_fit(test) : ""));
  chapters.push_back(preparation_chapter(test));
  chapters.push_back(Chapter{"What was assumed"}.show(Bullets{assumptions_of(test)}));
  chapters.push_back(provenance_chapter(test));
  return chapters;
}

std::string fit_text(const FittedTest& test) {
  return fit_screen(test.name, answer_of(test)) + in_text(document_of(test));
}

}  // namespace flexslip
