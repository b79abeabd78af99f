// Coefficients of friction that the literature gives, for pairs of materials that a case states.
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
  double low, high;         // [1] least and greatest
  std::string_view source;  // the measurements
};

// Source:     Table 1 of Fang, Kochiyama & Kesari (2021) and what it cites.
// Fails:      none where the table has no such pair.
std::optional<LiteratureFriction> friction_in_literature(const Materials& materials);

}  // namespace flexslip
