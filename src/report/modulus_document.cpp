#include <algorithm>
#include <cmath>
#include <string_view>

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

std::string with_minus(const std::string& number) { return number.front() == '-' ? "−" + number.substr(1) : number; }

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

// The numbers with their definitions.
Rows number_rows(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  const auto& measurement = test.measurement;
  if (numbers.status != SmallDeflectionStatus::ok) return {};
  const auto as = [&](const Kind& kind) { return kind_in(measurement.test, kind); };
  const auto& [slope, error, low, high] = numbers.stiffness;
  const double relative = error / slope;
  Rows rows{{"stiffness F/δ", readable(slope, error, as(kind::stiffness))}};
  if (numbers.bending_stiffness)
    rows.push_back(
        {"bending stiffness E I = F L³/(48 δ)",
         readable(*numbers.bending_stiffness, relative * *numbers.bending_stiffness, as(kind::bending_stiffness))});
  if (numbers.chord)
    rows.push_back({"flexural modulus E_f, chord of ISO 178",
                    fmt::format("{} (± {})", three_digits(numbers.chord->modulus, as(kind::pressure)),
                                percent_to_two_digits(relative_error(numbers.chord->stiffness)))});
  if (numbers.modulus)
    rows.push_back({numbers.chord ? "flexural modulus E_f, straight part" : "flexural modulus E_f = F L³/(48 I δ)",
                    fmt::format("{} (± {})", three_digits(*numbers.modulus, as(kind::pressure)),
                                percent_to_two_digits(relative))});
  if (const auto modulus = modulus_less_supports(test); modulus && supports_count(test))
    rows.push_back({fmt::format("{} less {} by the supports", numbers.chord ? "that of the chord" : "the same",
                                percent_to_two_digits(*test.supports.alone)),
                    three_digits(modulus->value, as(kind::pressure))});
  add_reached(rows, measurement.test, numbers.greatest, "greatest force", "flexural strength σ_fM",
              "at the greatest force");
  if (is_broken(test))
    add_reached(rows, measurement.test, numbers.end, "force at break", "flexural stress at break σ_fB", "at break");
  rows.push_back({"straight part",
                  fmt::format("rows {} to {}, from {:.0f} % to {:.0f} % of {}", file_row(measurement, numbers.first),
                              last_file_row(measurement, numbers.last - 1), 100 * numbers.window.from,
                              100 * numbers.window.up_to, readable(numbers.window_force, as(kind::force)))});
  rows.push_back(
      {"deflection and strain count from",
       fmt::format("{}, {}",
                   readable(measurement.contact_offset + numbers.origin, numbers.origin_error, as(kind::length)),
                   measurement.contact == ContactSource::stated ? "the contact stated"
                                                                : "where the straight part meets zero force")});
  if (load_train_counts(test))
    rows.push_back(
        {"share of the displacement that the load train takes", percent_to_two_digits(numbers.load_train_share)});
  return rows;
}

// The reason why there are no numbers, and what to do.
std::string why_no_numbers(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  const bool load_train = load_train_counts(test);
  const std::string taken =
      fmt::format("load train takes {} of the displacement", format_percent(numbers.load_train_share));
  constexpr std::string_view check = "Check the units of force and displacement (flexslip read FILE shows them)";
  if (numbers.status == SmallDeflectionStatus::no_straight_part)
    return "The record has no straight rising part of three points or more over a quarter of its greatest force, so no "
           "stiffness can be read off; another part can be named as the window.";
  if (numbers.status == SmallDeflectionStatus::too_stiff)
    return fmt::format("The modulus would be {}, and no material exceeds {}{}. {}, span and section{}.",
                       three_digits(*numbers.modulus, kind_in(test.measurement.test, kind::pressure)),
                       three_digits(max_material_modulus, kind_in(test.measurement.test, kind::pressure)),
                       load_train ? "; the " + taken : "", check,
                       load_train ? ", and the stiffness of the load train" : "");
  if (!load_train)
    return fmt::format(
        "The error of the slope is more than half of it, so the record cannot tell a modulus. {}, and "
        "name the straight part as the window.",
        check);
  return fmt::format(
      "The {}, and what it leaves is uncertain by more than half: the record cannot tell a modulus. {} and "
      "the stiffness of the load train; a deflection measured at the specimen needs none.",
      taken, check);
}

// The possible effect of friction.
std::string friction_in_words(const StandardTest& test, const FrictionGain& gain) {
  const auto [least, most] = gain.friction;
  std::string words =
      least == most ? fmt::format("Friction of {:g}", least) : fmt::format("Friction of {:g} to {:g}", least, most);
  const auto& rig = test.measurement.test.rig;
  const bool are_edges_assumed = !rig->states_supports();
  words += fmt::format(" at these supports{} ", are_edges_assumed ? " (knife edges, as none are stated)" : "");
  const bool adds = gain.modulus.least >= 0 && gain.strength.least >= 0;
  words += fmt::format(fmt::runtime(adds ? "adds {} to the modulus and {} to the strength"
                                         : "changes the modulus by {} and the strength by {}"),
                       percent_range(gain.modulus), percent_range(gain.strength));
  words += fmt::format(", and takes {} of the work up to the greatest force.", percent_range(gain.work));
  if (gain.turns) words += " The rollers turn on their pins before it gets so high, which is taken into account.";
  if (!gain.is_stated)
    words +=
        fmt::format(" Another friction: {}.", test.measurement.test.by_flags ? "modulus --friction" : "[friction] mu0");
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
      ends ? fmt::format("the force is greatest at a strain of {}", percent_to_two_digits(*numbers.greatest.strain))
      : first > 0 ? fmt::format("the record begins at a strain of {}", strain(first))
                  : std::string("the force does not rise between the two"));
}

std::vector<Block> paragraphs(const std::vector<std::string>& words) { return {words.begin(), words.end()}; }

}  // namespace

std::vector<std::string> small_deflection_in_words(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  if (numbers.status != SmallDeflectionStatus::ok) return {why_no_numbers(test)};
  std::vector<std::string> list;
  list.emplace_back(
      "These numbers assume small deflections, no shear and no friction at the supports. The errors are standard "
      "errors of the slope, with that of the load train; they do not include errors of the dimensions.");
  if (!test.geometry.span)
    list.emplace_back("The span is not stated: state it to get a bending stiffness.");
  else if (!test.geometry.section)
    list.emplace_back("The section is not stated: state it to get modulus, stress and strain.");
  if (load_train_counts(test) && numbers.load_train_share > train_share_worth_a_word)
    list.push_back(fmt::format(
        "The load train takes {} of the displacement: an error of 1 % in its stiffness makes one of {:.1f} % in that "
        "of "
        "the specimen. Measure the deflection itself, or the stiffness of the load train.",
        format_percent(numbers.load_train_share), numbers.load_train_share / (1 - numbers.load_train_share)));
  if (numbers.modulus && *numbers.modulus > high_material_modulus && !test.measurement.test.reduced)
    list.push_back(
        fmt::format("Hardly any material is stiffer than {}: check the units of force, displacement, span and section.",
                    three_digits(high_material_modulus, kind_in(test.measurement.test, kind::pressure))));
  if (supports_count(test))
    list.push_back(
        fmt::format("As the specimen bends, its contacts with the supports move inwards, which adds {} to the "
                    "stiffness of the {}.",
                    percent_to_two_digits(*test.supports.alone), numbers.chord ? "chord" : "straight part"));
  if (test.supports.friction) list.push_back(friction_in_words(test, *test.supports.friction));
  if (numbers.origin_before_record > beginning_worth_a_word * numbers.greatest.deflection)
    list.push_back(
        fmt::format("The straight part would meet zero force before the record begins, so deflection and strain count "
                    "from its beginning{}.",
                    beginning_in_words(test)));
  if (const std::string why = why_no_chord(test); !why.empty()) list.push_back(why);
  if (numbers.chord_in_toe)
    list.push_back(fmt::format(
        "The chord of ISO 178, from 0.05 % to 0.25 % strain, lies in the toe, where the record still bends up: the "
        "straight part is {} steeper, and supports and friction explain {}. Use the modulus of the straight part.",
        format_percent(numbers.toe_excess), format_percent(numbers.toe_excess_explained)));
  if (numbers.chord && numbers.modulus) {
    constexpr double clearly = 2;  // [standard errors]
    const double error = std::hypot(relative_error(numbers.chord->stiffness), relative_error(numbers.stiffness));
    const double apart = *numbers.modulus / numbers.chord->modulus - 1;
    if (std::abs(apart) > clearly * error)
      list.push_back(fmt::format(
          "The modulus of the straight part differs by {} from that of the chord, which is more than their errors: {}",
          signed_percent(apart),
          apart > numbers.toe_excess_explained && apart > 0
              ? fmt::format("friction and large deflection explain {} of it, and a toe, which the noise of the chord "
                            "hides, may explain {}. Use the modulus of the straight part.",
                            numbers.toe_excess_explained > 0 ? format_percent(numbers.toe_excess_explained) : "none",
                            numbers.toe_excess_explained > 0 ? "the rest" : "it")
          : apart > 0
              ? "friction and large deflection steepen the straight part more than the chord. Use the chord, or "
                "the modulus that fit finds."
              : "the record begins steeper than it goes on, as under a preload or with a zero of the force that "
                "is off."));
  }
  if (numbers.deflection_large)
    list.push_back(
        fmt::format("The greatest force is reached at a deflection of {:.0f} % of the span. Beyond 10 %, the "
                    "standards' formulas for stress and strain do not hold.",
                    100 * numbers.greatest.deflection / *test.geometry.span));
  if (numbers.shear_share && *numbers.shear_share > shear_worth_a_word) {
    constexpr double asked_for = 16;
    const double slenderness = *test.geometry.span / depth(*test.geometry.section);
    list.push_back(
        fmt::format("The span is {:.3g} times the thickness{}. Shear, which is neglected, adds {} to a small "
                    "deflection (Timoshenko beam, Poisson's ratio 0.3; more if the material is soft in shear), so the "
                    "modulus appears too small.",
                    slenderness, slenderness < asked_for ? ", less than the 16 that ISO 178 asks for" : "",
                    percent_to_two_digits(*numbers.shear_share)));
  }
  if (test.geometry.section && is_thin_tube(*test.geometry.section))
    list.emplace_back(
        "The wall of the tube is thin: the tube may become oval under the load, and the modulus then appears too "
        "small.");
  return list;
}

Chapter small_deflection_chapter(const FittedTest& test) {
  const StandardTest standard = standard_test(test);
  Rows rows = number_rows(standard);
  if (const auto beside = compare_stiffness(test); beside && !is_refused(answer_of(test).findings))
    rows.push_back(
        {"beside the fit",
         fmt::format("{:.3f} times its bending stiffness; their 95 % intervals {}", beside->ratio,
                     beside->disagrees ? "do not overlap: the fit takes friction and large deflection into account"
                                       : "overlap")});
  Chapter chapter{"Small deflection, as the standards have it", paragraphs(small_deflection_in_words(standard))};
  chapter.blocks.insert(chapter.blocks.begin(), rows);
  return chapter;
}

std::vector<Chapter> document_of(const StandardTest& test) {
  return {{"", {number_rows(test)}},
          {"What to know of them", paragraphs(small_deflection_in_words(test))},
          {"From the file to the record", {preparation_rows(test.measurement)}}};
}

}  // namespace flexslip
