// The reader of workbooks: whatever the bytes, it returns a sheet whose cells the reader of exports takes or refuses, or throws an
// InputError.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "instruments/export.h"
#include "io/input_error.h"
#include "io/workbook.h"

using flexslip::export_in;
using flexslip::InputError;
using flexslip::read_sheet;
using flexslip::WorkbookSheet;

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const WorkbookSheet sheet = read_sheet(bytes);
    if (sheet.name.empty() && sheet.sheets.empty()) std::abort();
    if (sheet.cells.size() == 0) std::abort();
    if (export_in(std::string(bytes), "fuzz").specimens.empty()) std::abort();
  } catch (const InputError& error) {
    if (error.fault.problem.empty() || std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}
