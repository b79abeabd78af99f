#include "io/text_file.h"

#include "io/durable_file.h"

namespace flexslip {

void write_text(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.stream() << text;
  file.finish();
}

}  // namespace flexslip
