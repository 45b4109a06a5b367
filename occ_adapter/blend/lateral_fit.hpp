// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/blend/blend_sheet.hpp>

/// Sheets that run along given curves between their sides. Not a public header.
namespace seamwright::occ {

/// The sheet moved to its lateral boundaries, by splines across; the derivatives that its ends have
/// at v = 0 and v = 1 stay as they are. Spans across are halved until every sample is within a
/// fifth of that share of the tolerance, or no span can be halved. A sheet that is near enough
/// stays as it is. \throws Cancelled. Source: docs/theory/surfaces.md S8.5, S8.6.
BSplineSurface fittedToLaterals(const BlendTask& task, const BSplineSurface& sheet,
                                double share_of_tolerance, int max_spans, const Progress& progress);

/// The largest distance between points of the boundary and those of the curve that are meant.
double farthestFromCurve_mm(const BlendLateral& lateral, const BSplineSurface& sheet);

}  // namespace seamwright::occ
