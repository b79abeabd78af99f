#include "io/call_files.h"

#include <filesystem>
#include <string>

#include <doctest/doctest.h>

#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

// What is said to a call that reads `input` where it has announced that it writes.
template <class Announce>
std::string refusal(const fs::path& input, const Announce& announce) {
  CallFiles files;
  announce(files);
  return message_of([&] { files.reads(input); });
}

}  // namespace

TEST_CASE("call files, table: an output is not an input, whatever its path is") {
  const TemporaryFolder folder;
  const fs::path input = folder.file("below/test.csv", "1");
  fs::create_symlink("below/test.csv", folder.path() / "link.csv");
  fs::create_directory_symlink("below", folder.path() / "here");
  fs::create_hard_link(input, folder.path() / "hard.csv");
  folder.file("other.csv", "1");
  const auto refused = [&](const fs::path& output) {
    return refusal(input, [&](CallFiles& files) { files.writes(folder.path() / output, "--curves"); });
  };
  for (const char* same : {"below/test.csv", "below/../below/./test.csv", "link.csv", "here/test.csv", "hard.csv"}) {
    const std::string message = refused(same);
    for (const std::string& words : {std::string("--curves"), std::string(same), input.string(),
                                     std::string("Pass another name (nothing has been written)")})
      CHECK_MESSAGE(message.find(words) != std::string::npos, same, ": ", message);
  }
  CHECK(refused("other.csv").empty());
  CHECK(refused("none yet.csv").empty());
}

TEST_CASE("call files, table: two outputs are two files, in whatever order they are announced") {
  const TemporaryFolder folder;
  fs::create_symlink("dangling.csv", folder.path() / "link.csv");
  const auto refused = [&](const fs::path& one, const fs::path& other) {
    CallFiles files;
    files.writes(folder.path() / one, "--curves");
    return message_of([&] { files.writes(folder.path() / other, "--profile"); });
  };
  CHECK(refused("a.csv", "a.csv").starts_with("--curves and --profile: '"));
  CHECK(refused("a.csv", "a.csv").find("a.csv' is named twice. Pass another name") != std::string::npos);
  CHECK(refused("a.csv", "./a.csv").find("the same file") != std::string::npos);
  CHECK(refused("link.csv", "dangling.csv").find("the same file") != std::string::npos);
  CHECK(refused("a.csv", "b.csv").empty());

  const auto with_figure = [&](const char* output, bool figure_first) {
    CallFiles files;
    const auto figure = [&] { files.writes_like(folder.path(), "map-", ".csv", "--figure"); };
    const auto table = [&] { files.writes(folder.path() / output, "--output"); };
    return message_of([&] {
      if (figure_first) figure();
      table();
      if (!figure_first) figure();
    });
  };
  for (const bool figure_first : {true, false}) {
    CHECK(with_figure("map-path.csv", figure_first).find("--figure") != std::string::npos);
    for (const char* other : {"map.csv", "map-.cs", "map-path.txt", "other.csv", "below/map-path.csv"})
      CHECK(with_figure(other, figure_first).empty());
  }
}

TEST_CASE("call files, table: no input lies in a folder of outputs, nor where a link in it leads") {
  const TemporaryFolder folder;
  const fs::path input = folder.file("test.csv", "1");
  const fs::path inside = folder.file("figures/a/force.csv", "1");
  const auto below = [&](CallFiles& files) { files.writes_below(folder.path() / "figures", "--report"); };
  CHECK(refusal(input, below).empty());
  CHECK(refusal(inside, below).find("another name or folder") != std::string::npos);
  fs::create_hard_link(input, folder.path() / "figures/a/link.csv");
  CHECK(refusal(input, below).find("link.csv") != std::string::npos);

  const auto kept_out = [&](CallFiles& files) { files.keeps_inputs_out_of(folder.path() / "figures/", "--report"); };
  CHECK(refusal(inside, kept_out).find("where no input may lie. Pass another name or folder") != std::string::npos);
  CHECK(refusal(input, kept_out).empty());
  CallFiles files;
  kept_out(files);
  files.writes(folder.path() / "figures/a/out.csv", "--output");  // an output may
}

TEST_CASE("call files, limit: devices, pipes and what is not there are in nobody's way") {
  CallFiles files;
  files.writes("/dev/null", "--curves");
  files.writes("/dev/null", "--profile");
  files.reads("/dev/null");
  files.writes("/nowhere/at all", "--output");
  files.reads("/nowhere/at all");
}

TEST_CASE("call files, identity: what a call under way writes is no input until it ends") {
  const TemporaryFolder folder;
  const fs::path table = folder.file("tests.csv", "1");
  announce_input(table);
  {
    CallFiles files;
    files.writes(table, "report");
    const CallUnderWay call(std::move(files));
    CHECK_THROWS_AS(announce_input(table), OutputClash);
    announce_input(folder.file("other.csv", "1"));
  }
  announce_input(table);
}

}  // namespace flexslip
