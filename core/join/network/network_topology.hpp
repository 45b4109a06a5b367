// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include <seamwright/core/join/network/network_condition.hpp>

/// Which poles of a network are shared, and which corners meet; not a public header.
namespace seamwright::network {

/// A corner of a surface: bit 1 is set at the end of u, bit 0 at the end of v.
struct Corner {
  int surface = 0;
  int corner = 0;
};

/// The end of a seam at a vertex, between two consecutive corners.
struct Spoke {
  int seam = 0;
  int end = 0;         ///< 0: the seam begins at the vertex, 1: it ends there
  bool first = false;  ///< side 0 of the seam is at the corner before the spoke
};

/// Corners in order around the vertex, and the spokes between them: spoke i follows corner i. There
/// are as many spokes as corners if the seams surround the vertex, otherwise one less.
struct Vertex {
  std::vector<Corner> corners;
  std::vector<Spoke> spokes;
  bool closed() const { return spokes.size() == corners.size(); }
};

/// The vertices of the seams that are not excluded.
std::vector<Vertex> vertices(std::size_t surfaces, const std::vector<NetworkSeam>& seams,
                             const std::vector<bool>& takes_part);

/// \throws std::invalid_argument as nearestNetwork() does.
void requireNetwork(const std::vector<NetworkSurface>& surfaces,
                    const std::vector<NetworkSeam>& seams, const NetworkOptions& options);

/// The rows of a side of a seam, by nearest::seamRows().
nearest::SeamRows rowsOf(const std::vector<NetworkSurface>& surfaces, const NetworkSeam& seam,
                         int side, int order);

/// Index of the parameter direction along an edge, among the directions of all surfaces: 2 surface
/// + 0 for u, 2 surface + 1 for v.
int directionOf(int surface, PatchEdge edge);

/// A number for each direction of each surface. Directions that seams tie to the same degree and
/// knots have the same number.
std::vector<int> strips(std::size_t surfaces, const std::vector<NetworkSeam>& seams);

/// The poles as unknowns; a shared pole is one unknown.
struct Unknowns {
  std::vector<std::vector<int>> of_pole;  ///< unknown of each pole, per surface
  /// Given positions relative to the centre; for shared poles the fixed position or the weighted
  /// mean.
  Eigen::MatrixXd target;
  Eigen::VectorXd move_weights;  ///< weight of a move; 0: the pole stays
  std::vector<int> shared;       ///< number of poles
  /// For poles that stay: the largest distance from the fixed poles that share the unknown.
  Eigen::VectorXd contradiction;
  Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
  double largest = 0;  ///< coordinate
  double joining = 0;  ///< cost of the moves that unite shared poles
};

Unknowns unknowns(const std::vector<NetworkSurface>& surfaces,
                  const std::vector<NetworkSeam>& seams, const std::vector<bool>& takes_part);

/// The unknown of each column of a seam's condition.
std::vector<int> columnsOf(const Unknowns& unknowns, const NetworkSeam& seam,
                           const Condition& condition);

/// The rows of x of these unknowns.
Eigen::MatrixXd polesOf(const Eigen::MatrixXd& x, const std::vector<int>& columns);

}  // namespace seamwright::network
