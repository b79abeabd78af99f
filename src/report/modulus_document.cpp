#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "finding/answer.h"
#include "finding/printed.h"
#include "report/answer_documents.h"

namespace flexslip {
namespace {

constexpr double train_share_worth_a_word = 0.3;  // of the displacement
constexpr double shear_worth_a_word = 0.01, supports_worth_a_word = 0.001, load_train_worth_a_word = 0.01;
constexpr double beginning_worth_a_word = 0.01;  // [1] of the maximum deflection

// Three significant digits, including trailing zeros.
std::string three_digits(double value, const Kind& kind) {
  const std::string_view unit = best_unit(value, kind);
  const double shown = unit.empty() ? value : from_si(value, parse_unit(unit));
  if (!(shown > 0) || !std::isfinite(shown)) return readable(value, kind);
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(shown) + 1e-12));
  const double step = std::pow(10, -decimals);
  const std::string number = fmt::format("{:.{}f}", step * std::round(shown / step), std::max(decimals, 0));
  return unit.empty() ? number : fmt::format("{} {}", number, typeset(unit));
}

bool supports_count(const StandardTest& test) {
  return test.supports.alone && *test.supports.alone > supports_worth_a_word;
}

// True if the deflection was computed from the stage and the load train takes much of it.
bool load_train_counts(const StandardTest& test) {
  return test.measurement.is_derived && test.numbers.load_train_share > load_train_worth_a_word;
}

double relative_error(const Estimate& estimate) { return estimate.standard_error / estimate.value; }

std::string percent_to_two_digits(double share) { return fmt::format("{:.2g} %", 100 * share); }

// "0.9 to 4.9 %", "3 %".
std::string percent_range(const ShareRange& share) {
  const std::string from = with_minus(fmt::format("{:.2g}", 100 * share.least));
  const std::string to = with_minus(fmt::format("{:.2g}", 100 * share.most));
  if (from == to) return to + " %";
  return share.most <= 0 ? fmt::format("{} to {} %", to, from) : fmt::format("{} to {} %", from, to);
}

// Force, deflection, stress and strain of a point of the loading.
void add_reached(Rows& rows, const Test& test, const LoadPoint& at, std::string_view force, std::string_view stress,
                 std::string_view where) {
  const auto as = [&](const Kind& kind) { return kind_in(test, kind); };
  rows.push_back({std::string(force), readable(at.force, as(kind::force))});
  rows.push_back({fmt::format("deflection {}", where), readable(at.deflection, as(kind::length))});
  if (at.stress) rows.push_back({std::string(stress), three_digits(*at.stress, as(kind::pressure))});
  if (at.strain) rows.push_back({fmt::format("flexural strain {}", where), percent_to_two_digits(*at.strain)});
}

// "29.5 ± 1.2 GPa": three significant digits, as ISO 178 requires. "17.6 GPa ± 0.02 %" if the error
// is smaller than the last digit.
std::string modulus_in_words(const Estimate& modulus, const Kind& kind) {
  const double value = modulus.value, relative_error = modulus.standard_error / value;
  const std::string_view unit = best_unit(value, kind);
  const double shown = unit.empty() ? value : from_si(value, parse_unit(unit));
  const double error = relative_error * shown;
  if (!(shown > 0) || !(error > 0) || !std::isfinite(shown + error)) return three_digits(value, kind);
  const int decimals = std::max(0, 2 - static_cast<int>(std::floor(std::log10(shown))));
  if (error < 0.5 * std::pow(10, -decimals))
    return fmt::format("{} ± {:.1g} %", three_digits(value, kind), 100 * relative_error);
  const std::string words = fmt::format("{:.{}f} ± {:.{}f}", shown, decimals, error, decimals);
  return unit.empty() ? words : fmt::format("{} {}", words, typeset(unit));
}

std::string rows_of_linear_region(const StandardTest& test) {
  const RowRange rows = rows_of_first_curve(test.measurement, test.numbers.first, test.numbers.last);
  return fmt::format("rows {} to {}", rows.first, rows.last);
}

// The stress at the maximum force is a strength only if the specimen broke.
std::string_view stress_label(const StandardTest& test) {
  return is_broken(test) ? "flexural strength σ_fM" : "flexural stress at the maximum force";
}

// The numbers with their definitions.
Rows number_rows(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  const auto& measurement = test.measurement;
  if (numbers.status != SmallDeflectionStatus::ok) return {};
  const auto as = [&](const Kind& kind) { return kind_in(measurement.test, kind); };
  Rows rows{
      {"stiffness F/δ", readable(numbers.stiffness.value, numbers.stiffness.standard_error, as(kind::stiffness))}};
  if (numbers.bending_stiffness)
    rows.push_back({"bending stiffness E I = F L³/(48 δ)",
                    readable(numbers.bending_stiffness->value, numbers.bending_stiffness->standard_error,
                             as(kind::bending_stiffness))});
  if (numbers.chord)
    rows.push_back(
        {"flexural modulus E_f, chord of ISO 178", modulus_in_words(numbers.chord->modulus, as(kind::pressure))});
  if (numbers.modulus)
    rows.push_back({numbers.chord ? "flexural modulus E_f, linear region" : "flexural modulus E_f = F L³/(48 I δ)",
                    modulus_in_words(*numbers.modulus, as(kind::pressure))});
  if (const auto modulus = modulus_less_supports(test); modulus && supports_count(test))
    rows.push_back({fmt::format("E_f of the {} without the effect of the supports",
                                reports_chord(numbers) ? "chord" : "linear region"),
                    three_digits(modulus->value, as(kind::pressure))});
  add_reached(rows, measurement.test, numbers.greatest, "maximum force", stress_label(test), "at the maximum force");
  if (is_broken(test))
    add_reached(rows, measurement.test, numbers.end, "force at break", "flexural stress at break σ_fB", "at break");
  rows.push_back({"linear region", fmt::format("{}, from {:.0f} % to {:.0f} % of {}", rows_of_linear_region(test),
                                               100 * numbers.window.from, 100 * numbers.window.up_to,
                                               readable(numbers.window_force, as(kind::force)))});
  rows.push_back(
      {"zero of deflection and strain",
       fmt::format("{}, {}",
                   readable(measurement.contact_offset + numbers.origin, numbers.origin_error, as(kind::length)),
                   measurement.contact == ContactSource::stated ? "the stated contact"
                                                                : "where the linear region meets zero force")});
  if (load_train_counts(test))
    rows.push_back({"load-train share of the displacement", percent_to_two_digits(numbers.load_train_share)});
  return rows;
}

// The reason why there are no numbers, and what to do.
std::string why_no_numbers(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  const bool load_train = load_train_counts(test);
  const std::string taken =
      fmt::format("The load train takes {} of the displacement", format_percent(numbers.load_train_share));
  constexpr std::string_view check = "Check the units of force and displacement (flexslip read FILE shows them)";
  if (numbers.status == SmallDeflectionStatus::no_straight_part)
    return "The force does not rise linearly over a quarter of its maximum, in three points or more, so no stiffness "
           "can "
           "be determined. Pass another region as the window (modulus --window).";
  if (numbers.status == SmallDeflectionStatus::too_stiff)
    return fmt::format("The modulus would be {}; no material exceeds {}.{} {}, span and section{}.",
                       three_digits(numbers.modulus->value, kind_in(test.measurement.test, kind::pressure)),
                       three_digits(max_material_modulus, kind_in(test.measurement.test, kind::pressure)),
                       load_train ? fmt::format(" {}.", taken) : "", check,
                       load_train ? ", and the stiffness of the load train" : "");
  if (!load_train)
    return fmt::format(
        "The error of the slope exceeds half of the slope, so the modulus cannot be determined. {}, and pass the "
        "linear "
        "region as the window (modulus --window).",
        check);
  return fmt::format(
      "{}, and the rest is uncertain by more than half, so the modulus cannot be determined. {} and the stiffness of "
      "the load train, or measure the deflection at the specimen.",
      taken, check);
}

// The possible effect of friction.
std::string friction_in_words(const StandardTest& test, const FrictionGain& gain) {
  const auto [least, most] = gain.friction;
  std::string words =
      least == most ? fmt::format("Friction of {:g}", least) : fmt::format("Friction of {:g} to {:g}", least, most);
  const auto& rig = test.measurement.test.rig;
  const bool are_edges_assumed = !rig->states_supports();
  words += fmt::format(" at these supports{} ", are_edges_assumed ? " (knife edges, as no supports are stated)" : "");
  const bool adds = gain.modulus.least >= 0 && gain.strength.least >= 0;
  words += fmt::format(fmt::runtime(adds ? "adds {} to the modulus and {} to the strength"
                                         : "changes the modulus by {} and the strength by {}"),
                       percent_range(gain.modulus), percent_range(gain.strength));
  words += fmt::format(", and takes {} of the work up to the maximum force.", percent_range(gain.work));
  if (gain.turns) words += " The rollers turn on their pins before friction reaches its maximum; this is included.";
  if (!gain.is_stated)
    words += fmt::format(" To state the friction: {}.",
                         test.measurement.test.by_flags ? "modulus --friction" : "[friction] mu0");
  return words;
}

// ", under 372 mN: a preload, or a wrong zero of the force (--zero "372 mN")".
std::string beginning_in_words(const StandardTest& test) {
  const Measurement& measurement = test.measurement;
  if (!(measurement.begins_under > 0)) return "";
  const std::string force = readable(measurement.begins_under, kind_in(measurement.test, kind::force));
  return fmt::format(", under {}: a preload, or, if the load cell was not set to zero, {}", force,
                     instruction_to_set(measurement.test, {{"record", "zero", fmt::format("\"{}\"", force)}}));
}

// The reason why a record with a modulus has no chord of ISO 178; "" if it has one, or if the chord
// is in the toe.
std::string why_no_chord(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  if (!test.geometry.span || !test.geometry.section || numbers.chord || numbers.chord_in_toe) return "";
  const auto strain = [&](double deflection) {
    return percent_to_two_digits(6 * deflection * depth(*test.geometry.section) /
                                 (*test.geometry.span * *test.geometry.span));
  };
  const double first = test.measurement.record.deflection.front() - numbers.origin + numbers.origin_before_record;
  const bool ends = numbers.greatest.strain < 0.0025;
  return fmt::format(
      "There is no chord of ISO 178, from 0.05 % to 0.25 % strain: {}.",
      ends ? fmt::format("the maximum force is at a strain of {}", percent_to_two_digits(*numbers.greatest.strain))
      : first > 0 ? fmt::format("the record begins at a strain of {}", strain(first))
                  : std::string("the force does not rise between these strains"));
}

// What to know of the numbers.
struct Remark {
  std::string sentence;
  std::string warning{};  // the same on one line of the screen; empty if it is no warning
};

// The relative difference between the moduli of linear region and chord, if it exceeds their errors.
std::optional<double> difference_from_chord(const SmallDeflection& numbers) {
  constexpr double clearly = 2;  // [standard errors]
  if (!numbers.chord || !numbers.modulus || numbers.chord_in_toe) return std::nullopt;
  const double error = std::hypot(relative_error(numbers.chord->stiffness), relative_error(numbers.stiffness));
  const double difference = numbers.modulus->value / numbers.chord->modulus.value - 1;
  return std::abs(difference) > clearly * error ? std::optional(difference) : std::nullopt;
}

// True if the linear region is steeper than friction and large deflection explain.
bool has_hidden_toe(const SmallDeflection& numbers) {
  const auto difference = difference_from_chord(numbers);
  return difference && *difference > std::max(numbers.toe_excess_explained, 0.0);
}

std::string difference_in_words(const SmallDeflection& numbers, double difference) {
  if (has_hidden_toe(numbers))
    return numbers.toe_excess_explained > 0
               ? fmt::format("Friction and large deflection explain {} of it, and a toe may explain the rest.",
                             format_percent(numbers.toe_excess_explained))
               : "Friction and large deflection do not explain it; a toe may.";
  return difference > 0 ? "Friction and large deflection steepen the linear region more than the chord. Use the chord, "
                          "or the modulus that fit determines."
                        : "The record begins steeper than it continues, as under a preload or with a wrong zero of "
                          "the force.";
}

Remark load_train_remark(double share) {
  const double effect = share / (1 - share);
  return {
      fmt::format(
          "The load train takes {} of the displacement: an error of 1 % in its stiffness makes an error of {:.1f} % "
          "in the stiffness of the specimen. Measure the deflection itself, or the stiffness of the load train.",
          format_percent(share), effect),
      fmt::format("The load train takes {} of the displacement; 1 % error in it gives {:.1f} % here.",
                  format_percent(share), effect)};
}

Remark shear_remark(const StandardTest& test, double share) {
  constexpr double required = 16;
  const double slenderness = *test.geometry.span / depth(*test.geometry.section);
  return {
      fmt::format(
          "The span is {:.3g} times the thickness{}. Shear, which the formulas neglect, adds {} to a small "
          "deflection (Timoshenko beam, Poisson's ratio 0.3; more if the material is soft in shear), so the modulus "
          "appears too small.",
          slenderness, slenderness < required ? ", less than the 16 that ISO 178 requires" : "",
          percent_to_two_digits(share)),
      fmt::format("Shear adds {} to the deflection, so the modulus appears too small.", percent_to_two_digits(share))};
}

bool states_dimension_errors(const StandardTest& test) {
  return test.geometry.span_error > 0 || test.geometry.moment_error > 0;
}

// Remarks that have no condition on the curve: assumptions and dimensions.
std::vector<Remark> remarks_on_inputs(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  std::vector<Remark> list{
      {"These numbers assume small deflections, no shear and no friction at the supports. Their errors are standard "
       "errors of the slope, including the load train; " +
       std::string(states_dimension_errors(test) ? "the stated errors of the dimensions are included."
                                                 : "errors of the dimensions are not included.")}};
  if (!test.geometry.span)
    list.push_back({"The span is not stated: state it to get a bending stiffness."});
  else if (!test.geometry.section)
    list.push_back({"The section is not stated: state it to get modulus, stress and strain."});
  if (load_train_counts(test) && numbers.load_train_share > train_share_worth_a_word)
    list.push_back(load_train_remark(numbers.load_train_share));
  if (numbers.modulus && numbers.modulus->value > high_material_modulus && !test.measurement.test.reduced) {
    const std::string words =
        fmt::format("Almost no material is stiffer than {}: check the units of force, displacement, span and section.",
                    three_digits(high_material_modulus, kind_in(test.measurement.test, kind::pressure)));
    list.push_back(
        {words, fmt::format("Almost no material is stiffer than {}: check units, span and section.",
                            three_digits(high_material_modulus, kind_in(test.measurement.test, kind::pressure)))});
  }
  if (supports_count(test))
    list.push_back(
        {fmt::format("As the specimen bends, its contacts with the supports move inwards, which adds {} to the "
                     "stiffness of the {}.",
                     percent_to_two_digits(*test.supports.alone), reports_chord(numbers) ? "chord" : "linear region")});
  if (test.supports.friction) list.push_back({friction_in_words(test, *test.supports.friction)});
  return list;
}

// Remarks on the curve.
std::vector<Remark> remarks_on_curve(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  std::vector<Remark> list;
  if (numbers.origin_before_record > beginning_worth_a_word * numbers.greatest.deflection)
    list.push_back(
        {fmt::format("The linear region would meet zero force before the record begins, so deflection and strain count "
                     "from its beginning{}.",
                     beginning_in_words(test)),
         "The record begins above zero force: deflection counts from its first row."});
  if (test.measurement.first_curve.record.force.size() > test.measurement.record.force.size())
    list.push_back(
        {fmt::format("The specimen was loaded more than once: the numbers follow the first loading, and every "
                     "later one, up to loading {}, only where it goes farther.",
                     test.measurement.loading.number),
         ""});
  for (const std::string& contradiction : test.measurement.contradictions)
    list.push_back({contradiction, contradiction});
  if (yields(numbers) && !is_broken(test))
    list.push_back({"The force levels off without a break: the specimen yielded."});
  if (const std::string why = why_no_chord(test); !why.empty()) list.push_back({why});
  if (numbers.chord_in_toe)
    list.push_back({fmt::format(
        "The chord of ISO 178, from 0.05 % to 0.25 % strain, lies in the toe, where the curve still becomes steeper: "
        "the linear region is {} steeper, and supports and friction explain {}. Use the modulus of the linear region.",
        format_percent(numbers.toe_excess), format_percent(numbers.toe_excess_explained))});
  if (const auto difference = difference_from_chord(numbers))
    list.push_back(
        {fmt::format(
             "The modulus of the linear region differs by {} from the modulus of the chord, more than their errors. {}",
             signed_percent(*difference), difference_in_words(numbers, *difference)),
         has_hidden_toe(numbers) ? ""
                                 : fmt::format("The linear region gives {} against the chord, more than their errors.",
                                               signed_percent(*difference))});
  if (numbers.deflection_large) {
    const double share = 100 * numbers.greatest.deflection / *test.geometry.span;
    list.push_back(
        {fmt::format("The maximum force is at a deflection of {:.0f} % of the span. Beyond 10 %, the "
                     "standards' formulas for stress and strain do not hold.",
                     share),
         fmt::format("At the maximum, the deflection is {:.0f} % of the span; the formulas hold up to 10 %.", share)});
  }
  if (numbers.shear_share && *numbers.shear_share > shear_worth_a_word)
    list.push_back(shear_remark(test, *numbers.shear_share));
  if (test.geometry.section && is_thin_tube(*test.geometry.section))
    list.push_back(
        {"The wall of the tube is thin: the tube may become oval under load, and the modulus then appears "
         "too small.",
         "The wall of the tube is thin: it may become oval, and the modulus too small."});
  return list;
}

std::vector<Remark> remarks_on(const StandardTest& test) {
  if (test.numbers.status != SmallDeflectionStatus::ok) return {{why_no_numbers(test)}};
  std::vector<Remark> list = remarks_on_inputs(test);
  for (Remark& remark : remarks_on_curve(test)) list.push_back(std::move(remark));
  return list;
}

std::vector<Block> paragraphs(const std::vector<std::string>& words) { return {words.begin(), words.end()}; }

// ---- The screen

// The first lines: the number to quote, and the number to compare with it.
struct Headline {
  std::string sentence, below{};
};

Headline headline_of(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  const auto as = [&](const Kind& kind) { return kind_in(test.measurement.test, kind); };
  if (numbers.status != SmallDeflectionStatus::ok) return {"no modulus.", why_no_numbers(test)};
  const std::string rows = rows_of_linear_region(test);
  if (!numbers.bending_stiffness)
    return {fmt::format("stiffness F/δ {} (steepest linear part, {}).",
                        readable(numbers.stiffness.value, numbers.stiffness.standard_error, as(kind::stiffness)), rows),
            "State the span and the section to get a modulus."};
  if (!numbers.modulus)
    return {fmt::format("bending stiffness EI {} (steepest linear part, {}).",
                        readable(numbers.bending_stiffness->value, numbers.bending_stiffness->standard_error,
                                 as(kind::bending_stiffness)),
                        rows),
            "State the section to get modulus, stress and strain."};
  const std::string linear = modulus_in_words(*numbers.modulus, as(kind::pressure));
  const std::string of_linear = fmt::format("flexural modulus {} (steepest linear part, {}).", linear, rows);
  if (!numbers.chord) return {of_linear, why_no_chord(test)};
  const std::string chord = modulus_in_words(numbers.chord->modulus, as(kind::pressure));
  if (numbers.chord_in_toe)
    return {of_linear,
            fmt::format("{} from the chord of ISO 178 (0.05 to 0.25 % strain), which lies in a toe.", chord)};
  return {fmt::format("flexural modulus {} (ISO 178 chord, 0.05 to 0.25 % strain).", chord),
          fmt::format("{} from the steepest linear part ({}){}.", linear, rows,
                      has_hidden_toe(numbers) ? "; a toe may lower the chord" : ", for comparison")};
}

// "12.68 mN at 394.2 µm: 979 MPa, strain 5 %"
std::string point_in_words(const StandardTest& test, const LoadPoint& at) {
  const auto as = [&](const Kind& kind) { return kind_in(test.measurement.test, kind); };
  std::string words =
      fmt::format("{} at {}", readable(at.force, as(kind::force)), readable(at.deflection, as(kind::length)));
  if (at.stress) words += fmt::format(": {}", three_digits(*at.stress, as(kind::pressure)));
  if (at.strain) words += fmt::format(", strain {}", percent_to_two_digits(*at.strain));
  return words;
}

// "−0.03 to −0.16 %", "+7.8 to +35 %"
std::string signed_range(const ShareRange& share) {
  const auto with_sign = [](double value) {
    return (value < 0 ? "" : "+") + with_minus(fmt::format("{:.2g}", 100 * value));
  };
  const std::string from = with_sign(share.least), to = with_sign(share.most);
  if (from == to) return to + " %";
  return share.most <= 0 ? fmt::format("{} to {} %", to, from) : fmt::format("{} to {} %", from, to);
}

std::string friction_row(const FrictionGain& gain) {
  const auto& [least, most] = gain.friction;
  return fmt::format("if {} at these supports: modulus {}, stress {}",
                     least == most ? fmt::format("{:g}", least) : fmt::format("{:g} to {:g}", least, most),
                     signed_range(gain.modulus), signed_range(gain.strength));
}

// The meaning of the stress at the maximum force.
std::string_view maximum_in_words(const StandardTest& test) {
  if (is_broken(test)) return " (strength)";
  if (yields(test.numbers)) return "; the specimen yielded";
  return ends_rising(test.numbers) ? "; still rising: not a strength" : "; no failure, so not a strength";
}

Rows screen_rows(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  if (numbers.status != SmallDeflectionStatus::ok) return {};
  const auto as = [&](const Kind& kind) { return kind_in(test.measurement.test, kind); };
  std::string stiffness =
      fmt::format("F/δ {}", readable(numbers.stiffness.value, numbers.stiffness.standard_error, as(kind::stiffness)));
  if (const auto& EI = numbers.bending_stiffness)
    stiffness += fmt::format("; EI {}", readable(EI->value, EI->standard_error, as(kind::bending_stiffness)));
  const bool has_stress = numbers.greatest.stress.has_value();
  const auto without_supports = supports_count(test) ? modulus_less_supports(test) : std::nullopt;
  return {
      {"stiffness", stiffness},
      {"maximum", point_in_words(test, numbers.greatest) + std::string(has_stress ? maximum_in_words(test) : "")},
      {"3.5 % strain", numbers.at_conventional_strain && !is_broken(test)
                           ? three_digits(*numbers.at_conventional_strain->stress, as(kind::pressure)) +
                                 " (conventional stress σ_fC of ISO 178)"
                           : ""},
      {"break", is_broken(test) ? point_in_words(test, numbers.end) : ""},
      {"supports", without_supports ? fmt::format("contacts that move inwards add {}; without them the modulus is {}",
                                                  percent_to_two_digits(*test.supports.alone),
                                                  three_digits(without_supports->value, as(kind::pressure)))
                                    : ""},
      {"friction", test.supports.friction ? friction_row(*test.supports.friction) : ""}};
}

}  // namespace

std::vector<std::string> small_deflection_in_words(const StandardTest& test) {
  std::vector<std::string> sentences;
  for (Remark& remark : remarks_on(test)) sentences.push_back(std::move(remark.sentence));
  return sentences;
}

std::string modulus_screen(const std::string& name, const StandardTest& test, const ScreenStyle& style) {
  constexpr std::size_t max_warnings = 3;
  const auto [sentence, below] = headline_of(test);
  const bool has_numbers = test.numbers.status == SmallDeflectionStatus::ok;
  std::size_t warnings = 0;
  Rows shown;
  for (const Remark& remark : remarks_on(test))
    if (!remark.warning.empty() && ++warnings <= max_warnings) shown.push_back({"warning", remark.warning});
  const std::size_t more = warnings - shown.size();
  return in_text(
      Screen{.title = screen_title(name, sentence, {below}, style),
             .rows = screen_rows(test),
             .doubts = style.is_full ? Rows{} : shown,
             .footer = fmt::format(
                 "{}{}{}", more > 0 && !style.is_full ? format_count(more, "more warning. ", "more warnings. ") : "",
                 !has_numbers                    ? ""
                 : states_dimension_errors(test) ? "± is one standard error, with the stated errors of the dimensions. "
                                                 : "± is one standard error, without errors of the dimensions. ",
                 style.is_full ? "" : "More: --full")},
      style);
}

Chapter small_deflection_chapter(const FittedTest& test) {
  const StandardTest standard = standard_test(test);
  Rows rows = number_rows(standard);
  if (const auto comparison = compare_stiffness(test); comparison && !is_refused(answer_of(test).findings))
    rows.push_back(
        {"compared with the fit",
         fmt::format("{:.3f} times its bending stiffness; their 95 % intervals {}", comparison->ratio,
                     comparison->disagrees ? "do not overlap: the fit takes friction and large deflection into account"
                                           : "overlap")});
  Chapter chapter{"Small deflection, by the bending standards", paragraphs(small_deflection_in_words(standard))};
  chapter.blocks.insert(chapter.blocks.begin(), rows);
  return chapter;
}

std::string modulus_text(const std::string& name, const StandardTest& test) {
  return modulus_screen(name, test, {.is_full = true}) +
         in_text({{"The numbers", {number_rows(test)}},
                  {"What to know of them", paragraphs(small_deflection_in_words(test))},
                  {"From the file to the record", {preparation_rows(test.measurement)}}});
}

}  // namespace flexslip
