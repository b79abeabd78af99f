// Values for properties, spread evenly over a range whatever the size RapidCheck asks for.
#pragma once

#include <cstdint>

#include <rapidcheck.h>

namespace flexslip {

inline rc::Gen<double> between(double low, double high) {
  constexpr std::int64_t steps = std::int64_t{1} << 40;
  const auto step = rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(0, steps + 1));
  return rc::gen::map(
      step, [=](std::int64_t i) { return low + (high - low) * static_cast<double>(i) / static_cast<double>(steps); });
}

inline rc::Gen<int> whole(int first, int last) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(first, last + 1));
}

}  // namespace flexslip
