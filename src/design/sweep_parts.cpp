#include "design/sweep_parts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "design/design_result.h"
#include "design/sweep_plan.h"
#include "io/durable_file.h"
#include "io/hdf5.h"
#include "io/input_error.h"
#include "io/sha256.h"
#include "io/text_file.h"
#include "result/json.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "parts may be read on another computer");

constexpr int layout_of_parts = 1;  // of the folder and its parts: another one is not read
constexpr const char* plan_name = "sweep.json";
constexpr std::string_view part_prefix = "part-";
constexpr std::size_t checksum_size = 64;  // [bytes]

[[noreturn]] void refuse(const fs::path& folder, std::string found, std::string remedy) {
  throw InputError({.file = folder.string(),
                    .expected = "the parts of this sweep",
                    .found = std::move(found),
                    .remedy = std::move(remedy)});
}

// What the folder says it is for; none if it says nothing.
struct Label {
  std::string version, digest, source, text;
  std::vector<std::string> changes;
};

std::optional<Label> read_label(const fs::path& folder) {
  std::ifstream in(folder / plan_name, std::ios::binary);
  if (!in) return std::nullopt;
  try {
    const Json json = Json::parse(in);
    if (json.at("layout") != layout_of_parts)
      refuse(folder, "those of another version of FlexSlip", "continue with that version, or remove the folder");
    return Label{json.at("version").get<std::string>(), json.at("digest").get<std::string>(),
                 json.at("source").get<std::string>(), json.at("text").get<std::string>(),
                 json.value("changes", std::vector<std::string>())};
  } catch (const Json::exception&) {
    refuse(folder, fmt::format("a damaged {}", plan_name), "remove the folder, and the sweep is computed anew");
  }
}

void write_label(const fs::path& folder, const SweepPlan& plan, const std::string& digest) {
  const Json json{{"layout", layout_of_parts}, {"program", "FlexSlip"},       {"version", FLEXSLIP_VERSION},
                  {"digest", digest},          {"source", plan.input.source}, {"text", plan.text},
                  {"changes", plan.changes}};
  write_text((folder / plan_name).string(), json.dump(1) + "\n");
}

Label label_of(const fs::path& folder) {
  auto label = read_label(folder);
  if (!label)
    throw InputError({.file = folder.string(),
                      .expected = "a folder of parts, as flexslip sweep makes it beside its output",
                      .found = fs::is_directory(folder) ? fmt::format("one without {}", plan_name) : "no such folder"});
  if (label->version != FLEXSLIP_VERSION)
    refuse(folder, fmt::format("those of FlexSlip {}, but this is {}", label->version, FLEXSLIP_VERSION),
           "join them with that version, or compute the sweep anew");
  return *std::move(label);
}

SweepPlan plan_of(const Label& label) { return read_sweep(label.text, label.source, label.changes); }

// "part-000001", also while it is being written.
bool is_part(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::size_t digits = std::min(name.find_first_not_of("0123456789", part_prefix.size()), name.size());
  return name.starts_with(part_prefix) && digits > part_prefix.size() && (digits == name.size() || is_unfinished(file));
}

// Is all that a folder holds a sweep's? Parts say themselves of which sweep they are.
bool holds_nothing_else(const fs::path& folder) {
  return std::all_of(fs::directory_iterator(folder), fs::directory_iterator(), [](const fs::directory_entry& entry) {
    return is_part(entry.path()) || entry.path().filename().string().starts_with(plan_name);
  });
}

}  // namespace

SweepParts::SweepParts(fs::path folder, const SweepPlan& plan)
    : folder_(std::move(folder)), plan_(plan), digest_(digest_of_sweep(plan)), columns_(columns_of(plan).size()) {
  // Only this folder is made, so that a path misspelt is told.
  std::error_code error;
  fs::create_directory(folder_, error);
  if (error) throw unwritable(folder_.string(), error.message());
  const bool is_foreign =
      !holds_nothing_else(folder_);  // asked before the label is read, which a run beside this writes before its parts
  const auto label = read_label(folder_);
  if (!label && is_foreign)
    throw InputError({.file = folder_.string(),
                      .expected = "a folder of parts, or none",
                      .found = fmt::format("one with other files in it and without {}", plan_name),
                      .remedy = "pass another --output"});
  if (!label) write_label(folder_, plan_, digest_);
  if (label && label->digest != digest_)
    refuse(folder_,
           label->version == FLEXSLIP_VERSION
               ? fmt::format("those of another one, of {} before it was changed", in_quotes(label->source))
               : fmt::format("those of FlexSlip {}", label->version),
           "pass another --output, or remove the folder if they are not needed");
}

SweepParts::SweepParts(fs::path folder)
    : folder_(std::move(folder)),
      plan_(plan_of(label_of(folder_))),
      digest_(label_of(folder_).digest),
      columns_(columns_of(plan_).size()) {
  if (digest_of_sweep(plan_) != digest_)
    refuse(folder_, fmt::format("a damaged {}, or parts from a program that computes other numbers", plan_name),
           "run flexslip sweep with the case and this --output");
}

bool SweepParts::are_in(const fs::path& folder) { return fs::exists(folder / plan_name); }

bool SweepParts::are_all_there() const {
  for (std::uint64_t chunk = 0; chunk < chunks_of(plan_); ++chunk)
    if (!fs::exists(file_of(chunk))) return false;
  return true;
}

fs::path SweepParts::file_of(std::uint64_t chunk) const {
  return folder_ / fmt::format("{}{:06}", part_prefix, chunk + 1);
}

std::string SweepParts::head_of(std::uint64_t chunk) const {
  const auto [first, count] = rows_of_chunk(plan_, chunk);
  return fmt::format("FlexSlip sweep {}\nplan {}\nrows {} to {}\ncolumns {}\n", layout_of_parts, digest_, first + 1,
                     first + count, columns_);
}

Part SweepParts::read(std::uint64_t chunk) const {
  std::ifstream in(file_of(chunk), std::ios::binary);
  if (!in) return {PartState::missing, {}};
  const std::string head = head_of(chunk);
  const std::size_t values = columns_ * rows_of_chunk(plan_, chunk).count;
  const std::size_t body = head.size() + values * sizeof(double);
  std::string bytes(body + checksum_size + 1, '\0');  // one more than there should be
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const auto got = static_cast<std::size_t>(in.gcount());
  const std::string_view all(bytes.data(), got);
  if (got != body + checksum_size || !all.starts_with(head) || all.substr(body) != sha256_of(all.substr(0, body)))
    return {PartState::damaged, {}};
  Part part{PartState::whole, std::vector<double>(values)};
  std::memcpy(part.values.data(), bytes.data() + head.size(), values * sizeof(double));
  return part;
}

void SweepParts::write(std::uint64_t chunk, std::span<const double> values) const {
  if (values.size() != columns_ * rows_of_chunk(plan_, chunk).count)
    throw std::invalid_argument(fmt::format("SweepParts::write: {} values", values.size()));
  std::string bytes = head_of(chunk);
  const std::size_t head = bytes.size();
  bytes.resize(head + values.size_bytes());
  std::memcpy(bytes.data() + head, values.data(), values.size_bytes());
  bytes += sha256_of(bytes);
  write_text(file_of(chunk).string(), bytes);
}

void SweepParts::remove(std::uint64_t chunk) const {
  std::error_code absent;
  fs::remove(file_of(chunk), absent);
}

void SweepParts::remove_all() const {
  std::vector<fs::path> ours;
  std::error_code error;
  for (auto file = fs::directory_iterator(folder_, error); !error && file != fs::directory_iterator();
       file.increment(error))
    if (is_part(file->path()) || is_unfinished(file->path())) ours.push_back(file->path());
  for (const fs::path& file : ours) fs::remove(file, error);
  fs::remove(folder_ / plan_name, error);  // last: without it, nobody would know what the others are
  fs::remove(folder_, error);
}

double bytes_of_parts(const SweepPlan& plan) {
  constexpr double block = 4096;  // [bytes] files take whole blocks
  constexpr double head = 256;    // [bytes] at most, with the checksum
  const auto of_rows = static_cast<double>(rows_in_chunk(plan) * columns_of(plan).size() * sizeof(double));
  return static_cast<double>(chunks_of(plan)) * block * std::ceil((of_rows + head) / block);
}

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
