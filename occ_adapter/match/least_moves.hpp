// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include <seamwright/occ_adapter/deform/block_cholesky.hpp>

/// The least moves of points that satisfy linear conditions. Not a public header.
namespace seamwright::occ {

/// Time and memory grow with the number of pairs of points that occur together in a condition. Not
/// thread-safe.
class LeastMoves {
 public:
  explicit LeastMoves(int points) : points_(points) {}

  /// Prescribes a move. Must be called before the conditions that contain the point are added.
  void fix(int point, const Eigen::Vector3d& move);

  /// For each row of factors: direction . (sum of factor times move) = value.
  /// \param factors #values by #points.
  void add(const std::vector<int>& points, const Eigen::MatrixXd& factors,
           const Eigen::Vector3d& direction, const Eigen::VectorXd& values);
  /// Sum of factor times move = value.
  void addPoint(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
                const Eigen::Vector3d& value);

  /// For each row of factors: sum of factor times move = 0, with the weight \p softness of solve().
  void addSoft(const std::vector<int>& points, const Eigen::MatrixXd& factors);

  /// Minimises the sum of the squared residuals of the conditions plus \p damping times the squared
  /// moves. Returns #points by 3. A second call for the same conditions is faster.
  PointRows solve(double damping, double softness = 1) const;

 private:
  /// Conditions of the same points: several along one direction, or one in all three coordinates.
  struct Group {
    std::vector<int> points;  ///< they do not decrease
    Eigen::MatrixXd factors;
    bool is_point = false;
    bool is_soft = false;
    Eigen::Vector3d direction;  ///< if is_point: the value
    Eigen::VectorXd values;     ///< if is_point: empty
  };
  /// The blocks of the normal matrix: those of soft conditions are multiples of the unit matrix.
  struct Normal {
    BlockPattern pattern;
    std::vector<SymmetricBlock> blocks;
    std::vector<double> soft;
  };
  struct Prepared {
    Normal normal;
    BlockCholesky factors;
  };

  void addGroup(Group group);
  static void sortPoints(Group& group);
  Normal normalMatrix() const;
  void factor(double damping, double softness) const;
  PointRows pulled(const PointRows& moves, double softness) const;

  int points_;
  std::unordered_map<int, Eigen::Vector3d> fixed_;
  std::vector<Group> groups_;
  mutable std::optional<Prepared>
      prepared_;  ///< for the present conditions, after the first call of solve()
};

}  // namespace seamwright::occ
