// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_XYZ.hxx>

/// Points and vectors between OpenCASCADE and Eigen; not a public header.
namespace seamwright::occ {

inline Eigen::Vector3d vector(const gp_XYZ& xyz) {
  return {xyz.X(), xyz.Y(), xyz.Z()};
}

inline gp_Pnt pointOf(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

/// \param v not zero.
inline gp_Dir directionOf(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace seamwright::occ
