// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semaphore.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <iostream>
#include <seamwright/occ_adapter/model/unfinished_files.hpp>
#include <seamwright/plugin/cli/interrupt.hpp>
#include <string_view>
#include <thread>

namespace seamwright::cli {

namespace {

volatile sig_atomic_t first_signal = 0;
sem_t signals;  ///< those that nobody waited for yet
std::atomic_flag said_stopped;

/// \returns whether the caller is to say it.
bool isFirstToSay() {
  return !said_stopped.test_and_set();
}

int statusOf(int signal) {
  constexpr int by_signal = 128;
  return by_signal + signal;
}

void noteSignal(int number) {
  const int error = errno;
  if (first_signal == 0) first_signal = number;
  sem_post(&signals);
  errno = error;
}

void waitForSignal() {
  while (sem_wait(&signals) != 0) {  // another signal was handled
  }
}

/// \returns whether a signal came.
bool waitForSignal(int most_s) {
  timespec end{};
  clock_gettime(CLOCK_MONOTONIC, &end);
  end.tv_sec += most_s;
  int failed = 0;
  do failed = sem_clockwait(&signals, CLOCK_MONOTONIC, &end);
  while (failed != 0 && errno == EINTR);
  return failed == 0;
}

/// Whatever other threads do.
[[noreturn]] void endNow(const occ::UnfinishedFiles& files) {
  for (const auto& path : files.paths) unlink(path.c_str());
  if (isFirstToSay()) {
    const std::string_view text = files.some_finished
                                      ? "seamwright: stopped\n"
                                      : "seamwright: stopped, nothing was written\n";
    // Nothing can be done if nobody reads it.
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
  }
  _exit(statusOf(first_signal));
}

void endAfterSignals() {
  // A choice: steps of the work are shorter, but for a few.
  constexpr int grace_s = 1;
  waitForSignal();
  const bool again = waitForSignal(grace_s);
  if (const occ::UnfinishedFiles files = occ::unfinishedFiles(); again || !files.some_finished)
    endNow(files);
  waitForSignal();
  endNow(occ::unfinishedFiles());
}

}  // namespace

void noteInterrupts() {
  sem_init(&signals, 0, 0);
  // The main thread gets the signals, which end its calls that wait.
  sigset_t handled{}, before{};
  sigemptyset(&handled);
  sigaddset(&handled, SIGINT);
  sigaddset(&handled, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &handled, &before);
  std::thread(&endAfterSignals).detach();
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  struct sigaction action {};
  action.sa_handler = &noteSignal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return first_signal != 0;
}

int endStopped() {
  if (isFirstToSay()) std::cerr << "seamwright: stopped, nothing was written" << std::endl;
  return statusOf(first_signal == 0 ? SIGINT : first_signal);
}

}  // namespace seamwright::cli
