// The uncertain quantities of a specimen and its rig, and maps from these quantities to values.
#pragma once

#include <array>
#include <cstddef>

namespace flexslip {

// The preload is the deflection at which displacement and force were set to zero; the fit assumes
// none.
enum class StatedQuantity {
  bending_stiffness,
  contact,
  preload,
  load_train,
  span,
  force_gain,
  thickness,
  support_radius
};

inline constexpr std::array stated_quantities{
    StatedQuantity::bending_stiffness, StatedQuantity::contact,       StatedQuantity::preload,
    StatedQuantity::load_train,        StatedQuantity::span,          StatedQuantity::force_gain,
    StatedQuantity::thickness,         StatedQuantity::support_radius};

// True if changes of the quantity are in spans [L]; otherwise they are relative [1].
constexpr bool changes_in_spans(StatedQuantity quantity) {
  return quantity == StatedQuantity::contact || quantity == StatedQuantity::preload ||
         quantity == StatedQuantity::thickness || quantity == StatedQuantity::support_radius;
}

template <class T>
struct PerQuantity {
  std::array<T, stated_quantities.size()> values{};

  T& operator[](StatedQuantity quantity) { return values[static_cast<std::size_t>(quantity)]; }
  const T& operator[](StatedQuantity quantity) const { return values[static_cast<std::size_t>(quantity)]; }
};

}  // namespace flexslip
