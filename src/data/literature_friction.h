// Friction coefficients from the literature for the pair of materials that a case states.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace flexslip {

struct Materials {
  std::string specimen, support;  // "glass", "steel"
  bool operator==(const Materials&) const = default;
};

struct LiteratureFriction {
  std::string_view specimen, support;
  double low, high;         // [1] range of the measurements
  std::string_view source;  // reference of the measurements
};

// The friction coefficient of a pair of materials; empty if the table does not contain the pair.
// Source:     Table 1 of Fang, Kochiyama & Kesari (2021) and its references.
std::optional<LiteratureFriction> friction_in_literature(const Materials& materials);

}  // namespace flexslip
