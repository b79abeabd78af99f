#include "io/child_process.h"

#include <filesystem>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>

using namespace flexslip;

TEST_CASE("outside: arguments reach the program as they are, whatever a shell would make of them") {
  const auto result = run_child({"printf", "%s|", "a b", "$HOME", "`id`", "'; exit 7", "*"}, "/");
  CHECK(result.status == ChildStatus::exited);
  CHECK(result.exit_code == 0);
  CHECK(result.output == "a b|$HOME|`id`|'; exit 7|*|");
}

TEST_CASE("outside: the program runs in the folder, without input, and both its outputs are kept") {
  const auto folder = std::filesystem::canonical(std::filesystem::temp_directory_path()).string();
  const auto result = run_child({"sh", "-c", "pwd -P; cat; echo no >&2; exit 3"}, folder);
  CHECK(result.exit_code == 3);
  CHECK(result.output == folder + "\nno\n");
}

TEST_CASE("outside: more output than a pipe holds does not hang") {
  CHECK(run_child({"sh", "-c", "yes | head -c 1000000"}, "/").output.size() == 1000000);
}

TEST_CASE("outside: a signal counts as shells count it") {
  CHECK(run_child({"sh", "-c", "kill -TERM $$"}, "/").exit_code == 128 + 15);
}

TEST_CASE("limit: a program that is not there") {
  CHECK(run_child({"no-such-program-anywhere"}, "/").status == ChildStatus::not_found);
}
