// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fair/matrix_curve.hpp>

/// Not a public header.
namespace seamwright {

/// pointAndTangent() without the check of the whole curve, so that the cost does not grow with the
/// number of poles. \pre the curve is valid, the parameter finite.
CurveDerivatives pointAndTangentOfValid(const MatrixCurve& curve, double t);

}  // namespace seamwright
