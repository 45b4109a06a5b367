// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/seam/measure.hpp>
#include <seamwright/occ_adapter/convert/face_strip.hpp>

namespace seamwright::occ {

/// The place of the first edge, 0..1 of the range of its curve, at s of a seam.
double placeOnFirst(const Correspondence& correspondence, double s);

/// Both sides of a seam over its parameter s in [0, 1]. Not to be shared between threads; the seam
/// must outlive it.
class SeamStrips {
 public:
  /// \param pcurves the path of each side on its face, see pcurveOf().
  SeamStrips(const Seam& seam, const std::array<Pcurve, 2>& pcurves,
             JetOrder order = JetOrder::Second);

  /// The sides at corresponding points: equal parameters of a shared edge; of a matched one, the
  /// place of the first edge that its correspondence has at s, and the place of the second one that
  /// is nearest to it. Both tangents in the sense of s.
  /// \throws Standard_Failure where OpenCASCADE can't evaluate.
  PairMeasure measureAt(double s) const;

  /// 0, where the jet of a side may not be smooth, 1. Breaks that only rounding tells apart are
  /// one; the knots of the correspondence are no breaks, as points and planes go on smoothly there.
  std::vector<double> breaks() const;

 private:
  double placeOnB(double s, const Eigen::Vector3d& on_a) const;

  const Correspondence& map_;
  FaceStrip a_;
  FaceStrip b_;
};

}  // namespace seamwright::occ
