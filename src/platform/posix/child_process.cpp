#include "platform/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

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

// A child process and its output. The child ends with this object.
class Child {
 public:
  Child(pid_t id, int pipe, std::chrono::milliseconds limit)
      : id_(id), pipe_(pipe), end_(limit.count() > 0 ? Clock::now() + limit : Clock::time_point::max()) {}
  ~Child() {
    close(pipe_);
    if (ended_) return;
    kill(id_, SIGKILL);
    while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // The output until the child closes it or the time is over.
  std::string output() {
    std::string text;
    std::array<char, 4096> piece{};
    for (pollfd ready{pipe_, POLLIN, 0}; has_time();) {
      effort_spent += 1;  // a waiting thread can be stopped
      const int heard = poll(&ready, 1, looked_every.count());
      const ssize_t got = heard > 0 ? read(pipe_, piece.data(), piece.size()) : heard;
      if (got < 0 && errno != EINTR) fail(errno);
      if (heard > 0 && got == 0) break;
      if (got > 0) text.append(piece.data(), static_cast<std::size_t>(got));
    }
    return text;
  }

  // Empty if the time is over before the child ends.
  std::optional<int> exit_code() {
    for (int status = 0; has_time(); std::this_thread::sleep_for(looked_every)) {
      effort_spent += 1;
      const pid_t ended = waitpid(id_, &status, WNOHANG);
      if (ended < 0 && errno != EINTR) fail(errno);
      if (ended != id_) continue;
      ended_ = true;
      return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    return {};
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::duration<int, std::milli> looked_every{20};

  bool has_time() const { return Clock::now() < end_; }

  pid_t id_;
  int pipe_;
  Clock::time_point end_;
  bool ended_ = false;
};

std::vector<char*> environment_without(const std::vector<std::string>& unset_variables) {
  std::vector<char*> kept;
  for (char** each = environ; *each; ++each) {
    const std::string_view assignment = *each, name = assignment.substr(0, assignment.find('='));
    if (std::find(unset_variables.begin(), unset_variables.end(), name) == unset_variables.end()) kept.push_back(*each);
  }
  kept.push_back(nullptr);
  return kept;
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& command, const ChildOptions& options) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno);
  const auto [reading, writing] = ends;
  Actions actions;
  require(posix_spawn_file_actions_addchdir_np(actions.get(), options.folder.c_str()));
  require(posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0));
  require(posix_spawn_file_actions_adddup2(actions.get(), writing, STDOUT_FILENO));
  require(posix_spawn_file_actions_adddup2(actions.get(), writing, STDERR_FILENO));

  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::vector<char*> environment = environment_without(options.unset_variables);
  pid_t id = 0;
  const int error = posix_spawnp(&id, arguments.front(), actions.get(), nullptr, arguments.data(), environment.data());
  close(writing);
  if (error != 0) {
    close(reading);
    if (error == ENOENT || error == EACCES) return {ChildStatus::not_found, 0, ""};
    fail(error);
  }
  Child child(id, reading, options.limit);
  std::string output = child.output();
  const std::optional<int> exit_code = child.exit_code();
  return {exit_code ? ChildStatus::exited : ChildStatus::too_long, exit_code.value_or(0), std::move(output)};
}

}  // namespace flexslip
