#include "case/preparation.h"

#include <fmt/format.h>

#include "case/case_keys.h"

namespace flexslip {

PreparedValue value_in(const Test& test, double value, std::optional<double> error, const Kind& kind) {
  return {value, error, kind_in(test, kind)};
}

KeyChange switch_to(std::string_view key, std::string_view word) {
  return {"record", key, fmt::format("\"{}\"", word)};
}

}  // namespace flexslip
