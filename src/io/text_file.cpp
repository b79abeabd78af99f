#include "io/text_file.h"

#include <fstream>
#include <iterator>

#include "io/durable_file.h"

namespace flexslip {

void write_text(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.stream() << text;
  file.finish();
}

std::optional<std::string> read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

}  // namespace flexslip
