// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/plugin/cli/curve_methods.hpp>

namespace seamwright::cli {

/// \throws std::domain_error for a curve so large or small that formulas overflow or vanish.
void requireSize(const GivenCurve& given);

/// A curve far from the origin, in coordinates from a point of it.
struct LocalCurve {
  GivenCurve given;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double rounding_mm = 0;  ///< of the way there and back
};

LocalCurve localCurve(const GivenCurve& given);

/// The tolerance without what the rounding of the result takes. \throws std::domain_error if that
/// is too much of it.
CurveTask taskOf(const LocalCurve& local, const CurveTask& task);

/// Takes the result of the local curve to the place of the given one.
void moveBack(MadeCurve& made, const LocalCurve& local);

}  // namespace seamwright::cli
