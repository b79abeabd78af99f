#include "cli/sweep_output.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "answers/sweep_fields.h"
#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/progress.h"
#include "cli/shell_word.h"
#include "design/design_result.h"
#include "design/sweep_parts.h"
#include "design/sweep_plan.h"
#include "io/call_files.h"
#include "io/durable_file.h"
#include "io/input_error.h"
#include "io/text_file.h"

namespace flexslip {
namespace {

std::size_t count_of(const std::vector<PartFault>& faults, PartState state) {
  return static_cast<std::size_t>(
      std::count_if(faults.begin(), faults.end(), [&](const PartFault& fault) { return fault.state == state; }));
}

// The call that computes what is missing from a folder.
std::string remedy(const SweepParts& parts) {
  const std::string& source = parts.plan().input.source;
  std::filesystem::path output = parts.folder().lexically_normal();
  if (!output.has_filename()) output = output.parent_path();  // "map.h5.parts/"
  if (output.extension() == ".parts") output.replace_extension();
  return fmt::format("flexslip sweep {} --output {}", std::filesystem::exists(source) ? shell_word(source) : "CASE",
                     shell_word(output.string()));
}

std::string words_of(const SweepMerge& merge, const SweepParts& parts, const std::string& path) {
  const auto& faults = merge.faults;
  constexpr std::size_t most = 20;
  std::string text =
      fmt::format("{} is not written: of {} parts, {} are missing and {} are damaged\n", path, chunks_of(parts.plan()),
                  count_of(faults, PartState::missing), count_of(faults, PartState::damaged));
  const std::vector<ToldFault> told = faults_of(merge, parts.plan());
  for (std::size_t i = 0; i < std::min(told.size(), most); ++i)
    text += fmt::format("  {}, rows {} to {}: {}\n", told[i].file, told[i].first_row, told[i].last_row, told[i].state);
  if (faults.size() > most) text += fmt::format("  and {} more (--json lists all)\n", faults.size() - most);
  return text +
         fmt::format("To compute only these, and join all: {}\nIn jobs: the same with --shard I/N, for any I and N",
                     remedy(parts));
}

std::string words_of(const std::vector<std::uint64_t>& counts) {
  std::string text;
  const auto& words = result_status_words;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (counts[i] > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[i], words[i]);
  return text;
}

}  // namespace

std::string file_to_write(const std::string& path) {
  if (!path.empty() && path != "-") return path;
  throw InputError({.field = "--output",
                    .expected = "a file, as HDF5 cannot be written to standard output",
                    .found = in_quotes(path),
                    .remedy = "pass --output FILE"});
}

void announce_sweep(const std::string& path) {
  files_of_this_call().writes(path, "--output");
  files_of_this_call().writes(UnfinishedFile::name_for(path), "--output");
}

void join_parts(std::span<const SweepParts> folders, const std::string& path, const Output& output) {
  const SweepPlan& plan = folders.front().plan();
  const SweepMerge merge = [&] {
    const WhileInterruptible guard;
    return merge_sweep(folders, path, {.stop = &interrupted(), .progress = progress_of("designs joined", output)});
  }();
  if (merge.status == MergeStatus::stopped)
    throw Interrupted(fmt::format("interrupted; all parts are kept in {}, and the same command joins them",
                                  folders.front().folder().string()));
  const bool is_done = merge.status == MergeStatus::done;
  if (output.json)
    write_json("-", sweep_fields()({.status = is_done ? "done" : "incomplete",
                                    .file = path,
                                    .rows = plan.rows,
                                    .counts = is_done ? merge.counts : std::vector<std::uint64_t>(),
                                    .faults = faults_of(merge, plan)},
                                   {}));
  if (!is_done) throw CalculationFailed(words_of(merge, folders.front(), path));
  if (!output.json) write_text("-", fmt::format("{}: {} designs ({})\n", path, plan.rows, words_of(merge.counts)));
}

}  // namespace flexslip
