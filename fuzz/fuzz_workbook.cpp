// The reader of workbooks: whatever the bytes, it returns a sheet whose cells the reader of exports takes or refuses, or throws an
// InputError. The same bytes are read as XML too, so that the fuzzer need not pack.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "instruments/export.h"
#include "io/input_error.h"
#include "io/packed_xml.h"
#include "io/workbook.h"

using flexslip::export_in;
using flexslip::InputError;
using flexslip::read_sheet;
using flexslip::WorkbookSheet;
using flexslip::XmlAttributes;
using flexslip::XmlStream;

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const WorkbookSheet sheet = read_sheet(bytes);
    if (sheet.name.empty() && sheet.sheets.empty()) std::abort();
    if (sheet.cells.size() == 0) std::abort();
    if (export_in(std::string(bytes), "fuzz").specimens.empty()) std::abort();
  } catch (const InputError& error) {
    if (error.fault.expected.empty() || std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  try {
    int depth = 0;
    XmlStream xml({[&](std::string_view, const XmlAttributes& each) {
                     each.find("r");
                     ++depth;
                   },
                   [&](std::string_view) { --depth; }, [](std::string_view) {}});
    xml.feed(bytes.substr(0, size / 2));
    xml.feed(bytes.substr(size / 2));
    xml.finish();
    if (depth != 0) std::abort();
  } catch (const InputError&) {
  }
  return 0;
}
