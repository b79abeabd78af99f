#include "design/sweep_parts.h"

#include <limits>

#include <doctest/doctest.h>

#include "design/sweep_plan.h"
#include "io/text_file.h"
#include "tests/design/some_sweep.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

std::vector<double> some_values(const SweepPlan& plan, std::uint64_t chunk) {
  std::vector<double> values(columns_of(plan).size() * rows_of_chunk(plan, chunk).count, 1.0 / 3);
  values[1] = std::numeric_limits<double>::infinity();
  values[2] = 5e-324;
  return values;
}

TEST_CASE("identity: a part comes back to the last bit, also through a folder opened by another program") {
  const TemporaryFolder folder;
  const auto plan = some_sweep(100);
  const SweepParts parts(folder.path() / "parts", plan);
  CHECK(parts.read(1).state == PartState::missing);
  parts.write(1, some_values(plan, 1));
  const SweepParts again(folder.path() / "parts");
  CHECK(again.read(1).state == PartState::whole);
  CHECK(again.read(1).values == some_values(plan, 1));
  CHECK(again.digest() == parts.digest());
  CHECK(again.plan().text == plan.text);
}

TEST_CASE("identity: a part of which any byte is another, or that ends elsewhere, is damaged") {
  const TemporaryFolder folder;
  const auto plan = some_sweep(66);
  const SweepParts parts(folder.path() / "parts", plan);
  parts.write(1, some_values(plan, 1));  // two rows
  const std::string whole = bytes_of(parts.file_of(1));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ 1);
    folder.file(parts.file_of(1), flipped);
    CHECK(parts.read(1).state == PartState::damaged);
    folder.file(parts.file_of(1), whole.substr(0, at));
    CHECK(parts.read(1).state == PartState::damaged);
  }
  folder.file(parts.file_of(1), whole + "x");
  CHECK(parts.read(1).state == PartState::damaged);
  folder.file(parts.file_of(1), whole);
  CHECK(parts.read(1).state == PartState::whole);
  folder.file(parts.file_of(0), whole);  // of other rows
  CHECK(parts.read(0).state == PartState::damaged);
}

TEST_CASE("table: another sweep is refused, and so is a folder that is none of a sweep") {
  const TemporaryFolder folder;
  const SweepParts parts(folder.path() / "parts", some_sweep(100));
  const std::string other = message_of([&] { SweepParts(folder.path() / "parts", some_sweep(100, 2)); });
  CHECK(other.find("those of another one, of 'some.toml'") != std::string::npos);
  CHECK(other.find("pass another --output") != std::string::npos);
  CHECK(message_of([&] { SweepParts(folder.path()); }).find("one without sweep.json") != std::string::npos);
  CHECK(message_of([&] { SweepParts(folder.path() / "absent"); }).find("no such folder") != std::string::npos);
  folder.file("parts/sweep.json", "{");
  CHECK(message_of([&] { SweepParts(folder.path() / "parts"); }).find("a damaged sweep.json") != std::string::npos);
  folder.file("parts/sweep.json", R"({"layout":1,"version":"0.0.1","digest":"0","source":"some.toml","text":""})");
  CHECK(message_of([&] { SweepParts(folder.path() / "parts"); }).find("those of FlexSlip 0.0.1") != std::string::npos);
  CHECK(message_of([&] { SweepParts(folder.file("file", "") + "/parts", some_sweep(9)); }).find("cannot be written") !=
        std::string::npos);
}

TEST_CASE("table: all that is a sweep's is removed, and nothing else") {
  const TemporaryFolder folder;
  const auto plan = some_sweep(100);
  const SweepParts parts(folder.path() / "parts", plan);
  parts.write(0, some_values(plan, 0));
  folder.file("parts/part-000002.there-12.unfinished", "half");
  folder.file("parts/mine.txt", "mine");
  parts.remove_all();
  CHECK(!std::filesystem::exists(parts.file_of(0)));
  CHECK(!std::filesystem::exists(folder.path() / "parts/part-000002.there-12.unfinished"));
  CHECK(!std::filesystem::exists(folder.path() / "parts/sweep.json"));
  CHECK(std::filesystem::exists(folder.path() / "parts/mine.txt"));
  std::filesystem::remove(folder.path() / "parts/mine.txt");
  parts.remove_all();
  CHECK(!std::filesystem::exists(folder.path() / "parts"));
}

}  // namespace
}  // namespace flexslip
