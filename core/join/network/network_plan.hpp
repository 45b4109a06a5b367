// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include <seamwright/core/join/network/network_topology.hpp>

/// The sorts of vertices of a network, and the form of the connection functions that follows from
/// them; not a public header.
namespace seamwright::network {

enum class VertexSort { Boundary, Regular, Extraordinary };

/// The sort of a vertex, and the tangents of its rays in a plane.
struct VertexPlan {
  VertexSort sort = VertexSort::Boundary;
  Eigen::Matrix2Xd rays;
  std::vector<bool> stays;  ///< whether each ray is fixed
};

/// A seam that must be excluded, and why.
struct Obstacle {
  int seam = -1;
  double residual = 0;
  std::string why;
};

/// The form of the connection functions of a seam.
struct SeamPlan {
  bool takes_part = false;
  int order = 1;
  std::string why;  ///< why the order is lower than the given one; otherwise empty
  /// gamma and alpha are linear; otherwise alpha / gamma is constant.
  bool linear = false;
  int line = -1;  ///< line that the constant alpha / gamma belongs to; -1 if linear or held
  int sense = 1;  ///< 1: alpha / gamma is the constant of the line; -1: gamma / alpha is
  /// The form of beta. Double: quadratic, with a double zero at the end that is not extraordinary.
  /// Tied: linear from a regular vertex to the boundary, and the same on the other half of the
  /// line.
  enum class BetaForm { Zero, Linear, Quadratic, Double, Tied };
  BetaForm beta = BetaForm::Zero;
  struct End {
    int vertex = -1;
    int spoke = -1;  ///< index at an extraordinary or regular vertex; -1 at a boundary vertex
    VertexSort sort = VertexSort::Boundary;
  };
  std::array<End, 2> ends;
};

/// The structure of the network, and the form of the connection functions of each seam.
struct Plan {
  std::vector<Vertex> vertices;
  std::vector<VertexPlan> sorts;
  std::vector<SeamPlan> seams;
  int lines = 0;
  bool has_extraordinary = false;
  std::vector<Obstacle> obstacles;
};

struct Network {
  const std::vector<NetworkSurface>& surfaces;
  const std::vector<NetworkSeam>& seams;
  const std::vector<bool>& takes_part;
};

/// \param linear gamma and alpha are linear beside extraordinary vertices.
Plan planOf(const Network& network, const Unknowns& unknowns, const NetworkOptions& options,
            bool linear);

/// The condition with connection functions of the natural degrees, all of whose coefficients may be
/// other than zero.
Condition naturalCondition(const Network& network, int seam, int order);

/// Whether none of these unknowns moves.
bool staysWhole(const Unknowns& unknowns, const std::vector<int>& columns);

}  // namespace seamwright::network
