#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "answers/sweep_fields.h"
#include "cli/commands.h"
#include "cli/sweep_output.h"
#include "design/sweep_parts.h"
#include "io/input_error.h"

namespace flexslip {
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
  const auto request = std::make_shared<MergeRequest>();
  CLI::App* command = app.add_subcommand("merge", "Join the parts of a sweep in one file when all shards are computed");
  command
      ->add_option("folders", request->folders,
                   "Folder of parts, FILE.parts; several if shards were computed in different places")
      ->type_name("FOLDER")
      ->required();
  command->add_option("-o,--output", request->path, "HDF5 file to write")
      ->type_name("FILE")
      ->default_str("the first folder without .parts");
  command->add_flag("--keep-parts", request->keep_parts, "Keep the parts after they are joined");
  command->add_flag("--json", request->output.json, "Report the outcome in JSON");
  command->add_flag("--quiet", request->output.quiet, "No remarks on standard error, only errors");
  command->footer(
      "If parts are missing or damaged, no file is written and the exit code is 1. Those parts are listed with their\n"
      "rows and with the call that computes only them. The parts are removed when the file is complete and safe on "
      "the\n"
      "disk, so nothing is lost if the merge is stopped.\n\n"
      "Examples:\n"
      "  flexslip merge map.h5.parts\n"
      "  flexslip merge here/map.h5.parts there/map.h5.parts --output map.h5");
  command->callback([request] { run_merge(*request); });
}

}  // namespace flexslip
