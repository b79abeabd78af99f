#include "design/sweep_digest.h"

#include <cstdint>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "design/sweep_row.h"
#include "io/sha256.h"
#include "io/table.h"

namespace flexslip {
namespace {

// In place of the name of a file, what is in it.
std::string content_digest(const std::string& file) { return digest_of(*open_to_read(file)).sha256; }

std::string text_of_case(Case input) {
  input.record.reset();
  const auto by_content = [](FrictionProfileInput& profile) {
    if (auto* table = std::get_if<TabulatedFriction>(&profile)) table->file = content_digest(table->file);
    if (auto* surface = std::get_if<SurfaceFriction>(&profile)) surface->trace = content_digest(surface->trace);
  };
  if (input.friction && input.friction->profile) by_content(*input.friction->profile);
  if (input.friction && input.friction->other) by_content(input.friction->other->profile);
  if (input.stage)
    if (auto* measured = std::get_if<MeasuredProgramme>(&input.stage->programme))
      measured->file = content_digest(measured->file);
  return to_toml(input);
}

std::string text_of(const DesignAxis& axis) {
  if (const auto* values = std::get_if<AxisValues>(&axis.values))
    return fmt::format("{} {}", axis.parameter.name, *values);
  const auto& range = std::get<AxisRange>(axis.values);
  return fmt::format("{} {} {} {} {}", axis.parameter.name, range.from, range.to, range.points,
                     range.spacing == Spacing::linear ? "linear" : "log");
}

}  // namespace

std::string digest_of_sweep(const SweepPlan& plan) { return digest_of_sweep(plan, RowComputer(plan)); }

std::string digest_of_sweep(const SweepPlan& plan, const RowFunction& outcomes_of) {
  constexpr std::uint64_t answers = 8;
  std::string text = fmt::format("sweep of FlexSlip {}\n{}", FLEXSLIP_VERSION, text_of_case(plan.input));
  if (const auto* hypercube = std::get_if<LatinHypercube>(&plan.method))
    text += fmt::format("latin hypercube {} {}\n", hypercube->samples, hypercube->seed);
  for (const DesignAxis& axis : plan.axes) text += text_of(axis) + "\n";
  for (const SweepColumn& column : columns_of(plan)) text += column.path + "\n";
  for (std::uint64_t i = 0; i < answers; ++i)  // to the last bit
    text += fmt::format("{}\n", outcomes_of(inputs_of(plan, row_from_all_over(plan, i))));
  return sha256_of(text);
}

}  // namespace flexslip
