// SPDX-License-Identifier: LGPL-2.1-or-later
// TimeLimit: work goes on while there is time, and a request to stop is told from a time that is
// over.
#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>

#include <seamwright/occ_adapter/repair/time_limit.hpp>

namespace seamwright::test {
namespace {

using occ::Cancelled;
using occ::Progress;
using occ::TimeLimit;

/// Works until it is asked to stop, five seconds at most.
int untilStopped(const Progress& progress) {
  for (int k = 0; k < 5000; ++k) {
    if (!progress(0)) throw Cancelled();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return 5000;
}

TEST(TimeLimit, WorkIsStoppedAtItsShareOfTheTime) {
  const TimeLimit limit(2);
  EXPECT_FALSE(limit.within(0.25, {}, untilStopped));
  EXPECT_GE(limit.spent_s(), 0.5);
  EXPECT_FALSE(limit.isOver()) << "after a quarter of the time";
  EXPECT_FALSE(limit.within(1, {}, untilStopped));
  EXPECT_TRUE(limit.isOver());
}

TEST(TimeLimit, NothingIsBegunAfterTheTime) {
  const TimeLimit limit(1e-9);
  bool is_begun = false;
  EXPECT_FALSE(limit.within(1, {}, [&](const Progress&) { return is_begun = true; }));
  EXPECT_FALSE(is_begun);
}

TEST(TimeLimit, ProgressPassesThrough) {
  const TimeLimit limit(std::numeric_limits<double>::infinity());
  double share = 0;
  const Progress progress = [&](double now) {
    share = now;
    return true;
  };
  EXPECT_EQ(limit.within(1, progress, [](const Progress& own) { return own(0.7) ? 3 : 0; }), 3);
  EXPECT_EQ(share, 0.7);
  EXPECT_FALSE(limit.isOver());
}

TEST(TimeLimit, ARequestToStopIsNoEndOfTheTime) {
  const TimeLimit limit(1e9);
  const Progress stop = [](double) { return false; };
  EXPECT_THROW(static_cast<void>(limit.within(1, stop, untilStopped)), Cancelled);
  // Work that stops itself was not asked to.
  EXPECT_FALSE(limit.within(1, {}, [](const Progress&) -> int { throw Cancelled(); }));
}

}  // namespace
}  // namespace seamwright::test
