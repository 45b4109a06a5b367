// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <optional>

#include <seamwright/occ_adapter/progress.hpp>

/// Stops work when its time is over. Not a public header.
namespace seamwright::occ {

class TimeLimit {
 public:
  /// Starts the clock. \param limit_s infinity: no limit.
  explicit TimeLimit(double limit_s) : limit_s_(limit_s) {}

  double spent_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  double left_s() const { return limit_s_ - spent_s(); }
  bool isOver() const { return left_s() <= 0; }

  /// Calls \p work with a progress that asks it to stop once \p share of the limit has passed since
  /// the start, or when \p progress asks for it.
  /// \returns the result of the work; nothing if the time was over first.
  /// \throws Cancelled if \p progress asked for it.
  template <class Work>
  auto within(double share, const Progress& progress, const Work& work) const
      -> std::optional<decltype(work(progress))> {
    const double end_s = share * limit_s_;
    if (spent_s() >= end_s) return {};
    bool is_cancelled = false;
    const Progress timed = [&](double done) {
      is_cancelled = is_cancelled || (progress && !progress(done));
      return !is_cancelled && spent_s() < end_s;
    };
    try {
      return work(timed);
    } catch (const Cancelled&) {
      if (is_cancelled) throw;
      return {};
    }
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double limit_s_;
};

}  // namespace seamwright::occ
