#include "result/read_off.h"

#include <utility>

namespace flexslip {

Json told(double value, const Kind& kind, const Scales& scales) { return physical(value, kind, scales); }

Json told(const Estimate& value, const Kind& kind, const Scales& scales) {
  const auto of = [&](double number) { return physical(number, kind, scales); };
  return {{"value", of(value.value)},
          {"standard_error", of(value.standard_error)},
          {"interval95", {of(value.low), of(value.high)}}};
}

Json told(const std::vector<double>& values, const Kind& kind, const Scales& scales) {
  Json out = Json::array();
  for (const double number : values) out.push_back(physical(number, kind, scales));
  return out;
}

Json told(const std::string& words, const Kind& /*kind*/, const Scales& /*scales*/) { return words; }
Json told(const std::string_view& words, const Kind& /*kind*/, const Scales& /*scales*/) { return words; }
Json told(const bool& value, const Kind& /*kind*/, const Scales& /*scales*/) { return value; }
Json told(const std::size_t& count, const Kind& /*kind*/, const Scales& /*scales*/) { return count; }

void put(Json& object, std::string_view name, Json value) { object[std::string(name)] = std::move(value); }
void append(Json& array, Json value) { array.push_back(std::move(value)); }

Json with_unit(const Json& value, std::string_view unit) {
  return value.is_null() ? value : Json{{"value", value}, {"unit", unit}};
}

}  // namespace flexslip
