// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <map>
#include <string>

#include <seamwright/occ_adapter/topology/sew_reason.hpp>

/// All reasons why seams are not sewn, and their words. Not a public header.
namespace seamwright::occ {

/// By seam that prevents sewing: the reason.
using SewReasons = std::map<std::size_t, SewReason>;

namespace why_not_sewn {

/// The bound of the gap is above the tolerance.
/// \param figures of the seam.
SewReason gapTooLarge(const std::string& figures);

// Faces have a number and a name, since a new face has no number that a user knows.

/// The face occurs count times in the model.
SewReason faceInstances(int face, const std::string& name, int count);
/// The face belongs to a solid of several shells.
SewReason hollowSolid(int face, const std::string& name);
/// Both faces refer to one surface object.
SewReason commonSurface(int face, const std::string& name, int other,
                        const std::string& other_name);

/// An interval of that edge begins or ends within the seam.
SewReason intervalDivided(int edge);
/// The interval of that edge is no longer than the gap tolerance.
SewReason intervalShort(int edge);
/// The edge lies along more than one other edge there.
SewReason intervalTaken(int edge);
/// The edge has an open end.
SewReason noVertex(int edge);
/// The correspondence of both edges is not monotonous.
SewReason pointsOutOfOrder();
/// \param fault such as "no path runs along both edges".
SewReason noCurve(const std::string& fault);
/// A vertex at the end of the seam would need a tolerance above the allowed one.
SewReason vertexTooWide(double distance_mm, double allowed_mm);
/// The faces would close to a Möbius band.
SewReason oneSided();
/// The type and message of the failure are in the text.
SewReason openCascadeFailed(const Standard_Failure& failure);
/// The face would fail OpenCASCADE's checks.
SewReason checksFailForFace(int face);
/// The sewn shape would fail OpenCASCADE's checks.
SewReason checksFailForShape();
/// A closed shell would be open afterwards.
SewReason shellOpens();
/// The sewn seam, measured as one edge, has a lower level.
/// \param after, before figures of the seam.
SewReason losesLevel(const std::string& after, const std::string& before);

}  // namespace why_not_sewn

}  // namespace seamwright::occ
