// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <map>
#include <set>
#include <utility>

/// Faces that moved through others; not a public header.
namespace seamwright::occ {

/// Whether faces that move come out on the other side of others. Sampled at 32 by 32 points of the
/// parameters inside each face that moved: the straight way of such a point crosses another face,
/// as that was or as it is, and the point is on the other side of that face than it was. So sides
/// of a wall that move alike have not passed one another. What is narrower than the distance of the
/// points may be missed.
///
/// Faces that share a vertex, or a seam, do not count: they meet there, and their seams are
/// measured. Nor do faces that touched or cut one another before, as those of an assembly's parts.
class PassedFaces {
 public:
  /// \param beside_seams faces that share a seam, the smaller number first. \param touch_mm shorter
  /// ways are not looked at, nearer faces touch
  PassedFaces(const TopoDS_Shape& before, std::set<std::pair<int, int>> beside_seams,
              double touch_mm);

  /// \param after with the same numbers of faces and the same parameters. \param moved faces.
  /// \returns a face that was passed, by face that moved. Pairs of which OpenCASCADE can't tell are
  /// left out.
  std::map<int, int> in(const TopoDS_Shape& after, const std::set<int>& moved);

 private:
  std::set<int> facesAround(int face) const;
  bool touched(int face, int other);

  TopTools_IndexedMapOfShape faces_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_vertex_;
  std::set<std::pair<int, int>> beside_seams_;
  double touch_mm_;
  std::map<std::pair<int, int>, bool> touched_;
};

}  // namespace seamwright::occ
