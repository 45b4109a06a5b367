// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include <seamwright/occ_adapter/blend/blend_surface.hpp>
#include <seamwright/occ_adapter/blend/side_directions.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

/// A side of a model that a new surface continues. Not a public header.
namespace seamwright::occ {

inline constexpr int most_blend_order = 3;

/// The edges in their order along one chain. \throws std::invalid_argument for no edges, an edge
/// given twice, a number that names no edge, edges that are no single chain, and an edge that is
/// not free and has not exactly one face among the given ones, also if it has that face on both
/// sides; GeometryError for an edge that can't be computed with.
HoleSide chosenSide(const TopoDS_Shape& model, const SideChoice& choice, bool& closed);

/// The path along a side.
/// \throws std::invalid_argument where it has a corner, between edges or inside of one;
/// GeometryError as SidePath.
std::shared_ptr<const SidePath> smoothPath(const HoleSide& side, bool closed, double gap_mm,
                                           JetOrder order);

/// Whether the edges run along parameter lines of their faces, as those of faces that are not
/// trimmed do.
bool isAlongParameterLines(const HoleSide& side);

/// A chain of edges as a boundary of a new surface.
class BlendSide {
 public:
  /// \param begin share of the path at which a closed side begins
  BlendSide(std::shared_ptr<const SidePath> path, std::shared_ptr<const SideDirections> directions,
            bool reversed, double begin = 0)
      : path_(std::move(path)),
        directions_(std::move(directions)),
        reversed_(reversed),
        begin_(begin) {}

  /// Inner shares at which edges join.
  std::vector<double> joints() const;
  /// Shares inside of edges at which the side may not be smooth.
  std::vector<double> breaks() const;
  /// The sample, with the direction against that of the surface as the one into the face. Beside a
  /// pole, where there is no tangent plane.
  /// \param after at a joint, the edge that begins there.
  SideSample at(double share, bool after = true) const;
  /// The number of the edge at a share.
  int edgeAt(double share) const { return path_->edgeAt(ofPath(share)); }

 private:
  std::vector<double> sharesOf(const std::vector<double>& of_path) const;
  double ofPath(double share) const;

  std::shared_ptr<const SidePath> path_;
  std::shared_ptr<const SideDirections> directions_;
  bool reversed_;
  double begin_;
};

/// What bends the lines across a side in its tangent plane, at a speed of 1.
struct LineBend {
  double geodesic_per_mm = 0;  ///< geodesic curvature, positive towards the derivative of the side
  /// The part in the tangent plane of the third derivative: along the line, and at right angles to
  /// it, towards the derivative of the side.
  Eigen::Vector2d third_per_mm2 = Eigen::Vector2d::Zero();
};

/// The unit vectors at a sample in which lines across are expressed.
struct LineFrame {
  Eigen::Vector3d across;  ///< of the line
  Eigen::Vector3d along;   ///< at right angles in the tangent plane, towards the derivative
};
/// \param sense 1: the line goes out of the face; -1: into it.
LineFrame lineFrame(const SideSample& sample, double sense);

/// The derivatives 0 to \p order, by rows, of the line that leaves the face against the sample's
/// direction into it, at a speed of 1: the point, d, the normal curvature along d times the normal
/// N, and the change of normal curvature along the line times N. Without a bend these are the
/// derivatives of a geodesic, but for the part in the tangent plane at third order, which does not
/// affect continuity.
CurveDerivatives continuation(const SideSample& sample, double sense, int order,
                              const LineBend& bend = {});

}  // namespace seamwright::occ
