#include "io/text_file.h"

#include <cerrno>
#include <fstream>
#include <iostream>
#include <system_error>

#include "io/input_error.h"

namespace flexslip {

void write_text(const std::string& path, std::string_view text) {
  std::ofstream file;
  errno = 0;
  if (path != "-") file.open(path, std::ios::binary);
  std::ostream& out = path == "-" ? std::cout : file;
  if (out) out << text << std::flush;
  if (!out)
    throw InputError({.file = path == "-" ? "standard output" : path,
                      .expected = "a file that can be written",
                      .found = std::generic_category().message(errno)});
}

}  // namespace flexslip
