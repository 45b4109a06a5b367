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

/// \param figures of the seam.
SewReason gapTooLarge(const std::string& figures);

// Faces have a number and a name, since a new face has no number that a user knows.
SewReason faceInstances(int face, const std::string& name, int count);
SewReason hollowSolid(int face, const std::string& name);
SewReason commonSurface(int face, const std::string& name, int other,
                        const std::string& other_name);

SewReason intervalDivided(int edge);
SewReason intervalShort(int edge);
SewReason intervalTaken(int edge);
SewReason noVertex(int edge);
SewReason pointsOutOfOrder();
/// \param fault such as "no path runs along both edges".
SewReason noCurve(const std::string& fault);
SewReason vertexTooWide(double distance_mm, double allowed_mm);
SewReason oneSided();
SewReason openCascadeFailed(const Standard_Failure& failure);
SewReason checksFailForFace(int face);
SewReason checksFailForShape();
SewReason shellOpens();
/// \param after, before figures of the seam.
SewReason losesLevel(const std::string& after, const std::string& before);

}  // namespace why_not_sewn

}  // namespace seamwright::occ
