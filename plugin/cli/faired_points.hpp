// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/plugin/cli/curve_methods.hpp>

namespace seamwright::cli {

/// By how much points may be off: the middle one of their tolerances, or their rounding where that
/// is larger.
double pointError_mm(const GivenCurve& given, const CurveTask& task);

/// The clothoids through points that were made fair. \param error_mm by how much points may be off
/// where corners are looked for. \throws as fairClothoids().
MadeCurve madeFairPoints(const GivenCurve& given, const CurveTask& task, double error_mm);

/// Names points that are left out or too near to others.
std::vector<std::string> twinNotes(const GivenCurve& given, const CurveTask& task);

}  // namespace seamwright::cli
