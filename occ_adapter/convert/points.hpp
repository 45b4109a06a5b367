// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_XYZ.hxx>
#include <vector>

/// Points, vectors and numbers between OpenCASCADE and Eigen; not a public header.
namespace seamwright::occ {

/// The same coordinates; nothing is rounded.
inline Eigen::Vector3d vector(const gp_XYZ& xyz) {
  return {xyz.X(), xyz.Y(), xyz.Z()};
}

/// Of a gp_Pnt, gp_Vec or gp_Dir.
template <class Vector>
requires requires(const Vector& v) {
  v.XYZ();
}
Eigen::Vector3d vector(const Vector& v) {
  return vector(v.XYZ());
}

/// The same coordinates; nothing is rounded.
inline gp_Pnt pointOf(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

/// \param v not zero.
inline gp_Dir directionOf(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// \pre values not empty. The array counts from 1.
inline TColStd_Array1OfReal reals(const std::vector<double>& values) {
  TColStd_Array1OfReal array(1, static_cast<int>(values.size()));
  std::ranges::copy(values, array.begin());
  return array;
}

}  // namespace seamwright::occ
