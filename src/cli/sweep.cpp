#include "design/sweep.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "answers/design_fields.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "design/design_result.h"
#include "io/input_error.h"
#include "io/table.h"
#include "numerics/effort.h"
#include "result/table.h"

namespace flexslip {
namespace {

struct SweepRequest {
  CaseRequest test;
  std::string rows;
  unsigned threads = 1;
  Output output;
};

// The rows of --rows, counted from 1, both included; by default all rows.
RowSpan rows_of(const std::string& text, const SweepPlan& plan) {
  if (text.empty()) return {0, plan.rows};
  std::uint64_t first = 0, last = 0;
  const char* const end = text.data() + text.size();
  const auto until_colon = std::from_chars(text.data(), end, first);
  const bool has_colon = until_colon.ec == std::errc{} && until_colon.ptr != end && *until_colon.ptr == ':';
  const auto until_end = has_colon ? std::from_chars(until_colon.ptr + 1, end, last) : until_colon;
  if (!has_colon || until_end.ec != std::errc{} || until_end.ptr != end || first < 1 || last < first)
    throw InputError({.field = "--rows",
                      .problem = fmt::format("{} is not FIRST:LAST, two rows counted from 1", in_quotes(text)),
                      .remedy = "write it as \"1:1000\""});
  if (first > plan.rows)
    throw InputError(
        {.field = "--rows", .problem = fmt::format("The first row is {}, but the sweep has {}", first, plan.rows)});
  return {first - 1, std::min(last, plan.rows) - first + 1};
}

// The designs of some rows, computed in blocks.
class DesignsInOrder {
 public:
  DesignsInOrder(const SweepPlan& plan, RowSpan rows, const SweepRequest& request)
      : plan_(plan),
        rows_(rows),
        threads_(request.threads),
        fields_(point_fields(plan.axes)),
        progress_(progress_of("designs", request.output)) {}

  std::vector<std::string> titles() const {
    return titles_of(columns_of(fields_.descriptions(), plan_.loading.reduced));
  }

  // The cells of the next design; false after the last one.
  // Fails:      Stopped if the program is interrupted.
  bool next(std::vector<Cell>& cells) {
    if (at_ == block_.size() && !compute_block()) return false;
    const DesignPoint& point = block_[at_++];
    ++counts_.at(static_cast<std::size_t>(point.result.status));
    cells = cells_of(fields_, point, {});
    return true;
  }

  // "6000 designs: 5990 ok, 10 impossible"
  std::string summary() const {
    std::string text;
    for (std::size_t i = 0; i < counts_.size(); ++i)
      if (counts_[i] > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts_[i], result_status_words[i]);
    return fmt::format("{} designs: {}", done_, text);
  }

 private:
  bool compute_block() {
    constexpr std::uint64_t rows_of_thread = 256;  // [1] 50 ms of work: threads wait for less than 1 % of the time
    const std::uint64_t count = std::min(rows_.count - done_, rows_of_thread * threads_);
    if (count == 0) return false;
    block_ = points_of(plan_, {rows_.first + done_, count}, threads_);
    at_ = 0;
    done_ += count;
    if (progress_) progress_(done_, rows_.count);
    return true;
  }

  const SweepPlan& plan_;
  RowSpan rows_;
  unsigned threads_;
  Fields<DesignPoint> fields_;
  ProgressFunction progress_;
  std::vector<DesignPoint> block_{};
  std::size_t at_ = 0;  // in the block
  std::uint64_t done_ = 0;
  std::array<std::uint64_t, result_status_words.size()> counts_{};
};

void run_sweep(const SweepRequest& request) {
  const SweepPlan plan = read_sweep(request.test.file, request.test.changes);
  const RowSpan rows = rows_of(request.rows, plan);
  DesignsInOrder designs(plan, rows, request);
  try {
    const WhileInterruptible guard;
    const Stoppable stoppable(&interrupted());
    const auto next = [&](std::vector<Cell>& cells) { return designs.next(cells); };
    write_table(request.output.path, designs.titles(), next, request.output.csv);
  } catch (const Stopped&) {
    throw Interrupted(request.output.path == "-" ? "interrupted"
                                                 : fmt::format("interrupted; {} is not written", request.output.path));
  }
  note(request.output, designs.summary());
}

}  // namespace

void add_sweep_command(CLI::App& app) {
  const auto [command, request] =
      add_command(app, "sweep", "Thousands of designs of a test, on a grid or as a sample, as a table", run_sweep);
  add_case(command, request.test, "Case file with a section [sweep]; - is standard input");
  add_option(command, "--rows FIRST:LAST", request.rows,
             "Compute only these rows, counted from 1 and both included; LAST may be beyond the last one");
  add_threads_option(command, "-j,--threads NUMBER", request.threads, "Number of designs computed at the same time");
  add_output_option(command, request.output.path);
  add_csv_option(command, request.output);
  add_quiet_flag(command, request.output);
  command.footer(
      "The section [sweep] names the numbers of the case that vary:\n"
      "  [sweep]\n"
      "  method = \"grid\"          # or \"latin hypercube\", with samples = N and seed = N, and axes without points\n"
      "  [sweep.axes]\n"
      "  stiffness = { from = \"10 N/m\", to = \"1 kN/m\", points = 50, spacing = \"log\" }\n"
      "  mu0 = [0.3, 0.4, 0.5]\n"
      "Axes: mu0, amplitude, wavelength, phase, span, diameter, height, width, modulus, stiffness, travel, step,\n"
      "reference and pin_friction.\n\n"
      "Writes a CSV with a row for each design. A row is the same to the byte for any --rows and any number of "
      "threads.\n"
      "A file is there whole or not at all.\n\n"
      "Examples:\n"
      "  flexslip sweep map.toml --output map.csv\n"
      "  flexslip sweep map.toml --rows 1:1000 --output part-1.csv");
}

}  // namespace flexslip
