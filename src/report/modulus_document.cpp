#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "finding/answer.h"
#include "report/answer_documents.h"

namespace flexslip {
namespace {

constexpr double shear_worth_a_word = 0.01, supports_worth_a_word = 0.001;

// To three significant digits, trailing zeros among them.
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
  return test.supports_share && *test.supports_share > supports_worth_a_word;
}

double relative_error(const Estimate& estimate) { return estimate.standard_error / estimate.value; }

std::string percent_to_two_digits(double share) { return fmt::format("{:.2g} %", 100 * share); }

// The numbers, each with what it is.
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
    rows.push_back({"flexural modulus E_f, chord from 0.05 % to 0.25 % strain",
                    fmt::format("{} (± {})", three_digits(numbers.chord->modulus, as(kind::pressure)),
                                percent_to_two_digits(relative_error(numbers.chord->stiffness)))});
  if (numbers.modulus)
    rows.push_back(
        {numbers.chord ? "flexural modulus E_f, straight part, F L³/(48 I δ)" : "flexural modulus E_f = F L³/(48 I δ)",
         fmt::format("{} (± {})", three_digits(*numbers.modulus, as(kind::pressure)),
                     percent_to_two_digits(relative))});
  if (const auto modulus = modulus_less_supports(test); modulus && supports_count(test))
    rows.push_back({fmt::format("flexural modulus E_f without the {} that the supports add",
                                percent_to_two_digits(*test.supports_share)),
                    three_digits(modulus->value, as(kind::pressure))});
  rows.push_back({"greatest force", readable(numbers.greatest_force, as(kind::force))});
  rows.push_back({"deflection at the greatest force", readable(numbers.deflection, as(kind::length))});
  if (numbers.stress)
    rows.push_back({"flexural stress at the greatest force", three_digits(*numbers.stress, as(kind::pressure))});
  if (numbers.strain) rows.push_back({"flexural strain at the greatest force", percent_to_two_digits(*numbers.strain)});
  rows.push_back({"straight part",
                  fmt::format("rows {} to {}, from {:.0f} % to {:.0f} % of {}", file_row(measurement, numbers.first),
                              last_file_row(measurement, numbers.last - 1), 100 * numbers.window.from,
                              100 * numbers.window.up_to, readable(numbers.window_force, as(kind::force)))});
  rows.push_back({"toe, where deflection and strain count from", readable(numbers.origin, as(kind::length))});
  return rows;
}

std::vector<Block> paragraphs(const std::vector<std::string>& words) { return {words.begin(), words.end()}; }

}  // namespace

std::vector<std::string> small_deflection_in_words(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  if (numbers.status != SmallDeflectionStatus::ok)
    return {"The record has no straight rising part of five points or more, so no stiffness can be read off."};
  std::vector<std::string> list;
  list.emplace_back(
      "These numbers assume small deflections, no shear and no friction at the supports. The errors are standard "
      "errors of the slope; they do not include errors of the dimensions.");
  if (!test.geometry.span)
    list.emplace_back("The span is not stated: state it to get a bending stiffness.");
  else if (!test.geometry.section)
    list.emplace_back("The section is not stated: state it to get modulus, stress and strain.");
  if (supports_count(test))
    list.push_back(
        fmt::format("As the specimen bends, its contacts with the supports move inwards, which adds {} to the "
                    "stiffness given here. Friction adds to it as well.",
                    percent_to_two_digits(*test.supports_share)));
  if (numbers.chord && numbers.modulus) {
    constexpr double clearly = 3;  // errors
    const double error = std::hypot(relative_error(numbers.chord->stiffness), relative_error(numbers.stiffness));
    if (const double apart = *numbers.modulus / numbers.chord->modulus - 1; apart > clearly * error)
      list.push_back(
          fmt::format("The modulus of the straight part differs by {} from that of the chord, which is more than their "
                      "errors: friction and large deflection steepen the straight part more than the chord. Use the "
                      "chord, or the modulus that fit finds.",
                      signed_percent(apart)));
  }
  if (numbers.deflection_large)
    list.push_back(
        fmt::format("The greatest force is reached at a deflection of {:.0f} % of the span. Beyond 10 %, the "
                    "standards' formulas for stress and strain do not hold.",
                    100 * numbers.deflection / *test.geometry.span));
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
  if (const auto beside = small_deflection_beside_fit(test); beside && is_trusted(answer_of(test).standing))
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
          {"From the file to the record", {preparation_rows(test.measurement.preparation)}}};
}

}  // namespace flexslip
