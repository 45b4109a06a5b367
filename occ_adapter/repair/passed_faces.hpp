// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <map>
#include <set>
#include <utility>

/// Finds faces that moved through others. Not a public header.
namespace seamwright::occ {

/// Tells whether moved faces come out on the other side of others. It samples 32 by 32 points of
/// the parameters inside each moved face. A point has passed another face if its straight path from
/// the old to the new position crosses that face, old or new, and the point is on the other side of
/// that face than before. So sides of a wall that move alike have not passed one another. Faces
/// narrower than the distance of the samples may be missed.
///
/// Faces that share a vertex, or a seam, do not count: they meet there, and their seams are
/// measured. Faces that touched or intersected before do not count either, as faces of an
/// assembly's parts may.
class PassedFaces {
 public:
  /// \param beside_seams faces that share a seam, the smaller number first. \param touch_mm shorter
  /// moves are not tested, and faces nearer than this touch.
  PassedFaces(const TopoDS_Shape& before, std::set<std::pair<int, int>> beside_seams,
              double touch_mm);

  /// \param after with the same face numbers and the same parameters.
  /// \param moved numbers of faces.
  /// \returns by moved face: a face that it passed. Pairs for which OpenCASCADE finds no answer are
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
