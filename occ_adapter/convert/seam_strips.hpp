// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/seam/measure.hpp>
#include <seamwright/occ_adapter/convert/face_strip.hpp>

namespace seamwright::occ {

/// The parameter of the first edge, 0..1 over the range of its curve, at s of a seam.
double parameterOnFirst(const Correspondence& correspondence, double s);

/// Both sides of a seam over its parameter s in [0, 1]. Not thread-safe. The seam must outlive it.
class SeamStrips {
 public:
  /// \param pcurves the path of each side on its face, see pcurveOf().
  SeamStrips(const Seam& seam, const std::array<Pcurve, 2>& pcurves,
             JetOrder order = JetOrder::Second);

  /// The sides at corresponding points: equal parameters of a shared edge; for a matched seam, the
  /// point of the first edge that the correspondence has at s, and the point of the second edge
  /// that is nearest to it. Both tangents are in the sense of s.
  /// \throws Standard_Failure where OpenCASCADE can't evaluate.
  PairMeasure measureAt(double s) const;

  /// 0, the values of s at which the jet of a side may not be smooth, and 1. Breaks that differ by
  /// rounding only are one. Knots of the correspondence are not included, because points and planes
  /// are smooth there.
  std::vector<double> breaks() const;

 private:
  double parameterOnB(double s, const Eigen::Vector3d& on_a) const;

  const Correspondence& map_;
  FaceStrip a_;
  FaceStrip b_;
};

}  // namespace seamwright::occ
