// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <set>
#include <vector>

#include <seamwright/occ_adapter/repair/surface_basis.hpp>

/// A spline surface beside itself as it was given; not a public header.
namespace seamwright::occ {

/// The number of each pole's move, -1: it stays; poles with one number move as one.
struct MoveNumbers {
  std::vector<int> of_pole;
  int count = 0;
};

/// A spline surface whose poles move and whose knots may become more. Copies share what does not change. Where it ends at itself it is
/// periodic meanwhile (but for one that was given periodic in the other direction), so that it does so after the move, as smoothly as its
/// poles and knots made it before.
class MovingSurface {
 public:
  /// \param near_mm a side within that distance of one point becomes that point.
  MovingSurface(const opencascade::handle<Geom_BSplineSurface>& given, double near_mm);

  const SurfaceBasis& basis() const { return basis_; }
  /// As given, with the knots of now, periodic where it ends at itself, and sides that are nearly one point in one.
  const opencascade::handle<Geom_BSplineSurface>& before() const { return before_; }
  const PointRows& original() const { return original_; }
  const PointRows& poles() const { return poles_; }
  void setPoles(PointRows poles) { poles_ = std::move(poles); }
  /// Periodic where it was given so.
  opencascade::handle<Geom_BSplineSurface> moved() const;
  /// Of a pole, with what sides moved to become one point; 0 if no pole moved since.
  double largestMove_mm() const;
  /// Of the poles in u and v, in the mean, before knots were inserted.
  const std::array<double, 2>& givenSpacing() const { return given_spacing_; }

  /// To at least that. \returns whether it was needed. \pre no pole moved
  bool raiseDegrees(int least);

  /// From now on these poles move, and what knot insertion makes of them. \pre no knot was inserted
  void touch(const std::vector<bool>& poles);

  /// Shape and moves stay. Then only poles near these places move, or, if not \p near_alone, all that are touched.
  void insert(const std::array<std::set<double>, 2>& knots, const std::vector<Eigen::Vector2d>& places,
              bool near_alone);

  /// A side that is one point moves as one.
  MoveNumbers numbers() const;
  /// There is such a side.
  bool isCollapsed() const;

 private:
  opencascade::handle<Geom_BSplineSurface> now() const;

  double near_mm_;
  bool given_periodic_;
  opencascade::handle<Geom_BSplineSurface> before_;
  double collapse_mm_;  ///< the largest move of a pole that made a side one point
  opencascade::handle<Geom_BSplineSurface>
      touched_;  ///< one where a touched pole has a share in the pole of now
  SurfaceBasis basis_;
  PointRows poles_, original_;
  std::vector<bool> settled_;  ///< by pole: it stays where it is by now
  std::array<double, 2> given_spacing_;
};

}  // namespace seamwright::occ
