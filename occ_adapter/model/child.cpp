// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include <seamwright/occ_adapter/model/child.hpp>

namespace seamwright::occ {

namespace {

[[noreturn]] void fail(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

/// Owns the list of what happens to descriptors between fork and exec.
struct FileActions {
  posix_spawn_file_actions_t actions{};
  FileActions() { posix_spawn_file_actions_init(&actions); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
};

/// Starts the child in a process group of its own: Ctrl-C at the terminal is for the parent, which
/// then ends the child.
struct OwnGroup {
  posix_spawnattr_t attributes{};
  OwnGroup() {
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  }
  ~OwnGroup() { posix_spawnattr_destroy(&attributes); }
  OwnGroup(const OwnGroup&) = delete;
  OwnGroup& operator=(const OwnGroup&) = delete;
};

}  // namespace

Child::Child(const std::string& program, const std::vector<std::string>& arguments, int input) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno, "pipe");
  answer_ = ends[0];
  FileActions files;
  // The answer first: opening the null device may not land on the descriptor of the pipe before it
  // is passed on.
  posix_spawn_file_actions_adddup2(&files.actions, ends[1], answer_descriptor);
  if (input >= 0)
    posix_spawn_file_actions_adddup2(&files.actions, input, STDIN_FILENO);
  else
    posix_spawn_file_actions_addopen(&files.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files.actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files.actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const OwnGroup group;
  const int error = ::posix_spawn(&pid_, program.c_str(), &files.actions, &group.attributes,
                                  argv.data(), environ);
  ::close(ends[1]);
  if (error != 0) {
    ::close(answer_);
    fail(error, program.c_str());
  }
}

Child::~Child() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  ::close(answer_);
}

bool Child::receive(const std::function<void(std::string_view)>& receive) {
  pollfd waiting{answer_, POLLIN, 0};
  // Milliseconds: a stop is felt at once, and waiting costs nothing.
  if (::poll(&waiting, 1, 50) <= 0) return true;
  static thread_local std::array<char, 1 << 16> buffer;
  const ssize_t count = ::read(answer_, buffer.data(), buffer.size());
  if (count < 0) {
    if (errno == EINTR || errno == EAGAIN) return true;
    fail(errno, "read");
  }
  if (count > 0) receive({buffer.data(), static_cast<std::size_t>(count)});
  return count > 0;
}

std::optional<int> Child::ended() {
  int status = 0;
  const pid_t ended = ::waitpid(pid_, &status, WNOHANG);
  if (ended == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return std::nullopt;
  }
  if (ended < 0 && errno == EINTR) return std::nullopt;
  pid_ = -1;
  return status;
}

}  // namespace seamwright::occ
