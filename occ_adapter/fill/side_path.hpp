// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include <seamwright/core/differential/path_length.hpp>
#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/fill/holes.hpp>

/// Joins the edges of a side of a hole to one path. Not a public header.
namespace seamwright::occ {

/// A sample of a side at t: the point, its derivative by t, and the frame of the face.
struct SideSample {
  double t = 0;
  Eigen::Vector3d point, derivative;
  Eigen::Vector3d normal, beyond;  ///< unit vectors; beyond points across the edge into the face
  SurfaceJet jet;                  ///< of the face
};

/// How a path runs along an edge.
enum class PathAlong {
  Pcurve,
  /// As the pcurve, or where this has kinks and the edge's curve in space has none, along the
  /// points of the face nearest to that curve.
  Smoother,
};

/// The edges of a side, one after the other.
class SidePath {
 public:
  /// \param order of the jets of samples
  /// \throws GeometryError for an edge that can't be evaluated or a side without length.
  SidePath(const HoleSide& side, double gap_mm, JetOrder order = JetOrder::Second,
           PathAlong along = PathAlong::Pcurve);

  bool isOneEdge() const { return strips_.size() == 1; }
  double length_mm() const { return length_mm_; }
  /// Shares of the length, inside (0, 1), at which one edge ends and the next begins.
  std::vector<double> joints() const;
  /// Shares inside of the edges at which the path or the face may not be smooth.
  std::vector<double> breaks() const;
  int edgeAt(double share) const { return numbers_[edgeIndex(share, true)]; }

  /// The sample at a share of the length in [0, 1], with the derivative by that share.
  /// \param after at a joint, take the edge that begins there.
  SideSample atShare(double share, bool after) const;
  /// The same; but at the end of an edge where a boundary of the face collapses, so that it has no
  /// tangent plane, the jet and the frame are those of a point nearby.
  SideSample besidePoleAtShare(double share, bool after) const;
  /// The sample of a path of one edge at a share of the edge's own parameter.
  SideSample atParameter(double parameter) const;
  double parameterOf(double share) const;
  /// The inverse of parameterOf().
  double shareOf(double parameter) const;
  /// Whether the face has a tangent plane at a share of the length.
  bool hasTangentPlane(double share) const;

 private:
  /// An edge, and a parameter of its strip.
  struct Place {
    std::size_t edge = 0;
    double parameter = 0;
  };

  std::size_t edgeIndex(double share, bool after) const;
  Place placeOf(double share, bool after) const;
  SidePoint pointAt(const Place& place) const { return strips_[place.edge]->at(place.parameter); }
  SideSample sampleOf(const Place& place, const SidePoint& point) const;
  SideSample byShare(SideSample sample) const;

  std::vector<std::shared_ptr<const FaceStrip>> strips_;
  std::vector<std::vector<double>> breaks_;  ///< parameters of each strip
  std::vector<PathLength> lengths_;
  std::vector<double> begins_mm_;
  std::vector<bool> reversed_;
  std::vector<int> numbers_;
  double length_mm_ = 0;
};

}  // namespace seamwright::occ
