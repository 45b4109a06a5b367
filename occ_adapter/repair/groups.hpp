// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace seamwright::occ {

/// Disjoint groups of numbers. The smallest number of a group names the group.
class Groups {
 public:
  explicit Groups(int count = 0) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int of(int member) const {
    while (parent_[member] != member) member = parent_[member];
    return member;
  }
  void join(int a, int b) { parent_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }
  int count() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_;
};

}  // namespace seamwright::occ
