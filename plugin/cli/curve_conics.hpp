// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/plugin/cli/curve_methods.hpp>

namespace seamwright::cli {

/// Conics near a curve, or through its points or near them. \throws as conicSpline() and
/// fitConics().
MadeCurve madeConics(const GivenCurve& given, const CurveTask& task);

}  // namespace seamwright::cli
