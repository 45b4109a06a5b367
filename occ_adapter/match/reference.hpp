// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/match/boundary.hpp>

/// The face that stays while the other one of a pair is deformed to meet it. Not a public header.
namespace seamwright::occ {

/// The other face's pcurve along the side of a spline surface, in the parameter t of that side.
struct ReferencePath {
  /// Its parameter is linear in t in [0, 1]: t = 0 at first, or at last if against.
  Pcurve pcurve;
  bool against = false;
  bool with_edge_curve = true;  ///< the pcurve runs with the curve of the other face's edge
  bool linear = true;           ///< it is the given pcurve; false: fitted to the nearest points
  double apart_mm = 0;  ///< largest distance of the side from its nearest points on the path
  double mismatch_mm =
      0;  ///< largest distance of points of equal t, with t linear along the given path
  double ends_apart_mm = 0;  ///< largest distance of corresponding ends
  MatchReason failure;       ///< why there is no such path; empty if there is one
};

/// A linear correspondence is kept if it is within a tenth of the gap tolerance, or within the
/// distance of the edges if that is larger, of the nearest points. Otherwise the path is
/// reparametrised to the points nearest to the side, as a spline within a hundredth of the gap
/// tolerance of the given path.
/// \param moving the side that is deformed. \param other the face beside it.
/// \throws Standard_Failure.
ReferencePath referencePath(const EdgeRows& moving, const MatchSide& other,
                            const FaceMatchOptions& options);

/// A point of a side of a spline surface as a value of core, with the tangent in the sense of t.
SidePoint sidePoint(const EdgeRows& rows, double t);

/// Points of the other face by the parameter t of the side that is deformed. Not thread-safe.
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
