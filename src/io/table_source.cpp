#include "io/table_source.h"

#include <iterator>
#include <sstream>
#include <utility>

#include "io/input_error.h"
#include "io/table.h"

namespace flexslip {

TableSource open_table(const std::string& path, const std::optional<SheetChoice>& sheet, SheetFor purpose) {
  TableSource source{path == "-" ? "standard input" : path, open_to_read(path), {}};
  const auto first = source.text->peek();
  // What begins like a workbook is taken whole, as a stream need not go back.
  if (first == 'P' || first == 0xd0) {
    std::string bytes{std::istreambuf_iterator<char>(*source.text), {}};
    if (is_packed(bytes)) try {
        source.sheet = read_sheet(bytes, sheet, purpose);
        bytes = std::move(source.sheet->text);
      } catch (const InputError& error) {
        throw located(error, source.name, error.fault.line, error.fault.field);
      }
    source.text = std::make_shared<std::istringstream>(std::move(bytes));
  }
  if (sheet && !source.sheet)
    throw InputError({.file = source.name,
                      .field = "--sheet",
                      .expected = "a workbook (.xlsx), as this names a sheet",
                      .found = "a text file",
                      .remedy = "leave it out",
                      .key = "record.sheet"});
  return source;
}

}  // namespace flexslip
