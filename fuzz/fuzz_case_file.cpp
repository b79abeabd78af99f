// The reader of case files: whatever the bytes, it returns a case that is written and read back the same, or throws an
// InputError.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "case/case_file.h"

using flexslip::InputError;
using flexslip::read_case;
using flexslip::to_toml;

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::string written;
  try {
    written = to_toml(read_case(text, "fuzz.toml"));
  } catch (const InputError& error) {
    if (error.fault.problem.empty() || std::string(error.what()).find('\n') != std::string::npos) std::abort();
    return 0;
  }
  if (to_toml(read_case(written, "fuzz.toml")) != written) std::abort();
  return 0;
}
