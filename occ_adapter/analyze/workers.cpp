// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <seamwright/occ_adapter/analyze/workers.hpp>

namespace seamwright::occ {

void runParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                 const Progress& progress) {
  if (progress && !progress(0)) throw Cancelled();
  const std::size_t wanted =
      jobs > 0 ? static_cast<std::size_t>(jobs) : std::max(1u, std::thread::hardware_concurrency());
  const std::size_t threads = std::min(wanted, count);
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> stop = false;
  std::size_t running = threads;
  std::mutex mutex;
  std::condition_variable ended;
  std::exception_ptr failure;

  const auto loop = [&] {
    std::exception_ptr own_failure;
    try {
      for (std::size_t i = next++; i < count && !stop; i = next++) {
        work(i);
        ++done;
      }
    } catch (...) {
      own_failure = std::current_exception();
      stop = true;
    }
    const std::lock_guard lock(mutex);
    if (!failure) failure = own_failure;
    --running;
    ended.notify_one();
  };
  bool cancelled = false;
  {
    std::vector<std::jthread> pool;
    // An exception from progress must not leave threads behind that run on: they are told to stop
    // and joined.
    struct StopAtExit {
      std::atomic<bool>& stop;
      ~StopAtExit() { stop = true; }
    } stop_at_exit{stop};
    for (std::size_t i = 0; i < threads; ++i) pool.emplace_back(loop);
    std::unique_lock lock(mutex);
    // Twenty times a second: a progress bar looks smooth, and a stop is felt at once.
    while (!ended.wait_for(lock, std::chrono::milliseconds(50), [&] { return running == 0; })) {
      lock.unlock();
      if (progress && !stop && !progress(static_cast<double>(done) / static_cast<double>(count)))
        cancelled = stop = true;
      lock.lock();
    }
  }
  if (failure) std::rethrow_exception(failure);
  if (cancelled) throw Cancelled();
  if (progress && !progress(1)) throw Cancelled();
}

}  // namespace seamwright::occ
