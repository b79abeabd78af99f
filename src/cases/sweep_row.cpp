#include "cases/sweep_row.h"

#include <limits>

#include <fmt/format.h>

#include "cases/design_result.h"

namespace flexslip {
namespace {

double missing_in(const OutcomeColumn& column) {
  return column.stored_as == StoredAs::float64 ? std::numeric_limits<double>::quiet_NaN() : 0;
}

}  // namespace

std::vector<SweepColumn> columns_of(const SweepPlan& plan) {
  const auto units = [&](const Kind& kind) { return std::string(unit_of(kind, plan.input.reduced)); };
  std::vector<SweepColumn> columns;
  columns.reserve(plan.axes.size() + 1 + outcome_columns().size());
  for (const auto& [parameter, values] : plan.axes)
    columns.push_back({fmt::format("/inputs/{}", parameter.name), units(parameter.kind),
                       std::string(parameter.description), StoredAs::float64});
  columns.push_back({"/outcomes/status", units(kind::number), "whether the design could be computed, and how it ended",
                     StoredAs::uint8});
  for (const OutcomeColumn& column : outcome_columns())
    columns.push_back({fmt::format("/outcomes/{}", column.name), units(column.kind), std::string(column.description),
                       column.stored_as});
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
  values.reserve(1 + outcome_columns().size());
  for (const OutcomeColumn& column : outcome_columns())
    values.push_back(result.outcome ? column.value(*result.outcome, *result.units) : missing_in(column));
  return values;
}

}  // namespace flexslip
