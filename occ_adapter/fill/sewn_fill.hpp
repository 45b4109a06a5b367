// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <set>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/fill/hole_cuts.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>
#include <seamwright/occ_adapter/topology/sewn_shape.hpp>

/// Stages 3 and 4 of a fill: the new faces are sewn in, and their seams are measured. Not a public
/// header.
namespace seamwright::occ {

struct SewnFill {
  TopoDS_Shape whole;  ///< the given shape with the new faces, before sewing
  SewnShape sewn;
  std::set<int> faces;                  ///< numbers of the new faces in the sewn shape
  std::vector<std::string> face_names;  ///< of all faces of the sewn shape
  std::vector<Seam> seams;              ///< of the new faces

  bool isNew(int face) const { return faces.count(face) > 0; }
};

/// \param cut sides that the faces meet, empty for a face whose edges are copies of the hole's.
/// \throws NotFilled if a seam can't be sewn or an edge of the new faces stays free, Cancelled,
/// Standard_Failure.
SewnFill sewFill(const FillTask& task, const std::vector<TopoDS_Face>& faces, const HoleCut& cut,
                 const Progress& progress);

struct FillSeams {
  std::vector<SeamResult> outer;  ///< between the new faces and others
  std::vector<SeamResult> inner;  ///< between the new faces
};

/// Measures every seam of the new faces. \throws Cancelled.
FillSeams measureFill(const SewnFill& fill, const FillHoleOptions& options,
                      const Progress& progress);

/// The part at the position of the given shape in the sewn one; the whole if the given shape was a
/// compound.
TopoDS_Shape filledShape(const SewnFill& fill, const TopoDS_Shape& given);

}  // namespace seamwright::occ
