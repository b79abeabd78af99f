#include "case/preparation.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace flexslip {

void Preparation::add(std::string_view name, bool changed, std::string done, std::optional<KeyChange> otherwise,
                      std::optional<PreparedValue> value, std::optional<RowRange> rows) {
  const auto known = std::find(preparation_steps.begin(), preparation_steps.end(), name);
  if (known == preparation_steps.end()) throw std::logic_error("no step of a preparation: " + std::string(name));
  steps.push_back({*known, changed, std::move(done), value, rows, std::move(otherwise)});
}

}  // namespace flexslip
