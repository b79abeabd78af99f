// The reader of tables: whatever the bytes, it returns finite columns of one length or throws an InputError.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "io/input_error.h"
#include "io/table.h"

using flexslip::Column;
using flexslip::InputError;
using flexslip::Kind;
using flexslip::Table;
using flexslip::table_in;

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const char decimal = data[0] == ',' ? ',' : '.';
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  for (const Kind& kind : {flexslip::kind::length, flexslip::kind::number}) {
    try {
      const Table table = table_in(text, "fuzz", {{"w_s", kind}, {"F", kind}}, decimal);
      for (const Column& column : table.columns) {
        if (column.values.size() != table.rows()) std::abort();
        for (std::size_t row = 0; row < table.rows(); ++row)
          if (!std::isfinite(column.values[row]) || table.lines[row] < 2) std::abort();
      }
    } catch (const InputError& error) {
      if (error.fault.problem.empty() || std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
  }
  return 0;
}
