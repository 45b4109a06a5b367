// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <seamwright/core/seam/seam_side.hpp>

namespace seamwright {

/// The fields of one side over a piece of the seam.
struct SideFields {
  std::vector<SurfaceFields> alternatives;  ///< more than one if the piece lies across a knot line
  std::optional<double> split;              ///< there are no fields: cut the piece here first
  /// Derivative of (u, v) in the direction of increasing s, of any length; the third coordinate is
  /// 0. Only with the change of curvature.
  VectorModel direction = {};

  /// Whether the side is known to have a tangent plane on the whole piece.
  bool hasPlane() const;
  /// Whether the curvature of the side is known to be bounded on the whole piece; also for fields
  /// without the tensor.
  bool hasCurvature() const;
};

/// Evaluates a side over pieces [from, to] of the seam, with s in 0..1, and tells where to cut
/// pieces.
class SideEvaluator {
 public:
  explicit SideEvaluator(const SeamSide& side);

  bool faceOnLeft() const { return side_.face_on_left; }
  bool isRegular() const { return side_.surface->isRegular(); }

  /// Adds the parameters in (0, 1) at which the path is not smooth.
  void addBreaks(std::vector<double>& breaks) const;

  /// Where the path crosses knot lines of the surface inside the piece, the result has no fields
  /// but a parameter at which to cut. A piece shorter than 2^-30 of the seam is not cut: it has one
  /// alternative for each side of the line. Along a knot line, the side on which the face lies
  /// counts.
  SideFields fields(double from, double to, Detail detail) const;

 private:
  ChebyshevModel parameter(double from, double to) const;
  std::vector<double> hints(int d, const VectorModel& uv, double from, double to,
                            std::optional<double>& split) const;
  double touchingDistance(int d, const ChebyshevModel& coordinate) const;
  std::vector<double> besideKnots(const std::vector<double>& knots, int d,
                                  const VectorModel& uv) const;

  const SeamSide& side_;
  /// Typical size of the parameters along the path; 0 where the surface has no knots.
  std::array<double, 2> reach_{};
};

}  // namespace seamwright
