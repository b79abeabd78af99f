#include "finding/digits.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace flexslip {

MatchedDigits matched_digits(const Estimate& estimate, double factor) {
  const double error = factor * estimate.standard_error;
  constexpr double rounding = 1e-9;  // a value that is held has no error but this
  if (!std::isfinite(error) || error <= rounding * std::abs(factor * estimate.value))
    return {fmt::format("{:.4g}", factor * estimate.value), "", "", ""};
  // Rounded first: of 0.0996, two digits are 0.10.
  const double exponent = std::floor(std::log10(error));
  const double rounded = std::round(error / std::pow(10, exponent - 1)) * std::pow(10, exponent - 1);
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(rounded) + 1e-9)), 0, 12);
  const auto print = [&](double value) {
    const std::string text = fmt::format("{:.{}f}", factor * value, decimals);
    return text.find_first_of("123456789") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
  };
  return {print(estimate.value), print(estimate.standard_error), print(estimate.low), print(estimate.high)};
}

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return "";
  const int exponent = value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fmt::format("{:.{}f}", value, std::clamp(digits - 1 - exponent, 0, 12));
}

}  // namespace flexslip
