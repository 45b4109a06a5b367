// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include <seamwright/occ_adapter/deform/block_cholesky.hpp>

/// The least moves of points that satisfy linear conditions. Not a public header.
namespace seamwright::occ {

/// Each condition belongs to a part, whose weight solve() is given. Time and memory grow with the
/// number of pairs of points that occur together in a condition. Not thread-safe.
class LeastMoves {
 public:
  explicit LeastMoves(int points, int parts = 1) : points_(points), parts_(parts) {}

  /// Prescribes a move. Must be called before the conditions that contain the point are added.
  void fix(int point, const Eigen::Vector3d& move);

  /// For each row of factors: direction . (sum of factor times move) = value.
  /// \param factors #values by #points.
  /// \returns the number of the condition
  int add(const std::vector<int>& points, const Eigen::MatrixXd& factors,
          const Eigen::Vector3d& direction, const Eigen::VectorXd& values, int part = 0);
  /// Sum of factor times move = value.
  int addPoint(const std::vector<int>& points, const Eigen::RowVectorXd& factors,
               const Eigen::Vector3d& value, int part = 0);
  /// For each row of factors: sum of factor times move = 0. \pre no point is fixed
  void addZero(const std::vector<int>& points, const Eigen::MatrixXd& factors, int part = 0);

  /// Another value of a condition of add() with one row, or of addPoint(). \pre no point is fixed
  void setValue(int condition, double value);
  void setValue(int condition, const Eigen::Vector3d& value);

  /// Minimises the sum of the squared residuals of the conditions, each times the weight of its
  /// part, plus \p damping times the squared moves. Returns #points by 3. Further calls are faster:
  /// those with other weights, and much more those with other values only.
  PointRows solve(double damping, const std::vector<double>& weights = {1}) const;

 private:
  /// Conditions of the same points: several along one direction, or one in all three coordinates.
  struct Group {
    std::vector<int> points;  ///< they do not decrease
    Eigen::MatrixXd factors;  ///< if is_zero: their products, transposed factors times factors
    int part = 0;
    bool is_point = false;
    bool is_zero = false;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< if is_point: the value
    Eigen::VectorXd values = {};                          ///< if is_point: empty
  };
  /// Of a point in a group.
  struct Use {
    int group, column;
  };
  /// What the conditions of a part give to the blocks of the normal matrix, by block: a multiple of
  /// the unit matrix, and the rest if the part has conditions along directions.
  struct PartOfNormal {
    std::vector<double> multiples;
    std::vector<SymmetricBlock> blocks;
  };
  struct Normal {
    BlockPattern pattern;
    std::vector<PartOfNormal> parts;
  };
  struct Prepared {
    Normal normal;
    std::vector<bool> counting = {};  ///< the parts that are in the factors
    BlockCholesky factors = BlockCholesky(BlockPattern{});
    double damping = 0;                ///< of the last factorisation
    std::vector<double> weights = {};  ///< of the last factorisation; empty: there is none
  };

  int addGroup(Group group);
  static void sortPoints(Group& group);
  std::vector<std::vector<Use>> usesOfPoints() const;
  BlockPattern patternOf(const std::vector<std::vector<Use>>& uses) const;
  Normal normalMatrix() const;
  void order(const std::vector<double>& weights) const;
  void factor(double damping, const std::vector<double>& weights) const;
  PointRows pulled(const PointRows& moves, const std::vector<double>& weights) const;

  int points_, parts_;
  std::unordered_map<int, Eigen::Vector3d> fixed_;
  std::vector<Group> groups_;
  mutable std::optional<Prepared>
      prepared_;  ///< for the present conditions, after the first call of solve()
};

}  // namespace seamwright::occ
