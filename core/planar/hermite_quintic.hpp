// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/bezier/curve.hpp>

/// Not a public header.
namespace seamwright {

/// A point of the plane with the first two derivatives by the parameter of a curve.
struct PlanarJet {
  Eigen::Vector2d point, first, second;
};

/// The quintic with these jets at both ends of a parameter interval of length h.
inline BezierCurve hermiteQuintic(const PlanarJet& a, const PlanarJet& b, double h) {
  Poles poles = Poles::Zero(6, 3);
  poles.row(0).head<2>() = a.point;
  poles.row(1).head<2>() = a.point + h / 5 * a.first;
  poles.row(2).head<2>() = a.point + 2 * h / 5 * a.first + h * h / 20 * a.second;
  poles.row(3).head<2>() = b.point - 2 * h / 5 * b.first + h * h / 20 * b.second;
  poles.row(4).head<2>() = b.point - h / 5 * b.first;
  poles.row(5).head<2>() = b.point;
  return BezierCurve(poles);
}

/// The error of that quintic is at most this factor times the largest sixth derivative times h^6.
inline constexpr double hermite_quintic_error = 1.0 / 46080;

}  // namespace seamwright
