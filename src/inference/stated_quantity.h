// What a case states of a specimen and its rig, and may be off: a map of these quantities to numbers or columns of them.
#pragma once

#include <array>
#include <cstddef>

namespace flexslip {

// The preload is one of displacement and force that were set to zero when the specimen was bent already; it is taken as none.
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

// Changes of contact, preload, thickness and radius are in spans [L], those of all else in parts of its value [1].
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
