// The units of an answer, the rows of its file, and the conversion of values to JSON.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "data/scales.h"
#include "io/quantity.h"
#include "numerics/statistics.h"

namespace flexslip {

struct Frame {
  Scales scales = Scales(1, 1);  // from reduced variables to the units of the test
  bool reduced = false;          // the test itself is in reduced variables
  bool in_inches = false;        // screens and reports use inches and pounds
  std::function<std::size_t(std::size_t)> row = [](std::size_t point) {
    return point + 1;
  };  // row of the file of a point
};

// [SI, or reduced if the test is] The value of a number in reduced variables.
// Domain:     kinds of mechanics: lengths, forces, and the products and powers of both in kind::.
//             std::invalid_argument otherwise.
double physical(double reduced, const Kind& kind, const Scales& scales);

// The unit of the kind: "N", "EI/L^2" for a reduced test, "1" for a plain number.
std::string_view unit_of(const Kind& kind, bool reduced);

// ---- JSON values

using Json = nlohmann::ordered_json;

// Calls a getter with a row, and with the frame if it takes one.
template <class Get, class Row>
decltype(auto) call(const Get& get, const Row& row, const Frame& frame) {
  if constexpr (std::is_invocable_v<const Get&, const Row&, const Frame&>)
    return std::invoke(get, row, frame);
  else
    return std::invoke(get, row);
}

// True for types whose value may be missing: std::optional and pointers.
template <class Value>
concept MayBeMissing = (std::is_pointer_v<Value> && !std::is_same_v<Value, const char*>) ||
                       requires(const Value& value) {
  value.has_value();
};

// True for lists of words.
template <class Value>
concept SeveralWords = requires {
  typename Value::value_type;
}
&&!MayBeMissing<Value> && !std::is_convertible_v<Value, std::string_view> &&
    std::is_convertible_v<typename Value::value_type, std::string_view>;

// make(value), or null if a std::optional or a pointer is empty.
template <class Value, class Make>
Json if_there(const Value& value, Make make) {
  if constexpr (MayBeMissing<Value>)
    return value ? make(*value) : Json();
  else
    return make(value);
}

// The JSON value, with numbers converted from reduced variables to the units of the test. Words,
// counts and plain numbers are unchanged.
Json json_in_units(double value, const Kind& kind, const Scales& scales);
Json json_in_units(const Estimate& value, const Kind& kind, const Scales& scales);
Json json_in_units(const std::vector<double>& values, const Kind& kind, const Scales& scales);
Json json_in_units(const std::string& words, const Kind& kind, const Scales& scales);
Json json_in_units(const std::string_view& words, const Kind& kind, const Scales& scales);
Json json_in_units(const bool& value, const Kind& kind, const Scales& scales);
Json json_in_units(const std::size_t& count, const Kind& kind, const Scales& scales);
template <class Value>
Json json_in_units(const Value& value, const Kind& /*kind*/, const Scales& /*scales*/) {
  return value;
}

// Adds an entry to an object or an array.
void put(Json& object, std::string_view name, Json value);
void append(Json& array, Json value);
template <class Pairs>
Json object_of(const Pairs& pairs) {
  Json out = Json::object();
  for (const auto& [name, value] : pairs) put(out, name, value);
  return out;
}

// A quantity as value and unit; null stays null.
Json with_unit(const Json& value, std::string_view unit);

// The type that a getter returns.
template <class Get, class Row>
using Given = std::remove_cvref_t<decltype(call(std::declval<const Get&>(), std::declval<const Row&>(),
                                                std::declval<const Frame&>()))>;

template <class Get, class Row>
Json json_value(const Get& get, const Row& row, const Frame& frame, const Kind& kind = kind::number) {
  return if_there(call(get, row, frame), [&](const auto& value) { return json_in_units(value, kind, frame.scales); });
}

}  // namespace flexslip
