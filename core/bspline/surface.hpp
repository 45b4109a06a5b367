// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/seam/seam_side.hpp>

namespace seamwright {

/// A (rational) tensor-product B-spline surface with clamped ends, stored by its homogeneous poles.
///
/// Row i count_v + j of the pole matrix is the pole P[i][j]; i belongs to u, j to v. Knots are flat: each repeated by its multiplicity,
/// degree + 1 times at both ends.
struct BSplineSurface {
  int degree_u = 0;
  int degree_v = 0;
  std::vector<double> knots_u;
  std::vector<double> knots_v;
  HomogeneousPoles poles;

  int countU() const { return static_cast<int>(knots_u.size()) - degree_u - 1; }
  int countV() const { return static_cast<int>(knots_v.size()) - degree_v - 1; }
};

/// \throws std::invalid_argument if counts and knots do not fit, knots decrease or are not clamped, a number is not finite or a weight not
/// positive; with the index and the value.
void requireValid(const BSplineSurface& surface);

/// The same patch with knots 0 and 1.
BSplineSurface splineSurface(const BezierPatch& patch);

/// Point and partials to third order.
SurfaceJet jet(const BSplineSurface& surface, double u, double v);

/// The side that a surface gives to a seam along one of its edges, for encloseSeam(); s is the parameter that runs along the edge, mapped
/// to 0..1, or 1 minus it if \p reversed.
SeamSide seamSide(const BSplineSurface& surface, PatchEdge edge, bool reversed = false);

}  // namespace seamwright
