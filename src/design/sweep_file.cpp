#include "design/sweep_file.h"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "design/design_result.h"
#include "design/sweep_row.h"
#include "io/durable_file.h"
#include "io/hdf5.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

constexpr const char* digest_name = "plan";

void describe_axis(Hdf5File& file, const SweepPlan& plan, std::size_t i, const SweepColumn& column) {
  const DesignAxis& axis = plan.axes[i];
  if (const auto* range = std::get_if<AxisRange>(&axis.values)) {
    file.describe(column.path, "from", range->from);
    file.describe(column.path, "to", range->to);
    file.describe(column.path, "spacing", range->spacing == Spacing::linear ? "linear" : "log");
  }
  if (std::holds_alternative<LatinHypercube>(plan.method)) return;
  const std::vector<double> values = values_of(axis);
  const std::string path = fmt::format("/axes/{}", axis.parameter.name);
  file.add_column(path, values.size(), StoredAs::float64);
  file.describe(path, "units", column.units);
  file.describe(path, "description", "the values of this axis of the grid");
  file.write_rows(path, 0, values);
}

void describe_method(Hdf5File& file, const SweepPlan& plan) {
  std::vector<std::string> names;
  for (const DesignAxis& axis : plan.axes) names.emplace_back(axis.parameter.name);
  file.describe("/", "axes", names);
  if (const auto* hypercube = std::get_if<LatinHypercube>(&plan.method)) {
    file.describe("/", "method", "latin hypercube");
    file.describe("/", "seed", hypercube->seed);
    return;
  }
  file.describe("/", "method", "grid");
  file.describe("/", "shape", shape_of(plan));  // the last axis changes fastest
  file.add_group("/axes");
}

// All but the numbers of the columns.
void describe(Hdf5File& file, const SweepParts& parts, const std::vector<SweepColumn>& columns) {
  const SweepPlan& plan = parts.plan();
  file.describe("/", "title", "A sweep of bending tests, each row one design");
  file.describe("/", "program", "FlexSlip " FLEXSLIP_VERSION);
  file.describe("/", digest_name, parts.digest());
  file.describe("/", "case", plan.text);
  if (!plan.changes.empty()) file.describe("/", "changes", plan.changes);
  file.describe("/", "variables", plan.input.reduced ? "reduced: lengths in spans L, forces in EI/L^2" : "SI");
  file.describe("/", "rows", plan.rows);
  describe_method(file, plan);
  file.add_group("/inputs");
  file.add_group("/outcomes");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    file.add_column(columns[i].path, plan.rows, columns[i].stored_as);
    file.describe(columns[i].path, "units", columns[i].units);
    file.describe(columns[i].path, "description", columns[i].description);
    if (i < plan.axes.size()) describe_axis(file, plan, i, columns[i]);
  }
  const std::vector<std::string> words{result_status_words.begin(), result_status_words.end()};
  file.describe(columns[status_column(plan)].path, "meanings", words);
}

struct FoundPart {
  Part part;
  std::string file;
};

// The first folder with a whole part has it; else one with a damaged part is told of.
FoundPart find_part(std::span<const SweepParts> folders, std::uint64_t chunk) {
  FoundPart found{{PartState::missing, {}}, folders.front().file_of(chunk).string()};
  for (const SweepParts& parts : folders) {
    Part part = parts.read(chunk);
    if (part.state == PartState::missing) continue;
    const bool is_whole = part.state == PartState::whole;
    found = {std::move(part), parts.file_of(chunk).string()};
    if (is_whole) break;
  }
  return found;
}

}  // namespace

SweepMerge merge_sweep(std::span<const SweepParts> folders, const std::string& path, const MergeOptions& options) {
  if (folders.empty()) throw std::invalid_argument("merge_sweep: no folder");
  for (const SweepParts& parts : folders)
    if (parts.digest() != folders.front().digest()) throw std::invalid_argument("merge_sweep: parts of two sweeps");
  const SweepPlan& plan = folders.front().plan();
  const std::vector<SweepColumn> columns = columns_of(plan);
  UnfinishedFile unfinished(path);
  Hdf5File file(unfinished.name().string());
  describe(file, folders.front(), columns);
  SweepMerge merge{MergeStatus::done, {}, std::vector<std::uint64_t>(result_status_words.size())};
  for (std::uint64_t chunk = 0; chunk < chunks_of(plan); ++chunk) {
    if (options.stop && *options.stop) return {MergeStatus::stopped, {}, {}};
    const FoundPart found = find_part(folders, chunk);
    if (found.part.state != PartState::whole) merge.faults.push_back({chunk, found.part.state, found.file});
    if (!merge.faults.empty()) continue;  // the others are only looked at
    const auto [first, count] = rows_of_chunk(plan, chunk);
    const std::span<const double> values(found.part.values);
    for (std::size_t i = 0; i < columns.size(); ++i)
      file.write_rows(columns[i].path, first, values.subspan(i * count, count));
    for (const double status : values.subspan(status_column(plan) * count, count))
      ++merge.counts.at(static_cast<std::size_t>(status));
    if (options.progress) options.progress(first + count, plan.rows);
  }
  if (!merge.faults.empty()) return {MergeStatus::incomplete, std::move(merge.faults), {}};
  file.finish();
  unfinished.finish();
  return merge;
}

std::optional<std::string> digest_of_sweep_file(const std::string& path) { return hdf5_text(path, digest_name); }

bool finds_sweep(const std::string& path, const std::string& digest) {
  if (!std::filesystem::exists(path)) return false;
  const auto found = digest_of_sweep_file(path);
  if (found == digest) return true;
  throw InputError({.file = path,
                    .expected = "no file, or the file of this sweep",
                    .found = found ? "the file of another sweep or another version" : "another file",
                    .remedy = "pass another --output, or remove it"});
}

double bytes_of_sweep_file(const SweepPlan& plan) {
  constexpr double of_row = 8;            // [bytes] a column; it may not be compressible
  constexpr double of_description = 1e5;  // [bytes] of the file, beside the text and the axes
  double bytes = of_description + static_cast<double>(plan.text.size());
  for (const std::uint64_t points : shape_of(plan)) bytes += of_row * static_cast<double>(points);
  return bytes + of_row * static_cast<double>(columns_of(plan).size()) * static_cast<double>(plan.rows);
}

}  // namespace flexslip
