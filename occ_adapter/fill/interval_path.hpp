// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

#include <seamwright/occ_adapter/fill/side_cut.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

/// An interval of the side of a hole as a path, in several parametrisations. Not a public header.
namespace seamwright::occ {

/// The parametrisation of an interval:
/// - Own: that of its edge.
/// - ArcLength.
/// - Centripetal: between arc length and the centripetal one, in which each edge has the square
///   root of its length. Short edges get more of the freedom of a polynomial.
/// - AffineArcLength: nearly affine arc length, in which ellipses and parabolas have their standard
///   parametrisation.
enum class Parametrisation { Own, ArcLength, Centripetal, AffineArcLength };

class AffineArcLengthShare;

/// An interval of a side over t in [0, 1].
class IntervalPath {
 public:
  IntervalPath(std::shared_ptr<const SidePath> path, const SideInterval& interval)
      : path_(std::move(path)), interval_(interval), slope_(centripetalSlope()) {}

  bool isOneEdge() const { return path_->isOneEdge(); }
  double length_mm() const { return range() * path_->length_mm(); }
  SideSample at(double t, Parametrisation parametrisation) const;

 private:
  double range() const { return interval_.end - interval_.begin; }
  /// The sample at a share of the interval.
  SideSample atShare(double part) const;
  double parameterAround(double share) const;
  const AffineArcLengthShare& affineShare() const;
  /// The slope at 0 of the parabola from (0, 0) to (1, 1) that best fits the centripetal parameters
  /// of the joints.
  double centripetalSlope() const;

  std::shared_ptr<const SidePath> path_;
  SideInterval interval_;
  double slope_;  ///< slope of Parametrisation::Centripetal at the begin of the interval
  mutable std::shared_ptr<const AffineArcLengthShare> affine_;  ///< computed when needed
};

/// Samples at count + 1 Chebyshev nodes, which are closer near the ends.
std::vector<SideSample> samplesOf(const IntervalPath& path, Parametrisation parametrisation,
                                  int count);

}  // namespace seamwright::occ
