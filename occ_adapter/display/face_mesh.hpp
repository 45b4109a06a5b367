// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Poly_Triangulation.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <seamwright/occ_adapter/display/display_surface.hpp>

namespace seamwright::occ {

/// A piece of an edge between two nodes, numbered along the edge, so that it is the same on both
/// faces of the edge. Not a public header.
struct EdgePiece {
  int edge = 0;   ///< from 1; 0: of no edge
  int nodes = 0;  ///< of the edge as first triangulated
  double from = 0;
  double to = 0;
  auto operator<=>(const EdgePiece&) const = default;
};

/// The triangles of one face while they are refined.
class FaceMesh {
 public:
  /// \param face with triangles. \param edges gives the numbers of its edges.
  /// \throws Standard_Failure if the surface can't be evaluated or the face has no triangles.
  FaceMesh(const TopoDS_Face& face, const TopTools_IndexedMapOfShape& edges,
           const DisplayMeshOptions& options);

  /// Sets the face before it moved; triangles are split until they resolve the move. \throws
  /// Standard_Failure if it has no surface.
  void setMoves(const TopoDS_Face& before, double rough_mm, double longest_rel);

  /// The pieces of edges that are too coarse for this face. \throws Standard_Failure as
  /// DisplaySurface.
  std::vector<EdgePiece> coarsePieces();
  /// Halves the pieces of edges that are among the sorted \p pieces. \throws Standard_Failure as
  /// DisplaySurface.
  void splitPieces(const std::vector<EdgePiece>& pieces);
  /// Splits triangles inside the face until they are fine enough. Pieces of edges stay.
  /// \throws Standard_Failure as DisplaySurface.
  void refineInside();
  /// Gives nodes at which the surface has no normal the normal of the triangles around them.
  void completeNormals();

  double areaMm2() const;
  double sizeMm() const { return size_mm_; }
  const std::vector<Eigen::Vector2d>& parameters() const { return uv_; }
  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  const std::vector<Eigen::Vector3d>& normals() const { return normals_; }
  const std::vector<double>& movesMm() const { return moves_mm_; }
  std::vector<std::array<int, 3>> triangles() const;
  std::vector<NodeCurvature> curvatures() const;

 private:
  /// A piece of an edge with its ends among the nodes.
  struct Side {
    EdgePiece piece;
    int a = 0;
    int b = 0;
    double at_a = 0;  ///< parameter of the edge
    double at_b = 0;
    int path = 0;  ///< of paths_
  };
  using Middles = std::unordered_map<std::uint64_t, int>;

  int addNode(const Eigen::Vector2d& uv);
  void addTriangles(const Poly_Triangulation& triangulation);
  void addSides(const TopoDS_Face& face,
                const opencascade::handle<Poly_Triangulation>& triangulation,
                const TopLoc_Location& location, const TopTools_IndexedMapOfShape& edges);
  Eigen::Vector2d middleOf(const Side& side) const;
  bool isCoarse(int a, int b, const Eigen::Vector2d& middle) const;
  bool movesRoughly(int a, int b, const Eigen::Vector2d& middle) const;
  double moveAt(const Eigen::Vector2d& uv) const;
  Middles coarseInside(const std::unordered_set<std::uint64_t>& on_edges,
                       std::unordered_set<std::uint64_t>& fine);
  void split(const Middles& middles);
  void turnBack();
  bool turnBack(int triangle, const std::unordered_map<std::uint64_t, int>& owner,
                std::vector<bool>& touched);
  double signedArea(int a, int b, int c) const;

  DisplaySurface surface_;
  DisplayMeshOptions options_;
  bool flipped_;  ///< triangles that turn left in the parameters turn right seen from where the
                  ///< normals point
  std::optional<DisplaySurface> before_;
  double rough_mm_ = 0;
  double longest_mm_ = 0;
  double size_mm_ = 0;  ///< diagonal of the box around the nodes
  double sag_mm_ = 0;   ///< largest height over an edge
  std::vector<Eigen::Vector2d> uv_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<double> moves_mm_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<Side> sides_;
  std::vector<opencascade::handle<Geom2d_Curve>> paths_;
};

}  // namespace seamwright::occ
