// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <seamwright/core/fill/hole_corner.hpp>
#include <vector>

/// The derivatives of a ring fill along its sides; not a public header.
namespace seamwright::fill {

/// The end of a spoke, at which c V + d U = e S'.
struct SpokeEnd {
  std::optional<Eigen::Vector3d>
      derivative;  ///< S', out of the hole; nothing: both sides have position alone
  double c = 1, d = 1, e = 0;
  bool smooth = false;  ///< the sides continue each other as one smooth line
};

struct RingFields {
  std::vector<SpokeEnd> spokes;
  std::vector<std::optional<Poles>> fields;  ///< G of each side; nothing: position alone
  std::vector<FillCorner> corners;
  int degree = 0;  ///< of the patches
};

/// \throws as ringFill() does for corners.
/// Source: docs/theory/fills.md F5.1.
RingFields ringFields(const std::vector<FillSide>& sides, double spoke_scale, double tolerance_rad,
                      int more_degrees);

}  // namespace seamwright::fill
