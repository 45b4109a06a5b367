// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include <seamwright/occ_adapter/fill/bounded_face.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

/// Edges of faces that are fitted to the surroundings of a hole. Not a public header.
namespace seamwright::occ {

/// A copy of a hole's edge with a quintic spline as its pcurve; nothing if the edge has no curve.
/// Its curve in space is that of the hole's edge, or, if this runs at another pace than the edge's
/// pcurve on the face beside the hole, a spline along that pcurve.
/// \param path of the edge alone
/// \param at the point of the parameter plane by the share of the edge's range, from 0 to 1 in the
/// direction of the hole.
/// \param near accepted distance in the parameter plane; if it is out of reach, the pcurve comes as
/// near as the number of spans allows.
/// \param near_mm accepted distance of the curve in space
std::optional<BoundaryEdge> fittedEdge(const HoleEdge& edge, const SidePath& path,
                                       const std::function<Eigen::Vector2d(double)>& at,
                                       double near, double near_mm);

}  // namespace seamwright::occ
