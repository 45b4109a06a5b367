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

/// The displacement of a spline surface, as a spline of its own; not a public header.
namespace seamwright::occ {

/// A part of an energy: the sum over coordinates of c^T matrix c, where c has the coefficients'
/// coordinates.
struct EnergyBlock {
  std::vector<int> coefficients;  ///< increasing
  Eigen::MatrixXd matrix;
};

/// X + D: a surface X that is given and a displacement D, a spline over the same domain with few
/// knots of its own. D has degree 3 at least and simple knots, so it bends nowhere sharply,
/// whatever knots X has. If X has a denominator with continuous first derivatives D is divided by
/// it, over its first weight: so X + D has the degree of X, or of D. Where second derivatives of
/// the denominator jump, those of D do so in proportion. It is periodic where X is; where X ends at
/// itself with a seam that is to be repaired it may bend as sharply as X. Sides of X that are one
/// point, or within \p near_mm one, have one coefficient.
class Displacement {
 public:
  /// \param given clamped or periodic. \param face_range of the parameters that the face shows: u
  /// from, to, v from, to.
  /// \param spans of D over the face's range, in both directions. \param bends_at_closing see
  /// above.
  /// \param degrees by direction: those that X had before it was displaced for the first time, and
  /// so those of its denominator; none: those of X. With them, further displacements need no higher
  /// degree.
  Displacement(const opencascade::handle<Geom_BSplineSurface>& given,
               const std::array<double, 4>& face_range, int spans, double near_mm,
               bool bends_at_closing = false,
               const std::optional<std::array<int, 2>>& degrees = {});

  /// Unknowns: D = sum of share times coefficient.
  int count() const { return count_; }
  const PointRows& coefficients() const { return coefficients_; }
  void setCoefficients(PointRows coefficients) { coefficients_ = std::move(coefficients); }

  /// D and its derivatives by (u, v) as sums over coefficients. \param into see SurfaceBasis::at().
  PoleShares shares(const Eigen::Vector2d& uv, const Eigen::Vector2d& into) const;
  /// The coefficients whose functions are not zero at (u, v), and those of a few neighbours in both
  /// directions.
  std::vector<int> coefficientsNear(const Eigen::Vector2d& uv) const;
  /// Of the side where u (\p fixed 0) or v (1) is first or last, in the order of the other
  /// parameter.
  std::vector<int> coefficientsOfSide(int fixed, bool at_last) const;
  /// X and its derivatives.
  SurfaceJet given(const Eigen::Vector2d& uv, const Eigen::Vector2d& into) const;
  SurfaceJet moved(SurfaceJet given, const PoleShares& shares) const;
  JetNoise noise(const SurfaceJet& jet) const { return noiseOf(jet, given_basis_); }
  /// Of D, 1 if it has none.
  double denominator(const Eigen::Vector2d& uv) const;
  const SurfaceBasis& givenBasis() const { return given_basis_; }
  const SurfaceBasis& basis() const { return basis_; }
  const opencascade::handle<Geom_BSplineSurface>& givenSurface() const { return given_; }

  /// Knots of D in u and in v, beside those that it has; where X has a knot within the middle half
  /// of the span, that one. D stays.
  /// \returns whether any was inserted.
  bool halve(const std::array<std::set<int>, 2>& spans);

  /// The bending energy: the integral over the face of |Hess D|^2 dA, which has no unit. Hess is
  /// the covariant Hessian of each coordinate of D in the metric of X. Gauss points in each span of
  /// D. Beyond the face's range it counts for three hundredths.
  /// \returns a block for each span of D.
  std::vector<EnergyBlock> bending() const;

  double size_mm() const { return size_mm_; }
  struct Moved {
    /// X + D in the knots of both; in the sum of the degrees of the denominator and D if D is not
    /// divided by it.
    opencascade::handle<Geom_BSplineSurface> surface;
    /// No point of the face moves by more: the largest move of a pole of its part of X in these
    /// knots, with what made a side one point.
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
  opencascade::handle<Geom_BSplineSurface>
      shape_;           ///< knots, degrees and weights of D; its poles are no matter
  double collapse_mm_;  ///< see PreparedSurface
  std::array<double, 4> range_;
  double near_mm_;
  bool given_periodic_;
  std::array<int, 2> degrees_;    ///< of the denominator of X
  bool has_denominator_ = false;  ///< D has that of X
  SurfaceBasis given_basis_, basis_;
  PointRows given_poles_;
  std::vector<int> number_;  ///< by pole of D: its coefficient
  int count_ = 0;
  PointRows coefficients_;
  double size_mm_ = 0;
};

}  // namespace seamwright::occ
