// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/repair/prepared_surface.hpp>
#include <seamwright/occ_adapter/repair/surface_basis.hpp>

/// The displacement of a spline surface, as a separate spline. Not a public header.
namespace seamwright::occ {

/// A quadratic part of an energy: the sum over x, y, z of c^T matrix c, where c holds that
/// coordinate of each coefficient.
struct EnergyBlock {
  std::vector<int> coefficients;  ///< increasing
  Eigen::MatrixXd matrix;
};

/// X + D: a given surface X and its displacement D, a spline over the same domain with a few knots
/// of its own. D has at least degree 3 and simple knots, so it has no sharp bends, whatever knots X
/// has.
///
/// If X has a denominator with continuous first derivatives, D is a spline divided by that
/// denominator over its first weight. Then X + D has the degree of X, or of D. Where second
/// derivatives of the denominator jump, those of D jump in proportion. If the denominator varies
/// along a side that is one point, D is a plain spline.
///
/// D is periodic where X is. Where X meets itself along a seam that is to be repaired, D may bend
/// as sharply as X. A side of X that is one point, or within \p near_mm of one, has one
/// coefficient.
class Displacement {
 public:
  /// \param given clamped or periodic.
  /// \param face_range parameters that the face shows: u from, to, v from, to.
  /// \param spans number of spans of D over the face's range, in both directions.
  /// \param bends_at_closing see above.
  /// \param degrees in u and v that X had before its first displacement, and so the degrees of its
  /// denominator; none: those of X. With them, further displacements need no higher degree.
  Displacement(const opencascade::handle<Geom_BSplineSurface>& given,
               const std::array<double, 4>& face_range, int spans, double near_mm,
               bool bends_at_closing = false,
               const std::optional<std::array<int, 2>>& degrees = {});

  /// Number of unknown coefficients: D = sum of share times coefficient.
  int count() const { return count_; }
  const PointRows& coefficients() const { return coefficients_; }
  void setCoefficients(PointRows coefficients) { coefficients_ = std::move(coefficients); }

  /// D and its derivatives in u and v as sums over coefficients. \param into see
  /// SurfaceBasis::at().
  PoleShares shares(const Eigen::Vector2d& uv, const Eigen::Vector2d& into) const;
  /// Coefficients whose basis functions are not zero at (u, v), with a few neighbours in both
  /// directions.
  std::vector<int> coefficientsNear(const Eigen::Vector2d& uv) const;
  /// Coefficients of the side on which u (\p fixed 0) or v (\p fixed 1) has its first or last
  /// value, in the order of the other parameter.
  std::vector<int> coefficientsOfSide(int fixed, bool at_last) const;
  /// X and its derivatives.
  SurfaceJet given(const Eigen::Vector2d& uv, const Eigen::Vector2d& into) const;
  SurfaceJet moved(SurfaceJet given, const PoleShares& shares) const;
  JetNoise noise(const SurfaceJet& jet) const { return noiseOf(jet, given_basis_); }
  /// Denominator of D; 1 if D has none.
  double denominator(const Eigen::Vector2d& uv) const;
  const SurfaceBasis& givenBasis() const { return given_basis_; }
  const SurfaceBasis& basis() const { return basis_; }
  const opencascade::handle<Geom_BSplineSurface>& givenSurface() const { return given_; }

  /// Halves these spans of D in u and v by a knot in each: a knot of X in the middle half of the
  /// span if there is one, otherwise the middle. At an end of such a span where second derivatives
  /// of X jump, the knot gets the multiplicity with which those of D may jump too. D itself does
  /// not change.
  /// \returns whether a knot was inserted.
  bool halve(const std::array<std::set<int>, 2>& spans);

  /// The bending energy: the integral over the face of |Hess D|^2 dA, which has no unit. Hess is
  /// the covariant Hessian of each coordinate of D in the metric of X. Each span of D has its own
  /// Gauss points. Parameters beyond the face's range count with weight 0.03.
  /// \returns one block for each span of D.
  std::vector<EnergyBlock> bending() const;

  double size_mm() const { return size_mm_; }
  struct Moved {
    /// X + D in the knots of both. If X is rational and D is not divided by the denominator, the
    /// degree is the sum of the degrees of the denominator and D.
    opencascade::handle<Geom_BSplineSurface> surface;
    /// Upper bound of the move of any point of the face. It is the largest move of a pole of the
    /// part of X that the face shows, in these knots, and includes the move that made a side one
    /// point.
    double largest_move_mm = 0;
  };
  Moved moved() const;

 private:
  Displacement(const PreparedSurface& given, bool given_periodic,
               const std::array<double, 4>& face_range, int spans, double near_mm,
               bool bends_at_closing, const std::optional<std::array<int, 2>>& degrees);
  void number();
  EnergyBlock bendingOfSpan(int span_u, int span_v, double least_metric) const;
  opencascade::handle<Geom_BSplineSurface> displacementSurface() const;
  std::pair<opencascade::handle<Geom_BSplineSurface>, PointRows> refined() const;
  double largestOf(opencascade::handle<Geom_BSplineSurface> moves) const;

  opencascade::handle<Geom_BSplineSurface> given_;
  /// Knots, degrees and weights of D; its poles are not used.
  opencascade::handle<Geom_BSplineSurface> shape_;
  double collapse_mm_;  ///< see PreparedSurface
  std::array<double, 4> range_;
  double near_mm_;
  bool given_periodic_;
  std::array<int, 2> degrees_;    ///< of the denominator of X
  bool has_denominator_ = false;  ///< D has the denominator of X
  SurfaceBasis given_basis_, basis_;
  PointRows given_poles_;
  std::vector<int> number_;  ///< by pole of D: index of its coefficient
  int count_ = 0;
  PointRows coefficients_;
  double size_mm_ = 0;
};

}  // namespace seamwright::occ
