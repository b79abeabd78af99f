// Ten thousand damaged exports: an answer or an InputError, and nothing misread.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "instruments/export.h"
#include "instruments/export_fields.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "tests/instruments/export_files.h"

using namespace flexslip;

namespace {

constexpr std::size_t longest = 6000;  // [bytes] of a base: its beginning, to spend the time on many files

constexpr std::size_t fewest_rows = 5;  // with fewer, a preamble may outweigh the numbers

struct Base {
  std::string name, bytes;
  std::map<std::string, std::string> unit_of;  // of columns with a role, by their names
  bool is_utf16;
};

std::vector<Base> bases_in(const std::filesystem::path& folder) {
  std::vector<Base> all;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  for (const auto& path : paths) {
    Base base{
        path.filename().string(), bytes_of(path).substr(0, longest), {}, path.filename().string().starts_with("utf16")};
    try {
      for (const ExportedSpecimen& specimen : export_in(base.bytes, base.name).specimens)
        for (const ExportColumn& column : specimen.columns)
          if (column.role != ColumnRole::other) base.unit_of[column.name] = column.unit;
    } catch (const InputError&) {
    }  // refused ones are mutated as well
    all.push_back(std::move(base));
  }
  return all;
}

class Mutator {
 public:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  std::string mutate(std::string bytes) {
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) change(bytes);
    return bytes;
  }

 private:
  void change(std::string& bytes) {
    const std::size_t at = below(bytes.size());
    switch (below(9)) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << below(8)));
        break;
      case 2:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 3:
        bytes.erase(at, 1 + below(20));
        break;
      case 4:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(40)));
        break;
      case 5:
        bytes.insert(at, std::string(1, ",;\t \"'.\n\r#-"[below(11)]));
        break;
      case 6:  // another encoding in the middle
        bytes.insert(at, std::vector<std::string>{"é", "\xe9\xfc", "\x97\xcd\x95\xcf", "\xff\xfe"}[below(4)]);
        break;
      case 7: {  // the damage falls on the head, where names and units are
        const std::size_t head = below(std::min<std::size_t>(bytes.size(), 300));
        bytes[head] = static_cast<char>(static_cast<unsigned char>(bytes[head]) ^ (1U << below(8)));
        break;
      }
      default:
        bytes.erase(below(std::min<std::size_t>(bytes.size(), 300)), 1);
    }
  }

  std::mt19937_64 random_{20261121};
};

std::string canonical_of(const Export& file, std::size_t specimen) {
  std::ostringstream out;
  write_canonical(out, file, file.specimens[specimen]);
  return out.str();
}

// Does this text stand in the base? A unit that does not was made by the damage, and stands in the damaged file.
bool holds(const std::string& bytes, const std::string& text) { return bytes.find(text) != std::string::npos; }

std::string first_difference(const std::string& a, const std::string& b) {
  std::istringstream lines_a(a), lines_b(b);
  std::string line_a, line_b;
  do {
    if (!std::getline(lines_a, line_a)) line_a = "(end)";
    if (!std::getline(lines_b, line_b)) line_b = "(end)";
  } while (line_a == line_b && line_a != "(end)");
  return line_a + " | " + line_b;
}

void read_damaged(const std::vector<Base>& from, std::size_t mutants) {
  Mutator mutator;
  std::size_t answered = 0;
  std::size_t other_units = 0;
  for (std::size_t i = 0; i < mutants; ++i) {
    const Base& base = from[i % from.size()];
    const std::string bytes = mutator.mutate(base.bytes);
    CAPTURE(base.name);
    CAPTURE(i);
    std::optional<Export> file;
    try {
      file = export_in(bytes, base.name);
    } catch (const InputError& error) {
      const bool explained = !error.fault.problem.empty() && std::string(error.what()).find('\n') == std::string::npos;
      if (!explained) FAIL_CHECK(error.what());
      continue;
    }
    ++answered;
    for (const ExportedSpecimen& specimen : file->specimens)
      for (const ExportColumn& column : specimen.columns) {
        if (column.values.size() != specimen.lines.size()) FAIL("columns of different lengths");
        const auto known = base.unit_of.find(column.name);
        const auto unit = machine_unit(column.unit);
        if (known == base.unit_of.end() || column.role == ColumnRole::other || !unit) continue;
        if (unit == machine_unit(known->second)) continue;
        // Another valid unit: only if the damage itself wrote it, into the place of the unit.
        ++other_units;
        const bool written = base.is_utf16 || holds(bytes, column.unit);
        if (!written) FAIL_CHECK(column.name << " in " << column.unit << " instead of " << known->second);
      }
    // Whatever was made of it comes back from its canonical form; what is left of a file in a few rows may not.
    if (file->specimens.front().lines.size() < fewest_rows) continue;
    const std::string written = canonical_of(*file, 0);
    try {
      const Export again = export_in(written, "canonical");
      const std::string rewritten = canonical_of(again, 0);
      if (rewritten != written && again.specimens.size() == 1) FAIL_CHECK(first_difference(written, rewritten));
    } catch (const InputError& error) {
      FAIL_CHECK(std::string(error.what()) << "\n" << written.substr(0, 1500));
    }
  }
  MESSAGE(answered << " of " << mutants << " answered, " << other_units
                   << " columns with a unit that the damage wrote");
  CHECK(answered > mutants / 10);
}

}  // namespace

TEST_CASE("export: 10,000 damaged files give an answer or an InputError, and none takes a unit for another") {
  read_damaged(bases_in(fixtures), 10000);
}

TEST_CASE("export: the same of the published exports, 2,500 times") {
  if (!std::filesystem::exists(campaign_exports)) {
    MESSAGE("skipped: the published exports are not beside the repository");
    return;
  }
  read_damaged(bases_in(campaign_exports), 2500);
}

TEST_CASE("export: columns in another order take their titles, units and numbers with them") {
  Mutator mutator;
  for (const Base& base : bases_in(fixtures)) {
    std::optional<Export> original;
    try {
      original = export_in(base.bytes, base.name);
    } catch (const InputError&) {
      continue;
    }
    for (std::size_t turn = 0; turn < 20; ++turn) {
      Export shuffled = *original;
      shuffled.specimens.resize(1);
      std::vector<ExportColumn>& columns = shuffled.specimens.front().columns;
      for (std::size_t i = columns.size(); i > 1; --i) std::swap(columns[i - 1], columns[mutator.below(i)]);
      const Export again = export_in(canonical_of(shuffled, 0), base.name);
      const std::vector<ExportColumn>& found = again.specimens.front().columns;
      CAPTURE(base.name);
      REQUIRE(found.size() == columns.size());
      for (std::size_t i = 0; i < columns.size(); ++i) {
        CHECK(found[i].name == columns[i].name);
        CHECK(found[i].unit == columns[i].unit);
        CHECK(found[i].role == columns[i].role);
        CHECK(std::equal(found[i].values.begin(), found[i].values.end(), columns[i].values.begin(),
                         columns[i].values.end(),
                         [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
      }
    }
  }
}
