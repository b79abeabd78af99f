// Names of the values of an enumeration.
#pragma once

#include <cstddef>
#include <string_view>

namespace flexslip {

// The name of an enumerator.
// Domain:     an enumeration with the values 0, 1, … last, and one name for each in this order.
template <auto last, std::size_t count>
constexpr std::string_view name_in_order(decltype(last) value, const char* const (&names)[count]) {
  static_assert(count == static_cast<std::size_t>(last) + 1, "a name for each value");
  return names[static_cast<std::size_t>(value)];
}

}  // namespace flexslip
