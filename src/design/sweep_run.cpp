#include "design/sweep_run.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "design/sweep_parts.h"
#include "design/sweep_plan.h"
#include "io/input_error.h"
#include "io/parallel.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint64_t> chunks_of(const SweepPlan& plan, const Shard& shard) {
  if (shard.index < 1 || shard.index > shard.count)
    throw std::invalid_argument(fmt::format("no shard {} of {}", shard.index, shard.count));
  const std::uint64_t all = chunks_of(plan);
  const std::uint64_t step = std::min(shard.count, all);  // which does not overflow
  std::vector<std::uint64_t> chunks;
  chunks.reserve(all / step + 1);
  for (std::uint64_t chunk = shard.index - 1; chunk < all; chunk += step) chunks.push_back(chunk);
  return chunks;
}

struct ChunkState {
  std::uint64_t chunk;
  PartState state;
};

bool is_stopped(const SweepOptions& options) { return options.stop && *options.stop; }

// Of the chunks of a shard; if it is stopped, those not yet read are missing.
std::vector<ChunkState> states_of(const SweepParts& parts, const SweepOptions& options) {
  const auto chunks = chunks_of(parts.plan(), options.shard);
  std::vector<ChunkState> states;
  states.reserve(chunks.size());
  for (const std::uint64_t chunk : chunks) states.push_back({chunk, PartState::missing});
  for_each_index(states.size(), options.threads, [&](std::size_t i) {
    if (!is_stopped(options)) states[i].state = parts.read(states[i].chunk).state;
  });
  return states;
}

// Who wants to know of each row, and may stop the work. For any thread.
class RowsDone {
 public:
  RowsDone(const SweepOptions& options, std::uint64_t rows_to_do) : options_(options), rows_to_do_(rows_to_do) {}

  bool is_stopped() const { return flexslip::is_stopped(options_); }
  void count_row() {
    const std::uint64_t done = ++done_;
    if (options_.progress) options_.progress(done, rows_to_do_);
  }

 private:
  const SweepOptions& options_;
  std::uint64_t rows_to_do_;
  std::atomic<std::uint64_t> done_ = 0;
};

// What the part of a chunk holds; none if it was stopped.
std::optional<std::vector<double>> values_of_chunk(const SweepPlan& plan, std::uint64_t chunk,
                                                   const RowFunction& outcomes_of, RowsDone& done) {
  const auto [first, count] = rows_of_chunk(plan, chunk);
  const std::size_t inputs = plan.axes.size();
  std::vector<double> values(columns_of(plan).size() * count);
  for (std::uint64_t row = 0; row < count; ++row) {
    if (done.is_stopped()) return std::nullopt;
    const std::vector<double> of_input = inputs_of(plan, first + row);
    const std::vector<double> of_outcome = outcomes_of(of_input);
    for (std::size_t i = 0; i < of_input.size(); ++i) values[i * count + row] = of_input[i];
    for (std::size_t i = 0; i < of_outcome.size(); ++i) values.at((inputs + i) * count + row) = of_outcome[i];
    done.count_row();
  }
  return values;
}

// "1.4 TB", as disks are sold.
std::string readable_size(double bytes) {
  constexpr std::array units{"B", "kB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t i = 0;
  for (; bytes >= 1000 && i + 1 < units.size(); ++i) bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, units.at(i));
}

double size_of_files(const fs::path& folder) {
  double bytes = 0;
  std::error_code error;
  for (auto file = fs::directory_iterator(folder, error); !error && file != fs::directory_iterator();
       file.increment(error)) {
    std::error_code gone;
    const std::uintmax_t size = file->file_size(gone);
    if (!gone) bytes += static_cast<double>(size);
  }
  return bytes;
}

fs::path nearest_folder(fs::path path) {
  std::error_code error;
  path = fs::absolute(path, error);
  while (!fs::is_directory(path, error) && path.has_relative_path()) path = path.parent_path();
  return path;
}

}  // namespace

SweepRun run_sweep(const SweepParts& parts, const RowFunction& outcomes_of, const SweepOptions& options) {
  const SweepPlan& plan = parts.plan();
  SweepRun run{SweepStatus::done, 0, 0, {}};
  std::vector<std::uint64_t> to_do;
  std::uint64_t rows_to_do = 0;
  for (const auto& [chunk, state] : states_of(parts, options)) {
    const std::uint64_t rows = rows_of_chunk(plan, chunk).count;
    if (state == PartState::whole) {
      run.rows_found += rows;
      continue;
    }
    if (state == PartState::damaged) {
      parts.remove(chunk);
      run.damaged.push_back(chunk);
    }
    to_do.push_back(chunk);
    rows_to_do += rows;
  }

  RowsDone done(options, rows_to_do);
  std::atomic<std::uint64_t> rows_kept = 0;
  for_each_index(to_do.size(), options.threads, [&](std::size_t i) {
    if (done.is_stopped()) return;
    const auto values = values_of_chunk(plan, to_do[i], RowFunction(outcomes_of), done);
    if (!values) return;
    parts.write(to_do[i], *values);
    rows_kept += rows_of_chunk(plan, to_do[i]).count;
  });
  run.rows_computed = rows_kept;
  if (run.rows_computed < rows_to_do) run.status = SweepStatus::stopped;
  return run;
}

std::string parts_folder_of(const std::string& output) { return output + ".parts"; }

void require_space(const SweepPlan& plan, const std::string& output, const Shard& shard) {
  const double all_parts = bytes_of_parts(plan) / static_cast<double>(std::min(shard.count, chunks_of(plan)));
  const double of_parts = std::max(0.0, all_parts - size_of_files(parts_folder_of(output)));
  const double of_file = shard.count == 1 ? bytes_of_sweep_file(plan) : 0;  // shards are joined elsewhere, or later
  const fs::path folder = nearest_folder(output);
  const auto free = static_cast<double>(fs::space(folder).available);
  if (of_parts + of_file <= free) return;
  throw wrong_value(plan.input, "sweep", "a sweep that the disk has room for",
                    fmt::format("{} for {} designs ({} of parts, and at most {} of the file that joins them), "
                                "but {} free in {}",
                                readable_size(of_parts + of_file), plan.rows, readable_size(of_parts),
                                readable_size(of_file), readable_size(free), in_quotes(folder.string())),
                    "take fewer points, or an --output on a larger disk");
}

double seconds_of_design(const SweepPlan& plan, const RowFunction& outcomes_of) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::duration<double> long_enough(2.0);
  constexpr std::uint64_t most = 10'000;
  const std::uint64_t samples = std::min(plan.rows, most);
  const Clock::time_point start = Clock::now();
  std::uint64_t taken = 0;
  while (taken < samples && Clock::now() - start < long_enough)
    outcomes_of(inputs_of(plan, row_from_all_over(plan, taken++)));
  return std::chrono::duration<double>(Clock::now() - start).count() / static_cast<double>(taken);
}

}  // namespace flexslip
