// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/plugin/cli/curve_methods.hpp>

namespace seamwright::cli {

/// The splines of a chain made fair within the tolerance, each with the tangents at which it meets
/// its neighbours. Curves that would get more extrema, inflections or energy stay, as do those that
/// are no polynomial B-splines of degree 2 and more; notes count them. \throws as fairCurve().
MadeCurve madeFairSplines(const GivenCurve& given, const CurveTask& task);

}  // namespace seamwright::cli
