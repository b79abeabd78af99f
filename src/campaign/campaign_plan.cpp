#include "campaign/campaign_plan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include "case/case_keys.h"
#include "case/fitted.h"
#include "case/mechanics.h"
#include "case/toml.h"
#include "io/quantity.h"
#include "io/sha256.h"
#include "io/table.h"
#include "io/text.h"
#include "io/text_file.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 9> data_endings{".csv", ".tsv", ".txt",  ".dat", ".asc",
                                                       ".tra", ".lvm", ".xlsx", ".xlsm"};

// Beginnings of titles in tables that FlexSlip writes and that are no records: fit --profile,
// --curves and --draws, and campaigns.
constexpr std::array<std::string_view, 5> titles_of_results{",drawn_in [", ",model_force [", ",deviation,draw_1",
                                                            "test,status,", "category,"};

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// Adds numbers to names that several tests share, so that their folders differ.
void make_names_unique(std::vector<PlannedTest>& tests) {
  std::map<std::string, std::size_t, std::less<>> used;
  for (const auto& test : tests) used[lower_case(folder_name(test.name))] = 0;
  for (auto& test : tests) {
    auto& count = used[lower_case(folder_name(test.name))];
    if (count++ == 0) continue;
    std::string numbered;
    do numbered = fmt::format("{}-{}", test.name, count++);
    while (used.contains(lower_case(folder_name(numbered))));
    used[lower_case(folder_name(numbered))] = 1;
    test.name = std::move(numbered);
  }
}

// ---- Cases from shared and individual settings

toml::table read_common(const std::optional<std::string>& path) {
  if (!path) return {};
  std::ostringstream text;
  text << open_to_read(*path)->rdbuf();
  toml::table common = parse_toml(text.str(), *path);
  // Paths in the common case are relative to it. Make them relative to the working directory.
  const fs::path folder = fs::absolute(*path).parent_path();
  for (const CaseKey& key : case_keys())
    if (auto* file = key.holds == Holds::file ? common[key.section][key.name].as_string() : nullptr)
      file->get() = (folder / file->get()).string();
  return common;
}

Test case_from(const toml::table& table, const std::string& source, const std::vector<std::string>& changes) {
  std::ostringstream text;
  text << toml::toml_formatter(table);
  return read_case(text.str(), source, changes);
}

// The key of a case file in the title of a column.
struct TableKey {
  std::string title;
  std::string section, key, part;  // part: "uncertainty", or empty
  std::string unit;                // of plain numbers in the column
};

// The section of a key named without one: record if it has the key, otherwise specimen or rig.
std::string section_of(std::string_view name) {
  for (const char* section : {"record", "specimen", "rig"})
    if (case_key(section, name)) return section;
  return "record";
}

TableKey key_named(const std::string& title, std::string name, const std::string& unit) {
  std::string part;
  for (const char between : {' ', '_', '.'}) {
    const std::string ending = between + std::string("uncertainty");
    if (!name.ends_with(ending)) continue;
    part = "uncertainty";
    name.erase(name.size() - ending.size());
  }
  if (const std::size_t dot = name.find('.'); dot != std::string::npos)
    return {title, name.substr(0, dot), name.substr(dot + 1), part, unit};
  return {title, section_of(name), name, part, unit};
}

bool is_known(const TableKey& key) { return case_key(key.section, key.key) != nullptr; }

// Parses "span [um]", "span (mm)", "span_m": units as in the titles of records.
TableKey key_of(const std::string& title) {
  const ColumnTitle column = parse_column_title(title);
  const TableKey key = key_named(title, column.name, column.unit);
  if (is_known(key) || !column.unit.empty()) return key;
  const std::size_t at = title.find_last_of("_(");
  if (at == std::string::npos || at == 0) return key;
  const std::string_view unit =
      without_brackets(trimmed(std::string_view(title).substr(title[at] == '(' ? at : at + 1)));
  if (!unit_named(unit)) return key;
  TableKey with_unit = key_named(title, std::string(trimmed(std::string_view(title).substr(0, at))), std::string(unit));
  return is_known(with_unit) ? with_unit : key;
}

std::optional<double> as_number(std::string_view cell) {
  double value = 0;
  const auto [end, error] = fast_float::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

std::optional<std::int64_t> as_whole_number(std::string_view cell) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

void set(toml::table& table, const std::string& key, const std::string& cell, const std::string& unit) {
  const auto number = as_number(cell);
  auto whole = as_whole_number(cell);
  constexpr double largest = 1e15;  // spreadsheets write a count as "267.0"
  if (number && !whole && *number == std::floor(*number) && std::abs(*number) < largest)
    whole = static_cast<std::int64_t>(*number);
  if (number && !unit.empty())
    table.insert_or_assign(key, fmt::format("{} {}", cell, unit));
  else if (whole)
    table.insert_or_assign(key, *whole);
  else if (number)
    table.insert_or_assign(key, *number);
  else
    table.insert_or_assign(key, cell);
}

void say(toml::table& table, const TableKey& key, const std::string& cell) {
  toml::table& section = table_at(table, key.section);
  if (key.part.empty()) {
    const CaseKey* known = case_key(key.section, key.key);
    if (known != nullptr && (known->holds == Holds::text || known->holds == Holds::name_or_number) && key.unit.empty())
      section.insert_or_assign(key.key, cell);  // a number is the name of a sheet or column
    else
      set(section, key.key, cell, key.unit);
    return;
  }
  set(table_at(section, key.key), key.part, cell, key.unit);
}

// Refuses a case that is no test of a campaign.
Test checked(Test input) {
  if (!input.record) throw missing(input, "record");
  if (input.reduced)
    throw wrong_value(input, "reduced", "The test is reduced, but a campaign needs tests in physical units",
                      "give the span and the bending stiffness");
  return input;
}

// An error in a case, reported at the row of its table.
InputError in_row(const InputError& error, const TextTable& table, const TextRow& row,
                  const std::vector<TableKey>& keys) {
  InputFault fault = error.fault;
  if (!fault.file.empty() && fault.file != table.source) return error;
  fault.file = table.source;
  fault.line = row.line;
  for (const auto& key : keys)
    if (fault.key == fmt::format("{}.{}{}{}", key.section, key.key, key.part.empty() ? "" : ".", key.part))
      fault.field = "column " + in_quotes(key.title);
  if (fault.kind == FaultKind::missing)
    fault.remedy = fmt::format("{} to the case file passed as --common, or a column to the table",
                               fault.remedy.empty() ? "add it" : fault.remedy);
  return InputError(fault);
}

InputError unknown_column(const TableKey& key, const TextTable& table) {
  std::vector<std::string> known;
  for (const CaseKey& each : case_keys())
    if (each.section == key.section || section_of(each.name) == each.section) known.emplace_back(each.name);
  return InputError(
      {.file = table.source,
       .line = table.header_line,
       .field = "column " + in_quotes(key.title),
       .problem = "The title is neither 'name' nor a key of a case file, such as 'file', 'span [um]', 'diameter [um]', "
                  "'stiffness' or 'rig.span', with its unit in brackets if the cells have none",
       .remedy = did_you_mean(key.key, known, "put # before the title of a column that is not meant for FlexSlip")});
}

std::vector<PlannedTest> plan_of_table(const std::string& path, const toml::table& common,
                                       const std::vector<std::string>& changes) {
  const TextTable table = read_text_table(path);
  std::vector<TableKey> keys;
  std::vector<std::size_t> columns;
  std::size_t name_column = table.titles.size();
  for (std::size_t i = 0; i < table.titles.size(); ++i) {
    if (table.titles[i].starts_with('#')) continue;
    if (table.titles[i] == "name") {
      name_column = i;
      continue;
    }
    columns.push_back(i);
    try {
      keys.push_back(key_of(table.titles[i]));
    } catch (const InputError& error) {
      throw located(error, table.source, table.header_line, "column " + in_quotes(table.titles[i]));
    }
    if (keys.back().section.starts_with("sweep") || !case_key(keys.back().section, keys.back().key))
      throw unknown_column(keys.back(), table);
  }
  if (table.rows.empty())
    throw InputError({.file = table.source, .problem = "The table has a header only, and no row for a test"});

  std::vector<PlannedTest> tests;
  for (const TextRow& row : table.rows) {
    toml::table text = common;
    // Uncertainties come last, because they turn an existing value into a table.
    for (const bool of_uncertainties : {false, true})
      for (std::size_t i = 0; i < keys.size(); ++i)
        if (!row.cells[columns[i]].empty() && keys[i].part.empty() != of_uncertainties)
          say(text, keys[i], row.cells[columns[i]]);
    const std::string file = text["record"]["file"].value_or(std::string());
    std::string name = name_column < row.cells.size() ? row.cells[name_column] : "";
    if (name.empty()) name = file.empty() ? fmt::format("row {}", row.line) : fs::path(file).stem().string();
    PlannedTest test{name, fmt::format("{}:{}", table.source, row.line), InputError({})};
    try {
      Test input = checked(case_from(text, table.source, changes));
      for (auto& [key, line] : input.lines) line = row.line;
      test.input = std::move(input);
    } catch (const InputError& error) {
      test.input = in_row(error, table, row, keys);
    }
    tests.push_back(std::move(test));
  }
  return tests;
}

std::vector<fs::path> files_in(const fs::path& folder, bool below) {
  std::vector<fs::path> files;
  const auto options = fs::directory_options::skip_permission_denied;
  for (auto entry = fs::recursive_directory_iterator(folder, options); entry != fs::recursive_directory_iterator();
       ++entry) {
    const bool hidden = entry->path().filename().string().starts_with('.');
    if (entry->is_directory() && (hidden || !below)) entry.disable_recursion_pending();
    if (entry->is_regular_file() && !hidden) files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end(), [](const fs::path& first, const fs::path& second) {
    return in_natural_order(first.string(), second.string());
  });
  return files;
}

std::vector<PlannedTest> plan_of_cases(const std::string& folder, const std::vector<std::string>& changes) {
  std::vector<PlannedTest> tests;
  for (const auto& file : files_in(folder, true)) {
    if (file.extension() != ".toml") continue;
    PlannedTest test{name_of_test(file.string()), file.string(), InputError({})};
    try {
      Test input = read_case(file.string(), changes);
      if (!input.record) continue;  // a case for simulation, or shared settings
      test.input = checked(std::move(input));
    } catch (const InputError& error) {
      test.input = error;
    }
    tests.push_back(std::move(test));
  }
  return tests;
}

bool is_workbook(const fs::path& file) { return lower_case(file.extension().string()).starts_with(".xls"); }

// The first lines of a text file; empty if it cannot be read.
std::vector<std::string> first_lines(const fs::path& file) {
  constexpr std::size_t count = 4;
  std::vector<std::string> lines;
  std::ifstream stream(file, std::ios::binary);
  for (std::string line; lines.size() < count && std::getline(stream, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == '\n')) line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

bool is_result(const fs::path& file) {
  if (is_workbook(file)) return false;
  const std::vector<std::string> lines = first_lines(file);
  return !lines.empty() && std::any_of(titles_of_results.begin(), titles_of_results.end(), [&](std::string_view title) {
    return title.starts_with(',') ? lines.front().find(title) != std::string::npos : lines.front().starts_with(title);
  });
}

// True if the name of the file begins like the other's, and each of its lines is a line of the other
// with additional cells.
bool has_rows_of(const fs::path& file, const fs::path& other) {
  const std::string name = file.stem().string(), base = other.stem().string();
  if (file == other || name.size() <= base.size() || !name.starts_with(base) || is_workbook(file) || is_workbook(other))
    return false;
  const std::vector<std::string> lines = first_lines(file), shorter = first_lines(other);
  if (lines.size() < 2 || lines.size() != shorter.size()) return false;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (shorter[i].empty() || !lines[i].starts_with(shorter[i])) return false;
  return true;
}

std::string names_of(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.filename().string());
  return listed(names);
}

CampaignPlan plan_of_data(const std::string& folder, const toml::table& common,
                          const std::vector<std::string>& changes) {
  CampaignPlan plan;
  std::vector<fs::path> files, results, copies;
  for (const auto& file : files_in(folder, false)) {
    const std::string ending = lower_case(file.extension().string());
    if (std::find(data_endings.begin(), data_endings.end(), ending) == data_endings.end()) continue;
    if (file.filename().string().starts_with("~$")) continue;  // a lock file of Excel
    (is_result(file) ? results : files).push_back(file);
  }
  for (const auto& file : files) {
    if (std::any_of(files.begin(), files.end(), [&](const fs::path& other) { return has_rows_of(file, other); })) {
      copies.push_back(file);
      continue;
    }
    PlannedTest test{name_of_test(file.string()), file.string(), InputError({})};
    toml::table text = common;
    table_at(text, "record").insert_or_assign("file", file.string());
    try {
      Test input = checked(case_from(text, "", changes));
      // lines of this composed text mean nothing to the user
      for (auto& [key, line] : input.lines) line = 0;
      test.input = std::move(input);
    } catch (const InputError& error) {
      test.input = located(error, error.fault.file, error.fault.file.empty() ? 0 : error.fault.line, error.fault.field);
    }
    plan.tests.push_back(std::move(test));
  }
  if (!results.empty())
    plan.notes.push_back(fmt::format("omitted, because they are results of flexslip: {}", names_of(results)));
  if (!copies.empty())
    plan.notes.push_back(fmt::format(
        "omitted, because they repeat another file with more columns: {}; to read them, list the files in a table "
        "with the column 'file'",
        names_of(copies)));
  return plan;
}

// True if both use the same part of a file.
bool is_same_part(const RecordInput& a, const RecordInput& b) {
  return a.specimen == b.specimen && a.sheet == b.sheet && a.first == b.first && a.until == b.until;
}

// A record on disk. Files of equal size are compared by hash.
struct KeptRecord {
  const PlannedTest* test;
  const RecordInput* record;
  std::uintmax_t size;
  std::string hash{}, stated{};  // computed on demand
};

const std::string& hash_of(KeptRecord& kept) {
  if (kept.hash.empty()) kept.hash = sha256_of(read_text(kept.record->file).value_or(kept.record->file));
  return kept.hash;
}

// All statements of its test, except the path of the record.
const std::string& stated_of(KeptRecord& kept) {
  if (kept.stated.empty()) {
    Test test = std::get<Test>(kept.test->input);
    test.record->file = "same";
    kept.stated = to_toml(std::move(test));
  }
  return kept.stated;
}

// Finds tests with the same record: of one file, or of identical files. They are one specimen; if
// everything else is the same too, they are one test.
void count_same_records_once(CampaignPlan& plan) {
  std::vector<KeptRecord> all;
  std::vector<PlannedTest> tests;
  tests.reserve(plan.tests.size());
  for (PlannedTest& each : plan.tests) {
    const PlannedTest& test = tests.emplace_back(std::move(each));
    const auto* input = std::get_if<Test>(&test.input);
    if (input == nullptr) continue;
    std::error_code error;
    KeptRecord kept{&test, &*input->record, fs::file_size(input->record->file, error)};
    if (error) continue;
    const auto is_of_kept = [&](KeptRecord& other) {
      return other.size == kept.size && is_same_part(*other.record, *kept.record) && hash_of(other) == hash_of(kept);
    };
    const auto same = std::find_if(all.begin(), all.end(), is_of_kept);
    const auto again = std::find_if(
        same, all.end(), [&](KeptRecord& other) { return is_of_kept(other) && stated_of(other) == stated_of(kept); });
    if (again != all.end()) {
      plan.notes.push_back(fmt::format("{} is omitted: its record is identical to the record of {}",
                                       in_quotes(test.name), in_quotes(again->test->name)));
      tests.pop_back();
      continue;
    }
    if (same != all.end())
      plan.notes.push_back(
          fmt::format("{} has the same record as {}; it counts as another specimen, because its case "
                      "differs",
                      in_quotes(test.name), in_quotes(same->test->name)));
    all.push_back(std::move(kept));
  }
  plan.tests = std::move(tests);
}

void note_missing_sections(CampaignPlan& plan) {
  std::vector<std::string> names;
  for (const PlannedTest& test : plan.tests)
    if (const auto* input = std::get_if<Test>(&test.input); input != nullptr && !section_of(*input))
      names.push_back(test.name);
  if (!names.empty())
    plan.notes.push_back(fmt::format(
        "no section is stated for {}: unless the file of the record states it, the specimen counts as thin, and "
        "there is no strain, stress or modulus; add diameter, or width and height",
        names.size() == plan.tests.size() ? "any specimen" : listed(names)));
}

}  // namespace

std::string folder_name(std::string_view name) {
  constexpr std::size_t longest = 100, tail = 20;
  const auto between_characters = [&](std::size_t at) {
    while (at < name.size() && at > 0 && (name[at] & 0xc0) == 0x80) --at;
    return at;
  };
  std::string fit(name);
  if (name.size() > longest)  // keep the end, which distinguishes it
    fit = fmt::format("{}…{}", name.substr(0, between_characters(longest - tail)),
                      name.substr(between_characters(name.size() - tail)));
  for (char& c : fit)
    if (static_cast<unsigned char>(c) < 0x20 || std::string_view("/\\:*?\"<>|\x7f").find(c) != std::string_view::npos)
      c = '_';
  if (fit.empty() || fit.front() == '.') fit.insert(fit.begin(), '_');
  return fit;
}

CampaignPlan plan_campaign(const std::string& path, const std::optional<std::string>& common,
                           const std::vector<std::string>& changes) {
  const toml::table shared = read_common(common);
  CampaignPlan plan;
  if (fs::is_directory(path)) {
    if (common)
      plan = plan_of_data(path, shared, changes);
    else
      plan.tests = plan_of_cases(path, changes);
    if (plan.tests.empty())
      throw InputError(
          {.file = path,
           .problem = fmt::format("The folder holds no {}",
                                  common ? "data files (.csv, .tsv, .txt, .dat, .asc, .tra, .lvm, .xlsx)"
                                         : "case files (.toml) with a [record]"),
           .remedy = common
                         ? ""
                         : "write one for each test, or pass a case file with what all data files of the folder have "
                           "in common as --common CASE, or pass a table with a row for each test"});
  } else {
    plan.tests = plan_of_table(path, shared, changes);
  }
  make_names_unique(plan.tests);
  count_same_records_once(plan);
  note_missing_sections(plan);
  return plan;
}

}  // namespace flexslip
