#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answers/fit_fields.h"
#include "answers/profile_fields.h"
#include "data/names.h"
#include "finding/answer.h"
#include "finding/printed.h"
#include "finding/sensitivities.h"
#include "inference/fit.h"
#include "io/text.h"
#include "numerics/elementary.h"
#include "report/answer_documents.h"
#include "report/figures.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

Pictures picture(Plot (*drawn)(T), T test) {
  return {[drawn, &test](double) { return std::vector{drawn(test)}; }};
}

// ---- The screen

std::string with_remedy(const Finding& finding) {
  return finding.sentence + (finding.remedy.empty() ? "" : " " + finding.remedy);
}

constexpr std::size_t max_doubts = 2;
// Each doubt with as many of its words as fit on one line.
Rows doubt_rows(const std::vector<Finding>& doubts, std::size_t count, std::size_t width) {
  Rows rows;
  for (std::size_t i = 0; i < count; ++i) {
    std::string words = with_remedy(doubts[i]);
    if (!fits_row(words, width)) words = doubts[i].sentence;
    if (!fits_row(words, width) && !doubts[i].short_form.empty()) words = capitalised(doubts[i].short_form) + ".";
    rows.push_back({std::string(name_of(doubts[i].severity)), words});
  }
  return rows;
}

std::string footer_of(const Answer& answer, std::size_t more_doubts, bool is_full) {
  std::vector<std::string> sentences;
  if (more_doubts > 0) sentences.push_back(format_count(more_doubts, "more doubt.", "more doubts."));
  if (std::string checks = checks_in_words(answer); !checks.empty()) sentences.push_back(std::move(checks));
  sentences.emplace_back("± is one standard error.");
  if (!is_full) sentences.emplace_back("More: --full");
  return fmt::format("{}", fmt::join(sentences, " "));
}

// ---- The workbook

TableColumn column_of_words(const char* name) { return {name, false, kind::number, "", "", ""}; }
TableColumn column_of_numbers(const char* name) { return {name, true, kind::number, "", "", ""}; }

// Verdict, rows, doubts, checks and next step, as --full prints them.
ResultTable line_table(const Answer& answer) {
  ResultTable table{"answer", {column_of_words("line"), column_of_words("words")}, {}};
  const auto add = [&](const Rows& rows) {
    for (const AnswerRow& row : rows)
      if (!row.words.empty()) table.rows.push_back({row.label, row.words});
  };
  add({{"verdict", sentence_of(answer.verdict)}});
  add(all_rows(answer));
  add(full_doubts(answer));
  add({{"checks", checks_in_words(answer)}, {"next", answer.next}});
  return table;
}

// A row for each parameter of the fit, in SI.
ResultTable parameter_table(T test) {
  ResultTable table{"parameters",
                    {column_of_words("parameter"), column_of_numbers("value"), column_of_numbers("standard_error"),
                     column_of_numbers("low"), column_of_numbers("high"), column_of_words("unit")},
                    {}};
  const auto cell = [](const Json& value) { return Cell(value.is_number() ? value.get<double>() : not_a_number); };
  const Json all = fit_json(test);
  for (const auto& [name, parameter] : all.at("parameters").items())
    table.rows.push_back({name, cell(parameter.at("value")), cell(parameter.at("standard_error")),
                          cell(parameter.at("interval95").at(0)), cell(parameter.at("interval95").at(1)),
                          parameter.at("unit").get<std::string>()});
  return table;
}

// ---- The chapters: the numbers of a group of the answer, and lists of it as tables

PrintedTable numbers(T test, std::string_view group) { return group_table(fit_fields(), test, frame_of(test), group); }

// Not folded on a page.
PrintedTable open_numbers(T test, std::string_view group) {
  PrintedTable table = numbers(test, group);
  table.folding = Folding::never;
  return table;
}

PrintedTable listed(T test, std::string_view list, const std::vector<Shown>& columns) {
  return shown(fit_fields(), test, frame_of(test), list, columns);
}

// True if the record determines friction, so that it is drawn and its sensitivity is listed.
bool has_friction(T test, const Answer& answer) {
  return is_fitted(test) && !is_refused(answer.findings) && test.judgement.determines_friction;
}

// A warning about the numbers below; empty if not needed.
std::string caution_of(T test, const Answer& answer) {
  if (is_refused(answer.findings)) return "The fit cannot be used: it determines no friction.";
  return !test.judgement.determines_friction
             ? "The numbers below assume that the specimen kept its stiffness; the record speaks against that."
             : "";
}

// The reason why the heat of friction is omitted; empty if it is reported.
std::string heat_in_words(T test) {
  return std::isfinite(test.analysis.energy.friction_share)
             ? ""
             : "The record does not show how much of the work went into friction, so the share is omitted.";
}

// How μ₀ compares with the literature.
std::string in_literature(T test) {
  const auto& [value, error, low, high] = test.analysis.fit.mu0;
  if (!test.materials) return "state [specimen] material and [rig] support_material to compare friction with it";
  const auto known = literature_of(test);
  if (!known) return fmt::format("nothing about {} on {}", test.materials->specimen, test.materials->support);
  const std::string range =
      known->low < known->high ? fmt::format("{:g} to {:g}", known->low, known->high) : fmt::format("{:g}", known->low);
  const std::string source = fmt::format("{} for {} on {} ({})", range, known->specimen, known->support, known->source);
  if (test.analysis.fit.mu0_is_bound) return source + (high < known->low ? "; friction is below it" : "");
  if (value >= known->low && value <= known->high) return source + "; friction is within it";
  const double away = value < known->low ? known->low - value : value - known->high;
  return fmt::format("{}; friction {} it{}", source,
                     low <= known->high && high >= known->low ? "agrees with"
                     : value < known->low                     ? "is below"
                                                              : "is above",
                     error > 0 ? fmt::format(", {:.1f} standard errors away", away / error) : "");
}

Chapter friction_chapter(T test, const Answer& answer) {
  const std::string caution = caution_of(test, answer);
  if (is_refused(answer.findings)) return {"Parameters of the friction", {caution}};
  const TestAnalysis& analysis = test.analysis;
  const Supports& supports = analysis.rig.fibre.supports();
  const Print print(test);
  const double modulus =
      test.section_moment ? analysis.scales.bending_stiffness() / *test.section_moment : not_a_number;
  const Estimate& EI = analysis.fit.bending_stiffness;
  return {
      "Parameters of the friction",
      {caution, open_numbers(test, "parameters"),
       Rows{{"model", std::string(name_of(analysis.fit.model))},
            {"literature", in_literature(test)},
            {"modulus", !test.section_moment
                            ? ""
                            : fmt::format("E {} to {} (95 %)", print.own(modulus * EI.low, kind::pressure),
                                          print.own(modulus * EI.high, kind::pressure))},
            {"readings",
             analysis.fit.model == ProfileModel::constant
                 ? ""
                 : fmt::format("{} are informative about friction; errors one row apart have a correlation of {:.2f}",
                               analysis.fit.readings, analysis.fit.noise_correlation)},
            {"supports", fmt::format("friction acts {}", supports.half_depth > 0
                                                             ? "at the surface of the specimen, " +
                                                                   print.length(supports.half_depth) + " from its axis"
                                                             : "at the axis of the specimen")}}}};
}

// ---- Sensitivity

Chapter sensitivity_chapter(T test) {
  if (sensitivities_of(test).empty()) return {};
  std::vector<Shown> columns{{.heading = "Quantity", .field = "title"},
                             {.heading = "Stated", .field = "stated"},
                             {.heading = "Uncertainty", .field = "may_be_off"},
                             {.heading = "Friction increases by", .field = "friction_moves", .digits = 2}};
  if (!test.analysis.fit.mu0_is_bound)
    columns.push_back(
        {.heading = "and its share of the work (points)", .field = "work_moves", .digits = 2, .factor = 100});
  PrintedTable table = listed(test, "sensitivities", columns);
  table.folding = Folding::never;
  return {
      "What it depends on",
      {std::string(
           "How much the estimated friction would increase, to first order, if a quantity were stated larger by its "
           "uncertainty. The error of friction includes all of them, except supports and a thickness that "
           "are not stated."),
       table}};
}

// ---- Whether friction repeats

std::string_view in_words(Kernel kernel) {
  return name_in_order<Kernel::matern_9_2>(kernel, {"none", "exponential", "Matérn 3/2", "Matérn 9/2"});
}

// The explanations over which the answer averages, most probable first.
PrintedTable explanation_table(T test) {
  PrintedTable table{{"Roughness", "Wave", "Weight", "ln evidence minus the best"}, {}};
  const auto& explanations = test.analysis.fit.explanations;
  if (explanations.size() < 2) return table;
  for (std::size_t i = 0; i < std::min(listed_explanations, explanations.size()); ++i) {
    const auto& each = explanations[i];
    std::string waves;
    for (const double wavelength : each.wavelengths)
      waves += (waves.empty() ? "" : ", ") + Print(test).length(wavelength);
    table.rows.push_back({std::string(in_words(each.kernel)), waves.empty() ? "none" : waves,
                          each.weight < 0.0005 ? "< 0.1 %" : format_share(each.weight, 1),
                          fmt::format("{:.1f}", each.log_evidence - explanations.front().log_evidence)});
  }
  return table;
}

Chapter wave_chapter(T test) {
  Chapter chapter{
      "Does it repeat along the specimen?",
      {!determines_variation(test.analysis.fit)
           ? std::string("Friction cannot be distinguished from zero, so the record does not show how it "
                         "varies along the specimen: roughness and waves are omitted.")
       : test.analysis.fit.waves.empty()
           ? std::string("No wave of friction explains the record better than none, or the model has none.")
           : fmt::format("A wave counts as detected if it adds more than {} to the logarithm of the evidence.",
                         claiming_gain),
       numbers(test, "wave")}};
  if (has_waves(test)) chapter.blocks.emplace_back(picture(wavelength_figure, test));
  chapter.blocks.insert(
      chapter.blocks.end(),
      {
          explanation_table(test),
          !determines_lengths(test.analysis.fit)
              ? std::string()
              : std::string(test.measurement.test.rig->nose == Nose::holds
                                ? "The lengths hold for a nose that holds the middle of the specimen. Under "
                                  "one without friction, or one that turns, they are twice as long: state "
                                  "[rig] nose = \"free\"."
                                : "The nose is stated to be free: the specimen slides over one support at a "
                                  "time, and the weaker side determines the friction."),
      });
  return chapter;
}

// ---- Checks

Chapter checks_chapter(T test, const Answer& answer) {
  std::vector<Finding> findings = answer.findings;  // most serious first, unjudged checks last
  std::stable_partition(findings.begin(), findings.end(),
                        [](const Finding& finding) { return finding.severity != Severity::unjudged; });
  Rows rows;
  for (const Finding& finding : findings)
    rows.push_back({std::string(name_of(finding.severity)), with_remedy(finding)});
  Chapter chapter{"What was checked", {rows}};
  if (!is_fitted(test)) return chapter;
  chapter.blocks.emplace_back(
      std::string("A test is suspect if more than 5 % of the judged points are above the limit. Friction alone "
                  "lifts a sound curve above the Euler–Bernoulli line, by 5 % at μ = 0.6."));
  return chapter;
}

// ---- Drops

Chapter drops_chapter(T test, const Answer& answer) {
  const bool trusted = !is_refused(answer.findings) && test.analysis.slip_summary.count > 0;
  return {"Drops",
          {trusted ? numbers(test, "slips") : PrintedTable{}, numbers(test, "judgement"),
           listed(test, "drops",
                  {{.heading = "Rows", .field = "row_before", .last = "row_after"},
                   {"Stage", "stage"},
                   {"Force before", "force_before"},
                   {"Fall", "force_fall", 3},
                   {"Pulled in (both supports)", "pulled_in", 3},
                   {"μ before", "mu_before", 3},
                   {"μ after", "mu_after", 3},
                   {"Reading", "reading"}})}};
}

// ---- Loading and unloading

Chapter passes_chapter(T test) {
  Chapter chapter{"Loading, unloading and loading again", {}};
  if (has_passes(test))
    chapter.blocks.emplace_back(Pictures{[&test](double) {
      return std::vector{passes_figure(test), boxes_figure(test)};
    }});
  chapter.blocks.insert(
      chapter.blocks.end(),
      {numbers(test, "passes"),
       "All passes are fitted together: one bending stiffness, one rig, and one friction along the specimen that may "
       "wear from pass to pass. Lost stiffness lowers the force of both directions alike; friction moves them apart.",
       listed(test, "passes.passes",
              {{"Pass", ""},
               {.heading = "Direction", .field = "direction"},
               {"Rows", "rows"},
               {"Rows that slide", "sliding_rows"},
               {"Friction", "friction"}})});
  return chapter;
}

// ---- The record, and where it comes from

Chapter preparation_chapter(T test) {
  return {"From the file to the record",
          {preparation_rows(test.measurement), numbers(test, "contact"),
           is_fitted(test) ? numbers(test, "nominal_bending_stiffness") : PrintedTable{}}};
}

// A case with its numbers rounded to 12 digits: arithmetic in front ends makes 0.09065000000000001.
std::string with_readable_numbers(std::string_view text) {
  constexpr std::string_view number_characters = "0123456789.eE+-", before = " \"[(", after = " \"],\n";
  constexpr std::size_t max_digits = 12;
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.find_first_not_of(number_characters, i), text.size());
    const std::string number(text.substr(i, end - i));
    const bool is_alone =
        i > 0 && before.find(text[i - 1]) != before.npos && (end == text.size() || after.find(text[end]) != after.npos);
    char* read_to = nullptr;
    const double value = std::strtod(number.c_str(), &read_to);
    const bool is_long = number.size() > max_digits && number.find('.') != number.npos && *read_to == '\0';
    out += is_alone && is_long ? fmt::format("{:.12g}", value) : number;
    if (end < text.size()) out += text[end];
    i = end + 1;
  }
  return out;
}

Chapter provenance_chapter(T test) {
  const Provenance& provenance = test.provenance;
  PrintedTable files{{"File", "SHA-256"}, {}};
  for (const InputFile& file : provenance.inputs) files.rows.push_back({file.name, file.sha256});
  const std::string stated = with_readable_numbers(provenance.test);
  return {"Provenance",
          {fmt::format("FlexSlip {}.{}", provenance.version,
                       stated == provenance.test ? "" : " Numbers have 12 digits here, and all of them in --json."),
           numbers(test, "provenance.options"), files, Verbatim{stated}}};
}

// A chapter of details, which a page shows on request.
Chapter folded(Chapter chapter) {
  chapter.folding = Folding::always;
  return chapter;
}

}  // namespace

Rows full_doubts(const Answer& answer) {
  Rows rows;
  for (const Finding& doubt : doubts_of(answer))
    rows.push_back({std::string(name_of(doubt.severity)), with_remedy(doubt)});
  return rows;
}

std::string fit_screen(const std::string& name, const Answer& answer, const ScreenStyle& style) {
  const auto& [code, meaning, evidence, finding] = answer.verdict;
  const std::vector<Finding> doubts = doubts_of(answer);
  const std::size_t shown_doubts = style.is_full ? doubts.size() : std::min(doubts.size(), max_doubts);
  return in_text(
      Screen{.title = screen_title(name, fmt::format("{}. {}", verdict_word(code, style), meaning), {evidence}, style),
             .rows = style.is_full ? all_rows(answer) : answer.rows,
             .doubts = style.is_full ? full_doubts(answer) : doubt_rows(doubts, shown_doubts, style.width),
             .next = answer.next.empty() ? Rows{} : Rows{{"next", answer.next}},
             .footer = footer_of(answer, doubts.size() - shown_doubts, style.is_full)},
      style);
}

std::vector<std::pair<std::string, ResultTable>> sheets_of(const FittedTest& test) {
  return {{"Answer", line_table(answer_of(test))},
          {"Parameters", parameter_table(test)},
          {"Curves", in_best_units(curve_table(test))}};
}

std::vector<Chapter> document_of(const FittedTest& test) {
  const Answer answer = answer_of(test);
  const Record& record = test.analysis.record;
  const bool is_usable = is_fitted(test) && !is_refused(answer.findings);
  Chapter curve{};
  if (has_friction(test, answer))
    curve.blocks.emplace_back(picture(force_figure, test));
  else if (largest(record.deflection) > 0 && largest(record.force) > 0)
    curve.blocks.emplace_back(picture(record_figure, test));
  std::vector<Chapter> chapters{curve};
  if (has_friction(test, answer)) {
    chapters.push_back({"Friction along the specimen", {picture(profile_figure, test)}});
    chapters.push_back(sensitivity_chapter(test));
  }
  std::vector<Chapter> details;
  if (is_fitted(test)) details.push_back(friction_chapter(test, answer));
  if (is_usable) details.push_back(wave_chapter(test));
  details.push_back(checks_chapter(test, answer));
  if (is_fitted(test)) details.push_back(drops_chapter(test, answer));
  if (is_fitted(test) && test.passes) details.push_back(passes_chapter(test));
  if (is_usable)
    details.push_back({test.passes ? "Where the work of this loading went" : "Where the work went",
                       {caution_of(test, answer), open_numbers(test, "energy"), heat_in_words(test)}});
  details.push_back(small_deflection_chapter(test));
  details.push_back(preparation_chapter(test));
  details.push_back(provenance_chapter(test));
  for (Chapter& chapter : details) chapters.push_back(folded(std::move(chapter)));
  return chapters;
}

std::string fit_text(const FittedTest& test) {
  return fit_screen(test.name, answer_of(test), {.is_full = true}) + in_text(document_of(test));
}

std::string why_no_answer(const FittedTest& test) {
  const Answer answer = answer_of(test);
  if (is_answered(answer.verdict.code)) return "";
  return fmt::format("{}: {} {}", test.measurement.file, answer.findings.front().sentence, answer.next);
}

Rows preparation_rows(const Measurement& measurement) {
  Rows rows;
  for (const PreparationStep& step : measurement.preparation) {
    std::vector<std::string> about;
    if (const auto& value = step.value)
      about.push_back(value->error ? readable(value->value, *value->error, value->kind)
                                   : readable(value->value, value->kind));
    if (step.rows) about.push_back(fmt::format("rows {} to {}", step.rows->first, step.rows->last));
    std::string done = step.done;
    if (!about.empty()) done += fmt::format(" ({})", fmt::join(about, "; "));
    if (const auto& change = step.otherwise) done += "; to change this: " + in_words(measurement.test, *change);
    rows.push_back({std::string(step.name), std::move(done)});
  }
  return rows;
}

std::optional<LiteratureFriction> literature_of(const FittedTest& test) {
  return test.materials ? friction_in_literature(*test.materials) : std::nullopt;
}

}  // namespace flexslip
