// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace seamwright {

/// Point and derivatives of a curve at one parameter. Lengths are in mm; the parameter has no unit.
struct CurveJet {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d d1 = Eigen::Vector3d::Zero();
  Eigen::Vector3d d2 = Eigen::Vector3d::Zero();
  Eigen::Vector3d d3 = Eigen::Vector3d::Zero();
};

/// Point and derivatives of a curve up to any order; row k is the k-th derivative.
using CurveDerivatives = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Point and partial derivatives of a surface at one parameter pair (u, v). Lengths are in mm;
/// parameters have no unit.
struct SurfaceJet {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d uu = Eigen::Vector3d::Zero();
  Eigen::Vector3d uv = Eigen::Vector3d::Zero();
  Eigen::Vector3d vv = Eigen::Vector3d::Zero();
  Eigen::Vector3d uuu = Eigen::Vector3d::Zero();
  Eigen::Vector3d uuv = Eigen::Vector3d::Zero();
  Eigen::Vector3d uvv = Eigen::Vector3d::Zero();
  Eigen::Vector3d vvv = Eigen::Vector3d::Zero();
};

/// Bounds of the rounding in the first partials of a jet: |error of jet.u| <= u, |error of jet.v|
/// <= v. The code that evaluates a surface computes the noise, since it knows the size and the
/// parameter range of the surface.
struct JetNoise {
  double u = 0;
  double v = 0;
};

}  // namespace seamwright
