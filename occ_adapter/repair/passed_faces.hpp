// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <set>

/// Faces that moved through others; not a public header.
namespace seamwright::occ {

/// Sampled at 32 by 32 points of the parameters inside each face that moved: the straight way from the place of such a point before to the one after
/// crosses a face, as that is after. So a thin wall is found that a face was pushed through, unless all points on the other side lie between samples.
/// Faces that share a vertex before do not count: they meet there, and have seams that are measured. Nor do faces that touched or cut one another before, as
/// those of an assembly's parts and of a model that was not sewn.
///
/// \param before, after with the same numbers of faces, and the same parameters. \param moved faces. \param least_mm shorter ways are not looked at.
/// \param touch_mm nearer faces touch
/// \returns a face that was passed, by face that moved. \throws Standard_Failure.
std::map<int, int> passedFaces(const TopoDS_Shape& before, const TopoDS_Shape& after,
                               const std::set<int>& moved, double least_mm, double touch_mm);

}  // namespace seamwright::occ
