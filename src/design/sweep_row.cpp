#include "design/sweep_row.h"

#include <fmt/format.h>

#include "design/outcome_fields.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

StoredAs stored_as(Shape shape) { return shape == Shape::count ? StoredAs::uint32 : StoredAs::float64; }

double number_in(const Json& value, Shape shape) {
  if (!value.is_null()) return value.get<double>();
  return shape == Shape::count ? 0 : not_a_number;
}

}  // namespace

std::vector<SweepColumn> columns_of(const SweepPlan& plan) {
  const auto units = [&](const Kind& kind) { return std::string(unit_of(kind, plan.input.reduced)); };
  std::vector<SweepColumn> columns;
  for (const auto& [parameter, values] : plan.axes)
    columns.push_back({fmt::format("/inputs/{}", parameter.name), units(parameter.kind),
                       std::string(parameter.description), StoredAs::float64});
  columns.push_back({"/outcomes/status", units(kind::number), "whether the design could be computed, and how it ended",
                     StoredAs::uint8});
  for (const Description& outcome : outcome_fields().descriptions())
    columns.push_back({fmt::format("/outcomes/{}", outcome.name), units(outcome.kind), std::string(outcome.meaning),
                       stored_as(outcome.shape)});
  return columns;
}

std::size_t status_column(const SweepPlan& plan) { return plan.axes.size(); }

RowComputer::RowComputer(const SweepPlan& plan) : case_(plan.input) {
  parameters_.reserve(plan.axes.size());
  for (const DesignAxis& axis : plan.axes) parameters_.push_back(axis.parameter.parameter);
}

std::vector<double> RowComputer::operator()(std::span<const double> inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) case_.set(parameters_[i], inputs[i]);
  const DesignResult result = result_of(case_);
  std::vector<double> values{static_cast<double>(result.status)};
  const Frame frame;  // outcomes are in the units of their own design
  for (const auto& outcome : outcome_fields())
    values.push_back(number_in(outcome_fields().of(outcome, result, frame), outcome.what.shape));
  return values;
}

}  // namespace flexslip
