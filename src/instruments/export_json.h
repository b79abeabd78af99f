// An export as JSON: what was decided about the file and what it holds, without its numbers.
#pragma once

#include "instruments/export.h"
#include "io/json.h"

namespace flexslip {

// {format, encoding, byte_order_mark, delimiter, decimal, thousands, quoted, columns, rows, specimens: [{name, columns:
// [{number, name, unit, role, first, last}], rows, first_line, last_line, metadata}], metadata: {name: value}, test:
// {span, diameter, width, thickness, rate} in SI, notes, asks, repeat_with}; columns and rows are those of the specimen
// chosen, an index.
Json export_json(const Export& file, std::size_t chosen);

// "time", "displacement", "crosshead", "deflection", "force", "other"
std::string_view name_of(ColumnRole role);

}  // namespace flexslip
