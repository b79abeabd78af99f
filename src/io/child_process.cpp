#include "io/child_process.h"

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace flexslip {
namespace {

[[noreturn]] void fail(int error) {
  throw std::runtime_error("cannot start another program: " + std::generic_category().message(error));
}

void require(int error) {
  if (error != 0) fail(error);
}

class Actions {
 public:
  Actions() { require(posix_spawn_file_actions_init(&actions_)); }
  ~Actions() { posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  posix_spawn_file_actions_t* get() { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

std::string read_all(int pipe) {
  std::string text;
  std::array<char, 4096> piece{};
  for (;;) {
    const ssize_t got = read(pipe, piece.data(), piece.size());
    if (got > 0) text.append(piece.data(), static_cast<std::size_t>(got));
    if (got == 0 || (got < 0 && errno != EINTR)) return text;
  }
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& command, const std::string& folder) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno);
  const auto [reading, writing] = ends;
  Actions actions;
  require(posix_spawn_file_actions_addchdir_np(actions.get(), folder.c_str()));
  require(posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0));
  require(posix_spawn_file_actions_adddup2(actions.get(), writing, STDOUT_FILENO));
  require(posix_spawn_file_actions_adddup2(actions.get(), writing, STDERR_FILENO));

  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments.front(), actions.get(), nullptr, arguments.data(), environ);
  close(writing);
  if (error != 0) {
    close(reading);
    if (error == ENOENT || error == EACCES) return {ChildStatus::not_found, 0, ""};
    fail(error);
  }
  std::string output = read_all(reading);
  close(reading);
  int ended = 0;
  while (waitpid(child, &ended, 0) < 0)
    if (errno != EINTR) fail(errno);
  return {ChildStatus::exited, WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended), std::move(output)};
}

}  // namespace flexslip
