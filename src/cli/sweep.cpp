#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "answers/design_fields.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "design/design_result.h"
#include "design/sweep_parts.h"
#include "design/sweep_plan.h"
#include "design/sweep_run.h"
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

// The path as it is.
// Fails:      InputError if it is empty or standard output.
std::string file_to_write(const std::string& path) {
  if (!path.empty() && path != "-") return path;
  throw InputError({.field = "--output",
                    .expected = "a file, as HDF5 cannot be written to standard output",
                    .found = in_quotes(path),
                    .remedy = "pass --output FILE"});
}

// Announces the file (CallFiles), before anything is read.
void announce_sweep(const std::string& path) {
  files_of_this_call().writes(path, "--output");
  files_of_this_call().writes(UnfinishedFile::name_for(path), "--output");
}

// Joins the parts in a file, and says what came of it on standard output. The file is safe on the disk when this returns.
// Fails:      InputError if the file cannot be written; CalculationFailed, naming the parts, if some are missing or damaged.
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

// A file name as sbatch reads it in quotes: % begins what it replaces, and a quote would end it.
std::string sbatch_name(const std::string& path) {
  if (path.find_first_of("\"\\\n") != std::string::npos)
    throw InputError(
        {.field = "--output",
         .expected = "a path without double quotes, backslashes and line breaks, as sbatch does not read them",
         .found = in_quotes(path),
         .remedy = "pass another --output"});
  std::string name;
  for (const char c : path) name += c == '%' ? "%%" : std::string(1, c);
  return name;
}

std::string time_in_words(double minutes) {
  return minutes < 1 ? "less than a minute" : fmt::format("about {:.0f} minutes", minutes);
}

// A commented script that submits itself, as an array of jobs of Slurm, and the merge after it.
constexpr std::string_view script = R"script(#!/bin/bash
# A sweep of FlexSlip as an array of jobs, each {minutes} on {threads} threads.
#
#   bash THIS_FILE      submits the array, and a job after it that joins the parts
#   sbatch THIS_FILE    submits the array alone
#
# Whatever ends a job, running this again computes only what is missing.
#
#SBATCH --job-name={job}
#SBATCH --array=1-{shards}
#SBATCH --cpus-per-task={threads}
#SBATCH --time={time:.0f}   # minutes
#SBATCH --output="{log}"
#SBATCH --open-mode=append
# As your cluster wants it; "##" leaves a line out. A job needs little memory, however large the sweep.
##SBATCH --mem=1G
##SBATCH --partition=NAME
##SBATCH --account=NAME
# module load hdf5   # where the nodes have their libraries as modules

FLEXSLIP={program}   # as the compute nodes see it
CASE={case_file}
CHANGES=({changes})
OUTPUT={output}

if [[ ${{1:-}} == merge ]]; then exec "$FLEXSLIP" merge "$OUTPUT.parts" --output "$OUTPUT"; fi

# Outside of the array: submit it, and the merge when all its jobs have ended, with the same options. afterany, not afterok: if a
# job failed, the merge writes no file, but says in the log which parts are missing and how to compute them.
if [[ -z ${{SLURM_ARRAY_TASK_ID:-}} ]]; then
  set -euo pipefail
  array=$(sbatch --parsable "$0")
  array=${{array%%;*}}   # without the name of the cluster
  merge=$(sbatch --parsable --dependency="afterany:$array" --array=0 --cpus-per-task=1 "$0" merge)
  echo "array job $array, merge job ${{merge%%;*}}; watch them with: squeue --me"
  exit
fi

exec "$FLEXSLIP" sweep "$CASE" "${{CHANGES[@]}}" --output "$OUTPUT" --shard "$SLURM_ARRAY_TASK_ID/{shards}" --threads "$SLURM_CPUS_PER_TASK"
)script";

struct SweepRequest {
  CaseRequest test;
  std::optional<std::string> path;
  unsigned threads = 1;
  std::string shard;
  bool keep_parts = false;
  std::string slurm;
  double minutes = 10;
  std::optional<std::uint64_t> shards;
  Output output;
};

std::string file_of(const SweepRequest& request) {
  if (request.path) return file_to_write(*request.path);
  if (request.test.file == "-")
    throw InputError({.field = "--output",
                      .expected = "the file to write, as a case on standard input has no name",
                      .found = "none",
                      .remedy = "pass --output FILE"});
  return std::filesystem::path(request.test.file).filename().replace_extension(".h5").string();
}

Shard shard_of(const SweepRequest& request) {
  Shard shard;
  if (request.shard.empty()) return shard;
  const char* const end = request.shard.data() + request.shard.size();
  const auto index = std::from_chars(request.shard.data(), end, shard.index);
  const bool has_count = index.ec == std::errc{} && index.ptr != end && *index.ptr == '/';
  const auto count = has_count ? std::from_chars(index.ptr + 1, end, shard.count) : index;
  if (!has_count || count.ec != std::errc{} || count.ptr != end || shard.index < 1 || shard.index > shard.count)
    throw InputError({.field = "--shard",
                      .expected = "I/N, the I-th of N shards, counted from 1",
                      .found = in_quotes(request.shard)});
  return shard;
}

std::string absolute(const std::string& path) { return std::filesystem::absolute(path).lexically_normal().string(); }

// Fails:      InputError if jobs could not read the case, or sbatch the name of the output.
void write_slurm_script(const SweepRequest& request, const SweepPlan& plan, const std::string& path) {
  constexpr double max_jobs = 1000;  // Slurm's usual limit on an array
  constexpr double safety = 3;       // nodes differ, and so do the designs of a sweep
  constexpr double min_minutes = 5;  // for starting up
  if (request.test.file == "-")
    throw InputError({.field = "--slurm", .expected = "a case file that the jobs can read", .found = "standard input"});
  const double minutes = seconds_of_design(plan, RowComputer(plan)) * static_cast<double>(plan.rows) / 60 /
                         static_cast<double>(request.threads);
  const double wanted = std::clamp(std::ceil(minutes / request.minutes), 1.0, max_jobs);
  const std::uint64_t shards = std::min(request.shards.value_or(static_cast<std::uint64_t>(wanted)), chunks_of(plan));
  const double minutes_a_job = minutes / static_cast<double>(shards);
  const std::string output = absolute(path);
  std::string changes;
  for (const std::string& change : request.test.changes)
    changes += fmt::format("{}--set {}", changes.empty() ? "" : " ", shell_word(change));
  write_text(request.slurm,
             fmt::format(script, fmt::arg("minutes", time_in_words(minutes_a_job)),
                         fmt::arg("threads", request.threads), fmt::arg("shards", shards),
                         fmt::arg("job", shell_word(std::filesystem::path(output).filename().string())),
                         fmt::arg("time", std::ceil(safety * minutes_a_job + min_minutes)),
                         fmt::arg("log", sbatch_name(output + ".log")),
                         fmt::arg("program", shell_word(std::filesystem::read_symlink("/proc/self/exe").string())),
                         fmt::arg("case_file", shell_word(absolute(request.test.file))), fmt::arg("changes", changes),
                         fmt::arg("output", shell_word(output))));
  note(request.output,
       fmt::format("jobs: {}, for {:.2g} core hours of designs. To submit them, and the merge: bash {}", shards,
                   minutes * static_cast<double>(request.threads) / 60, shell_word(request.slurm)));
  if (minutes < 1)
    note(request.output, fmt::format("without a cluster, about {:.0f} s on {} threads of a machine like this",
                                     std::ceil(60 * minutes), request.threads));
}

SweepRun compute(const SweepRequest& request, const SweepParts& parts, const Shard& shard) {
  const WhileInterruptible guard;
  return run_sweep(parts, RowComputer(parts.plan()),
                   {.threads = request.threads,
                    .shard = shard,
                    .stop = &interrupted(),
                    .progress = progress_of("designs", request.output)});
}

void report_shard(const SweepRequest& request, const SweepParts& parts, const Shard& shard, const SweepRun& run) {
  const std::string folder = parts.folder().string();
  if (request.output.json)
    write_json(
        "-", sweep_fields()({.status = "done",
                             .shard = ToldShard{folder, {shard.index, shard.count}, run.rows_found, run.rows_computed}},
                            {}));
  else
    write_text("-", fmt::format("shard {} of {}: {} designs in {}; flexslip merge joins all shards\n", shard.index,
                                shard.count, run.rows_found + run.rows_computed, folder));
}

// A merge may have been stopped before it had removed all parts; but a whole set of them is nobody's remainder.
void report_done(const SweepRequest& request, const SweepPlan& plan, const std::string& path) {
  const std::string folder = parts_folder_of(path);
  note(request.output, fmt::format("{} is complete already", path));
  if (request.output.json) write_json("-", sweep_fields()({.status = "done", .file = path, .rows = plan.rows}, {}));
  if (!SweepParts::are_in(folder)) return;
  const SweepParts parts(folder, plan);
  if (!parts.are_all_there())
    parts.remove_all();
  else if (!request.keep_parts)
    note(request.output, fmt::format("its parts are still in {}; remove them if you do not need them", folder));
}

void run_sweep_command(const SweepRequest& request) {
  const Shard shard = shard_of(request);
  const std::string path = file_of(request);
  announce_sweep(path);
  const SweepPlan plan = read_sweep(request.test.file, request.test.changes);
  const std::string digest = digest_of_sweep(plan);
  const bool is_done = finds_sweep(path, digest);
  if (!is_done) require_space(plan, path, shard);
  if (!request.slurm.empty()) return write_slurm_script(request, plan, path);
  if (is_done) return report_done(request, plan, path);
  const SweepParts parts(parts_folder_of(path), plan);
  const SweepRun run = compute(request, parts, shard);
  for (const std::uint64_t chunk : run.damaged)
    note(request.output, fmt::format("{} is damaged and is computed again", parts.file_of(chunk).string()));
  if (run.rows_found > 0)
    note(request.output, fmt::format("{} of {} designs were computed by an earlier run", run.rows_found, plan.rows));
  if (run.status == SweepStatus::stopped)
    throw Interrupted(fmt::format("interrupted; {} designs are kept in {}, and the same command continues from there",
                                  run.rows_found + run.rows_computed, parts.folder().string()));
  if (!request.shard.empty()) return report_shard(request, parts, shard, run);
  if (finds_sweep(path, digest)) return report_done(request, plan, path);  // another run beside this was faster
  join_parts({&parts, 1}, path, request.output);
  if (!request.keep_parts) parts.remove_all();
}

}  // namespace

void add_sweep_command(CLI::App& app) {
  const auto [command, request] =
      add_command(app, "sweep", "Thousands of designs of a test, on a grid or as a sample, in HDF5", run_sweep_command);
  add_case(command, request.test, "Case file with a section [sweep]; - is standard input");
  add_option(command, "-o,--output FILE", request.path, "HDF5 file to write")->default_str("the case's name with .h5");
  add_threads_option(command, "-j,--threads NUMBER", request.threads, "Number of designs computed at the same time");
  CLI::Option* shard =
      add_option(command, "--shard I/N", request.shard, "Compute only the I-th of N shards; flexslip merge joins them");
  command.add_flag("--keep-parts", request.keep_parts, "Keep the parts after they are joined");
  CLI::Option* slurm = add_output_file(command, "--slurm", request.slurm,
                                       "Write a script for an array of Slurm jobs, and compute nothing yet");
  slurm->excludes(shard);
  add_option(command, "--minutes NUMBER", request.minutes, "With --slurm, approximate duration of a job")
      ->check(CLI::Range(0.1, 1e5).description(""))
      ->capture_default_str()
      ->needs(slurm);
  add_option(command, "--shards N", request.shards, "With --slurm, number of jobs")
      ->check(CLI::PositiveNumber.description(""))
      ->needs(slurm);
  add_output_flags(command, request.output, "Report the outcome in JSON");
  command.footer(
      "The section [sweep] names the numbers of the case that vary:\n"
      "  [sweep]\n"
      "  method = \"grid\"          # or \"latin hypercube\", with samples = N and seed = N, and axes without points\n"
      "  [sweep.axes]\n"
      "  stiffness = { from = \"10 N/m\", to = \"1 kN/m\", points = 50, spacing = \"log\" }\n"
      "  mu0 = [0.3, 0.4, 0.5]\n"
      "Axes: mu0, amplitude, wavelength, phase, span, diameter, height, width, modulus, stiffness, travel, step,\n"
      "reference and pin_friction.\n\n"
      "Results are kept in FILE.parts until all are joined in FILE. If a sweep is stopped, the same command continues\n"
      "where it stopped. The file is identical for any number of threads and shards.\n\n"
      "Examples:\n"
      "  flexslip sweep map.toml\n"
      "  flexslip sweep map.toml --slurm map.slurm && bash map.slurm\n"
      "  parallel flexslip sweep map.toml --threads 1 --shard {}/8 ::: $(seq 8) && flexslip merge map.h5.parts");
}

namespace {

struct MergeRequest {
  std::vector<std::string> folders;
  std::optional<std::string> path;
  bool keep_parts = false;
  Output output;
};

std::string file_of(const MergeRequest& request) {
  if (request.path) return file_to_write(*request.path);
  std::filesystem::path folder = std::filesystem::path(request.folders.front()).lexically_normal();
  if (std::filesystem::is_regular_file(folder))
    throw InputError({.file = folder.string(),
                      .expected = "a folder of parts, as flexslip sweep makes it beside its output",
                      .found = "a file",
                      .remedy = fmt::format("pass {}.parts", folder.string())});
  if (!folder.has_filename()) folder = folder.parent_path();  // "map.h5.parts/"
  if (folder.extension() != ".parts")
    throw InputError({.field = "--output",
                      .expected = "the file to write",
                      .found = fmt::format("none, and {} does not end in .parts", in_quotes(folder.string())),
                      .remedy = "pass --output FILE"});
  return folder.replace_extension().string();
}

void run_merge(const MergeRequest& request) {
  const std::string path = file_of(request);
  announce_sweep(path);
  // A job that is run again after its work was done. Which sweep the folder held is not known any more.
  const auto is_there = [](const std::string& folder) { return std::filesystem::exists(folder); };
  const bool is_gone = std::none_of(request.folders.begin(), request.folders.end(), is_there);
  if (is_gone && digest_of_sweep_file(path)) {
    note(request.output,
         fmt::format("{} does not exist, but {} does, the file of a sweep", request.folders.front(), path));
    if (request.output.json) write_json("-", sweep_fields()({.status = "done", .file = path}, {}));
    return;
  }
  for (const std::string& folder : request.folders) {
    std::error_code absent;
    const auto there = std::filesystem::absolute(path).parent_path();
    if (is_there(folder) && std::filesystem::equivalent(there, folder, absent))
      throw InputError({.field = "--output",
                        .expected = "a file outside the folder of parts",
                        .found = in_quotes(path) + " inside it",
                        .remedy = "pass another --output: the parts are removed once they are joined"});
  }

  std::vector<SweepParts> folders;
  folders.reserve(request.folders.size());
  for (const std::string& folder : request.folders) {
    folders.emplace_back(folder);
    if (folders.back().digest() != folders.front().digest())
      throw InputError({.file = folder,
                        .expected = fmt::format("parts of the same sweep as in {}", request.folders.front()),
                        .found = "those of another one",
                        .remedy = "leave it out"});
  }
  if (finds_sweep(path, folders.front().digest())) note(request.output, fmt::format("{} is replaced", path));
  join_parts(folders, path, request.output);
  if (!request.keep_parts)
    for (const SweepParts& parts : folders) parts.remove_all();
}

}  // namespace

void add_merge_command(CLI::App& app) {
  const auto [command, request] =
      add_command(app, "merge", "Join the parts of a sweep in one file when all shards are computed", run_merge);
  add_option(command, "folders FOLDER", request.folders,
             "Folder of parts, FILE.parts; several if shards were computed in different places")
      ->required();
  add_option(command, "-o,--output FILE", request.path, "HDF5 file to write")
      ->default_str("the first folder without .parts");
  command.add_flag("--keep-parts", request.keep_parts, "Keep the parts after they are joined");
  add_output_flags(command, request.output, "Report the outcome in JSON");
  command.footer(
      "If parts are missing or damaged, no file is written and the exit code is 1. Those parts are listed with their\n"
      "rows and with the call that computes only them. The parts are removed when the file is complete and safe on "
      "the\n"
      "disk, so nothing is lost if the merge is stopped.\n\n"
      "Examples:\n"
      "  flexslip merge map.h5.parts\n"
      "  flexslip merge here/map.h5.parts there/map.h5.parts --output map.h5");
}

}  // namespace flexslip
