// The text of an export as its columns: everything that reading one decides.
#pragma once

#include <optional>
#include <string>

#include "instruments/encoding.h"
#include "instruments/export.h"
#include "io/workbook.h"

namespace flexslip {

// What read_export makes of a text, or of the sheet of a workbook whose text it is.
// Fails:      as read_export, without the file.
Export export_in(const DecodedText& decoded, const std::string& source, const ExportOptions& options,
                 const std::optional<WorkbookSheet>& workbook = {});

}  // namespace flexslip
