// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <string>
#include <vector>

#include <seamwright/core/join/network/network_topology.hpp>

/// The laws of a network, and the parameters that they depend on; not a public header.
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

/// The value with three digits.
std::string text(double value);

/// The form of a seam's law.
struct SeamPlan {
  bool takes_part = false;
  int order = 1;
  std::string why;      ///< why the order is lower than the given one; otherwise empty
  bool linear = false;  ///< c and d are linear; otherwise d / c is constant
  int line = -1;        ///< line that the constant d / c belongs to; -1 if linear or held
  int sense = 1;        ///< 1: d / c is the constant of the line; -1: c / d is
  /// The form of e. Double: quadratic, with a double zero at the end that is not extraordinary.
  /// Tied: linear from a regular vertex to the boundary, and the same on the other half of the
  /// line.
  enum class E { Zero, Linear, Quadratic, Double, Tied } e = E::Zero;
  struct End {
    int vertex = -1;
    int spoke = -1;  ///< index at an extraordinary or regular vertex; -1 at a boundary vertex
    VertexSort sort = VertexSort::Boundary;
  };
  std::array<End, 2> ends;
};

/// The structure of the network, and the form of each law that follows from it.
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

Plan planOf(const Network& network, const Unknowns& unknowns, const NetworkOptions& options,
            bool linear);

/// Laws as functions of parameters. The parameters are logarithms of ratios, p / d, values of e and
/// q at ends, and tangents at extraordinary vertices.
class Laws {
 public:
  /// \pre the plan has no obstacles.
  Laws(const Network& network, const Unknowns& unknowns, const Plan& plan);

  const Eigen::VectorXd& start() const { return start_; }
  Eigen::Index directions() const { return basis_.cols(); }
  SeamLaw law(int seam, const Eigen::VectorXd& y) const;
  /// The parameters after a step in the free directions. The tangents at extraordinary vertices are
  /// then corrected so that they give the ratios of the lines.
  Eigen::VectorXd moved(const Eigen::VectorXd& y, const Eigen::VectorXd& step) const;
  /// d y / d step, at the start.
  const Eigen::SparseMatrix<double>& basis() const { return basis_; }
  /// The parameters that a seam's law depends on.
  const std::vector<int>& parametersOf(int seam) const { return of_seam_[seam]; }
  /// d law / d y(k).
  SeamLaw derivative(int seam, const Eigen::VectorXd& y, int k) const;
  /// A law with the degrees of the seam's law. A coefficient is 1 if it may be nonzero.
  SeamLaw shape(int seam) const;

 private:
  struct Slots {
    int ratio = -1, share = -1;  ///< parameters of the line: log d / c, p / d
    /// Log d / c at a boundary vertex if c and d are linear.
    std::array<int, 2> end_ratio = {-1, -1};
    std::array<int, 2> e = {-1, -1}, q = {-1, -1};
    int tied = -1;   ///< parameter of the line: e at the boundary
    int bulge = -1;  ///< middle coefficient of a quadratic e minus the mean of its ends
  };
  Eigen::Vector3d extraordinaryValues(const SeamPlan::End& end, const Eigen::VectorXd& y) const;
  void addParameters();
  void setStart(const Network& network, const Unknowns& unknowns);
  void setLines(const Eigen::VectorXd& sum, const Eigen::VectorXd& weight,
                const std::vector<bool>& stiff);
  void setBasis();
  Eigen::VectorXd excess(int vertex, const Eigen::VectorXd& y) const;
  Eigen::MatrixXd excessDerivative(int vertex, const Eigen::VectorXd& y) const;
  void restore(int vertex, Eigen::VectorXd& y) const;

  const Network& network_;
  const Plan& plan_;
  std::vector<Slots> slots_;
  std::vector<int> extraordinary_slot_;  ///< one per vertex; -1: not extraordinary
  std::vector<int> line_slot_, share_slot_, tied_slot_;
  std::vector<std::vector<int>> of_seam_;
  Eigen::VectorXd start_;
  Eigen::SparseMatrix<double> basis_;
};

}  // namespace seamwright::network
