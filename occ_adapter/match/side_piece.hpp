// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// The parts of a side, each with the neighbour that it has there. Not a public header.
namespace seamwright::occ {

/// A part of a side of a face and of its neighbour's boundary. The first side of the seam is that
/// of the face.
struct SidePiece {
  Seam seam;
  int order = 1;  ///< 0: the points only; 1: also the tangent planes; 2: also the curvature
};

/// The seam with that face as its first side. \pre the face is one of its sides
Seam withFirst(Seam seam, int face);

/// The part of a seam between two parameters of its first edge; as it is if they contain it. Null
/// if nothing is left. A part of a shared edge becomes a matched seam of the edge with itself.
std::optional<Seam> partOfSeam(const Seam& seam, double from, double to);

/// What a surface has to meet at a point: the point, and with a tangent plane its unit normal and
/// the curvature tensor for that normal.
struct MatchTarget {
  Eigen::Vector3d point;
  std::optional<Eigen::Vector3d> normal;
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
};

/// Corresponding points of both sides of a piece, and their parameters on the surfaces.
struct PiecePoint {
  SidePoint own, other;
  Eigen::Vector2d own_uv, other_uv;
};

/// Both sides of a piece by its parameter s in [0, 1]. Not thread-safe.
class PieceStrips {
 public:
  /// \throws GeometryError, Standard_Failure.
  PieceStrips(const Seam& seam, double gap_mm);

  PiecePoint at(double s) const;
  /// What the other side shows.
  MatchTarget otherAt(double s) const;
  /// The mean of both sides: point, normal, and the curvature across; the curvature along and the
  /// torsion are those of the mean points and normals, so that both sides can have it.
  MatchTarget meanAt(double s) const;
  /// s of the breaks of both sides, with 0 and 1.
  std::vector<double> breaks() const;

 private:
  struct Frame {
    Eigen::Vector3d point, normal;
    double curvature_across_per_mm = 0;
    Eigen::Vector3d along;
  };
  std::optional<Frame> meanFrameAt(double s) const;

  Seam seam_;
  Correspondence exchanged_;  ///< with b as its first parameters
  std::array<Pcurve, 2> pcurves_;
  FaceStrip own_, other_;
};

}  // namespace seamwright::occ
