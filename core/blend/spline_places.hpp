// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bezier/length.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

/// Places on a spline by its length, and exact division there; not a public header.
namespace seamwright::match {

/// A point of piece i at its parameter t in 0..1. A joint is t = 0 of the piece after it.
struct Place {
  int piece = 0;
  double t = 0;
};

/// A spline with the lengths of its pieces.
class Measured {
 public:
  /// \throws std::invalid_argument for a piece without length.
  explicit Measured(BezierSpline spline);

  const BezierSpline& spline() const { return spline_; }
  double length_mm() const { return sums_.back(); }
  /// The share of the length up to the beginning of piece i, i = 0 .. segments.
  double share(int i) const { return sums_[i] / sums_.back(); }
  double shareAt(const Place& place) const;
  /// \param precision share of the piece's length up to which the place is found.
  Place placeAt(double share, double precision = 1e-9) const;
  /// The place of a parameter by the knots.
  Place placeOf(double parameter) const;
  Eigen::Vector3d point(const Place& place) const;

 private:
  BezierSpline spline_;
  std::vector<BezierCurve> pieces_;
  std::vector<std::vector<LengthMark>> marks_;  ///< of each piece
  std::vector<double> sums_;                    ///< of lengths
  std::vector<double> sizes_;                   ///< lengths of the control polygons
};

/// The same curve with joints at these places, which increase; places at joints change nothing.
BezierSpline dividedAt(const BezierSpline& spline, const std::vector<Place>& places);

/// The same closed curve from that place on. The knots begin at the same number.
BezierSpline startingAt(const BezierSpline& spline, const Place& place);

/// The same curve run backwards, over the same range.
BezierSpline runBackwards(const BezierSpline& spline);

}  // namespace seamwright::match
