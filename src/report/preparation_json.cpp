#include "report/preparation_json.h"

#include <string>

namespace flexslip {
namespace {

// The unit of a kind that needs no factor; "1" for plain numbers.
std::string si_unit(const Kind& kind) {
  for (const std::string_view unit : kind.units)
    if (parse_unit(unit) == Unit{kind.dimension, 0, 1}) return std::string(unit);
  return "1";
}

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

}  // namespace

Json preparation_json(const Preparation& preparation) {
  Json steps = Json::array();
  for (const PreparationStep& step : preparation.steps) {
    Json out = {{"step", step.name}, {"changed", step.changed},       {"done", step.done},
                {"value", nullptr},  {"uncertainty", nullptr},        {"unit", nullptr},
                {"rows", nullptr},   {"key", text_or_null(step.key)}, {"flag", text_or_null(flag_of(step))}};
    if (step.value) {
      out["value"] = step.value->value;
      if (step.value->error) out["uncertainty"] = *step.value->error;
      out["unit"] = si_unit(step.value->kind);
    }
    if (step.rows) out["rows"] = {step.rows->first, step.rows->last};
    steps.push_back(out);
  }
  return steps;
}

}  // namespace flexslip
