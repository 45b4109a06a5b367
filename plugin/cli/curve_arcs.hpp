// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/plugin/cli/curve_methods.hpp>

namespace seamwright::cli {

/// Arcs and lines near a curve, from corner to corner of points. \throws as fitArcs().
MadeCurve madeArcs(const GivenCurve& given, const CurveTask& task);

}  // namespace seamwright::cli
