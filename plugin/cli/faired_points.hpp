// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/plugin/cli/curve_methods.hpp>

namespace seamwright::cli {

/// The clothoids through points that were made fair. \throws as fairClothoids().
MadeCurve madeFairPoints(const GivenCurve& given, const CurveTask& task);

}  // namespace seamwright::cli
