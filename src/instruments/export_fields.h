// What `read --json` tells of an export: what was decided about the file and what it holds, without its numbers.
#pragma once

#include "instruments/export.h"
#include "result/fields.h"

namespace flexslip {

// An export, and the specimen whose columns and rows are told first.
struct ToldExport {
  const Export& file;
  std::size_t chosen;
};
Fields<ToldExport> export_fields();

// "time", "displacement", "crosshead", "deflection", "force", "other"
std::string_view name_of(ColumnRole role);

}  // namespace flexslip
