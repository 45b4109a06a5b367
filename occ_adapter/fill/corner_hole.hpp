// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/occ_adapter/fill/corner.hpp>
#include <seamwright/occ_adapter/fill/corner_fillet.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>

/// Makes the boundary curves of a set-back corner. Not a public header.
namespace seamwright::occ {

/// The cylinder that rounds an edge of the corner, with its section at the setback.
struct CornerStrip {
  double radius_mm = 0, contact_mm = 0, setback_mm = 0;
  double sweep_rad = 0;                              ///< angle of the section's arc, in (0, pi)
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< centre of the section
  /// Unit vector from the centre towards the edge, through the middle of the section.
  Eigen::Vector3d to_edge = Eigen::Vector3d::Zero();
  /// Ends of the section, in the face before and in the face after the edge.
  std::array<Eigen::Vector3d, 2> contacts{};
  std::array<Eigen::Vector3d, 2> far_contacts{};  ///< far ends of the contact lines
};

struct CornerHole {
  std::vector<CornerStrip> strips;  ///< in the order of the edges
  std::vector<FillSide> sides;      ///< 2 i: section of strip i; 2 i + 1: spring curve in face i
  double section_error_mm = 0;
};

/// Radii, contacts, sweeps and setbacks, computed as if the faces were their tangent planes at the
/// corner.
/// \throws as cornerFillet() for radii and setbacks.
std::vector<CornerStrip> cornerStrips(const Corner& corner, const CornerFilletOptions& options);

/// The intersection, in face i, of the contact lines of edge i and of the next edge. It is given as
/// the distances along both edges from the corner to its feet.
std::array<double, 2> crossingIn(const Corner& corner, const std::vector<CornerStrip>& strips,
                                 std::size_t i);

/// The fillet of edge i for reasons why it has no room. Its cause is the edge itself if its setback
/// is given, else the edge, of it and its neighbours, whose contact lines are furthest away.
/// \param length_mm of edge i.
corner_why::SetBackFillet setBackFillet(const Corner& corner,
                                        const std::vector<CornerStrip>& strips,
                                        const CornerFilletOptions& options, std::size_t i,
                                        double length_mm);

/// A cubic from one point to another with these unit tangents. It is close to a circular arc if the
/// tangents are symmetric. Its inner poles lie before the intersection of the tangents.
/// \param legs distances from the ends to that intersection.
Poles springCurve(const Eigen::Vector3d& from, const Eigen::Vector3d& leaving,
                  const Eigen::Vector3d& to, const Eigen::Vector3d& arriving,
                  const std::array<double, 2>& legs);

/// \param corner a polyhedral corner.
/// \throws as cornerFillet() for radii and setbacks.
CornerHole cornerHole(const Corner& corner, const CornerFilletOptions& options);

/// A polynomial curve close to an arc of the unit circle, which runs at constant speed from the
/// angle -sweep / 2 to sweep / 2.
struct UnitArc {
  Eigen::MatrixX2d poles;
  double error = 0;  ///< largest distance of points with the same parameter, sampled
};

/// Interpolates the arc: its end points, its first derivatives at the ends, and degree - 3 points
/// at Chebyshev parameters. \param degree at least 4.
UnitArc unitArc(double sweep_rad, int degree);

}  // namespace seamwright::occ
