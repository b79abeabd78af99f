// In what an answer is told: the units of its test, and the rows of its file.
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
  Scales scales = Scales(1, 1);  // from the reduced variables of the library to those of the test
  bool reduced = false;          // the test is reduced itself
  bool in_inches = false;        // people are shown it in inches and pounds
  std::function<std::size_t(std::size_t)> row = [](std::size_t point) { return point + 1; };  // of the file, of a point
};

// Domain:     a kind of mechanics: lengths, forces, their products and powers that kind:: has; std::invalid_argument otherwise.

// [SI, or reduced if the test is] A number in reduced variables.
double physical(double reduced, const Kind& kind, const Scales& scales);

// The unit of such numbers: "N"; "EI/L^2" of a reduced test; "1" of a plain number.
std::string_view unit_of(const Kind& kind, bool reduced);

// How a value of the program becomes one of an answer.

using Json = nlohmann::ordered_json;

// What a getter gives of a row; in a frame, if it asks for one.
template <class Get, class Row>
decltype(auto) call(const Get& get, const Row& row, const Frame& frame) {
  if constexpr (std::is_invocable_v<const Get&, const Row&, const Frame&>)
    return std::invoke(get, row, frame);
  else
    return std::invoke(get, row);
}

// Values that may not be there: std::optional, and pointers.
template <class Value>
concept MayBeMissing = (std::is_pointer_v<Value> && !std::is_same_v<Value, const char*>) ||
                       requires(const Value& value) {
  value.has_value();
};

// Lists of words.
template <class Value>
concept SeveralWords = requires {
  typename Value::value_type;
}
&&!MayBeMissing<Value> && !std::is_convertible_v<Value, std::string_view> &&
    std::is_convertible_v<typename Value::value_type, std::string_view>;

// What is made of a value; null where a std::optional or a pointer has none.
template <class Value, class Make>
Json if_there(const Value& value, Make make) {
  if constexpr (MayBeMissing<Value>)
    return value ? make(*value) : Json();
  else
    return make(value);
}

// Numbers in reduced variables of a kind, as those of the test; words, counts and plain numbers as they are.
Json told(double value, const Kind& kind, const Scales& scales);
Json told(const Estimate& value, const Kind& kind, const Scales& scales);
Json told(const std::vector<double>& values, const Kind& kind, const Scales& scales);
Json told(const std::string& words, const Kind& kind, const Scales& scales);
Json told(const std::string_view& words, const Kind& kind, const Scales& scales);
Json told(const bool& value, const Kind& kind, const Scales& scales);
Json told(const std::size_t& count, const Kind& kind, const Scales& scales);
template <class Value>
Json told(const Value& value, const Kind& /*kind*/, const Scales& /*scales*/) {
  return value;
}

// Entries of objects and arrays.
void put(Json& object, std::string_view name, Json value);
void append(Json& array, Json value);
template <class Pairs>
Json object_of(const Pairs& pairs) {
  Json out = Json::object();
  for (const auto& [name, value] : pairs) put(out, name, value);
  return out;
}

// A quantity with its unit beside it; null stays null.
Json with_unit(const Json& value, std::string_view unit);

// What a getter gives of any row.
template <class Get, class Row>
using Given = std::remove_cvref_t<decltype(call(std::declval<const Get&>(), std::declval<const Row&>(),
                                                std::declval<const Frame&>()))>;

template <class Get, class Row>
Json read_off(const Get& get, const Row& row, const Frame& frame, const Kind& kind = kind::number) {
  return if_there(call(get, row, frame), [&](const auto& value) { return told(value, kind, frame.scales); });
}

}  // namespace flexslip
