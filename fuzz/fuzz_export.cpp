// The reader of exports: whatever the bytes, it returns columns of one length or throws an InputError, and what it returns
// is written so that it can be read again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "instruments/export.h"
#include "instruments/export_fields.h"
#include "io/input_error.h"

using flexslip::Export;
using flexslip::export_in;
using flexslip::ExportColumn;
using flexslip::ExportedSpecimen;
using flexslip::InputError;

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const Export file = export_in(std::string(bytes), "fuzz");
    if (file.specimens.empty()) std::abort();
    for (const ExportedSpecimen& specimen : file.specimens) {
      if (specimen.lines.empty()) std::abort();
      for (const ExportColumn& column : specimen.columns)
        if (column.values.size() != specimen.lines.size()) std::abort();
      std::ostringstream written;
      write_canonical(written, file, specimen);
    }
  } catch (const InputError& error) {
    if (error.fault.problem.empty() || std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}
