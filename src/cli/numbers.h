// What numbers options take, beyond what CLI11 checks: NaN lies in each of its ranges, and -1 is a whole number without a sign.
#pragma once

#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace flexslip {

inline CLI::Validator number_between(double low, double high) {
  return {[=](const std::string& text) {
            double value = 0;
            const bool within = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
            return within ? std::string()
                          : fmt::format("expected a number from {:g} to {:g}, found '{}'", low, high, text);
          },
          ""};
}

inline CLI::Validator whole_number() {
  return {[](const std::string& text) {
            const bool whole = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
            return whole ? std::string() : fmt::format("expected a whole number, 0 or more, found '{}'", text);
          },
          ""};
}

}  // namespace flexslip
