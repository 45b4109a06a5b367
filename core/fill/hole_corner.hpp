// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/core/fill/n_sided_fill.hpp>
#include <string>
#include <vector>

/// The given sides of a hole, and their data at the corners; not a public header.
namespace seamwright::fill {

/// "12.5 degrees", to six digits.
std::string degreesText(double angle_rad);

/// \throws std::invalid_argument as nSidedFill() does for sides: rational, degrees, not finite, not
/// closed, without a tangent; for a tolerance outside [0, 0.1]; and for an order other than 2 and
/// 3.
void requireSides(const std::vector<FillSide>& sides);
void requireFairness(int order);
void requireTolerance(double corner_tolerance_rad);
/// \throws std::invalid_argument for degrees outside 0 to 6.
void requireCurvature(const std::optional<int>& degrees);

/// d/dt at the ends of a side.
Eigen::Vector3d tangentAtBegin(const FillSide& side);
Eigen::Vector3d tangentAtEnd(const FillSide& side);

/// A side with tangent planes at one of its ends: derivatives by t.
struct SideEnd {
  Eigen::Vector3d edge, edge2;    // E', E''
  Eigen::Vector3d cross, cross1;  // T, T'
  double noise = 0;               // of T and E', by rounding of coordinates
};

/// The coefficients of \p vector by the two other vectors, by least squares.
Eigen::Vector2d combination(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                            const Eigen::Vector3d& vector);

/// The data of both sides at the corner where side k begins and side k - 1 ends.
class HoleCorner {
 public:
  /// \throws std::invalid_argument for a cross-boundary derivative parallel to the edge.
  HoleCorner(const std::vector<FillSide>& sides, std::size_t k);

  /// The angles at the corner. \throws std::invalid_argument for planes that differ by more than
  /// the tolerance and rounding.
  FillCorner figures(double tolerance_rad) const;
  /// The same for a convex corner. \throws std::invalid_argument also for an angle of the hole of
  /// 0, and of 180 degrees or more.
  FillCorner convexFigures(double tolerance_rad) const;
  /// Bound of the rounding of the angles.
  double noise_rad() const { return noise_rad_; }
  /// The direction from which a viewer sees the hole to the left of its sides; zero if no side has
  /// a tangent plane.
  Eigen::Vector3d up() const;

  const Eigen::Vector3d& in() const { return in_; }
  const Eigen::Vector3d& out() const { return out_; }
  const std::optional<SideEnd>& before() const { return before_; }
  const std::optional<SideEnd>& after() const { return after_; }

 private:
  double planeNoise(const SideEnd& end, std::size_t side) const;
  double planeAngle() const;
  double interiorAngle() const;

  std::size_t k_;
  Eigen::Vector3d in_, out_;
  std::optional<SideEnd> before_, after_;
  double noise_rad_ = 0;
};

/// Bound of the angle between span(E', G) and span(E', G + change), Bernstein coefficients on one
/// interval.
/// Source: docs/theory/fills.md F3.1.
double angleBound(const Poles& field, const Poles& change, const Poles& edge1);

}  // namespace seamwright::fill
