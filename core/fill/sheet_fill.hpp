// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/progress.hpp>

namespace seamwright {

/// A point of a side of a hole, with what the surface beyond has there.
struct SheetSample {
  Eigen::Vector3d point;       ///< mm
  Eigen::Vector3d derivative;  ///< by the share of the side, mm
  /// Unit normal; the hole is to the left of the derivative for a viewer at its tip.
  Eigen::Vector3d normal;
  /// c . bend c is the second derivative along a tangent vector c, towards the normal, 1/mm.
  Eigen::Matrix3d bend;
};

/// A side of a hole between two corners.
struct SheetFillSide {
  /// \param share of the length, in [0, 1].
  std::function<SheetSample(double share)> at;
  /// Shares inside (0, 1) at which the side or the surface beyond may not have a continuous
  /// curvature.
  std::vector<double> joints;
};

struct SheetFillOptions {
  double gap_mm = 0;     ///< accepted distance along the sides
  double angle_rad = 0;  ///< accepted angle of the normals along the sides; 0: position only
  int most_poles = 1500;
  /// Accepted curvature jumps weigh so much beside the variation of the second derivatives.
  double bend_weight = 10;
};

/// A spline over a rectangle whose four edges are the sides of the hole.
struct SheetFill {
  /// Of degree 5, with knots from 0 in mm: u along sides 0 and 2, v along sides 1 and 3. Side 0 is
  /// v = 0, side 1 the largest u, side 2 the largest v backwards, side 3 u = 0 backwards.
  BSplineSurface surface;
  double gap_mm = 0;     ///< largest distance from the sides, at samples between the fitted
  double angle_rad = 0;  ///< largest angle to the normals there
  bool regular = false;  ///< proved: the normal vanishes nowhere
};

/// The fairest splines that meet four sides in position, each by its length, and, if angle_rad is
/// above 0, in the tangent planes, one after another with more knots. They may bend as far as they
/// have to, as around a tube.
///
/// Among the surfaces that meet the sides each minimises the integral of the squared third
/// derivatives over a rectangle with their mean lengths. Knots are added where the sides are missed
/// most, until no further step helps. The sheets depend on the sides alone: which of them next()
/// returns depends on the accepted figures.
/// Identities (each has a test of its number):
///   (1) A bilinear surface with sides of constant speed is reproduced, up to rounding.
///   (2) The result does not depend on which side is the first.
///   (3) Along the sides the spline and its normals are the given ones within the reported figures.
///   (4) Larger accepted figures have every sheet that smaller ones have.
/// Source: docs/theory/fills.md F7.1.
class SheetSequence {
 public:
  /// \throws std::invalid_argument for tolerances that are not positive, samples that are not
  /// finite, and sides without length.
  SheetSequence(const std::array<SheetFillSide, 4>& sides, const SheetFillOptions& options);
  ~SheetSequence();
  SheetSequence(SheetSequence&&) noexcept;
  SheetSequence& operator=(SheetSequence&&) noexcept;

  /// The next sheet that is regular and comes within half of what is accepted. If there is none at
  /// all, the nearest one, once; nothing after the last.
  /// \throws std::invalid_argument for samples that are not finite; Cancelled.
  std::optional<SheetFill> next(const Progress& progress = {});

 private:
  class Filling;
  std::unique_ptr<Filling> filling_;
};

/// The first of a SheetSequence.
/// \throws what it throws.
SheetFill sheetFill(const std::array<SheetFillSide, 4>& sides, const SheetFillOptions& options,
                    const Progress& progress = {});

}  // namespace seamwright
