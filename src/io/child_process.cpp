#include "io/child_process.h"

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "numerics/effort.h"

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

// A child and what it writes. It does not outlive this.
class Child {
 public:
  Child(pid_t id, int pipe) : id_(id), pipe_(pipe) {}
  ~Child() {
    close(pipe_);
    if (ended_) return;
    kill(id_, SIGKILL);
    while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  std::string output() {
    constexpr int heard_every = 20;  // [ms]
    std::string text;
    std::array<char, 4096> piece{};
    for (pollfd ready{pipe_, POLLIN, 0};;) {
      effort_spent += 1;  // whoever waits may be stopped
      const int heard = poll(&ready, 1, heard_every);
      const ssize_t got = heard > 0 ? read(pipe_, piece.data(), piece.size()) : heard;
      if (got < 0 && errno != EINTR) fail(errno);
      if (heard > 0 && got == 0) return text;
      if (got > 0) text.append(piece.data(), static_cast<std::size_t>(got));
    }
  }

  int exit_code() {
    int status = 0;
    while (waitpid(id_, &status, 0) < 0)
      if (errno != EINTR) fail(errno);
    ended_ = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  pid_t id_;
  int pipe_;
  bool ended_ = false;
};

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
  pid_t id = 0;
  const int error = posix_spawnp(&id, arguments.front(), actions.get(), nullptr, arguments.data(), environ);
  close(writing);
  if (error != 0) {
    close(reading);
    if (error == ENOENT || error == EACCES) return {ChildStatus::not_found, 0, ""};
    fail(error);
  }
  Child child(id, reading);
  std::string output = child.output();
  return {ChildStatus::exited, child.exit_code(), std::move(output)};
}

}  // namespace flexslip
