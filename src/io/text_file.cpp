#include "io/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "io/call_files.h"
#include "io/durable_file.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

// The error for a file that cannot be opened. Of one that is not there, the remedy is a similar
// name in its folder, or where it was looked for.
InputError cannot_be_opened(const std::string& path, int reason) {
  InputError error = unreadable(path, std::generic_category().message(reason));
  if (reason != ENOENT) return error;
  const fs::path file(path);
  std::error_code unknown;
  const fs::path folder = fs::absolute(file, unknown).parent_path();
  if (!fs::is_directory(folder, unknown)) {
    error.fault.remedy = fmt::format("there is no folder '{}'", file.parent_path().string());
    if (file.is_relative()) error.fault.remedy += fmt::format(" in '{}'", fs::current_path(unknown).string());
    return InputError(error.fault);
  }
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unknown))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  const std::string meant = nearest(file.filename().string(), names);
  error.fault.remedy = meant.empty() ? fmt::format("it was looked for in '{}'", folder.lexically_normal().string())
                                     : fmt::format("did you mean '{}'?", (file.parent_path() / meant).string());
  return InputError(error.fault);
}

}  // namespace

std::shared_ptr<std::istream> open_to_read(const std::string& path) {
  announce_input(path);
  if (path == "-") return {std::shared_ptr<void>(), &std::cin};  // must stay open
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw InputError({.file = path, .problem = "This is a directory, not a file"});
  errno = 0;
  auto file = std::make_shared<std::ifstream>(path, std::ios::binary);
  if (!*file) throw cannot_be_opened(path, errno);
  return file;
}

std::string bytes_of(const std::string& path) {
  constexpr std::size_t piece = 1 << 20;
  constexpr std::size_t most = std::size_t{1} << 31;  // no test has as many readings
  const auto in = open_to_read(path);
  const std::string source = path == "-" ? "standard input" : path;
  std::string bytes;
  const auto require_at_most = [&](std::uintmax_t size) {
    if (size > most)
      throw InputError({.file = source,
                        .problem = "The file has more than 2 GiB",
                        .remedy = "split it, or export fewer readings a second"});
  };
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(path, unknown);
  if (!unknown) {
    require_at_most(size);
    bytes.reserve(size + piece);
  }
  for (std::size_t got = piece; got > 0;) {
    const std::size_t before = bytes.size();
    bytes.resize(before + piece);
    in->read(bytes.data() + before, piece);
    got = static_cast<std::size_t>(in->gcount());
    bytes.resize(before + got);
    if (in->bad()) throw unreadable(source, "an error while reading");
    require_at_most(bytes.size());
    if (before == 0 && got == piece && bytes.find_first_not_of('\0') == std::string::npos)
      throw InputError({.file = source,
                        .problem = "The first MiB of the file holds nothing but NUL characters",
                        .remedy = "copy the file again from where it was recorded"});
  }
  return bytes;
}

std::optional<std::string> read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

void write_text(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.stream() << text;
  file.finish();
}

}  // namespace flexslip
