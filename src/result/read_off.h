// How a value of the program becomes one of an answer.
#pragma once

#include <functional>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "data/estimate.h"
#include "result/frame.h"

namespace flexslip {

using Json = nlohmann::ordered_json;

// What a getter gives of a row; in a frame, if it asks for one.
template <class Get, class Row>
decltype(auto) call(const Get& get, const Row& row, const Frame& frame) {
  if constexpr (std::is_invocable_v<const Get&, const Row&, const Frame&>)
    return std::invoke(get, row, frame);
  else
    return std::invoke(get, row);
}

// What is made of a value; null where a std::optional or a pointer has none.
template <class Value, class Make>
Json if_there(const Value& value, Make make) {
  if constexpr (std::is_pointer_v<Value> && !std::is_same_v<Value, const char*>)
    return value ? make(*value) : Json();
  else if constexpr (requires { value.has_value(); })
    return value ? make(*value) : Json();
  else
    return make(value);
}

// Numbers in reduced variables of a kind, as those of the test; words, counts and plain numbers as they are.
template <class Value>
Json told(const Value& value, const Kind& kind, const Scales& scales) {
  if constexpr (std::is_same_v<Value, double>) {
    return physical(value, kind, scales);
  } else if constexpr (std::is_same_v<Value, Estimate>) {
    const auto of = [&](double number) { return physical(number, kind, scales); };
    return {{"value", of(value.value)},
            {"standard_error", of(value.standard_error)},
            {"interval95", {of(value.low), of(value.high)}}};
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    Json out = Json::array();
    for (const double number : value) out.push_back(physical(number, kind, scales));
    return out;
  } else {
    return value;
  }
}

template <class Get, class Row>
Json read_off(const Get& get, const Row& row, const Frame& frame, const Kind& kind = kind::number) {
  return if_there(call(get, row, frame), [&](const auto& value) { return told(value, kind, frame.scales); });
}

}  // namespace flexslip
