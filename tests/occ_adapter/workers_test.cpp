// SPDX-License-Identifier: LGPL-2.1-or-later
// Work on several threads: each piece once, and what is thrown comes out of the call when no thread
// runs any more.
#include <gtest/gtest.h>

#include <Standard_OutOfRange.hxx>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <seamwright/occ_adapter/analyze/workers.hpp>

namespace seamwright::test {
namespace {

using occ::runParallel;

TEST(Workers, EachPieceIsDoneOnce) {
  for (const int jobs : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> done(100);
    runParallel(done.size(), jobs, [&](std::size_t i) { ++done[i]; }, {});
    for (const auto& times : done) EXPECT_EQ(times, 1) << jobs << " jobs";
  }
  runParallel(0, 2, [](std::size_t) { FAIL() << "there is no work"; }, {});
}

TEST(Workers, WhatWorkThrowsComesOutOnceNoThreadRuns) {
  for (const int jobs : {1, 2, 4}) {
    std::atomic<int> running = 0, begun = 0;
    const auto work = [&](std::size_t i) {
      ++begun;
      ++running;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      --running;
      if (i == 3) throw std::out_of_range("piece 3");
    };
    try {
      runParallel(1000, jobs, work, {});
      FAIL() << "nothing was thrown with " << jobs << " jobs";
    } catch (const std::out_of_range& error) {
      EXPECT_STREQ(error.what(), "piece 3");
    }
    EXPECT_EQ(running, 0);
    EXPECT_LT(begun, 100) << "no further work is begun";
  }
}

TEST(Workers, FailuresOfOpenCascadeComeOutToo) {
  const auto work = [](std::size_t) { throw Standard_OutOfRange("too far"); };
  EXPECT_THROW(runParallel(8, 2, work, {}), Standard_OutOfRange);
}

TEST(Workers, WhatProgressThrowsComesOutOnceNoThreadRuns) {
  std::atomic<int> running = 0;
  const auto work = [&](std::size_t) {
    ++running;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    --running;
  };
  const occ::Progress progress = [](double share) -> bool {
    if (share > 0) throw std::runtime_error("asked to");
    return true;
  };
  EXPECT_THROW(runParallel(1000, 2, work, progress), std::runtime_error);
  EXPECT_EQ(running, 0);
  EXPECT_THROW(runParallel(1000, 2, work, [](double share) { return share == 0; }), occ::Cancelled);
  EXPECT_EQ(running, 0);
}

}  // namespace
}  // namespace seamwright::test
