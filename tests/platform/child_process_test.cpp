#include "platform/child_process.h"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>
#include <signal.h>

#include "numerics/effort.h"
#include "tests/temporary_folder.h"

using namespace flexslip;

TEST_CASE("outside: arguments reach the program as they are, whatever a shell would make of them") {
  const auto result = run_child({"printf", "%s|", "a b", "$HOME", "`id`", "'; exit 7", "*"});
  CHECK(result.status == ChildStatus::exited);
  CHECK(result.exit_code == 0);
  CHECK(result.output == "a b|$HOME|`id`|'; exit 7|*|");
}

TEST_CASE("outside: the program runs in the folder, without input, and both its outputs are kept") {
  const auto folder = std::filesystem::canonical(std::filesystem::temp_directory_path()).string();
  const auto result = run_child({"sh", "-c", "pwd -P; cat; echo no >&2; exit 3"}, {.folder = folder});
  CHECK(result.exit_code == 3);
  CHECK(result.output == folder + "\nno\n");
}

TEST_CASE("outside: more output than a pipe holds does not hang") {
  CHECK(run_child({"sh", "-c", "yes | head -c 1000000"}).output.size() == 1000000);
}

TEST_CASE("outside: a signal counts as shells count it") {
  CHECK(run_child({"sh", "-c", "kill -TERM $$"}).exit_code == 128 + 15);
}

TEST_CASE("outside: a child is ended with the wait for it") {
  const TemporaryFolder folder;
  std::atomic<bool> stop = false;
  pid_t id = 0;
  std::thread stopper([&] {
    while (!(std::ifstream(folder.path() / "id") >> id)) std::this_thread::yield();
    stop = true;
  });
  const Stoppable stoppable(&stop);
  CHECK_THROWS_AS(run_child({"sh", "-c", "echo $$ > written; mv written id; exec sleep 60"}, {.folder = folder.path()}),
                  Stopped);
  stopper.join();
  CHECK(kill(id, 0) != 0);  // there is no such process
}

TEST_CASE("limit: a program that takes too long is ended, and what it wrote is kept") {
  for (const std::string hangs : {"exec sleep 60", "exec >&- 2>&-; exec sleep 60"}) {
    CAPTURE(hangs);
    const auto result = run_child({"sh", "-c", "echo $$; " + hangs}, {.limit = std::chrono::milliseconds(100)});
    CHECK(result.status == ChildStatus::too_long);
    CHECK(kill(std::stoi(result.output), 0) != 0);  // there is no such process
  }
}

TEST_CASE("outside: a program does not see the variables that are unset, and sees the others") {
  setenv("FLEXSLIP_TEST_VARIABLE", "set", 1);
  const std::vector<std::string> print{"sh", "-c", "printf \"$FLEXSLIP_TEST_VARIABLE\""};
  CHECK(run_child(print).output == "set");
  CHECK(run_child(print, {.unset_variables = {"FLEXSLIP_TEST_VARIABLE"}}).output.empty());
  CHECK(run_child(print, {.unset_variables = {"FLEXSLIP_TEST"}}).output == "set");
  unsetenv("FLEXSLIP_TEST_VARIABLE");
}

TEST_CASE("limit: a program that is not there") {
  CHECK(run_child({"no-such-program-anywhere"}).status == ChildStatus::not_found);
}
