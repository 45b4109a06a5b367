// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include <seamwright/core/blend/spline_places.hpp>

/// Points along a frame, to compare frames with; not a public header.
namespace seamwright::match {

/// Points at equal shares of the length. They are only compared, so that a thousandth of a piece is
/// precise enough.
Poles samplesOf(const Measured& frame, int count);

/// Which way round closed points go: twice their vector area; nothing for points that enclose none
/// or as much one way round as the other. \param points about their mean.
std::optional<Eigen::Vector3d> roundOf(const Poles& points);

/// Where a frame is, how large it is, and which way round it goes.
struct FrameExtent {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< the mean by the length
  double radius_mm = 0;                              ///< root mean square distance from it
  std::optional<Eigen::Vector3d> round = {};         ///< of closed frames
};

FrameExtent extentOf(const Measured& frame);

}  // namespace seamwright::match
