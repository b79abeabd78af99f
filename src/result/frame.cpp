#include "result/frame.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace flexslip {
namespace {

struct Quantity {
  Dimension dimension;
  std::string_view physical, reduced;  // units
  double (*of)(double reduced, const Scales& scales);
};

double itself(double value, const Scales& /*scales*/) { return value; }

constexpr std::array quantities{
    Quantity{kind::number.dimension, "1", "1", itself},
    Quantity{kind::angle.dimension, "rad", "rad", itself},
    Quantity{kind::length.dimension, "m", "L", [](double x, const Scales& s) { return s.physical_length(x); }},
    Quantity{kind::speed.dimension, "m/s", "L/s", [](double x, const Scales& s) { return s.physical_length(x); }},
    Quantity{kind::inverse_length.dimension, "1/m", "1/L",
             [](double x, const Scales& s) { return x * (1 / s.span()); }},
    Quantity{kind::force.dimension, "N", "EI/L^2", [](double x, const Scales& s) { return s.physical_force(x); }},
    Quantity{kind::energy.dimension, "J", "EI/L", [](double x, const Scales& s) { return s.physical_energy(x); }},
    Quantity{kind::stiffness.dimension, "N/m", "EI/L^3",
             [](double x, const Scales& s) { return s.physical_stiffness(x); }},
    Quantity{kind::pressure.dimension, "Pa", "EI/L^4",
             [](double x, const Scales& s) { return x * s.force_unit() / (s.span() * s.span()); }},
    Quantity{kind::bending_stiffness.dimension, "N m^2", "EI",
             [](double x, const Scales& s) { return x * s.bending_stiffness(); }},
};

const Quantity& quantity_of(const Kind& kind) {
  const auto* found = std::find_if(quantities.begin(), quantities.end(),
                                   [&](const Quantity& quantity) { return quantity.dimension == kind.dimension; });
  if (found == quantities.end()) throw std::invalid_argument(fmt::format("no answer is {}", kind.name));
  return *found;
}

}  // namespace

double physical(double reduced, const Kind& kind, const Scales& scales) {
  return quantity_of(kind).of(reduced, scales);
}

std::string_view unit_of(const Kind& kind, bool reduced) {
  const Quantity& quantity = quantity_of(kind);
  return reduced ? quantity.reduced : quantity.physical;
}

Json json_in_units(double value, const Kind& kind, const Scales& scales) { return physical(value, kind, scales); }

Json json_in_units(const Estimate& value, const Kind& kind, const Scales& scales) {
  const auto of = [&](double number) { return physical(number, kind, scales); };
  return {{"value", of(value.value)},
          {"standard_error", of(value.standard_error)},
          {"interval95", {of(value.low), of(value.high)}}};
}

Json json_in_units(const std::vector<double>& values, const Kind& kind, const Scales& scales) {
  Json out = Json::array();
  for (const double number : values) out.push_back(physical(number, kind, scales));
  return out;
}

Json json_in_units(const std::string& words, const Kind& /*kind*/, const Scales& /*scales*/) { return words; }
Json json_in_units(const std::string_view& words, const Kind& /*kind*/, const Scales& /*scales*/) { return words; }
Json json_in_units(const bool& value, const Kind& /*kind*/, const Scales& /*scales*/) { return value; }
Json json_in_units(const std::size_t& count, const Kind& /*kind*/, const Scales& /*scales*/) { return count; }

void put(Json& object, std::string_view name, Json value) { object[std::string(name)] = std::move(value); }
void append(Json& array, Json value) { array.push_back(std::move(value)); }

Json with_unit(const Json& value, std::string_view unit) {
  return value.is_null() ? value : Json{{"value", value}, {"unit", unit}};
}

}  // namespace flexslip
