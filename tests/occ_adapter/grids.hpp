// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

/// Shells of spline patches in rows and columns.
namespace seamwright::test {

/// [i][j] is the i-th along u, the j-th along v.
using Patches = std::vector<std::vector<opencascade::handle<Geom_BSplineSurface>>>;

/// Pieces of one surface.
Patches cutUp(const opencascade::handle<Geom_BSplineSurface>& whole,
              const std::vector<double>& at_u, const std::vector<double>& at_v);

/// Whole patches that share their sides, faces in the order of i, then j; edges and vertices lie on
/// the patch that comes first.
/// \param tolerance_mm of edges and vertices, by which the others may be away.
TopoDS_Shape gridOf(const Patches& patches, double tolerance_mm = 0.3);

}  // namespace seamwright::test
