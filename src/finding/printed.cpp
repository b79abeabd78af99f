#include "finding/printed.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace flexslip {
MatchedDigits matched_digits(const Estimate& estimate, double factor) {
  const double error = factor * estimate.standard_error;
  constexpr double rounding = 1e-9;  // a fixed value has no other error
  if (!std::isfinite(error) || error <= rounding * std::abs(factor * estimate.value))
    return {fmt::format("{:.4g}", factor * estimate.value), "", "", ""};
  // Round first: 0.0996 has the two digits 0.10.
  const double exponent = std::floor(std::log10(error));
  const double rounded = std::round(error / std::pow(10, exponent - 1)) * std::pow(10, exponent - 1);
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(rounded) + 1e-9)), 0, 12);
  const auto print = [&](double value) {
    const std::string text = fmt::format("{:.{}f}", factor * value, decimals);
    return text.find_first_of("123456789") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
  };
  return {print(estimate.value), print(estimate.standard_error), print(estimate.low), print(estimate.high)};
}

std::string format_significant(double value, int digits) {
  if (!std::isfinite(value)) return "";
  const int exponent = value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fmt::format("{:.{}f}", value, std::clamp(digits - 1 - exponent, 0, 12));
}

std::string Print::own(double value, const Kind& kind) const {
  return std::isfinite(value) ? readable(value, as(kind)) : "not known";
}

std::string with_minus(const std::string& number) {
  return number.starts_with('-') ? "\u2212" + number.substr(1) : number;
}

std::string format_count(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string format_share(double part, double whole) {
  if (!(whole > 0)) return "";
  const double share = 100 * part / whole;
  return share != 0 && std::abs(share) < 0.05 ? "less than 0.1 %" : fmt::format("{:.1f} %", share);
}

std::string format_percent(double share) {
  return std::isfinite(share) ? fmt::format("{:.0f} %", 100 * share) : "an unknown share";
}

std::string format_relative(double share) {
  constexpr double all_digits = 0.0995;  // from here on two digits stand before the point
  return std::abs(share) < all_digits ? fmt::format("{:.2g} %", 100 * share) : fmt::format("{:.0f} %", 100 * share);
}

std::string format_roughly(double value, const Kind& kind) {
  if (!std::isfinite(value) || value == 0) return readable(value, kind);
  const std::string_view unit = best_unit(value, kind);
  const Unit scale = unit.empty() ? Unit{} : parse_unit(unit);
  const double shown = from_si(value, scale);
  const double step = std::pow(10, std::floor(std::log10(std::abs(shown))) - 1);
  return readable(to_si(step * std::round(shown / step), scale), kind);
}

}  // namespace flexslip
