#include "data/literature_friction.h"

#include <algorithm>
#include <array>

namespace flexslip {
namespace {

constexpr std::array table{
    LiteratureFriction{"glass", "steel", 0.5, 0.721,
                       "Tomlinson 1929; Beare and Bowden 1935; Deulin et al. 2010: polished, dry or in vacuum"},
    LiteratureFriction{"glass", "hard steel", 0.605, 0.605, "Tomlinson 1929: polished, clean, dry"},
    LiteratureFriction{"glass", "mild steel", 0.51, 0.721,
                       "Tomlinson 1929; Beare and Bowden 1935: polished, clean, dry"},
    LiteratureFriction{"glass", "stainless steel", 0.5, 0.5, "Deulin et al. 2010: polished, in vacuum"},
    LiteratureFriction{"silica", "stainless steel", 0.7, 0.7, "Marsal et al. 2013: a coating of silica, in air"},
};

}  // namespace

std::optional<LiteratureFriction> friction_in_literature(const Materials& materials) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const LiteratureFriction& each) {
    return each.specimen == materials.specimen && each.support == materials.support;
  });
  if (found == table.end()) return std::nullopt;
  return *found;
}

}  // namespace flexslip
