// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/core/blend/spline_places.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>
#include <vector>

namespace seamwright::cli {

/// Where closed curves should begin, whose loft has an edge there: at a corner, or else where all
/// are smooth; nothing if they begin there. \param orders of the joints of all curves, as
/// measureJoints() has them; \p order is asked for.
std::optional<match::Place> loftStart(const std::vector<BezierSpline>& curves,
                                      const std::vector<int>& orders, int order);

}  // namespace seamwright::cli
