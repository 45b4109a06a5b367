// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

/// Factorises sparse matrices of small blocks. Not a public header.
namespace seamwright::occ {

/// #points by 3: one point in each row.
using PointRows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// The blocks on and above the diagonal that may differ from zero. Column j has blocks in the rows
/// rows[begins[j]] .. rows[begins[j + 1] - 1], which increase; the last is j.
struct BlockPattern {
  std::vector<int> begins = {0}, rows;

  int size() const { return static_cast<int>(begins.size()) - 1; }
};

/// A symmetric block of 3 x 3: xx, yy, zz, xy, yz, zx.
using SymmetricBlock = Eigen::Matrix<double, 6, 1>;

/// The Cholesky factorisation of a positive definite matrix of symmetric blocks of 3 x 3, by the
/// multifrontal method with amalgamation of fronts. The order of elimination is found once for all
/// matrices of a pattern. Points whose blocks are multiples of the unit matrix, as are those of
/// points eliminated before them, take a 27th of the work. Not thread-safe.
/// Source: [DuffReid1983]; [AshcraftGrimes1989].
class BlockCholesky {
 public:
  /// \param is_multiple by block: it is a multiple of the unit matrix in all matrices that are
  /// factorised; empty: none is.
  explicit BlockCholesky(const BlockPattern& pattern, const std::vector<bool>& is_multiple = {});

  /// \param blocks in the order of the pattern. \param diagonal added to the diagonal.
  /// \returns false if the matrix is not positive definite up to rounding.
  bool factor(const std::vector<SymmetricBlock>& blocks, double diagonal);

  /// Solves for one right-hand side, #points by 3. \pre the last factor() returned true.
  PointRows solve(const PointRows& right) const;

 private:
  struct Entry {
    int block, row, column;  ///< rows and columns of the front
  };
  /// Columns first .. last - 1 and what they have below.
  struct Front {
    int first = 0, last = 0;
    bool is_scalar = false;  ///< all blocks are multiples of the unit matrix, stored as numbers
    std::vector<int> below;  ///< points, increasing
    std::vector<Entry> entries = {};
    std::vector<int> children = {};
    std::vector<int> in_parent = {};  ///< by index in below: its row in the parent's front
    double zeros = 0;                 ///< zero blocks that amalgamation stores
    Eigen::MatrixXd panel = {};       ///< the factor's columns

    int columns() const { return last - first; }
    int rows() const { return columns() + static_cast<int>(below.size()); }
    int row(int point) const;
    int size() const { return is_scalar ? 1 : 3; }  ///< of a block in the matrix
  };
  /// What an order of elimination leads to.
  struct Analysis {
    std::vector<int> position;  ///< by point of the pattern: its position in the order
    std::vector<Front> fronts;

    double work() const;  ///< about proportional to the arithmetic of a factorisation
  };

  static Analysis analysed(const BlockPattern& pattern, const std::vector<bool>& is_multiple,
                           const std::vector<int>& order);
  static std::vector<Front> amalgamated(const std::vector<std::vector<int>>& below,
                                        const std::vector<bool>& is_scalar);
  Eigen::MatrixXd assembled(const Front& front, const std::vector<SymmetricBlock>& blocks,
                            std::vector<Eigen::MatrixXd>& updates) const;

  std::vector<int>
      position_;  ///< by point of the pattern: its position in the order of elimination
  std::vector<Front> fronts_;
};

}  // namespace seamwright::occ
