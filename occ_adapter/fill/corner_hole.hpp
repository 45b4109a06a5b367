// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/occ_adapter/fill/corner.hpp>
#include <seamwright/occ_adapter/fill/corner_fillet.hpp>

/// The curves of a set-back corner; not a public header.
namespace seamwright::occ {

/// The cylinder that rounds an edge of the corner.
struct CornerStrip {
  double radius_mm = 0, contact_mm = 0, setback_mm = 0;
  double sweep_rad = 0;                               ///< of the section, in (0, pi)
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< of the section
  Eigen::Vector3d to_edge = Eigen::Vector3d::Zero();  ///< unit, from the centre to the edge: the
                                                      ///< middle of the section lies there
  std::array<Eigen::Vector3d, 2>
      contacts{};  ///< ends of the section, in the face before and the face after
  std::array<Eigen::Vector3d, 2> far_contacts{};  ///< ends of the cylinder
};

struct CornerHole {
  std::vector<CornerStrip> strips;  ///< as the edges
  std::vector<FillSide> sides;      ///< 2 i: section of strip i; 2 i + 1: spring curve in face i
  double section_error_mm = 0;
};

/// Radii, contacts, sweeps and setbacks, as if the faces were the planes that touch them at the
/// corner.
/// \throws as cornerFillet() for radii and setbacks.
std::vector<CornerStrip> cornerStrips(const Corner& corner, const CornerFilletOptions& options);

/// Where the contact lines of edge i and of the next one cross in face i: distances along both
/// edges, from the corner to the foot.
std::array<double, 2> crossingIn(const Corner& corner, const std::vector<CornerStrip>& strips,
                                 std::size_t i);

/// How a fillet that has no room comes to where it is, with the edge first whose radius, or
/// setback, is to blame: a sentence that goes on with what it would be. \param length_mm of edge i.
std::string setBackText(const Corner& corner, const std::vector<CornerStrip>& strips,
                        const CornerFilletOptions& options, std::size_t i, double length_mm);

/// A cubic from one point to another with these unit tangents, near a circle's arc where they are
/// symmetric. Its handles end before the tangents cross. \param legs from the ends to that
/// crossing.
Poles springCurve(const Eigen::Vector3d& from, const Eigen::Vector3d& leaving,
                  const Eigen::Vector3d& to, const Eigen::Vector3d& arriving,
                  const std::array<double, 2>& legs);

/// \param corner a polyhedral one. \throws as cornerFillet() for radii and setbacks.
CornerHole cornerHole(const Corner& corner, const CornerFilletOptions& options);

/// A polynomial near an arc of the unit circle, run at constant speed from -sweep / 2 to sweep / 2.
struct UnitArc {
  Eigen::MatrixX2d poles;
  double error = 0;  ///< largest distance of points that belong together, sampled
};

/// With the ends and the derivatives at the ends of the arc, and through it at degree - 3 Chebyshev
/// places. \param degree 4 at least.
UnitArc unitArc(double sweep_rad, int degree);

}  // namespace seamwright::occ
