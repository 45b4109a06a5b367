// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <string>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/match/boundary.hpp>

/// The face of a pair that stays while the other one is deformed to meet it; not a public header.
namespace seamwright::occ {

/// The other face's path along the side of a spline surface, brought to the parameter t of that
/// side.
struct ReferencePath {
  /// A point of it belongs to t in [0, 1] linearly: t = 0 at first, or at last if against.
  Pcurve pcurve;
  bool against = false;
  bool with_edge_curve = true;  ///< the pcurve runs with the curve of the other face's edge
  bool linear = true;           ///< it is the pcurve as given; false: fitted to the nearest points
  double apart_mm = 0;  ///< largest distance of the side from its nearest points on the path
  double mismatch_mm =
      0;  ///< largest distance of points of equal t, with t linear along the path given
  double ends_apart_mm = 0;  ///< largest distance of the ends that belong together
  std::string failure;       ///< why there is none
};

/// \param moving the side that is deformed; \param other the face beside it. A linear
/// correspondence is kept where the nearest points are within the larger of a tenth of the gap
/// tolerance and the distance of the edges from it; else the path is run through at the nearest
/// points of the side, as a spline that keeps within a hundredth of the gap tolerance of the path
/// given.
/// \throws Standard_Failure.
ReferencePath referencePath(const EdgeRows& moving, const MatchSide& other,
                            const FaceMatchOptions& options);

/// A point of a side of a spline surface as core sees it, tangent in the sense of t.
SidePoint sidePoint(const EdgeRows& rows, double t);

/// Points of the other face by the parameter t of the side that is deformed.
class Reference {
 public:
  Reference(const MatchSide& other, const ReferencePath& path);
  /// \throws Standard_Failure where OpenCASCADE can't evaluate.
  SidePoint at(double t) const;

 private:
  FaceStrip strip_;
  bool against_;
  bool other_side_;  ///< t runs against the curve of the other face's edge
};

}  // namespace seamwright::occ
