#include "io/durable_file.h"

#include <fstream>
#include <iterator>
#include <string>

#include <doctest/doctest.h>

#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t files_in(const TemporaryFolder& folder) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator(folder.path())) ++count;
  return count;
}

}  // namespace

TEST_CASE("durable file, identity: what is written is there, alone, and replaces what was") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "part";
  for (const std::string& bytes : {std::string("first"), std::string("a\0b\r\n", 5), std::string()}) {
    write_durably(file, bytes);
    CHECK(content_of(file) == bytes);
    CHECK(files_in(folder) == 1);
  }
}

TEST_CASE("durable file, contract: what cannot be written is refused with nothing left behind") {
  const TemporaryFolder folder;
  CHECK(message_of([&] { write_durably(folder.path() / "nowhere" / "part", "x"); }).find("nowhere") !=
        std::string::npos);
  std::filesystem::create_directory(folder.path() / "part");
  folder.file("part/full", "");
  CHECK(message_of([&] { write_durably(folder.path() / "part", "x"); }).find("a file that can be written") !=
        std::string::npos);
  CHECK(files_in(folder) == 1);
}

TEST_CASE("unfinished file, identity: it has its name once it is finished, and is gone if it is not") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "map.h5";
  folder.file("map.h5", "old");
  {
    const UnfinishedFile unfinished(file);
    CHECK(is_unfinished(unfinished.name()));
    std::ofstream(unfinished.name()) << "half";
  }
  CHECK(content_of(file) == "old");
  CHECK(files_in(folder) == 1);
  {
    UnfinishedFile unfinished(file);
    std::ofstream(unfinished.name()) << "whole";
    unfinished.finish();
  }
  CHECK(content_of(file) == "whole");
  CHECK(files_in(folder) == 1);
}

TEST_CASE("unfinished file, contract: two writers are kept apart, and what one left that was killed is replaced") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "map.h5";
  {
    const UnfinishedFile first(file);
    CHECK(message_of([&] { const UnfinishedFile second(file); }).find("map.h5") != std::string::npos);
  }
  folder.file("map.h5.unfinished", "left behind");
  UnfinishedFile next(file);
  std::ofstream(next.name()) << "whole";
  next.finish();
  CHECK(content_of(file) == "whole");
  CHECK(files_in(folder) == 1);
}

}  // namespace flexslip
