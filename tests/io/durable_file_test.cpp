#include "io/durable_file.h"

#include <filesystem>
#include <fstream>
#include <future>
#include <string>
#include <utility>

#include <doctest/doctest.h>
#include <sys/stat.h>

#include "io/text_file.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const TemporaryFolder& folder) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& file : fs::directory_iterator(folder.path())) ++count;
  return count;
}

}  // namespace

TEST_CASE("output file, identity: what is written is there, alone, and replaces what was") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "part";
  for (const std::string& bytes : {std::string("first"), std::string("a\0b\r\n", 5), std::string()}) {
    write_text(file.string(), bytes);
    CHECK(bytes_of(file) == bytes);
    CHECK(files_in(folder) == 1);
  }
}

TEST_CASE("output file, contract: what cannot be written is refused with nothing left behind") {
  const TemporaryFolder folder;
  const auto refusal = [](const fs::path& file) { return message_of([&] { write_text(file.string(), "x"); }); };
  CHECK(refusal(folder.path() / "nowhere" / "part").find("nowhere") != std::string::npos);
  fs::create_directory(folder.path() / "part");
  CHECK(refusal(folder.path() / "part").find("cannot be written: ") != std::string::npos);
  CHECK(files_in(folder) == 1);
}

TEST_CASE("output file, identity: until it is finished, and if it never is, the old file is there") {
  const TemporaryFolder folder;
  const fs::path file = folder.file("table.csv", "old");
  {
    OutputFile output(file.string());
    output.stream() << std::string(100000, 'x') << std::flush;
    CHECK(bytes_of(file) == "old");
  }
  CHECK(bytes_of(file) == "old");
  CHECK(files_in(folder) == 1);
}

TEST_CASE("output file, identity: permissions are kept, and those of a new file are as for any other") {
  const TemporaryFolder folder;
  const fs::path file = folder.file("table.csv", "old");
  for (const auto mode : {0600, 0640, 0664, 0755}) {
    fs::permissions(file, static_cast<fs::perms>(mode));
    write_text(file.string(), "new");
    CHECK(fs::status(file).permissions() == static_cast<fs::perms>(mode));
  }
  write_text((folder.path() / "new.csv").string(), "");
  const fs::path other = folder.file("other.csv", "");
  CHECK(fs::status(folder.path() / "new.csv").permissions() == fs::status(other).permissions());
}

TEST_CASE("output file, identity: a link stays one, and what it leads to is written") {
  const TemporaryFolder folder;
  folder.file("below/old.csv", "old");
  fs::create_symlink("below/old.csv", folder.path() / "link");
  fs::create_symlink("link", folder.path() / "link to it");
  fs::create_symlink("below/none yet.csv", folder.path() / "dangling");
  for (const auto& [link, file] : {std::pair{"link to it", "below/old.csv"}, {"dangling", "below/none yet.csv"}}) {
    write_text((folder.path() / link).string(), "new");
    CHECK(fs::is_symlink(folder.path() / link));
    CHECK(bytes_of(folder.path() / file) == "new");
    CHECK(fs::equivalent(target_of(folder.path() / link), folder.path() / file));
  }
  fs::create_symlink("circle", folder.path() / "circle");
  CHECK(message_of([&] { write_text((folder.path() / "circle").string(), ""); }) != "");
}

TEST_CASE("output file, identity: devices and pipes are written as they are") {
  const TemporaryFolder folder;
  write_text("/dev/null", "x");
  CHECK(fs::is_character_file("/dev/null"));
  if (fs::exists("/dev/full"))
    CHECK(message_of([] { write_text("/dev/full", "x"); }).find("/dev/full") != std::string::npos);
  const std::string pipe = (folder.path() / "pipe").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  auto read = std::async(std::launch::async, [&] { return bytes_of(pipe); });
  write_text(pipe, "through");
  CHECK(read.get() == "through");
  CHECK(fs::is_fifo(pipe));
}

}  // namespace flexslip
