// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace seamwright::cli {

/// What --edge says.
struct EdgeList {
  std::vector<int> numbers;
  bool all = false;  ///< every edge, each alone

  bool isGiven() const { return all || !numbers.empty(); }
};

/// From "all", or from numbers such as "3,Edge7".
/// \throws CLI::ValidationError
EdgeList edgeList(const std::string& text);

}  // namespace seamwright::cli
