#include "instruments/canonical.h"

#include <ostream>
#include <span>
#include <sstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "instruments/metadata.h"
#include "io/quantity.h"
#include "io/table.h"
#include "io/text_file.h"

namespace flexslip {
namespace {

std::string remark(const Metadatum& datum) {
  return datum.value.empty() ? fmt::format("# {}\n", datum.name) : fmt::format("# {}: {}\n", datum.name, datum.value);
}

// A line of the preamble so that it means in this table, which has decimal points, what it means in the file.
std::string translated(const Metadatum& datum, const NumberFormat& format) {
  const std::span<const Metadatum> alone(&datum, 1);
  const NumberFormat here{};
  const ExportedTest test = test_in(alone, format);
  const auto force = stated_maximum(alone, format);
  const auto force_here = stated_maximum(alone, here);
  const bool same_force = force.has_value() == force_here.has_value() && (!force || force->value == force_here->value);
  if (test == test_in(alone, here) && same_force) return remark(datum);
  for (const auto& length : {test.span, test.diameter, test.width, test.thickness})
    if (length) {
      const auto unit = best_unit(*length, kind::length);
      return remark({datum.name, fmt::format("{:.15g} {}", from_si(*length, parse_unit(unit)), unit), 0});
    }
  if (test.rate) return remark({datum.name, fmt::format("{} m/s", *test.rate), 0});
  if (force) return remark({datum.name, fmt::format("{} N", force->value), 0});
  return fmt::format("# not understood: {} = {}\n", datum.name, datum.value);
}

}  // namespace

void write_canonical(std::ostream& out, const Export& file, const ExportedSpecimen& specimen) {
  std::vector<Metadatum> all = file.metadata;
  const bool of_several = file.specimens.size() > 1;  // whose highest force need not be that of this one
  if (of_several) std::erase_if(all, states_maximum_force);
  all.insert(all.end(), specimen.metadata.begin(), specimen.metadata.end());
  const NumberFormat format{file.decimal, file.thousands};
  for (const Metadatum& datum : all) out << translated(datum, format);
  if (!specimen.name.empty() && specimen_name(all) != specimen.name) out << remark({"Specimen", specimen.name, 0});
  std::vector<std::string> titles;
  titles.reserve(specimen.columns.size());
  for (const ExportColumn& column : specimen.columns)
    titles.push_back(column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit));
  std::size_t row = 0;
  write_table(out, titles, [&](std::vector<Cell>& cells) {
    if (row == specimen.lines.size()) return false;
    cells.clear();
    for (const ExportColumn& column : specimen.columns)
      cells.push_back(column.words.empty() ? Cell(column.values[row]) : Cell(column.words[row]));
    ++row;
    return true;
  });
}

void write_canonical(const std::string& path, const Export& file, const ExportedSpecimen& specimen) {
  std::ostringstream text;
  write_canonical(text, file, specimen);
  write_text(path, text.str());
}

}  // namespace flexslip
