// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/bezier/length.hpp>
#include <seamwright/plugin/cli/loft_start.hpp>

namespace seamwright::cli {

namespace {

/// The middle of the piece that is longest on the first curve.
match::Place middleOfLongest(const BezierSpline& curve) {
  int longest = 0;
  double most_mm = 0;
  for (int i = 0; i < curve.segments(); ++i)
    if (const double length_mm = polygonLength(segment(curve, i)); length_mm > most_mm) {
      most_mm = length_mm;
      longest = i;
    }
  return {.piece = longest, .t = 0.5};
}

}  // namespace

std::optional<match::Place> loftStart(const std::vector<BezierSpline>& curves,
                                      const std::vector<int>& orders, int order) {
  if (!curves.front().closed) return std::nullopt;
  const bool has_corners = std::ranges::find(orders, 0) != orders.end();
  const auto isStart = [&](int n) { return has_corners ? n == 0 : n >= order; };
  if (isStart(orders.back())) return std::nullopt;
  const auto joint = std::ranges::find_if(orders, isStart);
  if (joint == orders.end()) return middleOfLongest(curves.front());
  return match::Place{.piece = static_cast<int>(joint - orders.begin()) + 1, .t = 0};
}

}  // namespace seamwright::cli
