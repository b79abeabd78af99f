#include "io/call_files.h"

#include <algorithm>
#include <mutex>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "io/durable_file.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

// A folder without links and dots; it need not exist.
fs::path real(const fs::path& folder) {
  std::error_code error;
  fs::path path = fs::weakly_canonical(folder.empty() ? "." : folder, error);
  if (error) return folder;
  return path.has_filename() ? path : path.parent_path();  // "report/"
}

bool is_below(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

template <class Iterator>
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (auto entry = Iterator(folder, error); !error && entry != Iterator(); entry.increment(error))
    entries.push_back(entry->path());
  return entries;
}

[[noreturn]] void refuse(const std::string& options, std::string problem, std::string remedy) {
  throw OutputClash(InputError({.field = options, .problem = std::move(problem), .remedy = std::move(remedy)}).what());
}

}  // namespace

// `file` with links resolved.
bool CallFiles::covers(const Claim& claim, const fs::path& file) {
  if (claim.kind == Kind::all_below || claim.kind == Kind::no_input_below) return is_below(file, claim.folder);
  if (file.parent_path() != claim.folder) return false;
  const std::string name = file.filename().string();
  if (claim.kind == Kind::one) return name == claim.begin;
  return name.size() >= claim.begin.size() + claim.end.size() && name.starts_with(claim.begin) &&
         name.ends_with(claim.end);
}

// The file of a claim that is the same as this one.
std::optional<fs::path> CallFiles::same_in(const Claim& claim, const fs::path& file) {
  if (covers(claim, target_of(file))) return claim.kind == Kind::one ? claim.given : file;
  const auto identity = identity_of(file);
  if (!identity) return std::nullopt;
  const auto found = claim.there.find(*identity);
  return found == claim.there.end() ? std::nullopt : std::optional(found->second);
}

void CallFiles::add(Claim claim) {
  // Files in the folder may be links to other places; only the path decides whether an input lies
  // in it.
  std::vector<fs::path> entries;
  if (claim.kind == Kind::one) entries = {claim.given};
  if (claim.kind == Kind::alike) entries = entries_of<fs::directory_iterator>(claim.folder);
  if (claim.kind == Kind::all_below) entries = entries_of<fs::recursive_directory_iterator>(claim.folder);
  for (const fs::path& file : entries)
    if (const auto identity = identity_of(file); identity && (claim.kind == Kind::one || covers(claim, file)))
      claim.there.emplace(*identity, file);

  for (const Claim& other : claims_) {
    if (other.option == claim.option) continue;
    const Claim* one = &claim;
    const Claim* many = &other;
    if (one->kind != Kind::one) std::swap(one, many);
    if (one->kind != Kind::one || many->kind == Kind::no_input_below) continue;
    if (const auto same = same_in(*many, one->given))
      refuse(fmt::format("{} and {}", other.option, claim.option),
             *same == one->given ? in_quotes(same->string()) + " is named twice"
                                 : fmt::format("{} and {} are the same file", in_quotes(same->string()),
                                               in_quotes(one->given.string())),
             "pass another name (nothing has been written)");
  }
  claims_.push_back(std::move(claim));
}

void CallFiles::writes(const fs::path& file, const std::string& option) {
  std::error_code error;
  const fs::path target = target_of(file);
  if (is_descriptor(target) || (fs::exists(target, error) && !identity_of(target))) return;
  add({Kind::one, option, file, target.parent_path(), target.filename().string()});
}

void CallFiles::writes_like(const fs::path& folder, std::string begin, std::string end, const std::string& option) {
  add({Kind::alike, option, folder, real(folder), std::move(begin), std::move(end)});
}

void CallFiles::writes_below(const fs::path& folder, const std::string& option) {
  add({Kind::all_below, option, folder, real(folder)});
}

void CallFiles::keeps_inputs_out_of(const fs::path& folder, const std::string& option) {
  add({Kind::no_input_below, option, folder, real(folder)});
}

void CallFiles::reads(const fs::path& file) const {
  const fs::path path = file == "-" ? "/dev/stdin" : file;
  if (claims_.empty() || !identity_of(path)) return;
  for (const Claim& claim : claims_) {
    const auto same = same_in(claim, path);
    if (!same) continue;
    const bool is_one = claim.kind == Kind::one;
    const std::string input =
        "The input " +
        (*same == path ? in_quotes(path.string())
                       : fmt::format("{}, the same file as {},", in_quotes(same->string()), in_quotes(path.string())));
    refuse(claim.option,
           input + (is_one ? " would be overwritten"
                    : claim.kind == Kind::no_input_below
                        ? fmt::format(" lies in {}, where no input may lie", in_quotes(claim.given.string()))
                        : " could be overwritten"),
           fmt::format("pass another {} (nothing has been written)", is_one ? "name" : "name or folder"));
  }
}

CallFiles& files_of_this_call() {
  static CallFiles files;
  return files;
}

namespace {

struct CallsUnderWay {
  std::mutex mutex;
  std::vector<const CallFiles*> files;
};

CallsUnderWay& calls_under_way() {
  static CallsUnderWay calls;
  return calls;
}

}  // namespace

CallUnderWay::CallUnderWay(CallFiles files) : files_(std::move(files)) {
  CallsUnderWay& calls = calls_under_way();
  const std::scoped_lock lock(calls.mutex);
  calls.files.push_back(&files_);
}

CallUnderWay::~CallUnderWay() {
  CallsUnderWay& calls = calls_under_way();
  const std::scoped_lock lock(calls.mutex);
  std::erase(calls.files, &files_);
}

void announce_input(const fs::path& file) {
  files_of_this_call().reads(file);
  CallsUnderWay& calls = calls_under_way();
  const std::scoped_lock lock(calls.mutex);
  for (const CallFiles* files : calls.files) files->reads(file);
}

}  // namespace flexslip
