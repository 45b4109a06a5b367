// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>

namespace seamwright {

/// A (rational) tensor-product B-spline surface with clamped ends, stored by its homogeneous poles.
///
/// Row i count_v + j of the pole matrix is the pole P[i][j]; i belongs to u, j to v. Knots are
/// flat: each is repeated by its multiplicity, degree + 1 times at both ends. The struct does not
/// check its numbers; requireValid() tells whether they make a surface.
struct BSplineSurface {
  int degree_u = 0;
  int degree_v = 0;
  std::vector<double> knots_u;
  std::vector<double> knots_v;
  HomogeneousPoles poles;

  int countU() const { return static_cast<int>(knots_u.size()) - degree_u - 1; }
  int countV() const { return static_cast<int>(knots_v.size()) - degree_v - 1; }

  bool operator==(const BSplineSurface& other) const {
    return degree_u == other.degree_u && degree_v == other.degree_v && knots_u == other.knots_u &&
           knots_v == other.knots_v && poles.rows() == other.poles.rows() && poles == other.poles;
  }
};

enum class SurfaceDirection { U, V };

/// Requires a valid surface: degrees of 1 to 25, and inner knots of multiplicity at most the
/// degree, so that the surface is continuous.
/// \throws std::invalid_argument, with the index and the value, if counts and knots do not match,
/// if knots decrease or are not clamped, if a number or the range of the knots is not finite (or
/// that range underflows), or if a weight is not positive.
void requireValid(const BSplineSurface& surface);

/// The Bézier patch as a B-spline surface with knots 0 and 1.
BSplineSurface splineSurface(const BezierPatch& patch);
/// A surface without inner knots as a Bézier patch. The parameters of the surface are mapped to
/// 0..1.
/// \throws std::invalid_argument if there are inner knots.
BezierPatch bezierPatch(const BSplineSurface& surface);

/// Point and partials up to third order. On a knot line the derivatives are those of the side of
/// larger parameters; at the end of the range, those from inside. Beyond the range the outermost
/// polynomials continue. Identities (each has a test of its number):
///   (1) For splineSurface(patch) the result is patch.jet().
///   (2) Within a span the partials are derivatives of the point.
/// \throws std::invalid_argument as requireValid() does, and for a parameter that is not finite.
SurfaceJet jet(const BSplineSurface& surface, double u, double v);

/// The same surface with one more knot at the given parameter, by Boehm's algorithm: each new pole
/// is a convex combination of two poles.
///   (3) Points and partials do not change, except for rounding.
/// \throws std::invalid_argument if the knot is not strictly inside the range, or has the
/// multiplicity of the degree already.
BSplineSurface withKnot(const BSplineSurface& surface, SurfaceDirection direction, double knot);

/// The same surface with more knots, all at once; a knot may occur several times. Each new pole is
/// a convex combination of given ones; poles none of whose knots are new stay bitwise. The time is
/// linear in the number of poles.
/// \throws std::invalid_argument as withKnot().
BSplineSurface withKnots(const BSplineSurface& surface, SurfaceDirection direction,
                         const std::vector<double>& added);

/// The same surface with the multiplicity of each inner knot of that direction raised by \p times,
/// but at most to the degree.
BSplineSurface withRaisedKnots(const BSplineSurface& surface, SurfaceDirection direction,
                               int times);

/// The same surface with one degree more in that direction. Each knot is repeated once more, so the
/// surface stays as smooth as it is.
/// \throws std::invalid_argument if the degree is 25.
BSplineSurface elevated(const BSplineSurface& surface, SurfaceDirection direction);

/// The direction of the parameter that runs along an edge.
SurfaceDirection along(PatchEdge edge);

}  // namespace seamwright
