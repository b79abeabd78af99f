#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <fmt/format.h>

#include "answers/sweep_fields.h"
#include "cli/case_flags.h"
#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/progress.h"
#include "cli/shell_word.h"
#include "cli/slurm_script.h"
#include "cli/sweep_output.h"
#include "design/sweep_parts.h"
#include "design/sweep_plan.h"
#include "design/sweep_run.h"
#include "io/input_error.h"
#include "io/text_file.h"

namespace flexslip {
namespace {

struct SweepRequest {
  std::string file;
  std::vector<std::string> changes;
  std::optional<std::string> path;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::string shard;
  bool keep_parts = false;
  std::string slurm;
  double minutes = 10;
  std::optional<std::uint64_t> shards;
  Output output;
};

std::string file_of(const SweepRequest& request) {
  if (request.path) return file_to_write(*request.path);
  if (request.file == "-")
    throw InputError({.field = "--output",
                      .expected = "the file to write, as a case on standard input has no name",
                      .found = "none",
                      .remedy = "pass --output FILE"});
  return std::filesystem::path(request.file).filename().replace_extension(".h5").string();
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

void write_slurm_script(const SweepRequest& request, const SweepPlan& plan, const std::string& path) {
  constexpr double most_jobs = 1000;  // Slurm's usual limit on an array
  if (request.file == "-")
    throw InputError({.field = "--slurm", .expected = "a case file that the jobs can read", .found = "standard input"});
  const double minutes = seconds_of_design(plan, RowComputer(plan)) * static_cast<double>(plan.rows) / 60 /
                         static_cast<double>(request.threads);
  const double wanted = std::clamp(std::ceil(minutes / request.minutes), 1.0, most_jobs);
  const std::uint64_t shards = std::min(request.shards.value_or(static_cast<std::uint64_t>(wanted)), chunks_of(plan));
  write_text(request.slurm, slurm_script({.program = std::filesystem::read_symlink("/proc/self/exe").string(),
                                          .case_file = absolute(request.file),
                                          .output = absolute(path),
                                          .changes = request.changes,
                                          .shards = shards,
                                          .threads = request.threads,
                                          .minutes = minutes / static_cast<double>(shards)}));
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
  const SweepPlan plan = read_sweep(request.file, request.changes);
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
  const auto request = std::make_shared<SweepRequest>();
  CLI::App* command = app.add_subcommand("sweep", "Thousands of designs of a test, on a grid or as a sample, in HDF5");
  command->add_option("case", request->file, "Case file with a section [sweep]; - is standard input")
      ->type_name("CASE")
      ->required();
  add_set_option(*command, request->changes);
  command->add_option("-o,--output", request->path, "HDF5 file to write")
      ->type_name("FILE")
      ->default_str("the case's name with .h5");
  command->add_option("-j,--threads", request->threads, "Number of designs computed at the same time")
      ->type_name("NUMBER")
      ->check(CLI::Range(1U, 1024U))
      ->default_str("the number of cores");
  CLI::Option* shard =
      command->add_option("--shard", request->shard, "Compute only the I-th of N shards; flexslip merge joins them")
          ->type_name("I/N");
  command->add_flag("--keep-parts", request->keep_parts, "Keep the parts after they are joined");
  CLI::Option* slurm = add_output_file(*command, "--slurm", request->slurm,
                                       "Write a script for an array of Slurm jobs, and compute nothing yet");
  slurm->excludes(shard);
  command->add_option("--minutes", request->minutes, "With --slurm, approximate duration of a job")
      ->type_name("NUMBER")
      ->check(CLI::Range(0.1, 1e5).description(""))
      ->capture_default_str()
      ->needs(slurm);
  command->add_option("--shards", request->shards, "With --slurm, number of jobs")
      ->type_name("N")
      ->check(CLI::PositiveNumber.description(""))
      ->needs(slurm);
  command->add_flag("--json", request->output.json, "Report the outcome in JSON");
  command->add_flag("--quiet", request->output.quiet, "No remarks on standard error, only errors");
  command->footer(
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
  command->callback([request] { run_sweep_command(*request); });
}

}  // namespace flexslip
