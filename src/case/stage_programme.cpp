#include "case/stage_programme.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "bending_test/history.h"
#include "case/stiffness_used.h"
#include "io/quantity.h"
#include "io/table.h"

namespace flexslip {
namespace {

// All positions at which the stage turns, halts or ends, cycle by cycle.
std::vector<double> written_out(const TurningPoints& programme) {
  std::vector<double> turns{programme.positions.front()};
  turns.reserve(1 + programme.cycles * (programme.positions.size() - 1));
  for (std::uint64_t cycle = 0; cycle < programme.cycles; ++cycle)
    turns.insert(turns.end(), programme.positions.begin() + 1, programme.positions.end());
  return turns;
}

StageProgramme programme_from(const Case& input, const TurningPoints& programme) {
  const auto& positions = programme.positions;
  const auto farthest = std::max_element(positions.begin(), positions.end());
  const std::string key = fmt::format("stage.program[{}]", farthest - positions.begin() + 1);
  if (!(*farthest >= nearest_reduced * span_of(input)))
    throw wrong_value(input, fmt::format("stage.program[{}]", positions.size()),
                      fmt::format("a position of at least {:g} spans", nearest_reduced),
                      readable_length(input, positions.back()));
  if (!(*farthest <= farthest_reduced * span_of(input)))
    throw wrong_value(input, key, fmt::format("a position within {:g} spans", farthest_reduced),
                      readable_length(input, *farthest), "check its unit");
  std::vector<double> turns = written_out(programme);
  if (!programme.step) return {std::move(turns), *farthest, false, false};
  return {stage_steps(turns, *programme.step), *farthest, true, false};
}

StageProgramme programme_from(const Case& input, const MeasuredProgramme& measured) {
  std::vector<WantedColumn> wanted{{measured.stage, kind_in(input, kind::length)}};
  if (measured.time) wanted.push_back({*measured.time, kind_in(input, kind::time)});
  Table table = read_table(measured.file, wanted, measured.decimal);
  const auto refuse = [&](std::size_t row, const Column& column, std::string expected, std::string found,
                          std::string remedy) {
    throw InputError({.file = table.source,
                      .line = table.line_of(row),
                      .field = fmt::format("column {}", in_quotes(column.name)),
                      .expected = std::move(expected),
                      .found = std::move(found),
                      .remedy = std::move(remedy)});
  };
  const Column& stage = table.columns.front();
  const double span = span_of(input);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double position = stage.values[row];
    if (position < 0)
      refuse(row, stage, "a stage position of at least 0, the point of contact", readable_length(input, position),
             "count the stage from where it touches the specimen, and leave out the rows before");
    if (!(position <= farthest_reduced * span))
      refuse(row, stage, fmt::format("a stage position within {:g} spans", farthest_reduced),
             readable_length(input, position), "check its unit");
    if (!measured.time || row == 0) continue;
    const Column& time = table.columns[1];
    if (time.values[row] < time.values[row - 1])
      refuse(row, time,
             fmt::format("a time no earlier than in the previous row, {}",
                         readable(time.values[row - 1], kind_in(input, kind::time))),
             readable(time.values[row], kind_in(input, kind::time)), "sort the rows by time");
  }
  const auto farthest = std::max_element(stage.values.begin(), stage.values.end());
  if (!(*farthest >= nearest_reduced * span))
    refuse(static_cast<std::size_t>(farthest - stage.values.begin()), stage,
           fmt::format("a stage that moves to at least {:g} spans", nearest_reduced),
           readable_length(input, *farthest) + " as the farthest", "check the unit");
  const double reach = *farthest;
  return {std::move(table.columns.front().values), reach, true, true};
}

}  // namespace

StageProgramme programme_of(const Case& input) {
  if (!input.stage) throw missing(input, "stage");
  return std::visit([&](const auto& programme) { return programme_from(input, programme); }, input.stage->programme);
}

}  // namespace flexslip
