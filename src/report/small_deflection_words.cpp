#include "report/small_deflection_words.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

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

}  // namespace

PrintedTable small_deflection_table(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  PrintedTable table{{"", "value"}, {}};
  if (numbers.status != SmallDeflectionStatus::ok) return table;
  const auto as = [&](const Kind& kind) { return kind_in(test.measurement.test, kind); };
  const auto add = [&](std::string name, std::string value) {
    table.rows.push_back({std::move(name), std::move(value)});
  };
  const auto& [slope, error, low, high] = numbers.stiffness;
  const double relative = error / slope;
  add("stiffness F/δ", readable(slope, error, as(kind::stiffness)));
  if (numbers.bending_stiffness)
    add("bending stiffness E I = F L³/(48 δ)",
        readable(*numbers.bending_stiffness, relative * *numbers.bending_stiffness, as(kind::bending_stiffness)));
  if (numbers.chord)
    add("flexural modulus E_f, chord from 0.05 % to 0.25 % strain",
        fmt::format("{} (± {})", three_digits(numbers.chord->modulus, as(kind::pressure)),
                    percent_to_two_digits(numbers.chord->stiffness.standard_error / numbers.chord->stiffness.value)));
  if (numbers.modulus)
    add(numbers.chord ? "flexural modulus E_f, straight part, F L³/(48 I δ)" : "flexural modulus E_f = F L³/(48 I δ)",
        fmt::format("{} (± {})", three_digits(*numbers.modulus, as(kind::pressure)), percent_to_two_digits(relative)));
  if (const auto modulus = modulus_less_supports(test); modulus && supports_count(test))
    add(fmt::format("flexural modulus E_f without the {} that the supports add",
                    percent_to_two_digits(*test.supports_share)),
        three_digits(modulus->value, as(kind::pressure)));
  add("greatest force", readable(numbers.greatest_force, as(kind::force)));
  add("deflection at the greatest force", readable(numbers.deflection, as(kind::length)));
  if (numbers.stress) add("flexural stress at the greatest force", three_digits(*numbers.stress, as(kind::pressure)));
  if (numbers.strain) add("flexural strain at the greatest force", percent_to_two_digits(*numbers.strain));
  return table;
}

std::vector<std::string> small_deflection_in_words(const StandardTest& test) {
  const SmallDeflection& numbers = test.numbers;
  if (numbers.status != SmallDeflectionStatus::ok)
    return {"The record has no straight rising part of five points or more, so no stiffness can be read off."};
  const auto& measurement = test.measurement;
  const auto as = [&](const Kind& kind) { return kind_in(test.measurement.test, kind); };
  std::vector<std::string> list;
  list.push_back(
      fmt::format("The straight part is rows {} to {}, from {:.0f} % to {:.0f} % of {}. Extended to zero force, it "
                  "meets a deflection of {}; deflection and strain are counted from there.",
                  file_row(measurement, numbers.first), last_file_row(measurement, numbers.last - 1),
                  100 * numbers.window.from, 100 * numbers.window.up_to,
                  readable(numbers.window_force, as(kind::force)), readable(numbers.origin, as(kind::length))));
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
      list.push_back(fmt::format(
          "The modulus of the straight part differs by {} from that of the chord, which is more than their errors: "
          "friction "
          "and large deflection steepen the straight part more than the chord. Use the chord, or the modulus that fit "
          "finds.",
          signed_percent(apart)));
  }
  if (numbers.deflection_large)
    list.push_back(fmt::format(
        "The greatest force is reached at a deflection of {:.0f} % of the span. Beyond 10 %, the standards' "
        "formulas for stress and strain do not hold.",
        100 * numbers.deflection / *test.geometry.span));
  if (numbers.shear_share && *numbers.shear_share > shear_worth_a_word) {
    constexpr double asked_for = 16;
    const double slenderness = *test.geometry.span / depth(*test.geometry.section);
    list.push_back(fmt::format(
        "The span is {:.3g} times the thickness{}. Shear, which is neglected, adds {} to a small deflection "
        "(Timoshenko "
        "beam, Poisson's ratio 0.3; more if the material is soft in shear), so the modulus appears too small.",
        slenderness, slenderness < asked_for ? ", less than the 16 that ISO 178 asks for" : "",
        percent_to_two_digits(*numbers.shear_share)));
  }
  if (test.geometry.section && is_thin_tube(*test.geometry.section))
    list.emplace_back(
        "The wall of the tube is thin: the tube may become oval under the load, and the modulus then appears too "
        "small.");
  return list;
}

std::string small_deflection_and_fit(const FittedTest& test) {
  const auto beside = small_deflection_beside_fit(test);
  if (!beside) return "There is no fitted bending stiffness to compare with.";
  return fmt::format(
      "The bending stiffness of the straight part is {:.3f} times that of the fit{}", beside->ratio,
      beside->disagrees
          ? ": their 95 % intervals do not overlap. The fit takes friction and large deflection into account; the "
            "straight part takes neither."
          : "; their 95 % intervals overlap.");
}

}  // namespace flexslip
