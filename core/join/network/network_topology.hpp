// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include <seamwright/core/join/network/network_condition.hpp>

/// Which poles of a network are one, and which corners meet; not a public header.
namespace seamwright::network {

/// A corner of a surface: bit 1 is the end of u, bit 0 that of v.
struct Corner {
  int surface = 0;
  int corner = 0;
};

/// The end of a seam at a vertex, between two corners that follow each other.
struct Spoke {
  int seam = 0;
  int end = 0;         ///< 0: the seam begins here, 1: it ends here
  bool first = false;  ///< side 0 of the seam is the corner before it
};

/// Corners in turn, and the spokes between them: spoke i follows corner i; as many as corners if
/// the seams surround the vertex, else one less.
struct Vertex {
  std::vector<Corner> corners;
  std::vector<Spoke> spokes;
  bool closed() const { return spokes.size() == corners.size(); }
};

/// The vertices of the seams that take part.
std::vector<Vertex> vertices(std::size_t surfaces, const std::vector<NetworkSeam>& seams,
                             const std::vector<bool>& takes_part);

/// \throws std::invalid_argument as nearestNetwork() does.
void requireNetwork(const std::vector<NetworkSurface>& surfaces,
                    const std::vector<NetworkSeam>& seams, const NetworkOptions& options);

/// The side of a seam for nearest::seamRows().
nearest::SeamRows rowsOf(const std::vector<NetworkSurface>& surfaces, const NetworkSeam& seam,
                         int side, int order);

/// The direction of a surface that runs along an edge, among all: 2 surface + 0 for u, 1 for v.
int directionOf(int surface, PatchEdge edge);

/// Which directions are tied to the same degree and knots by seams: a number for each, those tied
/// together the same.
std::vector<int> strips(std::size_t surfaces, const std::vector<NetworkSeam>& seams);

/// The poles as unknowns, each shared one once.
struct Unknowns {
  std::vector<std::vector<int>> of_pole;  ///< of each surface
  Eigen::MatrixXd target;                 ///< where they want to be, about the centre
  Eigen::VectorXd pull;                   ///< weight of a move; 0: stays
  std::vector<int> shared;                ///< number of poles
  /// Of poles that stay: the largest distance from what they share their unknown with.
  Eigen::VectorXd contradiction;
  Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
  double largest = 0;  ///< coordinate
  double joining = 0;  ///< cost of making shared poles one
};

Unknowns unknowns(const std::vector<NetworkSurface>& surfaces,
                  const std::vector<NetworkSeam>& seams, const std::vector<bool>& takes_part);

/// Unknown of each column of a seam's condition.
std::vector<int> columnsOf(const Unknowns& unknowns, const NetworkSeam& seam,
                           const Condition& condition);

}  // namespace seamwright::network
