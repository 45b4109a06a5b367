// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace seamwright {

/// The numbers 0 to count - 1 in sets that can be united. The smallest member names a set.
class DisjointSets {
 public:
  explicit DisjointSets(int count = 0) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  /// Adds a set with the next number as its only member. \returns that number.
  int add() {
    parent_.push_back(count());
    return parent_.back();
  }
  int of(int member) const {
    while (parent_[member] != member) member = parent_[member];
    return member;
  }
  void unite(int a, int b) {
    const int of_a = of(a), of_b = of(b);
    parent_[std::max(of_a, of_b)] = std::min(of_a, of_b);
  }
  int count() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_;
};

}  // namespace seamwright
